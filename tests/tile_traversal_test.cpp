// SPDX-License-Identifier: Apache-2.0
#include "tile_traversal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <vector>

#include "compare.hpp"
#include "fixed.hpp"
#include "samples.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

using Wide = __int128;

// A configuration whose pyramid, with g = 2, is deeper than it needs for small frames.
Config deep(int samples, int s) {
  return {
      .subpixel_bits = s, .viewport_bits = 6, .guard_bits = 7, .samples = samples, .grid_log2 = 2};
}

// Edge i's biased value at a node's origin, never saturated: the oracle of this file. S.(s+q) px^2.
Wide unsaturated(const Triangle& t, std::size_t i, const SetupTriangle& setup, int x, int y,
                 const Config& config) {
  const Point from = t.vertex[i];  // E is zero on the line through it, whichever way it runs
  const int f = config.position_bits();
  const Wide centre = config.samples == 1 ? Wide{1} << (f - 1) : 0;
  const auto offset = [&](int pixel, std::int32_t vertex) {
    return (Wide{pixel} << f) + centre - (Wide{vertex} << (f - config.subpixel_bits));
  };
  const EdgeSlope slope = setup.slope[i];
  const bool keeps_ties = slope.a > 0 || (slope.a == 0 && slope.b > 0);
  const Wide e = slope.a * offset(x, from.x) + slope.b * offset(y, from.y) - (keeps_ties ? 0 : 1);
  return e >> config.dropped_bits();
}

// Nodes of a random way down the pyramid, the root first: at every level any live child.
std::vector<Node> random_way(Random& random, const SetupTriangle& setup, const Config& config) {
  std::vector<Node> way{root_node(setup)};
  for (int level = 0; level + 1 < config.levels(); ++level) {
    GridMask live = live_children(way.back(), level, setup, config);
    if (live == 0) break;
    for (auto skip = random.in(0, std::popcount(live) - 1); skip > 0; --skip) live &= live - 1;
    way.push_back(child_node(way.back(), level, std::countr_zero(live), setup, config));
  }
  return way;
}

// Triangles of every shape, and the widest, in the largest frame of a configuration.
template <class Visit>
void for_each_triangle(std::uint64_t seed, int each, const Config& config, Visit&& visit) {
  Random random(seed);
  const FrameState frame{config.max_size(), config.max_size(), Cull::kNone};
  for (int n = 0; n < each; ++n) {
    for (const Shape shape : kShapes) {
      const Triangle t = random_triangle(random, shape, frame, config);
      const auto setup = triangle_setup(t, frame, config);
      if (setup) visit(t, *setup, frame, random);
    }
  }
  for (const Triangle& t : widest_triangles(config)) {
    const auto setup = triangle_setup(t, frame, config);
    if (setup) visit(t, *setup, frame, random);
  }
}

std::vector<Config> configs() {
  return {kTiny,
          kFull,
          kD3d,
          kMsaa4,
          {.subpixel_bits = 0, .samples = 16},
          {.subpixel_bits = 12, .viewport_bits = 15, .guard_bits = 16, .samples = 8},
          {.guard_bits = 0},
          {.grid_log2 = 2},
          {.subpixel_bits = 3, .viewport_bits = 4, .guard_bits = 16, .samples = 2}};
}

// docs/03_design/config.md: whatever path led to a node, its values are the true ones cut at the
// greatest its width holds.
TEST(TileTraversal, NodeValuesAreTheTrueOnesCutAtTheTop) {
  constexpr std::uint64_t kSeed = 41;
  std::uint64_t nodes = 0;
  std::uint64_t cut = 0;
  for (const Config& config : configs()) {
    for_each_triangle(
        kSeed, 200, config,
        [&](const Triangle& t, const SetupTriangle& setup, const FrameState& frame,
            Random& random) {
          const std::vector<Node> way = random_way(random, setup, config);
          for (std::size_t level = 1; level < way.size(); ++level) {
            const int width = config.node_bits(config.node_log2(static_cast<int>(level)));
            const Wide greatest = (Wide{1} << (width - 1)) - 1;
            for (std::size_t i = 0; i < 3; ++i) {
              const Wide truth = unsaturated(t, i, setup, way[level].x, way[level].y, config);
              ASSERT_EQ(Wide{way[level].e[i]} == std::min(truth, greatest), true)
                  << "level " << level << " edge " << i << " node " << way[level].x << ","
                  << way[level].y << ": model " << way[level].e[i] << ", true "
                  << static_cast<std::int64_t>(truth) << ", seed " << kSeed << ": "
                  << describe(t, frame, config);
              ++nodes;
              cut += truth > greatest ? 1u : 0u;
            }
          }
        });
  }
  EXPECT_GT(nodes, 20'000u);
  EXPECT_GT(cut, nodes / 10);
}

// A child is live when every edge is non-negative somewhere in its square of samples and it
// overlaps the box: from unsaturated values, by trying the square's corners.
TEST(TileTraversal, LivenessIsWhatUnsaturatedEdgesSay) {
  constexpr std::uint64_t kSeed = 42;
  for (const Config& config : configs()) {
    const bool one = config.samples == 1;
    const int q = config.sample_bits();
    const SampleExtent extent = sample_extent(config.samples);
    const auto units = [q](int sixteenths) { return (sixteenths << q) >> 4; };
    for_each_triangle(
        kSeed, 60, config,
        [&](const Triangle& t, const SetupTriangle& setup, const FrameState& frame,
            Random& random) {
          const std::vector<Node> way = random_way(random, setup, config);
          for (int level = 0;
               level < std::min<int>(config.levels() - 1, static_cast<int>(way.size())); ++level) {
            const Node& node = way[static_cast<std::size_t>(level)];
            const int side = 1 << config.node_log2(level + 1);
            GridMask expected = 0;
            for (int bit = 0; bit < config.lanes(); ++bit) {
              const int x = node.x + bit % config.grid() * side;
              const int y = node.y + bit / config.grid() * side;
              bool live = x <= setup.box.x_last && x + side > setup.box.x_first &&
                          y <= setup.box.y_last && y + side > setup.box.y_first;
              for (std::size_t i = 0; i < 3 && live; ++i) {
                const Wide e = unsaturated(t, i, setup, x, y, config);
                bool somewhere = false;
                for (const int corner : {0, 1, 2, 3}) {
                  const int u = (corner & 1) == 0
                                    ? (one ? 0 : units(extent.low.x))
                                    : ((side - 1) << q) + (one ? 0 : units(extent.high.x));
                  const int v = (corner & 2) == 0
                                    ? (one ? 0 : units(extent.low.y))
                                    : ((side - 1) << q) + (one ? 0 : units(extent.high.y));
                  somewhere =
                      somewhere || e + Wide{setup.slope[i].a} * u + Wide{setup.slope[i].b} * v >= 0;
                }
                live = somewhere;
              }
              expected |= GridMask{live ? 1u : 0u} << bit;
            }
            ASSERT_EQ(live_children(node, level, setup, config), expected)
                << "level " << level << " node " << node.x << "," << node.y << ", seed " << kSeed
                << ": " << describe(t, frame, config);
          }
        });
  }
}

TEST(TileTraversal, NeverClearsAChildThatHoldsAnOwnedSample) {
  constexpr std::uint64_t kSeed = 43;
  Random random(kSeed);
  for (const int samples : {1, 2, 4, 8, 16}) {
    for (const int s : {0, 2, 8}) {
      const Config config = deep(samples, s);
      const FrameState frame{64, 64, Cull::kNone};
      for (int n = 0; n < 66; ++n) {
        const Triangle t = random_triangle(
            random, kShapes[static_cast<std::size_t>(n) % kShapes.size()], frame, config);
        const auto hits = oracle_hits({t}, frame, config);
        std::vector<bool> reached(hits.size());
        if (const auto setup = triangle_setup(t, frame, config)) {
          TraversalCount count;
          tile_traversal(root_node(*setup), 0, *setup, config, count, [&](const Node& leaf) {
            for (int bit = 0; bit < config.lanes(); ++bit) {
              reached[static_cast<std::size_t>((leaf.y + bit / 4) * 64 + leaf.x + bit % 4)] = true;
            }
          });
        }
        for (std::size_t pixel = 0; pixel < hits.size(); ++pixel) {
          ASSERT_TRUE(hits[pixel] == 0 || reached[pixel])
              << "pixel " << pixel % 64 << "," << pixel / 64 << ", seed " << kSeed << ": "
              << describe(t, frame, config);
        }
      }
    }
  }
}

// Which child of which child a leaf is, as one number: its place in the order of the contract.
std::int64_t place(const Node& leaf, const Config& config) {
  std::int64_t key = 0;
  for (int level = 1; level < config.levels(); ++level) {
    const int shift = config.node_log2(level);
    const int i = (leaf.x >> shift) & (config.grid() - 1);
    const int j = (leaf.y >> shift) & (config.grid() - 1);
    key = key * config.lanes() + j * config.grid() + i;
  }
  return key;
}

TEST(TileTraversal, LeavesComeDepthFirstLowestChildFirstAndOnce) {
  constexpr std::uint64_t kSeed = 44;
  for (const Config& config : {kTiny, deep(4, 4), Config{.viewport_bits = 9, .guard_bits = 10}}) {
    for_each_triangle(
        kSeed, 20, config,
        [&](const Triangle& t, const SetupTriangle& setup, const FrameState& frame, Random&) {
          if (t.vertex[0].x % 7 != 0 && config == kTiny) return;  // a sample of the large ones
          std::int64_t before = -1;
          TraversalCount count;
          std::uint64_t leaves = 0;
          tile_traversal(root_node(setup), 0, setup, config, count, [&](const Node& leaf) {
            ASSERT_EQ(leaf.x % config.grid(), 0);
            ASSERT_EQ(leaf.y % config.grid(), 0);
            const std::int64_t now = place(leaf, config);
            ASSERT_GT(now, before) << "leaf " << leaf.x << "," << leaf.y << ", seed " << kSeed
                                   << ": " << describe(t, frame, config);
            before = now;
            ++leaves;
          });
          ASSERT_EQ(count.nodes[0], 1u);
          ASSERT_EQ(count.nodes[static_cast<std::size_t>(config.levels() - 1)], leaves);
        });
  }
}

TEST(TileTraversal, CountsNodesOfEveryLevel) {
  const Config config{.viewport_bits = 9, .guard_bits = 10};  // three levels: 512, 64, 8 px
  const auto count_of = [&config](const Triangle& t, int size) {
    const auto setup = triangle_setup(t, {size, size, Cull::kNone}, config);
    TraversalCount count;
    tile_traversal(root_node(*setup), 0, *setup, config, count, [](const Node&) {});
    return count.nodes;
  };
  using Nodes = std::array<std::uint64_t, 8>;
  const std::int32_t far = 1000 * 256;
  const Triangle beside{{{{-far, -far}, {far, -far}, {-far, far}}}, 0};  // x + y < 0
  EXPECT_EQ(count_of(beside, 512), (Nodes{1, 0, 0}));
  const Triangle upper{{{{-far, -far}, {far, -far}, {far, far}}}, 0};  // x > y
  EXPECT_EQ(count_of(upper, 512), (Nodes{1, 8 * 9 / 2, 64 * 65 / 2}));
  EXPECT_EQ(count_of(upper, 64), (Nodes{1, 1, 8 * 9 / 2}));
  const Triangle dot{{{{1280, 1280}, {1536, 1280}, {1280, 1536}}}, 0};  // pixel (5, 5)
  EXPECT_EQ(count_of(dot, 512), (Nodes{1, 1, 1}));
}

TEST(TileTraversal, SingleLevelPyramidIsTheLeafItself) {
  const Config config{.viewport_bits = 3, .guard_bits = 4};
  ASSERT_EQ(config.levels(), 1);
  const auto setup =
      triangle_setup({{{{0, 0}, {2048, 0}, {0, 2048}}}, 0}, {8, 8, Cull::kNone}, config);
  ASSERT_TRUE(setup);
  TraversalCount count;
  std::vector<Node> leaves;
  tile_traversal(root_node(*setup), 0, *setup, config, count,
                 [&](const Node& leaf) { leaves.push_back(leaf); });
  EXPECT_EQ(leaves, std::vector<Node>{root_node(*setup)});
}

}  // namespace
}  // namespace halfspace
