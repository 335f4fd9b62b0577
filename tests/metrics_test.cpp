// SPDX-License-Identifier: Apache-2.0
//
// The fast exact hit counts against the oracle's own answer, pixel by pixel.
#include "oracle/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "vectors/reproducers.hpp"

namespace halfspace::oracle {
namespace {

void expect_as_oracle(const std::vector<Corners>& triangles, int size, const char* what) {
  const std::vector<std::uint32_t> fast = exact_hits(triangles, {size, size, 0, 0});
  const std::vector<std::uint8_t> slow = hit_count(triangles, size, size, standard_samples(1));
  for (std::size_t i = 0; i < slow.size(); ++i) {
    ASSERT_EQ(fast[i], slow[i]) << what << ": pixel " << i % static_cast<std::size_t>(size) << ", "
                                << i / static_cast<std::size_t>(size);
  }
}

TEST(Metrics, RowSpansAreTheOraclesPixels) {
  expect_as_oracle(jittered_mesh({.size = 128, .cell = 16}), 128, "mesh16");
  expect_as_oracle(jittered_mesh({.size = 128, .cell = 4}), 128, "mesh4");
  expect_as_oracle(
      jittered_mesh({.size = 128, .cell = 8, .grid = 1, .phase = 0.5, .square = false}), 128,
      "vertices on centres");
  expect_as_oracle(random_triangles(7, 300, 40, 96), 96, "real-valued, seed 7");
  expect_as_oracle(random_triangles(8, 60, 400, 64), 64, "beyond the frame, seed 8");
  expect_as_oracle(quad_on_samples(), 16, "quad");
  expect_as_oracle({thin_sliver(), collinear()}, 96, "sliver and collinear");
}

TEST(Metrics, WindowAwayFromTheOriginSeesTheSameMesh) {
  const auto here = exact_hits(jittered_mesh({.size = 256, .cell = 16}), {256, 256, 0, 0});
  const auto there =
      exact_hits(jittered_mesh({.size = 256, .cell = 16, .offset = 4096}), {256, 256, 4096, 4096});
  EXPECT_EQ(here, there);
}

TEST(Metrics, PolygonOfOneRingIsItsTriangles) {
  const std::vector<Rings> ring{{diamond()}};
  const auto& d = diamond();
  const std::vector<Corners> halves{{d[0], d[1], d[2]}, {d[0], d[2], d[3]}};
  const Window window{10, 10, 0, 0};
  EXPECT_EQ(exact_hits(ring, window), exact_hits(halves, window));
}

TEST(Metrics, ComparisonTellsGapsFromDoubles) {
  const std::vector<std::uint32_t> exact{1, 1, 1, 0, 2}, hits{1, 0, 2, 1, 2};
  const HitErrors e = compare_hits(hits, exact);
  EXPECT_EQ(e.covered, 4u);
  EXPECT_EQ(e.gaps, 1u);
  EXPECT_EQ(e.doubles, 2u);
  EXPECT_EQ(e.wrong, 3u);
  EXPECT_DOUBLE_EQ(e.ppm(), 750000.0);
  EXPECT_EQ(HitErrors{}.ppm(), 0.0);
  EXPECT_TRUE(std::isinf(compare_hits(hits, std::vector<std::uint32_t>(5)).ppm()));
}

TEST(Metrics, AttributeIsExactAtVerticesAndHyperbolicBetween) {
  const AttributeFacet f{{{{0, 0}, 1, 0}, {{8, 0}, 3, 200}, {{0, 8}, 1, 0}}};
  for (const AttributeVertex& v : f) {
    EXPECT_NEAR(static_cast<double>(attribute_at(f, v.position, true)), v.value, 1e-12);
  }
  // Halfway on the screen is a quarter of the way in the world when w is 1 and 3.
  EXPECT_NEAR(static_cast<double>(attribute_at(f, {4, 0}, true)), 50.0, 1e-12);
  EXPECT_NEAR(static_cast<double>(attribute_at(f, {4, 0}, false)), 100.0, 1e-12);
}

TEST(Metrics, SummaryCountsWhatIsNotANumberApart) {
  ErrorSummary s;
  s.add(3);
  s.add(-4);
  s.add(std::nan(""));
  EXPECT_EQ(s.count, 2u);
  EXPECT_EQ(s.not_finite, 1u);
  EXPECT_EQ(s.greatest, 4.0);
  EXPECT_DOUBLE_EQ(s.rms(), std::sqrt(12.5));
}

}  // namespace
}  // namespace halfspace::oracle
