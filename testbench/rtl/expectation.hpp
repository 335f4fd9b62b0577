// SPDX-License-Identifier: Apache-2.0
//
// What the model says will change hands between the stages, and when.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "cycle_model.hpp"
#include "rtl_rasterizer.hpp"

namespace halfspace {

// One packet that the model says will change hands: when, of which triangle, and the values of its
// fields (link_layout()).
struct Packet {
  std::uint64_t clock = 0;
  std::uint64_t triangle = 0;
  Values values;
};

// The packets of all links, made on demand, one triangle at a time.
class Expectation {
 public:
  Expectation(std::span<const Triangle> triangles, const FrameState& frame, const Config& config,
              const Stalls& stalls)
      : triangles_(triangles),
        config_(config),
        model_(frame, config, stalls),
        queue_(links(config).size()) {}

  // The next packet of a link, null when there is none left.
  const Packet* next(Link link) {
    std::deque<Packet>& queue = queue_of(link);
    while (queue.empty() && done_ < triangles_.size()) run_one();
    return queue.empty() ? nullptr : &queue.front();
  }
  void pop(Link link) { queue_of(link).pop_front(); }
  const RasterStats& stats() const { return model_.stats(); }
  double seconds() const { return seconds_; }

 private:
  struct Listener {
    Expectation& to;
    SetupTriangle triangle{};

    void accepted(std::uint64_t clock) { to.push(kLinkAccept, clock, {}); }
    void setup(std::uint64_t clock, const SetupTriangle& packet) {
      triangle = packet;
      to.push(kLinkSetup, clock, values_of(packet, to.config_));
    }
    void node(int level, std::uint64_t clock, const Node& packet) {
      to.push(link_into(level), clock, values_of(packet, triangle, to.config_));
    }
    void tile(std::uint64_t clock, const CoverageTile& packet) {
      to.push(kLinkTile, clock, values_of(packet, to.config_));
    }
  };

  std::deque<Packet>& queue_of(Link link) { return queue_[index_of(link, config_)]; }
  void push(Link link, std::uint64_t clock, Values values) {
    queue_of(link).push_back({clock, done_, std::move(values)});
  }
  void run_one() {
    const auto start = std::chrono::steady_clock::now();
    model_.draw(triangles_[done_], Listener{*this});
    ++done_;
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  std::span<const Triangle> triangles_;
  Config config_;
  CycleModel model_;
  std::vector<std::deque<Packet>> queue_;  // by index_of(link)
  std::size_t done_ = 0;
  double seconds_ = 0;
};

}  // namespace halfspace
