// SPDX-License-Identifier: Apache-2.0
#include "cosim.hpp"

#include <fmt/format.h>

#include <chrono>
#include <deque>
#include <stdexcept>

#include "cycle_model.hpp"

namespace halfspace {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string stage_name(int link, const Config& config) {
  if (link == kLinkAccept) return "accept";
  if (link == kLinkSetup) return "triangle_setup";
  if (link == link_output(config)) return "coverage";
  return fmt::format("tile_traversal[{}]", link - 2);
}

// What the model says will change hands, and when. One struct for all links keeps the queues alike;
// a field that a link does not have stays at its default on both sides.
struct Packet {
  std::uint64_t clock = 0;
  std::uint64_t triangle = 0;
  SetupTriangle setup;
  Node node;
  CoverageTile tile;
};

// The packets of all links, made on demand, one triangle at a time.
class Expectation {
 public:
  Expectation(std::span<const Triangle> triangles, const FrameState& frame, const Config& config,
              const Stalls& stalls)
      : triangles_(triangles),
        config_(config),
        model_(frame, config, stalls),
        queue_(static_cast<std::size_t>(link_output(config) + 1)) {}

  // The next packet of a link, null when there is none left.
  const Packet* next(int link) {
    std::deque<Packet>& queue = queue_[static_cast<std::size_t>(link)];
    while (queue.empty() && done_ < triangles_.size()) run_one();
    return queue.empty() ? nullptr : &queue.front();
  }
  void pop(int link) { queue_[static_cast<std::size_t>(link)].pop_front(); }
  const RasterStats& stats() const { return model_.stats(); }
  double seconds() const { return seconds_; }

 private:
  struct Listener {
    Expectation& to;
    void accepted(std::uint64_t clock) { to.push(kLinkAccept, clock); }
    void setup(std::uint64_t clock, const SetupTriangle& packet) {
      to.push(kLinkSetup, clock).setup = packet;
    }
    void node(int level, std::uint64_t clock, const Node& packet) {
      to.push(level + 1, clock).node = packet;
    }
    void tile(std::uint64_t clock, const CoverageTile& packet) {
      to.push(link_output(to.config_), clock).tile = packet;
    }
  };

  Packet& push(int link, std::uint64_t clock) {
    Packet& packet = queue_[static_cast<std::size_t>(link)].emplace_back();
    packet.clock = clock;
    packet.triangle = done_;
    return packet;
  }
  void run_one() {
    const Clock::time_point start = Clock::now();
    model_.draw(triangles_[done_], Listener{*this});
    ++done_;
    seconds_ += seconds_since(start);
  }

  std::span<const Triangle> triangles_;
  Config config_;
  CycleModel model_;
  std::vector<std::deque<Packet>> queue_;
  std::size_t done_ = 0;
  double seconds_ = 0;
};

// Field by field, the first that differs.
class Difference {
 public:
  explicit Difference(Mismatch& out) : out_(out) {}
  template <class T>
  Difference& field(const char* name, const T& model, const T& rtl) {
    if (!found_ && !(model == rtl)) {
      found_ = true;
      out_.field = name;
      out_.model = fmt::format("{}", model);
      out_.rtl = fmt::format("{}", rtl);
    }
    return *this;
  }
  Difference& mask(int sample, GridMask model, GridMask rtl) {
    if (!found_ && model != rtl) {
      found_ = true;
      out_.field = fmt::format("mask[{}]", sample);
      out_.model = fmt::format("{:#018x}", model);
      out_.rtl = fmt::format("{:#018x}", rtl);
    }
    return *this;
  }
  bool found() const { return found_; }

 private:
  Mismatch& out_;
  bool found_ = false;
};

class Scoreboard {
 public:
  Scoreboard(RtlRasterizer& rtl, Expectation& expected, const Config& config, CosimResult& result)
      : rtl_(rtl),
        expected_(expected),
        config_(config),
        result_(result),
        count_(static_cast<std::size_t>(link_output(config) + 1)) {
    result_.busy.assign(count_.size(), 0);
  }

  // Compares all handshakes of one clock; false at the first difference.
  bool check(std::uint64_t clock) {
    for (int link = 0; link <= link_output(config_); ++link) {
      if (!check_link(link, clock)) return false;
    }
    return true;
  }
  // No packet is due any more.
  bool finished() {
    for (int link = link_output(config_); link >= 0; --link) {
      if (expected_.next(link) != nullptr) return false;
    }
    return true;
  }

 private:
  bool check_link(int link, std::uint64_t clock) {
    const Packet* packet = expected_.next(link);
    const bool fires = rtl_.fires(link);
    const bool due = packet != nullptr && packet->clock == clock;
    if (!fires && !due) return true;
    Mismatch found;
    if (!(fires && due ? same(link, *packet, found) : clocks(packet, fires, found))) {
      found.stage = stage_name(link, config_);
      found.packet = count_[static_cast<std::size_t>(link)];
      found.clock = clock;
      if (packet != nullptr) found.triangle = packet->triangle;
      result_.mismatch = found;
      return false;
    }
    ++count_[static_cast<std::size_t>(link)];
    ++result_.busy[static_cast<std::size_t>(link)];
    ++result_.packets_compared;
    expected_.pop(link);
    return true;
  }

  static bool clocks(const Packet* packet, bool fires, Mismatch& found) {
    found.field = "clock";
    found.model = packet == nullptr ? "no packet" : fmt::format("clock {}", packet->clock);
    found.rtl = fires ? "a packet now" : "no packet now";
    return false;
  }

  bool same(int link, const Packet& packet, Mismatch& found) {
    Difference difference(found);
    if (link == kLinkAccept) return true;
    if (link == kLinkSetup) {
      compare(packet.setup, rtl_.setup(), difference);
    } else if (link == link_output(config_)) {
      found.x = packet.tile.x;
      found.y = packet.tile.y;
      const CoverageTile tile = rtl_.coverage();
      compare(packet.tile, tile, difference);
      ++result_.tiles_compared;
    } else {
      found.x = packet.node.x;
      found.y = packet.node.y;
      const int level = link - 1;
      const auto tag = static_cast<std::uint32_t>(packet.triangle & tag_mask());
      compare(packet.node, rtl_.node(level), difference);
      difference.field("tag", tag, rtl_.node_tag(level));
    }
    return !difference.found();
  }

  void compare(const SetupTriangle& model, const SetupTriangle& rtl, Difference& difference) const {
    static constexpr std::array<const char*, 3> kA{"a0", "a1", "a2"};
    static constexpr std::array<const char*, 3> kB{"b0", "b1", "b2"};
    static constexpr std::array<const char*, 3> kE{"e0", "e1", "e2"};
    for (std::size_t i = 0; i < 3; ++i) {
      difference.field(kA[i], model.slope[i].a, rtl.slope[i].a)
          .field(kB[i], model.slope[i].b, rtl.slope[i].b)
          .field(kE[i], model.e[i], rtl.e[i]);
    }
    difference.field("box.x_first", model.box.x_first, rtl.box.x_first)
        .field("box.y_first", model.box.y_first, rtl.box.y_first)
        .field("box.x_last", model.box.x_last, rtl.box.x_last)
        .field("box.y_last", model.box.y_last, rtl.box.y_last)
        .field("flipped", model.flipped, rtl.flipped)
        .field("tag", model.tag & tag_mask(), rtl.tag);
  }
  static void compare(const Node& model, const Node& rtl, Difference& difference) {
    difference.field("x", model.x, rtl.x)
        .field("y", model.y, rtl.y)
        .field("e0", model.e[0], rtl.e[0])
        .field("e1", model.e[1], rtl.e[1])
        .field("e2", model.e[2], rtl.e[2]);
  }
  void compare(const CoverageTile& model, const CoverageTile& rtl, Difference& difference) const {
    difference.field("x", model.x, rtl.x).field("y", model.y, rtl.y);
    for (int m = 0; m < config_.samples; ++m) {
      difference.mask(m, model.mask[static_cast<std::size_t>(m)],
                      rtl.mask[static_cast<std::size_t>(m)]);
    }
    difference.field("tag", model.tag & tag_mask(), rtl.tag);
  }
  std::uint32_t tag_mask() const {
    return config_.tag_bits == 32 ? ~0u : (1u << config_.tag_bits) - 1;
  }

  RtlRasterizer& rtl_;
  Expectation& expected_;
  const Config& config_;
  CosimResult& result_;
  std::vector<std::uint64_t> count_;
};

// Offers triangles to the RTL as the stall pattern says.
class Source {
 public:
  Source(std::span<const Triangle> triangles, const Stalls& stalls, int tag_bits)
      : triangles_(triangles), stalls_(stalls), tag_bits_(tag_bits), offer_(stalls.gap(0)) {}

  // The triangle offered at this clock, or null. Tags are positions in the stream.
  const Triangle* at(std::uint64_t clock) {
    if (next_ >= triangles_.size() || clock < offer_) return nullptr;
    offered_ = triangles_[next_];
    const std::uint64_t mask = (std::uint64_t{1} << tag_bits_) - 1;
    offered_.tag = static_cast<std::uint32_t>(next_ & mask);
    return &offered_;
  }
  void accepted(std::uint64_t clock) {
    ++next_;
    offer_ = clock + 1 + stalls_.gap(next_);
  }
  std::uint64_t count() const { return next_; }
  bool done() const { return next_ == triangles_.size(); }

 private:
  std::span<const Triangle> triangles_;
  Stalls stalls_;
  int tag_bits_;
  std::uint64_t next_ = 0;
  std::uint64_t offer_;
  Triangle offered_;
};

std::vector<Triangle> tagged(std::span<const Triangle> triangles) {
  std::vector<Triangle> out(triangles.begin(), triangles.end());
  for (std::size_t i = 0; i < out.size(); ++i) out[i].tag = static_cast<std::uint32_t>(i);
  return out;
}

// After a difference: on to the end of the waves asked for, comparing no more.
void wave_on(RtlRasterizer& rtl, Source& source, const CosimOptions& options, bool tracing,
             std::uint64_t clock) {
  if (!tracing || options.trace_to == UINT64_MAX) return;
  try {
    for (; clock < options.trace_to; ++clock) {
      if (rtl.fires(kLinkAccept)) source.accepted(clock);
      rtl.clock();
      rtl.drive(source.at(clock + 1), options.stalls.ready(clock + 1));
    }
  } catch (const std::runtime_error&) {  // an assertion: the waves end there
  }
}

}  // namespace

std::string Mismatch::line() const {
  return fmt::format(
      "mismatch: stage={} packet={} clock={} triangle={} tile=({},{}) field={} model={} rtl={}",
      stage, packet, clock, triangle, x, y, field, model, rtl);
}

CosimResult cosim(RtlRasterizer& rtl, std::span<const Triangle> triangles, const FrameState& frame,
                  const Config& config, const CosimOptions& options) {
  CosimResult result;
  const std::vector<Triangle> stream = tagged(triangles);
  Expectation expected(stream, frame, config, options.stalls);
  rtl.reset(2);
  rtl.set_frame(frame);
  Source source(stream, options.stalls, config.tag_bits);
  Scoreboard scoreboard(rtl, expected, config, result);
  const Clock::time_point start = Clock::now();
  std::uint64_t clock = 0;
  bool tracing = false;
  for (; !scoreboard.finished(); ++clock) {
    if (!options.trace.empty() && clock == options.trace_from) {
      rtl.open_trace(options.trace);
      tracing = true;
    }
    rtl.drive(source.at(clock), options.stalls.ready(clock));
    if (!scoreboard.check(clock)) {
      wave_on(rtl, source, options, tracing, clock);
      break;
    }
    if (rtl.fires(kLinkAccept)) {
      source.accepted(clock);
      if (options.progress) options.progress(source.count());
    }
    try {
      rtl.clock();
    } catch (const std::runtime_error& error) {
      result.mismatch = Mismatch{.stage = "assertion",
                                 .packet = 0,
                                 .clock = clock,
                                 .triangle = source.count(),
                                 .x = 0,
                                 .y = 0,
                                 .field = "rtl",
                                 .model = "no failure",
                                 .rtl = error.what()};
      break;
    }
    if (tracing && clock == options.trace_to) {
      rtl.close_trace();
      tracing = false;
    }
  }
  result.clocks = clock;
  // Nothing may come after the last packet either.
  for (int i = 0; i < 64 && !result.mismatch; ++i, ++clock) {
    rtl.drive(nullptr, true);
    if (scoreboard.check(clock)) rtl.clock();
  }
  if (!result.mismatch && rtl.busy()) {
    result.mismatch =
        Mismatch{"rasterizer", 0, clock, source.count(), 0, 0, "busy_o", "empty", "busy"};
  }
  rtl.close_trace();
  result.stats = expected.stats();
  result.model_seconds = expected.seconds();
  result.rtl_seconds = seconds_since(start) - result.model_seconds;
  return result;
}

RtlRun run_rtl(RtlRasterizer& rtl, std::span<const Triangle> triangles, const FrameState& frame,
               const Stalls& stalls, const std::function<void(const CoverageTile&)>& tile) {
  rtl.reset(2);
  rtl.set_frame(frame);
  const Config& config = rtl.config();
  Source source(triangles, stalls, config.tag_bits);
  const Clock::time_point start = Clock::now();
  RtlRun run;
  std::uint64_t moved = 0;
  for (std::uint64_t clock = 0;; ++clock) {
    rtl.drive(source.at(clock), stalls.ready(clock));
    if (rtl.fires(link_output(config))) {
      tile(rtl.coverage());
      run.clocks = clock + 1;
      moved = clock;
    }
    if (rtl.fires(kLinkAccept)) {
      source.accepted(clock);
      run.clocks = clock + 1;
      moved = clock;
    }
    rtl.clock();
    if (source.done() && !rtl.busy()) break;
    if (clock - moved > 100000) throw std::runtime_error("the RTL does not move any more");
  }
  run.seconds = seconds_since(start);
  return run;
}

CosimResult cosim_with_resets(RtlRasterizer& rtl, std::span<const Triangle> triangles,
                              const FrameState& frame, const Config& config,
                              const CosimOptions& options, int resets) {
  for (int i = 0; i < resets; ++i) {
    rtl.reset(1 + i % 3);
    rtl.set_frame(frame);
    Source source(triangles, options.stalls, config.tag_bits);
    // Somewhere in the middle of things, a different place each time.
    const std::uint64_t strike = 7 + 23 * static_cast<std::uint64_t>(i);
    for (std::uint64_t clock = 0; clock < strike; ++clock) {
      rtl.drive(source.at(clock), options.stalls.ready(clock));
      if (rtl.fires(kLinkAccept)) source.accepted(clock);
      rtl.clock();
    }
  }
  return cosim(rtl, triangles, frame, config, options);
}

}  // namespace halfspace
