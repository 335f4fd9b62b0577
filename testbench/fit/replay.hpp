// SPDX-License-Identifier: Apache-2.0
//
// Level auto: does the RTL agree with level cycle on some of the windows that the prediction rests
// on? docs/01_overview/levels.md.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "estimate.hpp"
#include "io/stats_json.hpp"

namespace halfspace {

// What the RTL and level cycle said of the same triangles.
struct RtlAgreement {
  std::uint64_t clocks = 0;
  std::uint64_t packets = 0;  // compared, at all handshakes
  std::string mismatch;       // the first difference; empty: none
};
// Runs triangles through both, from reset; nothing when there is no RTL of the configuration.
using RtlReplay = std::function<std::optional<RtlAgreement>(std::span<const Triangle>)>;

// Replays the estimate's stretches of the frame's triangles and adds to `out`, until the first
// difference. A run of many frames stops after kReplayClocks: later frames are not replayed.
inline constexpr std::uint64_t kReplayClocks = 50'000;
void replay_stretches(const ClockEstimate& estimate, std::span<const Triangle> triangles,
                      const RtlReplay& replay, RunStats::Prediction::Rtl& out);

}  // namespace halfspace
