// SPDX-License-Identifier: Apache-2.0
#include "scoreboard.hpp"

#include <fmt/format.h>

#include <array>

namespace halfspace {
namespace {

std::string stage_name(int link, const Config& config) {
  if (link == kLinkAccept) return "accept";
  if (link == kLinkSetup) return "triangle_setup";
  if (link == link_output(config)) return "coverage";
  return fmt::format("tile_traversal[{}]", link - 2);
}

bool clocks(const Packet* packet, bool fires, Mismatch& found) {
  found.field = "clock";
  found.model = packet == nullptr ? "no packet" : fmt::format("clock {}", packet->clock);
  found.rtl = fires ? "a packet now" : "no packet now";
  return false;
}

}  // namespace

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

Scoreboard::Scoreboard(RtlRasterizer& rtl, Expectation& expected, const Config& config,
                       CosimResult& result)
    : rtl_(rtl),
      expected_(expected),
      config_(config),
      result_(result),
      count_(static_cast<std::size_t>(link_output(config) + 1)) {
  result_.busy.assign(count_.size(), 0);
}

bool Scoreboard::check(std::uint64_t clock) {
  for (int link = 0; link <= link_output(config_); ++link) {
    if (!check_link(link, clock)) return false;
  }
  return true;
}

bool Scoreboard::finished() {
  for (int link = link_output(config_); link >= 0; --link) {
    if (expected_.next(link) != nullptr) return false;
  }
  return true;
}

bool Scoreboard::check_link(int link, std::uint64_t clock) {
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

bool Scoreboard::same(int link, const Packet& packet, Mismatch& found) {
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

void Scoreboard::compare(const SetupTriangle& model, const SetupTriangle& rtl,
                         Difference& difference) const {
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

void Scoreboard::compare(const Node& model, const Node& rtl, Difference& difference) {
  difference.field("x", model.x, rtl.x)
      .field("y", model.y, rtl.y)
      .field("e0", model.e[0], rtl.e[0])
      .field("e1", model.e[1], rtl.e[1])
      .field("e2", model.e[2], rtl.e[2]);
}

void Scoreboard::compare(const CoverageTile& model, const CoverageTile& rtl,
                         Difference& difference) const {
  difference.field("x", model.x, rtl.x).field("y", model.y, rtl.y);
  for (int m = 0; m < config_.samples; ++m) {
    difference.mask(m, model.mask[static_cast<std::size_t>(m)],
                    rtl.mask[static_cast<std::size_t>(m)]);
  }
  difference.field("tag", model.tag & tag_mask(), rtl.tag);
}

}  // namespace halfspace
