// SPDX-License-Identifier: Apache-2.0
//
// Config::extent_bits: the narrower widths hold every legal triangle, one bit fewer does not, and
// what lies beyond is stopped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "compare.hpp"
#include "engines/coverage/coverage_engine.hpp"
#include "engines/cycle/cycle_engine.hpp"
#include "extremes.hpp"
#include "fixed.hpp"
#include "samples.hpp"
#include "triangle_setup.hpp"

namespace halfspace {
namespace {

Config narrow(int s, int n, int k, int x, int samples = 1) {
  return {.subpixel_bits = s,
          .viewport_bits = n,
          .guard_bits = k,
          .extent_bits = x,
          .samples = samples,
          .grid_log2 = 2};
}

std::vector<Config> small_configs() {
  std::vector<Config> out;
  for (const int samples : {1, 2, 16}) {
    out.push_back(narrow(1, 3, 0, 1, samples));
    out.push_back(narrow(0, 3, 0, 2, samples));
    out.push_back(narrow(2, 3, 0, 2, samples));
    out.push_back(narrow(1, 3, 3, 2, samples));
    out.push_back(narrow(1, 3, 4, 2, samples));
    out.push_back(narrow(1, 3, 5, 2, samples));
  }
  return out;
}

// Every edge that is legal, from every point of the lattice: visit(from, to).
template <class Visit>
void every_edge(const Config& config, Visit&& visit) {
  const auto low = static_cast<int>(config.coordinate_min());
  const auto high = static_cast<int>(config.coordinate_max());
  const auto most = static_cast<int>(config.extent_max());
  for (int y = low; y <= high; ++y) {
    for (int x = low; x <= high; ++x) {
      for (int v = std::max(low, y - most); v <= std::min(high, y + most); ++v) {
        for (int u = std::max(low, x - most); u <= std::min(high, x + most); ++u) {
          visit(Point{x, y}, Point{u, v});
        }
      }
    }
  }
}

struct EdgeExtremes {
  Extremes delta, constant, full, dropped;
};

EdgeExtremes edge_extremes(const Config& config) {
  EdgeExtremes seen;
  const int f = config.position_bits();
  const int up = f - config.subpixel_bits;
  const int last = config.max_size() - 1;
  std::vector<Point> sample;  // the outermost pixels' samples, in 2^-f px
  for (const SamplePosition p : sample_positions(config.samples)) {
    for (const int y : {0, last}) {
      for (const int x : {0, last}) {
        sample.push_back({((16 * x + p.x) << f) >> 4, ((16 * y + p.y) << f) >> 4});
      }
    }
  }
  every_edge(config, [&](Point from, Point to) {
    const std::int64_t a = std::int64_t{from.y} - to.y;
    const std::int64_t b = std::int64_t{to.x} - from.x;
    seen.delta.see(a);
    seen.delta.see(b);
    seen.constant.see(std::int64_t{from.x} * to.y - std::int64_t{to.x} * from.y);
    for (const Point p : sample) {
      const std::int64_t e = a * (p.x - (std::int64_t{from.x} << up)) +
                             b * (p.y - (std::int64_t{from.y} << up)) - 1;  // biased
      seen.full.see(e);
      seen.dropped.see(floor_shift(e, config.dropped_bits()));
    }
  });
  return seen;
}

TEST(Extent, SetupWidthsHoldEveryLegalEdgeAndOneBitFewerDoesNot) {
  for (const Config& config : small_configs()) {
    ASSERT_EQ(validate(config), "");
    const EdgeExtremes seen = edge_extremes(config);
    expect_sharp(seen.delta, config.delta_bits(), "A, B", config);
    expect_sharp(seen.constant, config.constant_bits(), "C", config);
    expect_sharp(seen.full, config.edge_full_bits(), "E", config);
    expect_sharp(seen.dropped, config.edge_bits(), "e", config);
  }
}

TEST(Extent, AreaWidthHoldsEveryLegalTriangleAndOneBitFewerDoesNot) {
  for (const Config& config : {narrow(1, 3, 0, 1), narrow(0, 3, 0, 2), narrow(0, 3, 4, 2)}) {
    // The area does not depend on where the triangle is: one vertex stays.
    Extremes seen;
    const auto most = static_cast<int>(config.extent_max());
    const auto each = [most](auto&& visit) {
      for (int y = -most; y <= most; ++y) {
        for (int x = -most; x <= most; ++x) visit(x, y);
      }
    };
    each([&](int x1, int y1) {
      each([&](int x2, int y2) {
        if (std::abs(x2 - x1) <= most && std::abs(y2 - y1) <= most) seen.see(x1 * y2 - y1 * x2);
      });
    });
    expect_sharp(seen, config.area_bits(), "area", config);
  }
}

// Every triangle of whole-pixel vertices: with its first vertex anywhere, the others anywhere that
// is legal.
template <class Visit>
std::uint64_t every_triangle(const Config& config, Visit&& visit) {
  std::uint64_t count = 0;
  every_edge(config, [&](Point a, Point b) {
    const auto low = static_cast<int>(config.coordinate_min());
    const auto high = static_cast<int>(config.coordinate_max());
    const auto most = static_cast<int>(config.extent_max());
    for (int y = std::max({low, a.y - most, b.y - most});
         y <= std::min({high, a.y + most, b.y + most}); ++y) {
      for (int x = std::max({low, a.x - most, b.x - most});
           x <= std::min({high, a.x + most, b.x + most}); ++x) {
        visit(Triangle{{{a, b, Point{x, y}}}, 0});
        ++count;
      }
    }
  });
  return count;
}

std::vector<CoverageTile> tiles_of(const Triangle& triangle, const Config& config) {
  const FrameState frame{config.max_size(), config.max_size(), Cull::kNone};
  std::vector<CoverageTile> tiles;
  RasterStats unused;
  rasterize(triangle, frame, config, unused,
            [&](const CoverageTile& tile) { tiles.push_back(tile); });
  return tiles;
}

// The checks of every packet run too: a width too small would stop the test.
TEST(Extent, EveryLegalTriangleIsCoveredAsWithoutTheLimit) {
  std::uint64_t triangles = 0;
  for (const Config& config : {narrow(0, 3, 0, 2), narrow(0, 3, 4, 1), narrow(0, 3, 3, 1, 4)}) {
    Config wide = config;
    wide.extent_bits = 0;
    triangles += every_triangle(config, [&](const Triangle& triangle) {
      ASSERT_EQ(tiles_of(triangle, config), tiles_of(triangle, wide))
          << describe(triangle, {8, 8, Cull::kNone}, config);
    });
  }
  EXPECT_GT(triangles, 100'000u);
}

TEST(Extent, LaneWidthIsNeeded) {
  for (const Config& config : {narrow(0, 5, 0, 2), narrow(0, 5, 6, 1)}) {
    const FrameState frame{config.max_size(), config.max_size(), Cull::kNone};
    const int last = config.grid() - 1;
    Extremes seen;
    for (const Triangle& triangle : widest_triangles(config)) {
      const auto setup = triangle_setup(triangle, frame, config);
      if (!setup) continue;
      // A node's edge value anywhere between the clamps: the lanes from there.
      const std::int64_t limit = std::int64_t{1} << (config.node_bits(config.grid_log2) - 1);
      for (const EdgeSlope& slope : setup->slope) {
        for (const std::int64_t base : {-limit, limit - 1}) {
          for (const int lane : {0, 1, 2, 3}) {
            seen.see(base + std::int64_t{slope.a} * (lane & 1) * last +
                     std::int64_t{slope.b} * (lane >> 1) * last);
          }
        }
      }
    }
    expect_sharp(seen, config.lane_bits(), "lane", config);
  }
}

TEST(Extent, AsWideAsTheCoordinatesChangesNoWidth) {
  for (const Preset& preset : kPresets) {
    Config config = preset.config;
    config.extent_bits = (config.has_guard_band() ? config.guard_bits : config.viewport_bits) + 1;
    ASSERT_EQ(validate(config), "");
    EXPECT_EQ(config.delta_bits(), preset.config.delta_bits());
    EXPECT_EQ(config.area_bits(), preset.config.area_bits());
    EXPECT_EQ(config.constant_bits(), preset.config.constant_bits());
    EXPECT_EQ(config.edge_full_bits(), preset.config.edge_full_bits());
    EXPECT_EQ(config.node_bits(5), preset.config.node_bits(5));
    EXPECT_EQ(config.lane_bits(), preset.config.lane_bits());
    ++config.extent_bits;
    EXPECT_EQ(validate(config).rfind("extent_bits = ", 0), 0u);
    config.extent_bits = -1;
    EXPECT_EQ(validate(config).rfind("extent_bits = -1", 0), 0u);
  }
}

TEST(Extent, LongerEdgesAreStoppedByEveryEngineAndShorterAreNot) {
  Config config = kFull;
  config.extent_bits = 4;  // less than 4096 subpixels
  const FrameState frame{640, 480, Cull::kNone};
  const auto run = [&](const Triangle& triangle) {
    std::uint64_t tiles = 0;
    CycleEngine cycle(frame, config, Stalls());
    CoverageEngine coverage(frame, config);
    cycle.run(std::span(&triangle, 1), [&](const CycleChunk&) { ++tiles; });
    coverage.cover(std::span(&triangle, 1), [&](const CoverageChunk&) { ++tiles; });
    return tiles;
  };
  const Triangle widest{{{{100, 200}, {4195, 300}, {200, 4295}}}, 0};
  ASSERT_TRUE(within_extent(widest, config));
  EXPECT_TRUE(triangle_setup(widest, frame, config));
  EXPECT_GT(run(widest), 0u);
  for (std::size_t i = 0; i < 3; ++i) {
    for (const bool in_x : {false, true}) {
      Triangle wider = widest;
      for (Point& p : wider.vertex) p = {std::clamp(p.x, 100, 4195), std::clamp(p.y, 200, 4295)};
      (in_x ? wider.vertex[i].x : wider.vertex[i].y) = in_x ? 4196 + 100 : 4296 + 200;
      EXPECT_FALSE(within_extent(wider, config)) << i << in_x;
      EXPECT_DEATH(triangle_setup(wider, frame, config), "within_extent");
    }
  }
  Triangle wider = widest;
  wider.vertex[1].x = 4196;
  EXPECT_FALSE(within_extent(wider, config));
  EXPECT_DEATH(
      CycleEngine(frame, config, Stalls()).run(std::span(&wider, 1), [](const CycleChunk&) {}),
      "within_extent");
  EXPECT_DEATH(
      CoverageEngine(frame, config).cover(std::span(&wider, 1), [](const CoverageChunk&) {}),
      "within_extent");
}

}  // namespace
}  // namespace halfspace
