// SPDX-License-Identifier: Apache-2.0
//
// hs_tile_traversal by itself, at four levels, against live_children(), child_node() and the rules
// of timing.md.
#include "tile_traversal.hpp"

#include "stage_cosim.hpp"

namespace halfspace {
namespace {

std::vector<StagePacket> packets_of(const std::vector<PlacedNode>& nodes, int level,
                                    const Config& config) {
  std::vector<StagePacket> packets;
  for (const auto& [node, setup] : nodes) {
    StagePacket packet{values_of(node, setup, config), {}};
    for (GridMask live = live_children(node, level, setup, config); live != 0; live &= live - 1) {
      const Node child = child_node(node, level, std::countr_zero(live), setup, config);
      packet.out.push_back(values_of(child, setup, config));
    }
    packets.push_back(std::move(packet));
  }
  return packets;
}

void expect_same_level(const StageVariant& variant, const std::vector<StagePacket>& packets,
                       const FrameState& frame, std::uint64_t seed) {
  const Layout layout = traversal_layout(variant.config);
  const StageRun run{tile_traversal_clocks, layout, layout};
  expect_same("tile_traversal", variant, run, packets, frame, seed);
}

TEST(TileTraversalCosim, NodesOfEveryShapeAgreeInBitsAndClocks) {
  constexpr std::uint64_t kSeed = 73;
  for (const StageVariant& variant : tile_traversal_stages()) {
    const Config& config = variant.config;
    const FrameState frame{config.max_size() - 3, config.max_size() - 130, Cull::kNone};
    const std::vector<PlacedNode> nodes = random_nodes(kSeed, 4000, variant.level, frame, config);
    const std::vector<StagePacket> packets = packets_of(nodes, variant.level, config);
    std::size_t children = 0;
    for (const StagePacket& packet : packets) children += packet.out.size();
    EXPECT_GT(children, 4000u);
    ASSERT_NO_FATAL_FAILURE(expect_same_level(variant, packets, frame, kSeed));
  }
}

// Nodes without a live child between nodes with many: they must neither come out nor cost a clock
// that the children before them hide. They are rare: found where triangles are as large as nodes.
TEST(TileTraversalCosim, DeadNodesEndInTheirClock) {
  constexpr std::uint64_t kSeed = 74;
  for (const StageVariant& variant : tile_traversal_stages()) {
    const Config& config = variant.config;
    const int side = std::min(3 << config.node_log2(variant.level) >> 1, config.max_size());
    const FrameState frame{side, side, Cull::kNone};
    std::vector<PlacedNode> chosen;
    std::size_t dead = 0;
    for (const PlacedNode& placed : random_nodes(kSeed, 40'000, variant.level, frame, config)) {
      const bool live = live_children(placed.node, variant.level, placed.setup, config) != 0;
      dead += live ? 0 : 1;
      if (!live || chosen.size() < 4 * dead) chosen.push_back(placed);
    }
    EXPECT_GT(dead, 20u) << variant.name << " level " << variant.level;
    ASSERT_NO_FATAL_FAILURE(
        expect_same_level(variant, packets_of(chosen, variant.level, config), frame, kSeed));
  }
}

}  // namespace
}  // namespace halfspace
