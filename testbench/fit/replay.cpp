// SPDX-License-Identifier: Apache-2.0
#include "replay.hpp"

#include <fmt/format.h>

namespace halfspace {

void replay_stretches(const ClockEstimate& estimate, std::span<const Triangle> triangles,
                      const RtlReplay& replay, RunStats::Prediction::Rtl& out) {
  for (const ClockEstimate::Stretch& stretch : estimate.stretches) {
    if (!out.mismatch.empty() || out.clocks >= kReplayClocks) return;
    const auto agreement = replay(triangles.subspan(stretch.begin, stretch.end - stretch.begin));
    if (!agreement) return;
    out.available = true;
    ++out.windows;
    out.clocks += agreement->clocks;
    out.packets += agreement->packets;
    if (agreement->mismatch.empty()) continue;
    out.mismatch = fmt::format("triangles {} to {}, counted from {}: {}", stretch.begin,
                               stretch.end - 1, stretch.begin, agreement->mismatch);
  }
}

}  // namespace halfspace
