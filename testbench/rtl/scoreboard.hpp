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

class Difference;

// Holds references: all must outlive it. Adds to result, and sets its mismatch once.
class Scoreboard {
 public:
  Scoreboard(RtlRasterizer& rtl, Expectation& expected, const Config& config, CosimResult& result);

  // Compares all handshakes of one clock; false at the first difference.
  bool check(std::uint64_t clock);
  // No packet is due any more.
  bool finished();

 private:
  bool check_link(int link, std::uint64_t clock);
  bool same(int link, const Packet& packet, Mismatch& found);
  void compare(const SetupTriangle& model, const SetupTriangle& rtl, Difference& difference) const;
  static void compare(const Node& model, const Node& rtl, Difference& difference);
  void compare(const CoverageTile& model, const CoverageTile& rtl, Difference& difference) const;
  std::uint32_t tag_mask() const {
    return config_.tag_bits == 32 ? ~0u : (1u << config_.tag_bits) - 1;
  }

  RtlRasterizer& rtl_;
  Expectation& expected_;
  const Config& config_;
  CosimResult& result_;
  std::vector<std::uint64_t> count_;  // packets so far, per link
};

}  // namespace halfspace
