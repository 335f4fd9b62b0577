// SPDX-License-Identifier: Apache-2.0
//
// The arithmetic of interpolation, value by value.
#include <gtest/gtest.h>

#include <array>

#include "interpolation.hpp"
#include "triangle_setup.hpp"

namespace halfspace {
namespace {

TEST(Interpolation, ReciprocalIsTheFloorForEveryMantissa) {
  for (int bits = 6; bits <= 16; ++bits) {
    Config config = kFull;
    config.reciprocal_bits = bits;
    for (std::uint32_t m = 1u << (bits - 1); m < 1u << bits; ++m) {
      const std::uint64_t r = reciprocal(m, config);
      const std::uint64_t d = 2 * std::uint64_t{m} + 1;
      const std::uint64_t n = std::uint64_t{1} << (2 * bits);
      ASSERT_TRUE(r * d <= n && (r + 1) * d > n) << "bits " << bits << " mantissa " << m;
      ASSERT_LT(r, 1u << bits);
    }
  }
}

TEST(Interpolation, PerspectiveClampsWhatExtrapolationLeaves) {
  EXPECT_EQ(perspective(-5, 1 << 29, kFull), 0);
  EXPECT_EQ(perspective(1 << 30, 1 << 20, kFull), 255);
  EXPECT_EQ(perspective(0, 0, kFull), 0);
  EXPECT_EQ(perspective(INT32_MIN, INT32_MIN, kFull), 0);
  EXPECT_EQ(perspective(INT32_MAX, INT32_MAX, kFull), 255);
}

TEST(Interpolation, DepthValueRoundsToNearestAndClamps) {
  EXPECT_EQ(depth_value(-1, kFull), 0u);
  EXPECT_EQ(depth_value(31, kFull), 0u);
  EXPECT_EQ(depth_value(32, kFull), 1u);
  EXPECT_EQ(depth_value(INT32_MAX, kFull), (1u << 24) - 1);
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
    EXPECT_EQ(planes.attribute[0].at_vertex0, std::uint64_t{1 - below} << kFull.gradient_bits);
  }
}

TEST(InterpolationDeathTest, RefusesPacketsOutOfRange) {
  const Triangle t{{{{0, 0}, {0, 2560}, {2560, 0}}}, 0};
  const SetupTriangle setup = *triangle_setup(t, {64, 64}, kFull);
  std::array<VertexAttributes, 3> a{};
  EXPECT_DEATH(interpolation_setup(setup, t, a, 1, kFull), "inverse_w");
  for (VertexAttributes& v : a) v.inverse_w = 1;
  a[1].depth = 1u << 30;
  EXPECT_DEATH(interpolation_setup(setup, t, a, 0, kFull), "depth");
}

}  // namespace
}  // namespace halfspace
