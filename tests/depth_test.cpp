// SPDX-License-Identifier: Apache-2.0
#include "depth.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace halfspace
