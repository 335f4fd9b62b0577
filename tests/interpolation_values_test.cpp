// SPDX-License-Identifier: Apache-2.0
//
// The arithmetic of interpolation, value by value.
#include <gtest/gtest.h>

#include <array>

#include "interpolation.hpp"
#include "triangle_setup.hpp"

namespace halfspace {
namespace {

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
