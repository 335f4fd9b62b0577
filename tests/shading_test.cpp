// SPDX-License-Identifier: Apache-2.0
#include "shading.hpp"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(Shading, ReciprocalIsTheFloorForEveryMantissa) {
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

TEST(Shading, PerspectiveClampsWhatExtrapolationLeaves) {
  EXPECT_EQ(perspective(-5, 1 << 29, 0, kFull), 0);
  EXPECT_EQ(perspective(1 << 30, 1 << 20, 0, kFull), 255);
  EXPECT_EQ(perspective(0, 0, 0, kFull), 0);
  EXPECT_EQ(perspective(INT32_MIN, INT32_MIN, 0, kFull), 0);
  EXPECT_EQ(perspective(INT32_MAX, INT32_MAX, 0, kFull), 255);
}

TEST(Shading, AddsTheLevelAndSaturates) {
  EXPECT_EQ(perspective(1 << 28, 1 << 29, 7, kFull), 128 + 7);
  EXPECT_EQ(perspective(1 << 28, 1 << 29, 200, kFull), 255);
  EXPECT_EQ(perspective(-1, 1 << 29, 200, kFull), 200);
}

// Red is 100 everywhere, green grows by one level a pixel to the right, blue by one a row down; 1/w
// is 1/2. A sample moves red by its number.
ShadingPlanes planes() {
  constexpr std::uint32_t kLevel = (1u << 29) / 256;
  ShadingPlanes out;
  out.inverse_w.center = {1u << 29, 0, 0};
  out.color[0].center = {100 * kLevel, 0, 0};
  out.color[1].center = {kLevel, kLevel, 0};
  out.color[2].center = {kLevel, 0, kLevel};
  for (std::uint32_t m = 0; m < kMaxSamples; ++m) out.color[0].offset[m] = (m + 1) * kLevel;
  return out;
}

TEST(Shading, GivesEachFragmentTheColourOfItsPixelAndNoOther) {
  for (const Config& config : {kFull, kTiny}) {
    CoverageTile tile;
    tile.mask[0] = 0xffff;
    SampleMasks passed{};
    passed[0] = 0x8421;
    const ColorTile color = shading(tile, passed, planes(), 3, config);
    for (int lane = 0; lane < config.lanes(); ++lane) {
      const auto x = static_cast<std::uint8_t>(lane % config.grid());
      const auto y = static_cast<std::uint8_t>(lane / config.grid());
      const bool fragment = (passed[0] >> lane & 1) != 0;
      const auto right = static_cast<std::uint8_t>(x + 1), down = static_cast<std::uint8_t>(y + 1);
      EXPECT_EQ(color[static_cast<std::size_t>(lane)], (fragment ? Rgb{100, right, down} : Rgb{}));
    }
  }
}

TEST(Shading, LeavesChannelsBeyondTheColoursBlack) {
  CoverageTile tile;
  tile.mask[0] = 1;
  EXPECT_EQ(shading(tile, tile.mask, planes(), 1, kFull)[0], (Rgb{100, 0, 0}));
  EXPECT_EQ(shading(tile, tile.mask, planes(), 0, kFull)[0], (Rgb{0, 0, 0}));
}

// At the centre where the triangle covers all samples, else at the first that it covers: whether
// that one passed the depth test plays no part.
TEST(Shading, IsEvaluatedAtTheCentreOrTheFirstCoveredSample) {
  for (unsigned covered = 1; covered < 16; ++covered) {
    for (unsigned won = 1; won < 16; ++won) {
      if ((won & ~covered) != 0) continue;
      CoverageTile tile;
      SampleMasks passed{};
      for (std::size_t m = 0; m < 4; ++m) {
        tile.mask[m] = static_cast<GridMask>(covered >> m & 1) << 9;
        passed[m] = static_cast<GridMask>(won >> m & 1) << 9;
      }
      const int red = covered == 15 ? 100 : 101 + std::countr_zero(covered);
      EXPECT_EQ(shading(tile, passed, planes(), 3, kMsaa4)[9][0], red) << covered << " " << won;
    }
  }
}

}  // namespace
}  // namespace halfspace
