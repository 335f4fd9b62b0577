// SPDX-License-Identifier: Apache-2.0
//
// The fill rule on the inputs that break other rasterizers: each sample has exactly one owner.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "compare.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

int covered_pixels(const HitCount& hits) {
  return static_cast<int>(
      std::count_if(hits.count().begin(), hits.count().end(), [](auto n) { return n != 0; }));
}

int most(const HitCount& hits) {
  return *std::max_element(hits.count().begin(), hits.count().end());
}

Triangle triangle_px(oracle::Vec a, oracle::Vec b, oracle::Vec c, const Config& config = kFull) {
  return {{snap_px(a.x, a.y, config), snap_px(b.x, b.y, config), snap_px(c.x, c.y, config)}, 0};
}

TEST(FillRule, QuadOnPixelCentresHas64PixelsNoneDouble) {
  const oracle::Vec a{1.5, 1.5}, b{9.5, 1.5}, c{9.5, 9.5}, d{1.5, 9.5};
  for (const auto& [one, other] : {std::pair{triangle_px(a, b, c), triangle_px(a, c, d)},
                                   {triangle_px(b, c, d), triangle_px(b, a, d)}}) {
    const HitCount hits = model_hits({one, other}, {16, 16}, kFull);
    EXPECT_EQ(covered_pixels(hits), 64);
    EXPECT_EQ(most(hits), 1);
    EXPECT_EQ(hits.at(1, 1), 1);  // the top-left corner is in
    EXPECT_EQ(hits.at(9, 1), 0);  // the right column is out
    EXPECT_EQ(hits.at(1, 9), 0);  // the bottom row is out
  }
}

// The picture of docs/03_design/exactness.md.
TEST(FillRule, SquareOfTheDocumentedPictureHasTenAndSixSamples) {
  const Triangle upper = triangle_px({1.5, 1.5}, {5.5, 1.5}, {5.5, 5.5});
  const Triangle lower = triangle_px({1.5, 1.5}, {5.5, 5.5}, {1.5, 5.5});
  EXPECT_EQ(covered_pixels(model_hits({upper}, {7, 7}, kFull)), 10);
  EXPECT_EQ(covered_pixels(model_hits({lower}, {7, 7}, kFull)), 6);
  EXPECT_EQ(covered_pixels(model_hits({upper, lower}, {7, 7}, kFull)), 16);
}

TEST(FillRule, DiamondOnPixelCentresHas32Pixels) {
  const oracle::Vec top{4.5, 0.5}, right{8.5, 4.5}, bottom{4.5, 8.5}, left{0.5, 4.5};
  const HitCount hits = model_hits(
      {triangle_px(top, right, bottom), triangle_px(top, bottom, left)}, {16, 16}, kFull);
  EXPECT_EQ(covered_pixels(hits), 32);
  EXPECT_EQ(most(hits), 1);
}

TEST(FillRule, CollinearVerticesCoverNothing) {
  const HitCount hits =
      model_hits({triangle_px({10.5, 10.5}, {50.5, 50.5}, {90.5, 90.5})}, {100, 100}, kFull);
  EXPECT_EQ(covered_pixels(hits), 0);
}

TEST(FillRule, SliverBetweenRowsCovers29Pixels) {
  const Triangle sliver = triangle_px({1.5, 5.25}, {60.5, 5.5}, {60.5, 5.75});
  EXPECT_EQ(covered_pixels(model_hits({sliver}, {64, 64}, kFull)), 29);
  EXPECT_TRUE(exact(sliver, {64, 64}, kFull));
}

TEST(FillRule, EdgeAlongTheDiagonalThroughTheOriginHasOneOwner) {
  const Triangle upper = triangle_px({0, 0}, {32, 0}, {32, 32});
  const Triangle lower = triangle_px({0, 0}, {32, 32}, {0, 32});
  const HitCount both = model_hits({upper, lower}, {32, 32}, kFull);
  EXPECT_EQ(covered_pixels(both), 32 * 32);
  EXPECT_EQ(most(both), 1);
  // Down the diagonal the upper right triangle's inside is to the right: its left edge.
  EXPECT_EQ(covered_pixels(model_hits({upper}, {32, 32}, kFull)), 32 * 33 / 2);
}

TEST(FillRule, SmallestTriangleAroundASampleCoversItAlone) {
  for (const Config& config : {kTiny, kFull, kD3d}) {
    const std::int32_t one = 1 << config.subpixel_bits;
    const std::int32_t centre = 5 * one + one / 2;
    // The sample strictly inside; on the top-left corner; on the bottom right one.
    const Triangle around{
        {{{centre, centre - 1}, {centre + 1, centre + 1}, {centre - 1, centre + 1}}}, 0};
    const Triangle from{{{{centre, centre}, {centre + 1, centre}, {centre + 1, centre + 1}}}, 0};
    const Triangle upto{{{{centre, centre}, {centre - 1, centre}, {centre - 1, centre - 1}}}, 0};
    const FrameState frame{16, 16};
    EXPECT_EQ(covered_pixels(model_hits({around}, frame, config)), 1) << describe(config);
    EXPECT_EQ(model_hits({around}, frame, config).at(5, 5), 1) << describe(config);
    EXPECT_EQ(covered_pixels(model_hits({from}, frame, config)), 1) << describe(config);
    EXPECT_EQ(covered_pixels(model_hits({upto}, frame, config)), 0) << describe(config);
  }
}

// The square of the Khronos conformance suite's fill rule cases: centre and half-side in normalized
// coordinates (y up), turned by `angle`, in a frame of `size` px, cut along one diagonal.
std::vector<Triangle> turned_square(oracle::Vec centre, double half_side, double angle, int size,
                                    bool other_diagonal) {
  const double c = half_side * std::cos(angle);
  const double s = half_side * std::sin(angle);
  const auto corner = [&](double h, double v) {
    const double x = centre.x + h * c + v * s;
    const double y = centre.y + h * s - v * c;
    return snap_px((x + 1) * size / 2, (1 - y) * size / 2, kFull);
  };
  std::array<Point, 4> p{corner(1, 1), corner(1, -1), corner(-1, -1), corner(-1, 1)};
  if (other_diagonal) std::rotate(p.begin(), p.begin() + 1, p.end());
  return {{{p[0], p[1], p[2]}, 0}, {{p[2], p[0], p[3]}, 1}};
}

void expect_partition(const std::vector<Triangle>& mesh, const std::vector<Triangle>& same_area,
                      const FrameState& frame) {
  const HitCount hits = model_hits(mesh, frame, kFull);
  EXPECT_LE(most(hits), 1);
  EXPECT_TRUE(same_hits(hits, oracle_hits(mesh, frame, kFull)));
  // No hole: the same area cut elsewhere has the same samples.
  EXPECT_TRUE(same_hits(hits, oracle_hits(same_area, frame, kFull)));
}

TEST(FillRule, ConformanceQuadsTurnedByThirtySecondsOfARightAngle) {
  for (int iteration = 0; iteration < 2; ++iteration) {
    std::vector<Triangle> mesh;
    std::vector<Triangle> other;
    for (int cell = 0; cell < 16; ++cell) {
      const oracle::Vec centre{(cell % 4 + 0.5) / 4 * 2 - 1, (cell / 4 + 0.5) / 4 * 2 - 1};
      const double angle = (iteration * 16 + cell) / 32.0 * std::numbers::pi / 2;
      for (const bool diagonal : {false, true}) {
        for (const Triangle& t : turned_square(centre, 0.15, angle, 256, diagonal)) {
          (diagonal ? other : mesh).push_back(t);
        }
      }
    }
    expect_partition(mesh, other, {256, 256});
    for (Triangle& t : mesh) std::swap(t.vertex[0], t.vertex[1]);  // the suite's reversed case
    expect_partition(mesh, other, {256, 256});
  }
}

TEST(FillRule, ConformanceQuadsCutByTheFrame) {
  for (int iteration = 0; iteration < 15; ++iteration) {
    const double angle = iteration / 14.0 * std::numbers::pi / 2;
    const auto part = [angle](bool diagonal) {
      return turned_square({0.5, 0.5}, 1, angle, 64, diagonal);
    };
    expect_partition(part(false), part(true), {64, 64});
    const auto full = turned_square({0, 0}, 2, angle, 64, false);
    expect_partition(full, turned_square({0, 0}, 2, angle, 64, true), {64, 64});
    EXPECT_EQ(covered_pixels(model_hits(full, {64, 64}, kFull)), 64 * 64);
  }
}

// Every pixel of the square exactly once; with several samples, every sample.
void expect_mesh_partitions(std::uint64_t seed, int size, int cell, int step,
                            const Config& config) {
  const FrameState frame{size, size, Cull::kNone};
  std::vector<std::array<std::uint8_t, kMaxSamples>> owners(static_cast<std::size_t>(size) *
                                                            static_cast<std::size_t>(size));
  RasterStats stats;
  for (const Triangle& t : jittered_mesh(seed, size, cell, step, config)) {
    rasterize(t, frame, config, stats, [&](const CoverageTile& tile) {
      for (std::size_t m = 0; m < static_cast<std::size_t>(config.samples); ++m) {
        for (GridMask left = tile.mask[m]; left != 0; left &= left - 1) {
          const int bit = std::countr_zero(left);
          const int pixel = (tile.y + bit / config.grid()) * size + tile.x + bit % config.grid();
          ++owners[static_cast<std::size_t>(pixel)][m];
        }
      }
    });
  }
  std::uint64_t gaps = 0;
  std::uint64_t doubles = 0;
  for (const auto& pixel : owners) {
    for (int m = 0; m < config.samples; ++m) {
      gaps += pixel[static_cast<std::size_t>(m)] == 0 ? 1u : 0u;
      doubles += pixel[static_cast<std::size_t>(m)] > 1 ? 1u : 0u;
    }
  }
  EXPECT_EQ(gaps, 0u) << "cell " << cell << ", seed " << seed << ", " << describe(config);
  EXPECT_EQ(doubles, 0u) << "cell " << cell << ", seed " << seed << ", " << describe(config);
}

TEST(FillRule, JitteredMeshesOwnEachSampleOnce) {
  for (const std::uint64_t seed : {61u, 62u, 63u}) {
    expect_mesh_partitions(seed, 1024, 16, 1, kFull);    // Mesh16
    expect_mesh_partitions(seed, 1024, 4, 1, kFull);     // Mesh4
    expect_mesh_partitions(seed, 1024, 16, 128, kFull);  // MeshH: vertices on half pixels
    expect_mesh_partitions(seed, 512, 4, 1, kTiny);
    expect_mesh_partitions(seed, 256, 16, 16, kMsaa4);  // vertices on sixteenths: on samples
    expect_mesh_partitions(seed, 256, 4, 1, {.subpixel_bits = 4, .samples = 16});
    expect_mesh_partitions(seed, 256, 8, 2, {.subpixel_bits = 2, .samples = 8, .grid_log2 = 2});
  }
}

TEST(FillRule, FanOfTwoThousandSliversOwnsEachPixelOnce) {
  for (const double centre : {512.0, 512.5, 511.171875}) {
    const auto slivers = fan(centre, centre, 500, 2000, kFull);
    const FrameState frame{1024, 1024};
    const HitCount hits = model_hits(slivers, frame, kFull);
    EXPECT_EQ(most(hits), 1);
    for (int y = 0; y < 1024; ++y) {
      for (int x = 0; x < 1024; ++x) {
        const double distance = std::hypot(x + 0.5 - centre, y + 0.5 - centre);
        if (std::abs(distance - 500) < 0.1) continue;  // the rim is a polygon
        ASSERT_EQ(hits.at(x, y), distance < 500 ? 1 : 0) << x << "," << y << ", " << centre;
      }
    }
  }
}

TEST(FillRule, FanOfSliversIsTheOraclesSliverBySliver) {
  const Config config{.viewport_bits = 8, .guard_bits = 9};
  const auto slivers = fan(128.5, 128.5, 120, 500, config);
  EXPECT_TRUE(
      same_hits(model_hits(slivers, {256, 256}, config), oracle_hits(slivers, {256, 256}, config)));
}

}  // namespace
}  // namespace halfspace
