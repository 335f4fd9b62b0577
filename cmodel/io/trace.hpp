// SPDX-License-Identifier: Apache-2.0
//
// What changed hands when: recorded from level cycle or from the RTL.
// A log is the handshakes alone, so the same run leaves the same log whichever side it came from.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "../config.hpp"
#include "../packets.hpp"
#include "../stalls.hpp"

namespace halfspace {

// One packet at one handshake. Fields that a link does not have are 0.
struct TraceEvent {
  std::uint64_t clock = 0;
  std::uint32_t tag = 0;  // the triangle's number, modulo 2^tag_bits
  std::int32_t x = 0;     // node or tile: pixel column of its origin
  std::int32_t y = 0;
  std::uint32_t covered = 0;  // tile: samples
  bool operator==(const TraceEvent&) const = default;
};

// Every handshake of one run, from reset until nothing is under way. Link 0: a triangle is
// accepted; 1: it leaves setup; l + 1: a node enters level l of the pyramid, the last of which is
// coverage; levels() + 1: a tile leaves coverage. Each link's events come in the order of clocks;
// the order between links does not matter.
class TraceLog {
 public:
  // stalls: of the run; kept by value.
  TraceLog(const Config& config, const Stalls& stalls)
      : config_(config),
        stalls_(stalls),
        links_(static_cast<std::size_t>(config.levels()) + 2),
        tag_mask_((std::uint64_t{1} << config.tag_bits) - 1) {}

  void accepted(std::uint64_t clock) { add(0, {.clock = clock, .tag = tag(links_[0].size())}); }
  // triangle: its number, or its tag.
  void setup(std::uint64_t clock, std::uint64_t triangle) {
    add(1, {.clock = clock, .tag = tag(triangle)});
  }
  void node(int level, std::uint64_t clock, std::uint64_t triangle, const Node& node) {
    add(level + 1, {.clock = clock, .tag = tag(triangle), .x = node.x, .y = node.y});
  }
  void tile(std::uint64_t clock, std::uint64_t triangle, const CoverageTile& tile) {
    int covered = 0;
    for (const GridMask mask : tile.mask) covered += std::popcount(mask);
    add(config_.levels() + 1, {.clock = clock,
                               .tag = tag(triangle),
                               .x = tile.x,
                               .y = tile.y,
                               .covered = static_cast<std::uint32_t>(covered)});
  }

  const Config& config() const { return config_; }
  const Stalls& stalls() const { return stalls_; }
  const std::vector<TraceEvent>& link(std::size_t index) const { return links_[index]; }
  std::size_t links() const { return links_.size(); }

 private:
  std::uint32_t tag(std::uint64_t triangle) const {
    return static_cast<std::uint32_t>(triangle & tag_mask_);
  }
  void add(int link, const TraceEvent& event) {
    links_[static_cast<std::size_t>(link)].push_back(event);
  }

  Config config_;
  Stalls stalls_;
  std::vector<std::vector<TraceEvent>> links_;
  std::uint64_t tag_mask_;
};

// Listener of CycleModel::draw(), for one triangle after the other.
class ModelTrace {
 public:
  explicit ModelTrace(TraceLog& log) : log_(log) {}
  void accepted(std::uint64_t clock) {
    triangle_ = log_.link(0).size();
    log_.accepted(clock);
  }
  void setup(std::uint64_t clock, const SetupTriangle&) { log_.setup(clock, triangle_); }
  void node(int level, std::uint64_t clock, const Node& node) {
    log_.node(level, clock, triangle_, node);
  }
  void tile(std::uint64_t clock, const CoverageTile& tile) { log_.tile(clock, triangle_, tile); }

 private:
  TraceLog& log_;
  std::uint64_t triangle_ = 0;
};

// The run of level cycle, whole.
TraceLog trace_model(std::span<const Triangle> triangles, const FrameState& frame,
                     const Config& config, const Stalls& stalls);

// One packet at one handshake, with what the rules of docs/03_design/timing.md say of the registers
// between the handshakes.
struct TracePacket {
  std::uint64_t offered = 0;   // first clock in which its valid was high
  std::uint64_t clock = 0;     // in which it was taken
  std::uint64_t ended = 0;     // clock in which the last of what became of it left the next stage;
                               // where it was dropped there, in which it was dropped
  std::uint64_t triangle = 0;  // number, not tag
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::uint32_t covered = 0;
  std::size_t parent = 0;  // index in the link before
  std::size_t first = 0;   // index of its first descendant in the next link
  std::size_t count = 0;   // of them; 0: dropped, or the last link
};

// packets[link][i] belongs to log.link(link)[i]. Throws Error(kInternal) when the log does not fit
// together: a packet without a parent, or one that left before it can have come. Exact for 4 tag
// bits and more.
std::vector<std::vector<TracePacket>> trace_packets(const TraceLog& log);

}  // namespace halfspace
