// SPDX-License-Identifier: Apache-2.0
#include "trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "../cycle_model.hpp"
#include "error.hpp"

namespace halfspace {
namespace {

using Packets = std::vector<TracePacket>;

[[noreturn]] void misfit(std::size_t link, std::size_t index) {
  throw Error(ErrorCode::kInternal, "--trace",
              fmt::format("packet {} of link {} belongs to none before it", index, link));
}

// timing.md's F[r] of every register, with the clocks of the handshakes as they were instead of as
// they should have been.
class Registers {
 public:
  explicit Registers(const TraceLog& log)
      : log_(log), config_(log.config()), packets_(log.links()) {
    for (std::size_t link = 0; link < log.links(); ++link) {
      for (const TraceEvent& event : log.link(link)) {
        packets_[link].push_back(
            {.clock = event.clock, .x = event.x, .y = event.y, .covered = event.covered});
      }
    }
  }

  std::vector<Packets> run() {
    source();
    setup();
    for (int level = 0; level + 1 < config_.levels(); ++level) traversal(level);
    coverage();
    return std::move(packets_);
  }

 private:
  void source() {
    std::uint64_t next = 0;
    std::uint64_t number = 0;
    for (TracePacket& packet : packets_[0]) {
      packet.triangle = number++;
      packet.offered = next + log_.stalls().gap(packet.triangle);
      if (packet.clock < packet.offered) misfit(0, packet.triangle);
      next = packet.clock + 1;
    }
  }

  void setup() {
    Packets& in = packets_[0];
    Packets& out = packets_[1];
    std::size_t matched = 0;
    for (std::size_t k = 0; k < out.size(); ++k) matched = match_setup(k, matched) + 1;
    std::array<std::uint64_t, 7> free{};
    for (TracePacket& packet : in) {
      std::uint64_t t = std::max(packet.clock + 1, free[2]) +
                        static_cast<std::uint64_t>(config_.setup_interval) - 1;
      for (std::size_t r = 3; r <= 6; ++r) {
        t = std::max(t + 1, free[r]);
        free[r - 1] = t;
      }
      free[6] = leave(packet, t, 1);
    }
  }

  // Setup holds so few triangles that the last one with the tag is the one.
  std::size_t match_setup(std::size_t k, std::size_t from) {
    Packets& in = packets_[0];
    const TraceEvent& event = log_.link(1)[k];
    const auto later = std::lower_bound(
        in.begin(), in.end(), event.clock,
        [](const TracePacket& packet, std::uint64_t clock) { return packet.clock < clock; });
    for (auto i = static_cast<std::size_t>(later - in.begin()); i-- > from;) {
      if (log_.link(0)[i].tag == event.tag) {
        adopt(0, i, k);
        return i;
      }
    }
    misfit(1, k);
  }

  void adopt(std::size_t link, std::size_t parent, std::size_t child) {
    TracePacket& from = packets_[link][parent];
    TracePacket& to = packets_[link + 1][child];
    if (from.count++ == 0) from.first = child;
    to.parent = parent;
    to.triangle = from.triangle;
  }

  // The one descendant, if any, is offered by a stage's last register from the clock after `t` on;
  // nothing: the packet ends there. The clock in which the register becomes free.
  std::uint64_t leave(TracePacket& packet, std::uint64_t t, std::size_t link) {
    packet.ended = t + 1;
    if (packet.count != 0) {
      TracePacket& out = packets_[link][packet.first];
      out.offered = t + 1;
      if (out.clock < out.offered) misfit(link, packet.first);
      packet.ended = out.clock;
    }
    return packet.ended;
  }

  // The packets of the next link that lie in the same square of 2^log2 px, in order.
  void match(std::size_t link, int log2) {
    const std::vector<TraceEvent>& in = log_.link(link);
    const std::vector<TraceEvent>& out = log_.link(link + 1);
    std::size_t k = 0;
    for (std::size_t i = 0; i < in.size(); ++i) {
      while (k < out.size() && out[k].tag == in[i].tag && out[k].x >> log2 == in[i].x >> log2 &&
             out[k].y >> log2 == in[i].y >> log2 && out[k].clock > in[i].clock) {
        adopt(link, i, k++);
      }
    }
    if (k != out.size()) misfit(link + 1, k);
  }

  void traversal(int level) {
    const auto link = static_cast<std::size_t>(level) + 1;
    match(link, config_.node_log2(level));
    std::uint64_t free2 = 0, free3 = 0, free4 = 0, free5 = 0;
    for (TracePacket& node : packets_[link]) {
      std::uint64_t t = std::max(node.clock + 1, free2);
      t = std::max(t + 1, free3);
      free2 = t;
      node.ended = free3 = t + 1;
      if (node.count == 0) continue;
      t = std::max(t + 1, free4);
      free3 = t;
      for (std::size_t k = node.first; k < node.first + node.count; ++k) {
        TracePacket& child = packets_[link + 1][k];
        t = std::max(t + 1, free5);
        child.offered = t + 1;
        if (child.clock < child.offered) misfit(link + 1, k);
        node.ended = free5 = child.clock;
      }
      free4 = t;
    }
  }

  void coverage() {
    const std::size_t link = log_.links() - 2;
    match(link, config_.grid_log2);
    std::uint64_t free2 = 0, free3 = 0, free4 = 0;
    for (TracePacket& tile : packets_[link]) {
      std::uint64_t t = tile.clock;
      if (config_.samples > 1) t = std::max(t + 1, free2);
      t = std::max(t + 1, free3);
      free2 = t;
      t = std::max(t + 1, free4);
      free3 = t;
      free4 = leave(tile, t, link + 1);
    }
  }

  const TraceLog& log_;
  const Config& config_;
  std::vector<Packets> packets_;
};

}  // namespace

TraceLog trace_model(std::span<const Triangle> triangles, const FrameState& frame,
                     const Config& config, const Stalls& stalls) {
  TraceLog log(config, stalls);
  ModelTrace listener(log);
  CycleModel model(frame, config, stalls);
  for (const Triangle& triangle : triangles) model.draw(triangle, listener);
  return log;
}

std::vector<std::vector<TracePacket>> trace_packets(const TraceLog& log) {
  return Registers(log).run();
}

}  // namespace halfspace
