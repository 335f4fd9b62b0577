// SPDX-License-Identifier: Apache-2.0
#include "depth.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

// A plane of constant depth, in LSB of the depth buffer.
TilePlane flat(std::uint32_t depth, const Config& config) {
  return {depth << (kPlaneBits - config.depth_bits), 0, 0};
}

TEST(Depth, LessKeepsTheFirstOfEqualDepths) {
  DepthTile stored{};
  stored.fill(100);
  EXPECT_EQ(depth_test(~GridMask{0}, flat(100, kFull), DepthFunction::kLess, stored, kFull), 0u);
  EXPECT_EQ(depth_test(~GridMask{0}, flat(99, kFull), DepthFunction::kLess, stored, kFull),
            ~GridMask{0});
  EXPECT_EQ(stored[63], 99u);
}

TEST(Depth, LessEqualLetsTheLaterOfEqualDepthsWin) {
  DepthTile stored{};
  stored.fill(100);
  EXPECT_EQ(depth_test(0xff, flat(100, kFull), DepthFunction::kLessEqual, stored, kFull), 0xffu);
  EXPECT_EQ(depth_test(0xff, flat(101, kFull), DepthFunction::kLessEqual, stored, kFull), 0u);
}

TEST(Depth, TouchesOnlyCoveredLanes) {
  DepthTile stored{};
  stored.fill(100);
  depth_test(GridMask{1} << 17, flat(5, kFull), DepthFunction::kLess, stored, kFull);
  for (std::size_t i = 0; i < 64; ++i) EXPECT_EQ(stored[i], i == 17 ? 5u : 100u) << "lane " << i;
}

// Depth grows by one LSB per pixel right and eight per pixel down: each lane has its own value.
TEST(Depth, LaneIsRowTimesGridPlusColumn) {
  for (const Config& config : {kFull, kTiny}) {
    DepthTile stored{};
    stored.fill(0xffffff);
    const std::uint32_t lsb = 1u << (kPlaneBits - config.depth_bits);
    const GridMask all = config.lanes() == 64 ? ~GridMask{0} : 0xffff;
    depth_test(all, {0, lsb, 8 * lsb}, DepthFunction::kLess, stored, config);
    for (int y = 0; y < config.grid(); ++y) {
      for (int x = 0; x < config.grid(); ++x) {
        EXPECT_EQ(stored[static_cast<std::size_t>(y * config.grid() + x)],
                  static_cast<std::uint32_t>(8 * y + x));
      }
    }
  }
}

TEST(Depth, ValueIsRoundedToNearestAndClamped) {
  EXPECT_EQ(depth_value(-1, kFull), 0u);
  EXPECT_EQ(depth_value(31, kFull), 0u);
  EXPECT_EQ(depth_value(32, kFull), 1u);
  EXPECT_EQ(depth_value(INT32_MAX, kFull), (1u << 24) - 1);
}

// Each function, against the comparison that its name says, for a depth on either side and alike.
TEST(Depth, EveryFunctionComparesAsItIsNamed) {
  const auto wins = [](DepthFunction function, std::uint32_t depth) {
    DepthTile stored{};
    stored.fill(100);
    const bool won = depth_test(2, flat(depth, kFull), function, stored, kFull) == 2;
    EXPECT_EQ(stored[1], won ? depth : 100);
    return won;
  };
  for (const std::uint32_t depth : {0u, 99u, 100u, 101u, 0xffffffu}) {
    EXPECT_FALSE(wins(DepthFunction::kNever, depth));
    EXPECT_EQ(wins(DepthFunction::kLess, depth), depth < 100);
    EXPECT_EQ(wins(DepthFunction::kEqual, depth), depth == 100);
    EXPECT_EQ(wins(DepthFunction::kLessEqual, depth), depth <= 100);
    EXPECT_EQ(wins(DepthFunction::kGreater, depth), depth > 100);
    EXPECT_EQ(wins(DepthFunction::kNotEqual, depth), depth != 100);
    EXPECT_EQ(wins(DepthFunction::kGreaterEqual, depth), depth >= 100);
    EXPECT_TRUE(wins(DepthFunction::kAlways, depth));
  }
}

TEST(Depth, ValueReachesBothEndsWithEveryNumberOfBits) {
  for (int bits = 16; bits <= 32; ++bits) {
    Config config;
    config.depth_bits = bits;
    EXPECT_EQ(depth_value(0, config), 0u) << bits;
    EXPECT_EQ(depth_value(-5, config), 0u) << bits;
    EXPECT_EQ(depth_value(1 << 30, config), config.depth_max()) << bits;
    EXPECT_EQ(depth_value(3 << 29, config), config.depth_max()) << bits;
    EXPECT_EQ(depth_value(1 << 29, config), 1u << (bits - 1)) << bits;
    const std::uint32_t step = bits > 30 ? 1u << (bits - 30) : 1;
    EXPECT_EQ(depth_value((1 << 29) + (1 << std::max(30 - bits, 0)), config),
              (1u << (bits - 1)) + step);
  }
}

}  // namespace
}  // namespace halfspace
