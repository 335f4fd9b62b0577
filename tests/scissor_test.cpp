// SPDX-License-Identifier: Apache-2.0
#include "scissor.hpp"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

// Every box of a frame of 12 x 12 pixels, on the tiles of both grids: a lane stays when its pixel
// is in the box.
TEST(Scissor, KeepsThePixelsInTheBoxAndNoOther) {
  constexpr int kSide = 12;
  for (const Config& config : {kFull, kTiny}) {
    for (int corners = 0; corners < kSide * kSide * kSide * kSide; ++corners) {
      const Box box{corners % kSide, corners / kSide % kSide, corners / kSide / kSide % kSide,
                    corners / kSide / kSide / kSide};
      if (box.x_first > box.x_last || box.y_first > box.y_last) continue;
      for (int y = 0; y < kSide; y += config.grid()) {
        for (int x = 0; x < kSide; x += config.grid()) {
          GridMask want = 0;
          for (int lane = 0; lane < config.lanes(); ++lane) {
            const int px = x + lane % config.grid(), py = y + lane / config.grid();
            const bool in =
                px >= box.x_first && px <= box.x_last && py >= box.y_first && py <= box.y_last;
            want |= GridMask{in} << lane;
          }
          ASSERT_EQ(scissor_lanes(box, x, y, config.grid_log2), want);
        }
      }
    }
  }
}

TEST(Scissor, CutsEverySampleAlikeAndDropsWhatIsEmpty) {
  CoverageTile tile{8, 0, {}, 77};
  tile.mask[0] = 0x0f;
  tile.mask[3] = 0xff0f;
  const auto left = scissor(tile, {0, 0, 9, 9}, kMsaa4);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->mask[0], 3u);
  EXPECT_EQ(left->mask[1], 0u);
  EXPECT_EQ(left->mask[3], 0x303u);
  EXPECT_EQ(left->tag, 77u);
  EXPECT_EQ(left->x, 8);
  EXPECT_FALSE(scissor(tile, {0, 0, 7, 9}, kMsaa4));
  EXPECT_FALSE(scissor(tile, {14, 0, 15, 0}, kMsaa4));
}

}  // namespace
}  // namespace halfspace
