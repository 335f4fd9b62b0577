// SPDX-License-Identifier: Apache-2.0
//
// What the tests of a single stage share: the patterns they run under, and packets of the model to
// feed a stage in the middle.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "rtl/stage/stage_run.hpp"
#include "tile_traversal.hpp"
#include "triangle_setup.hpp"
#include "vectors/generators.hpp"

namespace halfspace {

struct StagePattern {
  double stall;  // gaps before packets and clocks without a taker
  std::uint64_t seed;
  int resets;  // in the middle of things, before the run that is compared
};
// Back to back; some stalls, with resets; mostly stalls.
inline constexpr StagePattern kStagePatterns[] = {{0, 1, 0}, {0.3, 2, 6}, {0.8, 3, 2}};

// The packets through one stage under every pattern; prints seeds and both values at the first
// difference.
inline void expect_same(const char* stage, const StageVariant& variant, const StageRun& run,
                        const std::vector<StagePacket>& packets, const FrameState& frame,
                        std::uint64_t seed, const PortWords& state = {}) {
  const std::unique_ptr<StageRtl> rtl = variant.make();
  for (const StagePattern& pattern : kStagePatterns) {
    rtl->set_frame(frame);
    if (!state.empty()) rtl->set_state(state);
    const std::string difference = compare_stage(
        *rtl, variant, run, packets, Stalls(pattern.stall, pattern.seed), pattern.resets);
    ASSERT_EQ(difference, "") << "stage=" << stage << " config=" << variant.name
                              << " level=" << variant.level << " packets of seed " << seed
                              << ", stalls " << pattern.stall << " of seed " << pattern.seed;
  }
}

struct PlacedNode {
  Node node;
  SetupTriangle setup;
};

// Nodes that enter `level`: down from the roots of triangles of every shape, at every level on the
// way any live child; a few of each triangle.
inline std::vector<PlacedNode> random_nodes(std::uint64_t seed, std::size_t count, int level,
                                            const FrameState& frame, const Config& config) {
  std::vector<PlacedNode> nodes;
  Random random(seed);
  for (std::uint32_t n = 0; nodes.size() < count; ++n) {
    Triangle triangle = random_triangle(random, kShapes[n % kShapes.size()], frame, config);
    triangle.tag = n;
    const std::optional<SetupTriangle> setup = triangle_setup(triangle, frame, config);
    for (int way = 0; setup && way < 3; ++way) {
      Node node = root_node(*setup);
      GridMask live = 1;
      for (int at = 0; at < level && live != 0; ++at) {
        live = live_children(node, at, *setup, config);
        if (live == 0) break;
        for (auto skip = random.in(0, std::popcount(live) - 1); skip > 0; --skip) live &= live - 1;
        node = child_node(node, at, std::countr_zero(live), *setup, config);
      }
      if (live != 0) nodes.push_back({node, *setup});
    }
  }
  return nodes;
}

}  // namespace halfspace
