// SPDX-License-Identifier: Apache-2.0
//
// Level coverage in batches: on every instruction set the masks of level bit, and so the oracle's.
#include "engines/coverage/coverage_engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "compare.hpp"
#include "engines/coverage/hit_plane.hpp"
#include "rasterizer.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

struct Case {
  const char* name;
  Config config;
  FrameState frame;
  int triangles = 60000;
};

// How GoogleTest prints a parameter.
void PrintTo(const Case& c, std::ostream* out) { *out << describe(c.config); }

Config odd(int s, int n, int k, int samples, int grid_log2) {
  Config config;
  config.subpixel_bits = s;
  config.viewport_bits = n;
  config.guard_bits = k;
  config.samples = samples;
  config.grid_log2 = grid_log2;
  return config;
}

// Frames are small so that 60,000 triangles fit the time; coordinates reach as far as ever.
const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"full", kFull, {128, 96, Cull::kNone}},
      {"tiny", kTiny, {120, 72, Cull::kNone}},
      {"d3d", kD3d, {127, 65, Cull::kNone}},
      {"msaa4", kMsaa4, {72, 90, Cull::kBack}},
      {"no_guard", odd(8, 7, 0, 1, 3), {128, 128, Cull::kFront}},
      {"pixel_vertices", odd(0, 7, 8, 1, 3), {128, 100, Cull::kNone}},
      {"coarse_16", odd(1, 6, 0, 16, 2), {64, 61, Cull::kNone}},
      {"nine_bits", odd(9, 8, 9, 1, 3), {130, 70, Cull::kNone}},
      {"ten_bits_2", odd(10, 7, 12, 2, 3), {100, 100, Cull::kNone}},
      {"finest", odd(12, 15, 16, 1, 3), {96, 96, Cull::kNone}},
      {"finest_16", odd(12, 15, 16, 16, 3), {40, 56, Cull::kNone}},
      {"one_pixel_frame", odd(4, 3, 5, 8, 2), {1, 1, Cull::kNone}},
  };
  return all;
}

// Every shape of the generators, every third one flat on top or below; then the widest.
std::vector<Triangle> adversarial(const Case& c, int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    const Shape shape = kShapes[static_cast<std::size_t>(i) % kShapes.size()];
    Triangle t = random_triangle(random, shape, c.frame, c.config);
    if (i % 3 == 0) t.vertex[1].y = t.vertex[0].y;
    triangles.push_back(t);
  }
  const std::vector<Triangle> widest = widest_triangles(c.config);
  for (std::size_t i = 0; i < std::min<std::size_t>(widest.size(), 600); ++i) {
    triangles.push_back(widest[i * widest.size() / 600 % widest.size()]);
  }
  return triangles;
}

using Tiles = std::vector<CoverageTile>;

void in_raster_order(Tiles& tiles) {
  std::sort(tiles.begin(), tiles.end(), [](const CoverageTile& a, const CoverageTile& b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
  });
}

std::vector<Tiles> level_bit(std::span<const Triangle> triangles, const Case& c,
                             RasterStats& stats) {
  std::vector<Tiles> out(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    rasterize(triangles[i], c.frame, c.config, stats,
              [&](const CoverageTile& tile) { out[i].push_back(tile); });
    in_raster_order(out[i]);
  }
  return out;
}

std::vector<Tiles> level_coverage(std::span<const Triangle> triangles, const Case& c,
                                  std::string_view isa, RasterStats& stats) {
  std::vector<Tiles> out(triangles.size());
  CoverageEngine engine(c.frame, c.config, isa);
  std::size_t next = 0;
  engine.cover(triangles, [&](const CoverageChunk& chunk) {
    count_records(chunk, stats);
    for (std::size_t i = 0; i < chunk.triangle.size(); ++i) {
      const std::size_t triangle = chunk.triangle[i];
      EXPECT_GE(triangle, next) << "out of order";
      next = triangle + 1;
      for_each_tile(chunk, i, triangles[triangle].tag,
                    [&](const CoverageTile& tile) { out[triangle].push_back(tile); });
      in_raster_order(out[triangle]);
    }
  });
  count_triangles(engine.counts(), stats);
  return out;
}

::testing::AssertionResult same_counts(const RasterStats& a, const RasterStats& b) {
  const auto list = [](const RasterStats& s) {
    return std::array{
        s.triangles,     s.triangles_zero_area, s.triangles_culled, s.triangles_no_sample,
        s.tiles_covered, s.samples_covered,     s.fragments};
  };
  if (list(a) == list(b)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << ::testing::PrintToString(list(a)) << " and " << ::testing::PrintToString(list(b));
}

// 2000 at a time, to keep their tiles in memory.
void expect_level_bit(const Case& c, std::span<const Triangle> triangles) {
  for (std::size_t first = 0; first < triangles.size(); first += 2000) {
    const auto some =
        triangles.subspan(first, std::min<std::size_t>(2000, triangles.size() - first));
    RasterStats want_stats;
    const std::vector<Tiles> want = level_bit(some, c, want_stats);
    for (const std::string_view isa : coverage_isas()) {
      RasterStats got_stats;
      const std::vector<Tiles> got = level_coverage(some, c, isa, got_stats);
      ASSERT_TRUE(same_counts(want_stats, got_stats)) << isa;
      for (std::size_t i = 0; i < some.size(); ++i) {
        ASSERT_TRUE(got[i] == want[i])
            << isa << ": " << got[i].size() << " tiles, level bit " << want[i].size() << ", "
            << describe(some[i], c.frame, c.config);
      }
    }
  }
}

class CoverageEngineTest : public testing::TestWithParam<Case> {};

TEST_P(CoverageEngineTest, EveryInstructionSetGivesTheMasksOfLevelBit) {
  const Case& c = GetParam();
  expect_level_bit(c, adversarial(c, c.triangles, 1));
}

TEST_P(CoverageEngineTest, TheOracleAgrees) {
  const Case& c = GetParam();
  Random random(2);
  const std::vector<Triangle> triangles = adversarial(c, 330, 3);
  for (const std::string_view isa : coverage_isas()) {
    RasterStats stats;
    const std::vector<Tiles> got = level_coverage(triangles, c, isa, stats);
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
      const oracle::Corners corners = corners_px(triangles[i], c.config);
      const bool front = oracle::turn(corners[0], corners[1], corners[2]) < 0;
      if (c.frame.cull == (front ? Cull::kFront : Cull::kBack)) continue;
      for (const auto& [x, y] : telling_tiles(random, triangles[i], c.frame, c.config, 4)) {
        CoverageTile tile{x, y, {}, 0};
        for (const CoverageTile& t : got[i]) {
          if (t.x == x && t.y == y) tile = t;
        }
        ASSERT_TRUE(same_masks(tile, oracle_tile(corners, x, y, c.frame, c.config), c.config))
            << isa << ": " << describe(triangles[i], c.frame, c.config);
      }
    }
  }
}

// The float path at its bound: triangles as wide as it takes them and a subpixel wider, with the
// steepest and the flattest edges that fit.
TEST_P(CoverageEngineTest, BothPathsMeetExactly) {
  const Case& c = GetParam();
  const Config& config = c.config;
  Random random(4);
  std::vector<Triangle> triangles;
  for (int i = 0; i < 6000; ++i) {
    const std::int64_t extent =
        (std::int64_t{float_extent(config)} << config.subpixel_bits) + random.in(-1, 1);
    const std::int64_t one = std::int64_t{1} << config.subpixel_bits;
    const std::int64_t x = random.in(-extent / 2, c.frame.width * one);
    const std::int64_t y = random.in(-extent / 2, c.frame.height * one);
    Triangle t;
    const auto corner = [&](std::int64_t low) {  // one end or the other, or a little off
      const std::int64_t end = low + (random.in(0, 1) != 0 ? extent : 0);
      const std::int64_t at = end + (random.in(0, 2) != 0 ? 0 : random.in(-2, 2));
      return static_cast<std::int32_t>(
          std::clamp(at, config.coordinate_min(), config.coordinate_max()));
    };
    for (Point& p : t.vertex) {
      p.x = corner(x);
      p.y = corner(y);
    }
    if (i % 2 == 0) {
      t.vertex[2].x = static_cast<std::int32_t>(
          std::clamp(x + random.in(0, extent), config.coordinate_min(), config.coordinate_max()));
    }
    triangles.push_back(t);
  }
  expect_level_bit(c, triangles);
}

TEST_P(CoverageEngineTest, PathIsChosenByTheProvenBound) {
  const Config& config = GetParam().config;
  EXPECT_TRUE(double_is_exact(config));
  const int extent = float_extent(config);
  EXPECT_TRUE(float_is_exact(extent, config.position_bits()));
  EXPECT_TRUE(extent == kWindowReach || !float_is_exact(extent + 1, config.position_bits()));
  const std::int64_t one = std::int64_t{1} << config.subpixel_bits;
  EXPECT_EQ(crossing_path(config, extent * one, 1), CrossingPath::kFloat);
  EXPECT_EQ(crossing_path(config, 1, extent * one + 1), CrossingPath::kDouble);
}

INSTANTIATE_TEST_SUITE_P(Config, CoverageEngineTest, testing::ValuesIn(cases()),
                         [](const testing::TestParamInfo<Case>& c) { return c.param.name; });

// Runs of full tiles, strips of many windows and frames that end inside a tile.
TEST(CoverageFrames, LargeFramesGiveTheMasksOfLevelBit) {
  const std::vector<Case> large{
      {"full", kFull, {1024, 1021, Cull::kNone}},
      {"wide", odd(8, 12, 13, 1, 3), {4096, 33, Cull::kNone}},
      {"tiny", kTiny, {509, 512, Cull::kNone}},
      {"msaa4", kMsaa4, {700, 300, Cull::kNone}},
      {"fine", odd(12, 11, 12, 8, 3), {513, 511, Cull::kNone}},
  };
  for (const Case& c : large) {
    SCOPED_TRACE(c.name);
    std::vector<Triangle> triangles = adversarial(c, 330, 5);
    triangles.resize(430);
    expect_level_bit(c, triangles);
  }
}

// The whole frame of the largest configuration: tile coordinates reach their ends.
TEST(CoverageFrames, LargestFrameIsCoveredOnce) {
  const Config config = odd(8, 15, 0, 1, 3);
  const FrameState frame{32768, 32768, Cull::kNone};
  const std::int32_t end = 32768 << 8;
  const std::vector<Triangle> quad{{{{{0, 0}, {end, 0}, {0, end}}}, 0},
                                   {{{{end, 0}, {end, end}, {0, end}}}, 1}};
  for (const std::string_view isa : coverage_isas()) {
    if (isa == "scalar") continue;  // 17 million tiles, one by one
    CoverageEngine engine(frame, config, isa);
    RasterStats stats;
    engine.cover(quad, [&](const CoverageChunk& chunk) { count_records(chunk, stats); });
    EXPECT_EQ(stats.samples_covered, std::uint64_t{1} << 30) << isa;
  }
}

TEST(CoverageFrames, IllegalVerticesStopTheProgram) {
  Triangle t;
  t.vertex = {{{0, 0}, {static_cast<std::int32_t>(kFull.coordinate_max()) + 1, 0}, {0, 99}}};
  for (const std::string_view isa : coverage_isas()) {
    CoverageEngine engine({64, 64, Cull::kNone}, kFull, isa);
    EXPECT_DEATH(engine.fill({&t, 1}, 0), "") << isa;
  }
}

TEST(HitPlane, CountsAsHitCount) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    std::vector<Triangle> triangles = adversarial(c, 1100, 6);
    HitCount want(c.frame.width, c.frame.height);
    RasterStats stats;
    for (const Triangle& t : triangles) {
      rasterize(t, c.frame, c.config, stats,
                [&](const CoverageTile& tile) { want.add(tile, c.config); });
    }
    CoverageEngine engine(c.frame, c.config);
    HitPlane first(c.frame.width, c.frame.height);
    HitPlane second(c.frame.width, c.frame.height);
    bool even = false;
    for (std::size_t done = 0; done < triangles.size();) {
      done += engine.fill(triangles, done, 64);
      (even ? first : second).add(engine.chunk());
      even = !even;
    }
    first.add(second);
    EXPECT_EQ(first.count(), want.count());
  }
}

}  // namespace
}  // namespace halfspace
