// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// The pyramid's root for one triangle: the node at (0, 0) that covers the viewport.
inline Node root_node(const SetupTriangle& triangle) { return {0, 0, triangle.e}; }

// One level of the pyramid: the children of a node that the triangle may touch.
//
//   node      at `level`, 0 <= level < levels() - 1
//   triangle  slopes and box
//   return    bit j * grid() + i: for every edge, E >= 0 at child (i, j)'s corner furthest inside
//             (the outermost sample column and row: a sample when there is one per pixel, a safe
//             bound otherwise), and the child overlaps the box
//
// Exact in the widths of config.md (checked). Never clears a child that holds a covered sample; may
// keep one that holds none. Cost: three grids. Twin: rtl/hs_tile_traversal.sv.
GridMask live_children(const Node& node, int level, const SetupTriangle& triangle,
                       const Config& config);

// Child (i, j) = (bit mod grid, bit / grid) of a node at `level`, edge values saturated upwards to
// the child's width.
Node child_node(const Node& node, int level, int bit, const SetupTriangle& triangle,
                const Config& config);

// Nodes handed down per level, the leaf's included; index 0 is the root.
struct TraversalCount {
  std::array<std::uint64_t, 8> nodes{};
};

// All nodes of one triangle in the RTL's order (depth first, lowest child first):
// visit(const Node&, level) for each, the root and the leaf tiles (level == levels() - 1) included.
// Needs no queue: the order is geometry's alone.
template <class Visit>
void visit_nodes(const Node& node, int level, const SetupTriangle& triangle, const Config& config,
                 Visit&& visit) {
  visit(node, level);
  if (level == config.levels() - 1) return;
  for (GridMask live = live_children(node, level, triangle, config); live != 0; live &= live - 1) {
    const Node child = child_node(node, level, std::countr_zero(live), triangle, config);
    visit_nodes(child, level + 1, triangle, config, visit);
  }
}

// The same for callers that want the leaf tiles: leaf(const Node&) for each, in order; `count` is
// added to.
template <class Leaf>
void tile_traversal(const Node& node, int level, const SetupTriangle& triangle,
                    const Config& config, TraversalCount& count, Leaf&& leaf) {
  visit_nodes(node, level, triangle, config, [&](const Node& visited, int at) {
    ++count.nodes[static_cast<std::size_t>(at)];
    if (at == config.levels() - 1) leaf(visited);
  });
}

}  // namespace halfspace
