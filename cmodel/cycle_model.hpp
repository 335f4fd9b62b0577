// SPDX-License-Identifier: Apache-2.0
//
// Level cycle: every packet of level bit with the clock at which it changes hands.
#pragma once

#include <bit>

#include "rasterizer.hpp"
#include "timing.hpp"

namespace halfspace {

// Follows triangles through the stages. A listener gets, in depth-first order,
//   accepted(clock)                       the triangle enters setup
//   setup(clock, SetupTriangle)           it leaves setup for level 0
//   node(level, clock, Node)              a node enters `level`, 1 <= level < levels()
//   tile(clock, CoverageTile)             a tile leaves coverage
// Exact in bits and clocks for any stalls. Twin: rtl/hs_rasterizer.sv.
class CycleModel {
 public:
  CycleModel(const FrameState& frame, const Config& config, const Stalls& stalls)
      : frame_(frame), config_(config), timing_(config, stalls) {}

  template <class Listener>
  void draw(const Triangle& triangle, Listener&& listener) {
    ++stats_.triangles;
    const Timing::Clock accepted = timing_.accept();
    finish(accepted);
    listener.accepted(accepted);
    SetupOutcome outcome = SetupOutcome::kDrawn;
    const std::optional<SetupTriangle> ready = triangle_setup(triangle, frame_, config_, &outcome);
    if (!ready) {
      count_drop(outcome, stats_);
      timing_.drop_setup();
      return;
    }
    listener.setup(timing_.enter_root(), *ready);
    follow(root_node(*ready), 0, *ready, listener);
  }

  const RasterStats& stats() const { return stats_; }
  const Timing& timing() const { return timing_; }

  // Clocks from reset to the last edge at which a triangle was accepted or a tile left, included.
  std::uint64_t clocks() const { return clocks_; }

 private:
  void finish(Timing::Clock clock) { clocks_ = std::max(clocks_, clock + 1); }

  template <class Listener>
  void follow(const Node& node, int level, const SetupTriangle& triangle, Listener& listener) {
    ++stats_.traversal.nodes[static_cast<std::size_t>(level)];
    if (level == config_.levels() - 1) {
      leaf(node, triangle, listener);
      return;
    }
    GridMask live = live_children(node, level, triangle, config_);
    if (live == 0) {
      timing_.drop_node(level);
      return;
    }
    timing_.begin_children(level);
    while (live != 0) {
      const Node child = child_node(node, level, std::countr_zero(live), triangle, config_);
      live &= live - 1;
      listener.node(level + 1, timing_.child(level, live == 0), child);
      follow(child, level + 1, triangle, listener);
    }
  }

  template <class Listener>
  void leaf(const Node& node, const SetupTriangle& triangle, Listener& listener) {
    ++stats_.tiles_visited;
    stats_.samples_tested += static_cast<std::uint64_t>(config_.lanes() * config_.samples);
    const std::optional<CoverageTile> covered = coverage(node, triangle, config_);
    if (!covered) {
      timing_.drop_tile();
      return;
    }
    count_tile(*covered, stats_);
    const Timing::Clock clock = timing_.leave_tile();
    finish(clock);
    listener.tile(clock, *covered);
  }

  FrameState frame_;
  Config config_;
  Timing timing_;
  RasterStats stats_;
  std::uint64_t clocks_ = 0;
};

}  // namespace halfspace
