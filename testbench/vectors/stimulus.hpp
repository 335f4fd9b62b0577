// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <tuple>

#include "depth.hpp"
#include "generators.hpp"
#include "vector_set.hpp"

namespace halfspace {

// What each stage gets of a triangle on its way through the rasterizer.
class StimulusMaker {
 public:
  using Sink = std::function<void(const Values& ports)>;

  explicit StimulusMaker(const VectorMeta& meta) : meta_(meta) {}

  // Forgets the depth buffer: a new frame.
  void begin_frame(const FrameState& frame);

  // Every input of the stage for this triangle, in order. half_plane_grid: every edge and sample of
  // every leaf tile; interpolation: one lane of every covered sample plane of every tile;
  // depth: those planes, against a depth buffer that the triangles before have filled.
  void draw(const ShadedTriangle& triangle, const Sink& sink);

 private:
  void draw_nodes(const SetupTriangle& setup, const Sink& sink) const;
  void draw_tile(const ShadedTriangle& triangle, const SetupTriangle& setup, const Node& node,
                 const Sink& sink);

  VectorMeta meta_;
  FrameState frame_;
  std::map<std::tuple<std::int32_t, std::int32_t, int>, DepthTile> depth_;  // x, y, sample
  std::uint64_t planes_ = 0;
};

// How many leaf tiles a triangle visits, counting no further than `most` + 1.
int count_leaves(const Triangle& triangle, const FrameState& frame, const Config& config, int most);

// Attributes for a triangle that has none: any legal value.
std::array<VertexAttributes, 3> random_attributes(Random& random, const Config& config);

}  // namespace halfspace
