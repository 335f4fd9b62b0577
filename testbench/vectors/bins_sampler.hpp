// SPDX-License-Identifier: Apache-2.0
//
// Part of bins.hpp: what one triangle hits.
#pragma once

#include <array>
#include <optional>

#include "bins.hpp"
#include "samples.hpp"

namespace halfspace {

// Adds to a set when it is made.
class TriangleSampler {
 public:
  TriangleSampler(const BinModel& model, const FrameState& frame, const Triangle& triangle,
                  BinSet& hits);

  // Edges with a sample strictly between their ends, bit i for edge i.
  unsigned tied_edges() const { return tied_; }
  const std::optional<SetupTriangle>& setup() const { return setup_; }

 private:
  // --- What setup sees: bins_sample.cpp
  void sample_cull();
  void sample_degenerate();
  void sample_dropped();
  void sample_setup();
  void sample_box();
  void sample_widths();
  void sample_root_saturation();

  // --- The pyramid: bins_tile.cpp
  // True when the node holds a covered sample. split: the first level with several live children.
  bool follow(const Node& node, int level, std::optional<int>& split);
  bool sample_tile(const Node& node);
  void sample_mask(GridMask mask, int sample);
  void sample_pixels(const CoverageTile& tile);
  // One edge alone decides the tile's first sample plane.
  void sample_cut(const Node& node, GridMask mask);

  // --- Ties: bins_tile.cpp
  // E of edge i, without its bias, at a position in pixel (x, y), S.(s + f).
  std::int64_t edge_at(std::size_t i, std::int64_t x, std::int64_t y, SamplePosition at) const;
  void sample_edge_ties(const Node& node);
  // A sample at a vertex, whether the tile is visited or not.
  void sample_vertex_ties();

  const Config& config_;
  const BinModel::Groups& g_;
  const std::vector<int>& phases_;
  FrameState frame_;
  std::array<Point, 3> v_;
  BinSet& hits_;
  int up_;
  std::int64_t area_ = 0;
  std::optional<SetupTriangle> setup_;
  unsigned tied_ = 0;
};

}  // namespace halfspace
