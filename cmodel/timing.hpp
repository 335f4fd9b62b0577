// SPDX-License-Identifier: Apache-2.0
//
// The clock at which every packet leaves every stage: level cycle. A function of the packets and of
// the stalls outside, not a re-run of registers: each packet is followed once, depth first, and all
// that is remembered of its predecessors is when each register last became free.
// Rules and proof: docs/03_design/timing.md. Twin: the handshakes of rtl/.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "config.hpp"
#include "stalls.hpp"

namespace halfspace {

// Clock 0 is the first clock edge after reset. All results are edges at which a packet changes
// hands. Calls must follow the packets depth first: accept, then drop_setup or enter_root; for the
// node that entered a level, drop_node or begin_children and the children one by one, each followed
// to its end before the next; for a tile that entered coverage, drop_tile or leave_tile.
// Cost: a few additions a call. CycleTiming (engines/cycle/cycle_timing.hpp) adds shortcuts.
class Timing {
 public:
  using Clock = std::uint64_t;

  // stalls: kept by value. config: legal.
  Timing(const Config& config, const Stalls& stalls)
      : stalls_(stalls),
        levels_(config.levels()),
        beats_(static_cast<Clock>(config.setup_interval)),
        many_samples_(config.samples > 1) {
    for (int level = 0; level < levels_; ++level) {
      level_[at(level)].buffered = config.buffered(level);
    }
  }

  // The next triangle is accepted and goes through triangle_setup to its last register.
  Clock accept() {
    const Clock offered = next_offer_ + stalls_.gap(triangles_++);
    accepted_ = std::max(offered, setup_free_[1]);
    next_offer_ = accepted_ + 1;
    // Register 1 hands over one product a clock, all of them once register 2 is free.
    Clock entered = std::max(accepted_ + 1, setup_free_[2]) + beats_ - 1;
    setup_free_[1] = entered;
    for (std::size_t k = 3; k <= 6; ++k) {
      entered = std::max(entered + 1, setup_free_[k]);
      setup_free_[k - 1] = entered;
    }
    setup_entered_ = entered;
    return accepted_;
  }

  // The accepted triangle ends in setup's last register.
  void drop_setup() { setup_free_[6] = setup_entered_ + 1; }

  // The accepted triangle leaves setup for level 0.
  Clock enter_root() {
    setup_free_[6] = enter(level_[0], setup_entered_);
    return setup_free_[6];
  }

  // The node that last entered `level` has no live child.
  void drop_node(int level) {
    Level& l = level_[at(level)];
    l.free3 = to_register3(l) + 1;
  }

  // The node that last entered `level` starts to hand down children.
  void begin_children(int level) {
    Level& l = level_[at(level)];
    l.handed = std::max(to_register3(l) + 1, l.free4);
    l.free3 = l.handed;
  }

  // Its next child enters level + 1. last: no child follows.
  Clock child(int level, bool last) {
    Level& l = level_[at(level)];
    l.handed = std::max(l.handed + 1, l.free5);
    if (last) l.free4 = l.handed;
    l.free5 = enter(level_[at(level + 1)], l.handed);
    return l.free5;
  }

  // The tile that last entered coverage holds no covered sample.
  void drop_tile() { coverage_free4_ = to_register4() + 1; }

  // When the last packet but the one that is in it left the first register of `level`.
  Clock left(int level) const { return level_[at(level)].left; }

  // It is taken by the sink.
  Clock leave_tile() {
    coverage_free4_ = stalls_.next_ready(to_register4() + 1);
    return coverage_free4_;
  }

 protected:
  struct Level {
    bool buffered = false;  // register 1 is a two-entry FIFO
    Clock entered = 0;      // the last packet's edge into register 1
    Clock left = 0;         // when register 1's last occupant left,
    Clock left_before = 0;  // and the one before
    Clock free2 = 0, free3 = 0, free4 = 0, free5 = 0;
    Clock handed = 0;  // the node's, then its last child's edge into register 4, 5
  };

  static constexpr std::size_t at(int level) { return static_cast<std::size_t>(level); }

  // From a register entered at `from` into register 1 of a level.
  static Clock enter(Level& l, Clock from) {
    l.entered = std::max(from + 1, l.buffered ? l.left_before + 1 : l.left);
    return l.entered;
  }
  // Register 1's occupant moves on to a register that is free at `free`.
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
  // Coverage: register 2 is there for more than one sample only.
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
  std::uint64_t triangles_ = 0;
  Clock accepted_ = 0;
  Clock next_offer_ = 0;
  std::array<Clock, 7> setup_free_{};  // [k]: when register k's last occupant left
  Clock setup_entered_ = 0;            // register 6
  std::array<Level, 8> level_{};       // the last one is coverage
  Clock coverage_free4_ = 0;
};

}  // namespace halfspace
