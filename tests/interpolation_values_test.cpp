// SPDX-License-Identifier: Apache-2.0
//
// The arithmetic of interpolation, value by value.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "interpolation.hpp"
#include "triangle_setup.hpp"

namespace halfspace {
namespace {

// Every width of an area, its ends and mantissas next to them, against the definition.
TEST(Interpolation, AreaReciprocalIsWithinItsBound) {
  std::mt19937_64 random(5);
  for (int bits = 1; bits <= 62; ++bits) {
    for (int i = 0; i < 2000; ++i) {
      const std::int64_t low = std::int64_t{1} << (bits - 1);
      const auto most = static_cast<std::uint64_t>(low - 1);
      std::int64_t area = low + static_cast<std::int64_t>(random() & most);
      if (i == 0) area = low;
      if (i == 1) area = low + static_cast<std::int64_t>(most);
      const AreaReciprocal r = area_reciprocal(area);
      ASSERT_EQ(r.shift, 32 + bits);
      ASSERT_EQ(r.factor & 1, 1u);
      ASSERT_LT(r.factor, std::uint64_t{1} << 33);
      const auto m =
          static_cast<unsigned __int128>(static_cast<unsigned __int128>(area) << 64 >> (32 + bits));
      const unsigned __int128 d = 2 * m + 1;
      const unsigned __int128 one = static_cast<unsigned __int128>(1) << 64;
      const unsigned __int128 quotient = r.factor >> 1;
      ASSERT_TRUE(quotient * d <= one && (quotient + 1) * d > one) << area;
      // |factor area - 2^shift| <= 2^(shift - 31)
      const auto product = static_cast<__int128>(r.factor) * area;
      const __int128 off = product - (static_cast<__int128>(1) << r.shift);
      ASSERT_LE(off < 0 ? -off : off, static_cast<__int128>(1) << (r.shift - 31)) << area;
    }
  }
}

// attribute / w at a vertex: 2^15 / 2^16 is a half and rounds up, anything less rounds down.
TEST(Interpolation, AttributeOverWIsRoundedToNearest) {
  const Triangle t{{{{0, 0}, {0, 2560}, {2560, 0}}}, 0};
  const SetupTriangle setup = *triangle_setup(t, {64, 64}, kFull);
  for (const std::uint32_t below : {0u, 1u}) {
    std::array<VertexAttributes, 3> a{};
    for (VertexAttributes& v : a) {
      v.inverse_w = (1u << 15) - below;
      v.value[0] = 1;
    }
    const InterpolationSetup planes = interpolation_setup(setup, t, a, 1, kFull);
    EXPECT_EQ(planes.attribute[0].at_origin, std::uint64_t{1 - below} << kFull.gradient_bits);
  }
}

TEST(InterpolationDeathTest, RefusesPacketsOutOfRange) {
  const Triangle t{{{{0, 0}, {0, 2560}, {2560, 0}}}, 0};
  const SetupTriangle setup = *triangle_setup(t, {64, 64}, kFull);
  std::array<VertexAttributes, 3> a{};
  EXPECT_DEATH(interpolation_setup(setup, t, a, 1, kFull), "inverse_w");
  for (VertexAttributes& v : a) v.inverse_w = 1;
  a[1].depth = kDepthMost + 1;
  EXPECT_DEATH(interpolation_setup(setup, t, a, 0, kFull), "depth");
}

}  // namespace
}  // namespace halfspace
