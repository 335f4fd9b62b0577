// SPDX-License-Identifier: Apache-2.0
//
// The judge of cosim: every handshake of the RTL against the model's packets.
#pragma once

#include <cstdint>
#include <vector>

#include "cosim.hpp"
#include "expectation.hpp"
#include "rtl_rasterizer.hpp"

namespace halfspace {

// Holds references: all must outlive it. Adds to result, and sets its mismatch once.
class Scoreboard {
 public:
  Scoreboard(RtlRasterizer& rtl, Expectation& expected, const Config& config, CosimResult& result);

  // Compares all handshakes of one clock; false at the first difference.
  bool check(std::uint64_t clock);
  // No packet is due any more.
  bool finished();

 private:
  bool check_link(std::size_t index, std::uint64_t clock);
  bool same(std::size_t index, const Packet& packet, Mismatch& found);

  RtlRasterizer& rtl_;
  Expectation& expected_;
  CosimResult& result_;
  std::vector<Link> links_;
  std::vector<Layout> layouts_;       // by place in links_
  std::vector<std::uint64_t> count_;  // packets so far, too
};

}  // namespace halfspace
