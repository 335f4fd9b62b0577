// SPDX-License-Identifier: Apache-2.0
#include "scoreboard.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace halfspace {
namespace {

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
      result_(result),
      links_(links(config)),
      count_(links_.size()) {
  result_.busy.assign(links_.size(), 0);
  for (const Link link : links_) layouts_.push_back(link_layout(link, config));
}

bool Scoreboard::check(std::uint64_t clock) {
  for (std::size_t index = 0; index < links_.size(); ++index) {
    if (!check_link(index, clock)) return false;
  }
  return true;
}

bool Scoreboard::finished() {
  return std::all_of(links_.rbegin(), links_.rend(),
                     [this](Link link) { return expected_.next(link) == nullptr; });
}

bool Scoreboard::check_link(std::size_t index, std::uint64_t clock) {
  const Link link = links_[index];
  const Packet* packet = expected_.next(link);
  const bool fires = rtl_.fires(link);
  const bool due = packet != nullptr && packet->clock == clock;
  if (!fires && !due) return true;
  Mismatch found;
  if (!(fires && due ? same(index, *packet, found) : clocks(packet, fires, found))) {
    found.stage = stage_of(link);
    found.packet = count_[index];
    found.clock = clock;
    if (packet != nullptr) found.triangle = packet->triangle;
    result_.mismatch = found;
    return false;
  }
  ++count_[index];
  ++result_.busy[index];
  ++result_.packets_compared;
  expected_.pop(link);
  return true;
}

bool Scoreboard::same(std::size_t index, const Packet& packet, Mismatch& found) {
  const Link link = links_[index];
  if (link == kLinkAccept) return true;
  const Values rtl = rtl_.packet(link);
  if (link == kLinkTile) ++result_.tiles_compared;
  const Layout& layout = layouts_[index];
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
