// SPDX-License-Identifier: Apache-2.0
//
// The rules of docs/03_design/timing.md again, for the fast engine: as class Timing, and two closed
// forms for when nothing stalls. Proofs: docs/03_design/cycle.md. Must equal: Timing (timing.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "../config.hpp"
#include "../stalls.hpp"

namespace halfspace {

class CycleTiming {
 public:
  using Clock = std::uint64_t;

  CycleTiming(const Config& config, const Stalls& stalls)
      : stalls_(stalls),
        levels_(config.levels()),
        beats_(static_cast<Clock>(config.setup_interval)),
        many_samples_(config.samples > 1),
        plain_(config.samples == 1 && !stalls.any()) {
    for (int level = 0; level < levels_; ++level) {
      level_[at(level)].buffered = (levels_ - 1 - level) % 2 == 0;
    }
    CycleTiming alone = *this;  // how long a triangle takes through an empty rasterizer
    alone.accept();
    to_root_ = alone.enter_root();
    alone.descend(levels_ - 1);
    latency_ = alone.leave_tile();
  }

  // One sample and no stalls: run_leaves() and the free flow are defined.
  bool plain() const { return plain_; }

  // --- As Timing. ----------------------------------------------------------------------------

  Clock accept() {
    const Clock offered = next_offer_ + stalls_.gap(triangles_++);
    accepted_ = std::max(offered, setup_free_[1]);
    next_offer_ = accepted_ + 1;
    Clock entered = std::max(accepted_ + 1, setup_free_[2]) + beats_ - 1;
    setup_free_[1] = entered;
    for (std::size_t k = 3; k <= 6; ++k) {
      entered = std::max(entered + 1, setup_free_[k]);
      setup_free_[k - 1] = entered;
    }
    setup_entered_ = entered;
    return accepted_;
  }
  void drop_setup() { setup_free_[6] = setup_entered_ + 1; }
  Clock enter_root() {
    setup_free_[6] = enter(level_[0], setup_entered_);
    return setup_free_[6];
  }
  void drop_node(int level) {
    Level& l = level_[at(level)];
    l.free3 = to_register3(l) + 1;
  }
  void begin_children(int level) {
    Level& l = level_[at(level)];
    l.handed = std::max(to_register3(l) + 1, l.free4);
    l.free3 = l.handed;
  }
  Clock child(int level, bool last) {
    Level& l = level_[at(level)];
    l.handed = std::max(l.handed + 1, l.free5);
    if (last) l.free4 = l.handed;
    l.free5 = enter(level_[at(level + 1)], l.handed);
    return l.free5;
  }
  void drop_tile() { coverage_free4_ = to_register4() + 1; }
  Clock leave_tile() {
    coverage_free4_ = stalls_.next_ready(to_register4() + 1);
    return coverage_free4_;
  }

  // --- Shortcuts. ----------------------------------------------------------------------------

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
  struct Level {
    bool buffered = false;
    Clock entered = 0, left = 0, left_before = 0;
    Clock free2 = 0, free3 = 0, free4 = 0, free5 = 0;
    Clock handed = 0;
  };
  using Levels = std::array<Level, 8>;

  static constexpr std::size_t at(int level) { return static_cast<std::size_t>(level); }

  Levels cleared() const {
    Levels out{};
    for (std::size_t i = 0; i < out.size(); ++i) out[i].buffered = level_[i].buffered;
    return out;
  }
  static Clock enter(Level& l, Clock from) {
    l.entered = std::max(from + 1, l.buffered ? l.left_before + 1 : l.left);
    return l.entered;
  }
  static Clock leave1(Level& l, Clock free) {
    l.left_before = l.left;
    l.left = std::max(l.entered + 1, free);
    return l.left;
  }
  static Clock to_register3(Level& l) {
    const Clock entered2 = leave1(l, l.free2);
    l.free2 = std::max(entered2 + 1, l.free3);
    return l.free2;
  }
  Clock to_register4() {
    Level& l = level_[at(levels_ - 1)];
    const Clock entered3 = many_samples_ ? to_register3(l) : leave1(l, l.free3);
    l.free3 = std::max(entered3 + 1, coverage_free4_);
    return l.free3;
  }

  Stalls stalls_;
  int levels_;
  Clock beats_;
  bool many_samples_;
  bool plain_;
  bool flows_ = false;
  Clock to_root_ = 0;
  Clock latency_ = 0;
  std::uint64_t triangles_ = 0;
  Clock accepted_ = 0;
  Clock next_offer_ = 0;
  std::array<Clock, 7> setup_free_{};
  Clock setup_entered_ = 0;
  Levels level_{};
  Clock coverage_free4_ = 0;
};

}  // namespace halfspace
