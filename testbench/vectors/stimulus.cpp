// SPDX-License-Identifier: Apache-2.0
#include "stimulus.hpp"

#include <algorithm>
#include <bit>

#include "coverage.hpp"
#include "fixed.hpp"
#include "packets_of.hpp"
#include "samples.hpp"
#include "tile_traversal.hpp"
#include "triangle_setup.hpp"

namespace halfspace {
namespace {

// Leaf tiles below a node, added to `count` until it passes `most`.
void count_below(const Node& node, int level, const SetupTriangle& setup, const Config& config,
                 int most, int& count) {
  if (count > most) return;
  if (level == config.levels() - 1) {
    ++count;
    return;
  }
  for (GridMask live = live_children(node, level, setup, config); live != 0 && count <= most;
       live &= live - 1) {
    count_below(child_node(node, level, std::countr_zero(live), setup, config), level + 1, setup,
                config, most, count);
  }
}

// The grids of one leaf tile: where coverage starts them.
void grids(const Node& node, const SetupTriangle& setup, const Config& config,
           const StimulusMaker::Sink& sink) {
  for (int m = 0; m < config.samples; ++m) {
    const SamplePosition offset = sample_offset(config, m);
    for (std::size_t i = 0; i < 3; ++i) {
      const EdgeSlope slope = setup.slope[i];
      const std::int64_t e =
          node.e[i] + std::int64_t{slope.a} * offset.x + std::int64_t{slope.b} * offset.y;
      sink({floor_shift(e, config.sample_bits()), slope.a, slope.b});
    }
  }
}

}  // namespace

void StimulusMaker::begin_frame(const FrameState& frame) {
  frame_ = frame;
  depth_.clear();
}

void StimulusMaker::draw(const ShadedTriangle& triangle, const Sink& sink) {
  if (meta_.stage <= VectorStage::kTriangleSetup) {
    sink(values_of(triangle.triangle, meta_.config));
    return;
  }
  const auto setup = triangle_setup(triangle.triangle, frame_, meta_.config);
  if (!setup) return;
  if (meta_.stage <= VectorStage::kCoverage) {
    draw_nodes(*setup, sink);
    return;
  }
  visit_nodes(root_node(*setup), 0, *setup, meta_.config, [&](const Node& node, int level) {
    if (level == meta_.config.levels() - 1) draw_tile(triangle, *setup, node, sink);
  });
}

void StimulusMaker::draw_nodes(const SetupTriangle& setup, const Sink& sink) const {
  const Config& config = meta_.config;
  const bool grid = meta_.stage == VectorStage::kHalfPlaneGrid;
  const int wanted = meta_.stage == VectorStage::kTileTraversal ? meta_.level : config.levels() - 1;
  visit_nodes(root_node(setup), 0, setup, config, [&](const Node& node, int level) {
    if (level != wanted) return;
    if (grid) {
      grids(node, setup, config, sink);
    } else {
      sink(values_of(node, setup, config));
    }
  });
}

void StimulusMaker::draw_tile(const ShadedTriangle& triangle, const SetupTriangle& setup,
                              const Node& node, const Sink& sink) {
  const Config& config = meta_.config;
  const auto tile = coverage(node, setup, config);
  if (!tile) return;
  const InterpolationSetup planes =
      interpolation_setup(setup, triangle.triangle, triangle.attributes, 0, config);
  for (int m = 0; m < config.samples; ++m) {
    const GridMask mask = tile->mask[static_cast<std::size_t>(m)];
    if (mask == 0) continue;
    ++planes_;
    if (meta_.stage == VectorStage::kInterpolation) {
      // First and last covered lanes in turn.
      const int lane = (planes_ & 1u) == 0 ? std::countr_zero(mask) : 63 - std::countl_zero(mask);
      sink(values_of(InterpolationInput{setup, triangle.triangle, triangle.attributes, node.x,
                                        node.y, m, lane},
                     config));
      continue;
    }
    const auto [entry, fresh] = depth_.try_emplace({node.x, node.y, m});
    if (fresh) entry->second.fill(config.depth_max());
    TilePlane plane = tile_plane(planes.depth, planes.origin, node.x, node.y, config);
    plane.base += sample_delta(planes.depth, m, config);
    const auto function = static_cast<DepthFunction>(planes_ % kDepthFunctions);
    sink(values_of(DepthInput{mask, plane, function, entry->second}, config));
    depth_test(mask, plane, function, entry->second, config);
  }
}

int count_leaves(const Triangle& triangle, const FrameState& frame, const Config& config,
                 int most) {
  int count = 0;
  if (const auto setup = triangle_setup(triangle, frame, config)) {
    count_below(root_node(*setup), 0, *setup, config, most, count);
  }
  return count;
}

std::array<VertexAttributes, 3> random_attributes(Random& random, const Config& config) {
  std::array<VertexAttributes, 3> out;
  const std::int64_t depth_most =
      (std::int64_t{1} << kPlaneBits) - (1 << std::max(kPlaneBits - config.depth_bits, 0));
  const std::int64_t w_most = (std::int64_t{1} << config.inverse_w_bits) - 1;
  for (VertexAttributes& vertex : out) {
    vertex.depth = static_cast<std::int32_t>(random.in(0, depth_most));
    vertex.inverse_w = static_cast<std::uint32_t>(random.in(1, w_most));
    for (std::size_t n = 0; n < static_cast<std::size_t>(config.attributes); ++n) {
      vertex.value[n] = static_cast<std::int32_t>(random.in(0, 255 << kAttributeFractionBits));
    }
  }
  // The greatest of the three has its top bit set.
  out[static_cast<std::size_t>(random.in(0, 2))].inverse_w |= 1u << (config.inverse_w_bits - 1);
  return out;
}

}  // namespace halfspace
