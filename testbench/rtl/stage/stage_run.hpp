// SPDX-License-Identifier: Apache-2.0
//
// A stage's packets through model and RTL: every bit and every clock of both handshakes.
#pragma once

#include <string>
#include <vector>

#include "stage.hpp"
#include "stalls.hpp"

namespace halfspace {

// One packet into a stage and what the model says comes out: at most one packet of triangle_setup
// and coverage, the live children of tile_traversal.
struct StagePacket {
  Values in;
  std::vector<Values> out;
};

// When a stage by itself does what, by the rules of docs/03_design/timing.md.
struct StageClocks {
  std::vector<std::uint64_t> accepted;  // one per packet
  std::vector<std::uint64_t> emitted;   // one per packet that comes out
  std::vector<std::uint64_t> ended;     // one per packet in: the last clock in which busy_o is high
};
using StageTiming = StageClocks (*)(const std::vector<StagePacket>&, const StageVariant&,
                                    const Stalls&);
StageClocks triangle_setup_clocks(const std::vector<StagePacket>&, const StageVariant&,
                                  const Stalls&);
StageClocks tile_traversal_clocks(const std::vector<StagePacket>&, const StageVariant&,
                                  const Stalls&);
StageClocks coverage_clocks(const std::vector<StagePacket>&, const StageVariant&, const Stalls&);
StageClocks tile_plane_clocks(const std::vector<StagePacket>&, const StageVariant&, const Stalls&);
StageClocks depth_test_clocks(const std::vector<StagePacket>&, const StageVariant&, const Stalls&);
StageClocks shade_clocks(const std::vector<StagePacket>&, const StageVariant&, const Stalls&);

struct StageRun {
  StageTiming timing;
  Layout in;
  Layout out;
  void (*clean)(Values& rtl) = nullptr;  // clears what means nothing in a packet that came out
};

// Drives the packets through the RTL from reset on and compares. Empty when all is the same, else
// one line on the first difference. resets: so many times before, the RTL gets a part of the
// packets and is reset while they are inside.
std::string compare_stage(StageRtl& rtl, const StageVariant& variant, const StageRun& run,
                          const std::vector<StagePacket>& packets, const Stalls& stalls,
                          int resets);

}  // namespace halfspace
