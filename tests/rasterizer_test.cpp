// SPDX-License-Identifier: Apache-2.0
#include "rasterizer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "compare.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

const std::vector<Config>& configs() {
  static const std::vector<Config> all = [] {
    std::vector<Config> list;
    for (const Preset& preset : kPresets) list.push_back(preset.config);
    list.push_back({.subpixel_bits = 0, .samples = 16});
    list.push_back({.subpixel_bits = 12, .viewport_bits = 15, .guard_bits = 16, .samples = 8});
    list.push_back({.viewport_bits = 11, .guard_bits = 13, .grid_log2 = 2});
    list.push_back({.viewport_bits = 11, .guard_bits = 0});
    list.push_back({.subpixel_bits = 1, .viewport_bits = 7, .guard_bits = 9, .samples = 2});
    list.push_back({.subpixel_bits = 5, .guard_bits = 12, .samples = 16, .grid_log2 = 2});
    list.push_back({.subpixel_bits = 3, .viewport_bits = 3, .guard_bits = 16, .samples = 4});
    return list;
  }();
  return all;
}

// Whole frames of a size that is no multiple of a tile, every sample.
TEST(Rasterizer, EveryShapeIsExactInASmallFrame) {
  constexpr std::uint64_t kSeed = 71;
  for (const Config& config : configs()) {
    Random random(kSeed);
    const FrameState frame{std::min(61, config.max_size()), std::min(45, config.max_size()),
                           Cull::kNone};
    for (int n = 0; n < 40; ++n) {
      for (const Shape shape : kShapes) {
        const Triangle t = random_triangle(random, shape, frame, config);
        ASSERT_TRUE(exact(t, frame, config)) << shape_name(shape) << ", seed " << kSeed;
      }
    }
  }
}

// The largest frame of every configuration, at the tiles where a mistake would show.
TEST(Rasterizer, EveryShapeIsExactAtFullWidth) {
  constexpr std::uint64_t kSeed = 72;
  for (const Config& config : configs()) {
    Random random(kSeed);
    const FrameState frame{config.max_size(), config.max_size() - 3, Cull::kNone};
    for (int n = 0; n < 250; ++n) {
      for (const Shape shape : kShapes) {
        const Triangle t = random_triangle(random, shape, frame, config);
        ASSERT_TRUE(exact_at_telling_tiles(random, t, frame, config, 12))
            << shape_name(shape) << ", seed " << kSeed;
      }
    }
  }
}

TEST(Rasterizer, WidestTrianglesAreExact) {
  constexpr std::uint64_t kSeed = 73;
  for (const Config& config : configs()) {
    Random random(kSeed);
    const FrameState frame{config.max_size(), config.max_size(), Cull::kNone};
    for (const Triangle& t : widest_triangles(config)) {
      ASSERT_TRUE(exact_at_telling_tiles(random, t, frame, config, 12)) << "seed " << kSeed;
    }
  }
}

// Two widest triangles that share a diagonal of the legal square own every sample of the frame
// once.
TEST(Rasterizer, LegalSquareCutInTwoFillsTheFrame) {
  for (const Config& config : configs()) {
    Random random(74);
    const int size = config.max_size();
    const FrameState frame{size, size, Cull::kNone};
    const auto low = static_cast<std::int32_t>(config.coordinate_min());
    const auto high = static_cast<std::int32_t>(config.coordinate_max());
    const Point a{low, low}, b{high, low}, c{high, high}, d{low, high};
    const GridMask all = config.lanes() == 64 ? ~GridMask{0} : (GridMask{1} << config.lanes()) - 1;
    for (const auto& [one, other] : {std::pair{Triangle{{a, b, c}, 0}, Triangle{{c, d, a}, 0}},
                                     {{{b, c, d}, 0}, {{b, a, d}, 0}}}) {
      const auto first = triangle_setup(one, frame, config);
      const auto second = triangle_setup(other, frame, config);
      for (const auto& [x, y] : telling_tiles(random, one, frame, config, 200)) {
        const CoverageTile mine = first ? model_tile(*first, x, y, config) : CoverageTile{};
        const CoverageTile rest = second ? model_tile(*second, x, y, config) : CoverageTile{};
        for (std::size_t m = 0; m < static_cast<std::size_t>(config.samples); ++m) {
          ASSERT_EQ(mine.mask[m] ^ rest.mask[m], all)
              << "tile " << x << "," << y << ", " << describe(config);
        }
      }
    }
  }
}

TEST(Rasterizer, OffScreenTrianglesDrawNothing) {
  const FrameState frame{64, 48, Cull::kNone};
  const auto px = [](std::int32_t v) { return v * 256; };
  const std::vector<Triangle> outside{
      {{{{px(-9), px(5)}, {px(-1), px(20)}, {px(0), px(5)}}}, 0},        // left
      {{{{px(64), px(5)}, {px(90), px(20)}, {px(64), px(40)}}}, 0},      // right
      {{{{px(5), px(-30)}, {px(20), px(0)}, {px(40), px(-2)}}}, 0},      // above
      {{{{px(5), px(48)}, {px(20), px(99)}, {px(40), px(48)}}}, 0},      // below
      {{{{px(-99), px(50)}, {px(50), px(-99)}, {px(-99), px(-99)}}}, 0}  // across the corner
  };
  for (const Triangle& t : outside) {
    RasterStats stats;
    rasterize(t, frame, kFull, stats, [](const CoverageTile&) {});
    EXPECT_EQ(stats.samples_covered, 0u) << describe(t, frame, kFull);
    EXPECT_TRUE(exact(t, frame, kFull));
  }
}

TEST(Rasterizer, StatsAddUpToWhatWasDrawn) {
  constexpr std::uint64_t kSeed = 75;
  Random random(kSeed);
  const Config config = kMsaa4;
  const FrameState frame{150, 90, Cull::kBack};
  const auto samples = oracle::standard_samples(4);
  RasterStats stats;
  std::array<std::uint64_t, 8> visits{};
  std::uint64_t setups = 0, covered_visits = 0, tiles = 0, owned = 0;
  for (int n = 0; n < 220; ++n) {
    const Triangle t = random_triangle(
        random, kShapes[static_cast<std::size_t>(n) % kShapes.size()], frame, config);
    rasterize(
        t, frame, config, stats, [&](const SetupTriangle&) { ++setups; },
        [&](const Node&, int level, bool covered) {
          ++visits[static_cast<std::size_t>(level)];
          covered_visits += level == 3 && covered ? 1u : 0u;
        },
        [&](const CoverageTile&) { ++tiles; });
    const auto corners = corners_px(t, config);
    if (oracle::turn(corners[0], corners[1], corners[2]) >= 0) continue;  // back or no area
    for (int pixel = 0; pixel < frame.width * frame.height; ++pixel) {
      owned += static_cast<std::uint64_t>(std::popcount(
          oracle::pixel_mask(corners, pixel % frame.width, pixel / frame.width, samples)));
    }
  }
  EXPECT_EQ(stats.triangles, 220u);
  EXPECT_GT(stats.triangles_zero_area, 0u);
  EXPECT_GT(stats.triangles_culled, 0u);
  EXPECT_GT(stats.triangles_no_sample, 0u);
  EXPECT_EQ(setups, stats.triangles - stats.triangles_zero_area - stats.triangles_culled -
                        stats.triangles_no_sample);
  EXPECT_EQ(stats.traversal.nodes[0], setups);
  EXPECT_EQ(stats.traversal.nodes[3], stats.tiles_visited);
  EXPECT_EQ(visits, stats.traversal.nodes);
  EXPECT_EQ(covered_visits, stats.tiles_covered);
  EXPECT_EQ(tiles, stats.tiles_covered);
  EXPECT_EQ(stats.samples_tested, stats.tiles_visited * 64 * 4);
  EXPECT_EQ(stats.samples_covered, owned);
}

TEST(Rasterizer, TilesCarryTheTagAndComeInTriangleOrder) {
  const auto mesh = jittered_mesh(76, 64, 16, 1, kFull);
  RasterStats stats;
  std::uint32_t before = 0;
  for (const Triangle& t : mesh) {
    rasterize(t, {64, 64, Cull::kNone}, kFull, stats, [&](const CoverageTile& tile) {
      EXPECT_EQ(tile.tag, t.tag);
      EXPECT_GE(tile.tag, before);
      before = tile.tag;
    });
  }
  EXPECT_EQ(before, mesh.size() - 1);
}

TEST(HitCount, CountsAPixelOncePerTriangleAndStopsAt255) {
  const Triangle t{{{{0, 0}, {4096, 0}, {0, 4096}}}, 0};
  for (const Config& config : {kFull, kMsaa4}) {
    const HitCount hits = model_hits(std::vector<Triangle>(300, t), {16, 16, Cull::kNone}, config);
    EXPECT_EQ(hits.at(0, 0), 255);
    EXPECT_EQ(hits.at(15, 15), 0);
    EXPECT_EQ(model_hits({t, t, t}, {16, 16, Cull::kNone}, config).at(3, 2), 3);
  }
}

}  // namespace
}  // namespace halfspace
