// SPDX-License-Identifier: Apache-2.0
//
// One frame of a model behind the C interface: triangles in, what was asked for kept.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "../engines/cycle/cycle_engine.hpp"
#include "../geometry.hpp"
#include "halfspace.h"

namespace halfspace::capi {

// Throws Refusal when an edge is longer than Config::extent_bits allows.
void check_extent(const Triangle& triangle, const Config& config);

class Frame {
 public:
  // Throws Refusal when a field of `request` is out of range.
  Frame(const hs_frame& request, const Config& config);

  const hs_frame& request() const { return request_; }
  const FrameState& state() const { return state_; }
  bool keeps(std::uint32_t output) const { return (outputs_ & output) != 0; }

  // Legal triangles in snapped coordinates. Memory: what they leave to be pulled.
  void draw(std::span<const ShadedTriangle> triangles);
  // Clips first.
  void draw_clip(const std::array<ClipVertex, 3>& triangle, std::uint32_t tag);
  // Triangles given to draw() as they came, or made elsewhere by a geometry stage.
  void count_in(const GeometryStats& stats);

  std::deque<hs_tile>& tiles() { return tiles_; }
  std::deque<hs_fragment>& fragments() { return fragments_; }
  const std::vector<hs_triangle_clocks>& clocks() const { return clocks_; }
  const std::vector<std::uint8_t>& hits() const;
  const Rasterizer* rasterizer() const { return rasterizer_.get(); }
  // All but struct_size and the CRC.
  hs_stats stats() const;

 private:
  template <bool kSetup>
  struct Listener;
  void take(std::uint64_t clock, const CoverageTile& tile);

  hs_frame request_;
  Config config_;
  FrameState state_;
  std::uint32_t outputs_;
  std::optional<HitCount> hits_;            // without a rasterizer, which has its own
  std::unique_ptr<Rasterizer> rasterizer_;  // where depth is asked for
  CycleEngine engine_;
  GeometryStats counted_;
  std::vector<ShadedTriangle> pieces_;
  std::uint64_t triangles_ = 0;  // that entered the hardware
  std::deque<hs_tile> tiles_;
  std::deque<hs_fragment> fragments_;
  std::vector<hs_triangle_clocks> clocks_;
};

}  // namespace halfspace::capi
