// SPDX-License-Identifier: Apache-2.0
//
// The rules of time, and two closed forms of them for when nothing stalls. Proofs:
// docs/03_design/cycle_engine.md. Must equal: the calls of Timing that each stands for.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "../../timing.hpp"

namespace halfspace {

class CycleTiming : public Timing {
 public:
  CycleTiming(const Config& config, const Stalls& stalls)
      : Timing(config, stalls), plain_(config.samples == 1 && !stalls.any()) {
    CycleTiming alone = *this;  // how long a triangle takes through an empty rasterizer
    alone.accept();
    to_root_ = alone.enter_root();
    alone.descend(levels_ - 1);
    latency_ = alone.leave_tile();
  }

  // One sample and no stalls: run_leaves() and the free flow are defined.
  bool plain() const { return plain_; }

  // From the root's entry to that of a node at `level`, one child at every level.
  void descend(int level) {
    for (int l = 0; l < level; ++l) {
      begin_children(l);
      child(l, true);
    }
  }

  // plain() only: all `count` >= 1 children of a node at level levels - 2, whose begin_children()
  // is done. Returns the clock of the first tile; tile i leaves, or is dropped, i clocks later.
  Clock run_leaves(std::uint64_t count) {
    Level& node = level_[at(levels_ - 2)];
    Level& leaf = level_[at(levels_ - 1)];
    Clock handed = node.handed, free5 = node.free5;
    Clock left = leaf.left, left_before = leaf.left_before;
    Clock entered4 = leaf.free3, free4 = coverage_free4_, first = 0;
    const std::uint64_t steps = count < 5 ? count : 1;
    for (std::uint64_t i = 0; i < steps; ++i) {
      handed = std::max(handed + 1, free5);
      free5 = std::max(handed, left_before) + 1;
      left_before = left;
      left = std::max(free5 + 1, entered4);
      entered4 = std::max(left + 1, free4);
      free4 = entered4 + 1;
      if (i == 0) first = free4;
    }
    if (count >= 5) {  // from the fifth on every register is as full as it gets
      free4 = first + count - 1;
      entered4 = free4 - 1;
      left = free4 - 2;
      left_before = free4 - 3;
      free5 = free4 - 3;
      handed = free4 - 4;
    }
    node.handed = node.free4 = handed;
    node.free5 = free5;
    leaf.left = left;
    leaf.left_before = left_before;
    leaf.free3 = entered4;
    coverage_free4_ = free4;
    return first;
  }

  // Free flow: the last triangle met no occupied register on its way, so neither will the next as
  // long as each node has at most one live child. Then times are those of an empty rasterizer.
  bool flows() const { return flows_; }
  Clock accept_flowing() {
    accepted_ += beats_;
    return accepted_;
  }
  Clock root_flowing() const { return accepted_ + to_root_; }
  Clock tile_flowing() const { return accepted_ + latency_; }

  // Ends the free flow after the last triangle.
  void stop_flow() {
    const Clock accepted = accepted_;
    level_ = cleared();
    setup_free_ = {};
    coverage_free4_ = 0;
    flows_ = false;
    next_offer_ = accepted;
    accept();
    enter_root();
    descend(levels_ - 1);
    leave_tile();
  }
  // Ends it in the middle of a triangle whose node at `level` has several live children: brings the
  // state to the entry of that node.
  void stop_flow(int level) {
    accepted_ -= beats_;
    stop_flow();  // after the triangle before
    accept();
    enter_root();
    descend(level);
  }
  // After a triangle of one leaf tile, done with the calls above: does everything flow again?
  void try_flow() { flows_ = plain_ && coverage_free4_ == accepted_ + latency_; }

 private:
  std::array<Level, 8> cleared() const {
    std::array<Level, 8> out{};
    for (std::size_t i = 0; i < out.size(); ++i) out[i].buffered = level_[i].buffered;
    return out;
  }

  bool plain_;
  bool flows_ = false;
  Clock to_root_ = 0;
  Clock latency_ = 0;
};

}  // namespace halfspace
