// SPDX-License-Identifier: Apache-2.0
#include "coverage.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "compare.hpp"
#include "fixed.hpp"
#include "samples.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

constexpr Config kOne{.subpixel_bits = 1, .viewport_bits = 4, .guard_bits = 5, .grid_log2 = 2};

// Everything inside but for edge 0, and a box that is no limit.
SetupTriangle half_plane(EdgeSlope slope) {
  SetupTriangle setup;
  setup.slope = {slope, EdgeSlope{0, 1}, EdgeSlope{0, 1}};
  setup.box = {0, 0, 15, 15};
  setup.tag = 77;
  return setup;
}

TEST(Coverage, SampleExactlyOnTheLineIsInside) {
  // E = 2 x - 4 at the pixels' centres: zero in column 2.
  const auto tile = coverage({0, 0, {-4, 0, 0}}, half_plane({2, 0}), kOne);
  ASSERT_TRUE(tile);
  EXPECT_EQ(tile->mask[0], 0b1100'1100'1100'1100u);
  EXPECT_EQ(tile->tag, 77u);
  // One unit less, as the top-left bias takes from the other edges, and it is not.
  EXPECT_EQ(coverage({0, 0, {-5, 0, 0}}, half_plane({2, 0}), kOne)->mask[0],
            0b1000'1000'1000'1000u);
}

TEST(Coverage, BitsRunRightThenDown) {
  SetupTriangle setup = half_plane({0, 1});
  setup.box = {6, 5, 6, 5};  // pixel (2, 1) of the tile at (4, 4)
  const auto tile = coverage({4, 4, {0, 0, 0}}, setup, kOne);
  ASSERT_TRUE(tile);
  EXPECT_EQ(tile->mask[0], GridMask{1} << (1 * 4 + 2));
  EXPECT_EQ(tile->x, 4);
  EXPECT_EQ(tile->y, 4);
}

TEST(Coverage, PixelsOutsideTheBoxAreNotCovered) {
  SetupTriangle setup = half_plane({0, 1});
  setup.box = {0, 0, 9, 5};  // a frame that ends inside the tile at (8, 4)
  EXPECT_EQ(coverage({8, 4, {0, 0, 0}}, setup, kOne)->mask[0], 0b0000'0000'0011'0011u);
  EXPECT_EQ(coverage({12, 4, {0, 0, 0}}, setup, kOne), std::nullopt);
  EXPECT_EQ(coverage({8, 8, {0, 0, 0}}, setup, kOne), std::nullopt);
}

TEST(Coverage, TileWithoutASampleIsNothing) {
  EXPECT_EQ(coverage({0, 0, {-7, 0, 0}}, half_plane({2, 0}), kOne), std::nullopt);
}

TEST(Coverage, EveryEdgeMasksAlike) {
  for (std::size_t i = 0; i < 3; ++i) {
    SetupTriangle setup = half_plane({0, 1});
    setup.slope[i] = {1, 0};
    Node node{0, 0, {0, 0, 0}};
    node.e[i] = -3;
    EXPECT_EQ(coverage(node, setup, kOne)->mask[0], 0b1000'1000'1000'1000u) << "edge " << i;
  }
}

TEST(Coverage, MasksBeyondTheLastSampleAreZero) {
  for (const int samples : {1, 2, 4, 8, 16}) {
    Config config = kOne;
    config.samples = samples;
    const auto tile = coverage({0, 0, {0, 0, 0}}, half_plane({0, 0}), config);
    ASSERT_TRUE(tile);
    for (int m = 0; m < kMaxSamples; ++m) {
      EXPECT_EQ(tile->mask[static_cast<std::size_t>(m)], m < samples ? 0xffffu : 0u);
    }
  }
}

// A line that advances through one pixel in sixteenths reaches the samples in the order of their
// positions in the standard's table.
TEST(Coverage, SampleIsInsideFromItsOwnPositionOn) {
  for (const int samples : {2, 4, 8, 16}) {
    Config config = kOne;
    config.samples = samples;
    const auto standard = oracle::standard_samples(samples);
    const int unit = 1 << config.sample_bits();
    for (int at = 0; at <= unit; ++at) {
      const auto across = coverage({0, 0, {-at, 0, 0}}, half_plane({1, 0}), config);
      const auto down = coverage({0, 0, {-at, 0, 0}}, half_plane({0, 1}), config);
      for (std::size_t m = 0; m < standard.size(); ++m) {
        EXPECT_EQ(across->mask[m] & 1u, standard[m].x * unit >= at ? 1u : 0u)
            << samples << " samples, number " << m << ", x >= " << at;
        EXPECT_EQ(down->mask[m] & 1u, standard[m].y * unit >= at ? 1u : 0u)
            << samples << " samples, number " << m << ", y >= " << at;
      }
    }
  }
}

// Against the definition: E >= 0 at each sample of each pixel, for values at and around zero.
TEST(Coverage, RandomTilesMatchTheDefinition) {
  constexpr std::uint64_t kSeed = 51;
  Random random(kSeed);
  for (const int samples : {1, 2, 4, 8, 16}) {
    for (const int g : {2, 3}) {
      const Config config{.subpixel_bits = 4, .samples = samples, .grid_log2 = g};
      const int unit = 1 << config.sample_bits();
      const auto standard = oracle::standard_samples(samples);
      for (int n = 0; n < 2000; ++n) {
        SetupTriangle setup = half_plane({0, 0});
        Node node{0, 0, {}};
        for (std::size_t i = 0; i < 3; ++i) {
          setup.slope[i] = {static_cast<std::int32_t>(random.in(-40, 40)),
                            static_cast<std::int32_t>(random.in(-40, 40))};
          const std::int64_t steps = random.in(-100, 100);
          node.e[i] = steps * random.in(0, unit);
        }
        const CoverageTile tile = coverage(node, setup, config).value_or(CoverageTile{});
        for (std::size_t m = 0; m < standard.size(); ++m) {
          GridMask expected = 0;
          for (int bit = 0; bit < config.lanes(); ++bit) {
            const double u = unit * (bit % config.grid() + (samples == 1 ? 0 : standard[m].x));
            const double v = unit * (bit / config.grid() + (samples == 1 ? 0 : standard[m].y));
            bool inside = true;
            for (std::size_t i = 0; i < 3; ++i) {
              const double e =
                  static_cast<double>(node.e[i]) + setup.slope[i].a * u + setup.slope[i].b * v;
              inside = inside && e >= 0;
            }
            expected |= GridMask{inside ? 1u : 0u} << bit;
          }
          ASSERT_EQ(tile.mask[m], expected)
              << "sample " << m << " of " << samples << ", number " << n << ", seed " << kSeed;
        }
      }
    }
  }
}

TEST(Coverage, EdgeValueThatDoesNotFitStopsTheProgram) {
  const std::int64_t limit = std::int64_t{1} << (kOne.node_bits(2) - 1);
  EXPECT_DEATH(coverage({0, 0, {limit, 0, 0}}, half_plane({0, 1}), kOne), "node_bits|grid_log2");
  EXPECT_DEATH(coverage({0, 0, {0, 0, -limit - 1}}, half_plane({0, 1}), kOne),
               "node_bits|grid_log2");
}

}  // namespace
}  // namespace halfspace
