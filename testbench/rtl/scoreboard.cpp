// SPDX-License-Identifier: Apache-2.0
#include "scoreboard.hpp"

#include <fmt/format.h>

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

std::string text_of(const PortField& field, std::int64_t value) {
  return field.name.starts_with("mask") ? fmt::format("{:#018x}", static_cast<std::uint64_t>(value))
                                        : fmt::format("{}", value);
}

}  // namespace

Scoreboard::Scoreboard(RtlRasterizer& rtl, Expectation& expected, const Config& config,
                       CosimResult& result)
    : rtl_(rtl),
      expected_(expected),
      config_(config),
      result_(result),
      count_(static_cast<std::size_t>(link_output(config) + 1)) {
  result_.busy.assign(count_.size(), 0);
  for (int link = 0; link <= link_output(config); ++link) {
    layouts_.push_back(link_layout(link, config));
  }
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
  if (link == kLinkAccept) return true;
  const Values rtl = rtl_.packet(link);
  if (link == link_output(config_)) ++result_.tiles_compared;
  const Layout& layout = layouts_[static_cast<std::size_t>(link)];
  for (std::size_t i = 0; i < layout.size(); ++i) {
    if (packet.values[i] == rtl[i]) continue;
    found.field = layout[i].name;
    found.model = text_of(layout[i], packet.values[i]);
    found.rtl = text_of(layout[i], rtl[i]);
    if (link != kLinkSetup) {  // traversal and coverage packets begin with their place
      found.x = static_cast<std::int32_t>(packet.values[0]);
      found.y = static_cast<std::int32_t>(packet.values[1]);
    }
    return false;
  }
  return true;
}

}  // namespace halfspace
