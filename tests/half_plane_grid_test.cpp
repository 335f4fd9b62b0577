// SPDX-License-Identifier: Apache-2.0
#include "half_plane_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "compare.hpp"
#include "fixed.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

std::int64_t lane(std::int64_t base, EdgeSlope slope, int i, int j) {
  return base + std::int64_t{slope.a} * i + std::int64_t{slope.b} * j;
}

// Do all lanes fit? They change monotonically, so the corners tell.
bool legal(std::int64_t base, EdgeSlope slope, const Config& config) {
  const int last = config.grid() - 1;
  for (const int corner : {0, 1, 2, 3}) {
    if (!fits(lane(base, slope, (corner & 1) * last, (corner >> 1) * last), config.lane_bits())) {
      return false;
    }
  }
  return true;
}

GridMask direct(std::int64_t base, EdgeSlope slope, const Config& config) {
  GridMask mask = 0;
  for (int bit = 0; bit < config.lanes(); ++bit) {
    const bool inside = lane(base, slope, bit % config.grid(), bit / config.grid()) >= 0;
    mask |= GridMask{inside ? 1u : 0u} << bit;
  }
  return mask;
}

// Every base and slope of the narrowest configuration: 8-bit lanes of a 4x4 grid, 9-bit of an 8x8.
TEST(HalfPlaneGrid, EveryInputOfTheNarrowestWidthsMatchesDirectEvaluation) {
  for (const int g : {2, 3}) {
    const Config config{.subpixel_bits = 0, .viewport_bits = 3, .guard_bits = 0, .grid_log2 = g};
    const int slopes = 1 << (config.delta_bits() - 1);
    const int bases = 1 << (config.lane_bits() - 1);
    std::uint64_t compared = 0;
    for (int a = -slopes; a < slopes; ++a) {
      for (int b = -slopes; b < slopes; ++b) {
        for (int base = -bases; base < bases; ++base) {
          const EdgeSlope slope{a, b};
          if (!legal(base, slope, config)) continue;
          ASSERT_EQ(half_plane_grid(base, slope, config), direct(base, slope, config))
              << "base " << base << " a " << a << " b " << b << " g " << g;
          ++compared;
        }
      }
    }
    EXPECT_GT(compared, 100'000u);
  }
}

TEST(HalfPlaneGrid, RandomInputOfTheWidestWidthsMatchesDirectEvaluation) {
  constexpr std::uint64_t kSeed = 31;
  Random random(kSeed);
  const Config widest{.subpixel_bits = 12, .viewport_bits = 15, .guard_bits = 16, .samples = 16};
  const Config widest4{.subpixel_bits = 12, .viewport_bits = 15, .guard_bits = 16, .grid_log2 = 2};
  int compared = 0;
  for (const Config& config : {kTiny, kFull, kD3d, kMsaa4, widest, widest4}) {
    const auto limit = std::int64_t{1} << (config.delta_bits() - 1);
    for (int n = 0; n < 100'000; ++n) {
      const int small = static_cast<int>(random.in(0, config.delta_bits() - 1));
      const EdgeSlope slope{
          static_cast<std::int32_t>(random.in(-limit, limit - 1) >> small),
          static_cast<std::int32_t>(random.in(-limit, limit - 1) >> random.in(0, small))};
      // A base that puts the border near a lane, and sometimes exactly on it.
      const std::int64_t beside = random.in(-1, 1);
      const auto j = static_cast<int>(random.in(-1, 8)), i = static_cast<int>(random.in(-1, 8));
      const std::int64_t base = beside - lane(0, slope, i, j);
      if (!legal(base, slope, config)) continue;
      ASSERT_EQ(half_plane_grid(base, slope, config), direct(base, slope, config))
          << "base " << base << " a " << slope.a << " b " << slope.b << " seed " << kSeed << ", "
          << describe(config);
      ++compared;
    }
  }
  EXPECT_GT(compared, 400'000);
}

TEST(HalfPlaneGrid, ExtremeLanesKeepTheirSigns) {
  for (const Preset& preset : kPresets) {
    const Config& config = preset.config;
    const auto greatest = (std::int64_t{1} << (config.lane_bits() - 1)) - 1;
    const GridMask all = config.lanes() == 64 ? ~GridMask{0} : (GridMask{1} << config.lanes()) - 1;
    EXPECT_EQ(half_plane_grid(greatest, {0, 0}, config), all);
    EXPECT_EQ(half_plane_grid(-greatest - 1, {0, 0}, config), 0u);
    EXPECT_EQ(half_plane_grid(0, {0, 0}, config), all);
    EXPECT_EQ(half_plane_grid(-1, {0, 0}, config), 0u);
    // Down to the least value in the last lane.
    const auto steep = -static_cast<std::int32_t>((std::int64_t{1} << (config.delta_bits() - 1)));
    const std::int64_t last = config.grid() - 1;
    const EdgeSlope slope{steep / 2, steep / 2};
    const std::int64_t base = -greatest - 1 - last * slope.a - last * slope.b;
    EXPECT_EQ(half_plane_grid(base, slope, config), direct(base, slope, config));
  }
}

TEST(HalfPlaneGrid, LaneThatDoesNotFitStopsTheProgram) {
  const auto limit = std::int64_t{1} << (kTiny.lane_bits() - 1);
  EXPECT_DEATH(half_plane_grid(limit, {0, 0}, kTiny), "lane_bits");
  EXPECT_DEATH(half_plane_grid(limit - 1, {1, 0}, kTiny), "lane_bits");
  EXPECT_DEATH(half_plane_grid(limit - 1, {0, 1}, kTiny), "lane_bits");
  EXPECT_DEATH(half_plane_grid(-limit, {0, -1}, kTiny), "lane_bits");
  EXPECT_DEATH(half_plane_grid(-limit + 3, {-1, -1}, kTiny), "lane_bits");
}

// Every box in a 24-pixel square against every 4x4 and 8x8 grid of 1, 4 and 8 px lanes near it.
TEST(BoxMask, LanesThatShareAPixelWithTheBoxAreSet) {
  for (const int g : {2, 3}) {
    const Config config{.grid_log2 = g};
    for (const int child_log2 : {0, 2, 3}) {
      const int side = 1 << (g + child_log2);
      for (int code = 0; code < 24 * 24; ++code) {
        const int first = code % 24;
        const int last = code / 24;
        if (last < first) continue;
        // Rows and columns are symmetric and independent: a second interval for the other one.
        const Box box{first, 23 - last, last, 23 - first};
        for (int origin = 0; origin < 24; origin += side) {
          GridMask expected = 0;
          for (int bit = 0; bit < config.lanes(); ++bit) {
            const int x = origin + ((bit % config.grid()) << child_log2);
            const int y = side + ((bit / config.grid()) << child_log2);
            const int end = (1 << child_log2) - 1;
            const bool overlap = x <= box.x_last && x + end >= box.x_first && y <= box.y_last &&
                                 y + end >= box.y_first;
            expected |= GridMask{overlap ? 1u : 0u} << bit;
          }
          ASSERT_EQ(box_mask(origin, side, child_log2, box, config), expected)
              << "box " << first << ".." << last << " origin " << origin << " lanes of 2^"
              << child_log2 << " px, g " << g;
        }
      }
    }
  }
}

}  // namespace
}  // namespace halfspace
