// SPDX-License-Identifier: Apache-2.0
#include "tile_traversal.hpp"

#include <algorithm>

#include "fixed.hpp"
#include "half_plane_grid.hpp"
#include "samples.hpp"

namespace halfspace {
namespace {

// Least and greatest sample offset within a pixel, in 2^-sample_bits() px.
struct Offsets {
  SamplePosition low;
  SamplePosition high;
};

Offsets sample_offsets(const Config& config) {
  if (config.samples == 1) return {{0, 0}, {0, 0}};
  const SampleExtent extent = sample_extent(config.samples);
  const int shift = 4 - config.sample_bits();
  return {{extent.low.x >> shift, extent.low.y >> shift},
          {extent.high.x >> shift, extent.high.y >> shift}};
}

}  // namespace

GridMask live_children(const Node& node, int level, const SetupTriangle& triangle,
                       const Config& config) {
  const int child_log2 = config.node_log2(level + 1);
  const int q = config.sample_bits();
  const Offsets offset = sample_offsets(config);
  const std::int64_t inside = ((std::int64_t{1} << child_log2) - 1) << q;  // last pixel's origin

  GridMask live = box_mask(node.x, node.y, child_log2, triangle.box, config);
  for (std::size_t i = 0; i < 3; ++i) {
    const EdgeSlope slope = triangle.slope[i];
    HS_CHECK(fits(node.e[i], config.node_bits(config.node_log2(level))));
    // The sample of child (0, 0) that lies furthest inside this edge.
    const std::int64_t corner =
        slope.a * (slope.a > 0 ? inside + offset.high.x : std::int64_t{offset.low.x}) +
        slope.b * (slope.b > 0 ? inside + offset.high.y : std::int64_t{offset.low.y});
    live &= half_plane_grid(floor_shift(node.e[i] + corner, child_log2 + q), slope, config);
  }
  return live;
}

Node child_node(const Node& node, int level, int bit, const SetupTriangle& triangle,
                const Config& config) {
  const int child_log2 = config.node_log2(level + 1);
  const int i = bit & (config.grid() - 1);
  const int j = bit >> config.grid_log2;
  Node child{node.x + (i << child_log2), node.y + (j << child_log2), {}};
  const int width = config.node_bits(child_log2);
  const std::int64_t greatest = (std::int64_t{1} << (width - 1)) - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const EdgeSlope slope = triangle.slope[k];
    const std::int64_t step = (std::int64_t{slope.a} * i + std::int64_t{slope.b} * j)
                              << (child_log2 + config.sample_bits());
    child.e[k] = std::min(node.e[k] + step, greatest);
    HS_CHECK(fits(child.e[k], width));
  }
  return child;
}

}  // namespace halfspace
