// SPDX-License-Identifier: Apache-2.0
#include "auto_level.hpp"

#include <fmt/format.h>

#include <vector>

#include "fit/estimate.hpp"
#include "fit/replay.hpp"
#include "rtl_link.hpp"

namespace halfspace {
namespace {

std::string rtl_text(const RunStats::Prediction::Rtl& rtl) {
  if (!rtl.available) return "; no Verilator or C++ compiler here to build the RTL and replay it";
  return fmt::format("; {} windows, {} clocks, replayed on the RTL: {}", rtl.windows, rtl.clocks,
                     rtl.mismatch.empty() ? "identical in bits and clocks" : "different");
}

}  // namespace

void add_prediction(const Scene& scene, std::size_t index, const FrameState& frame,
                    const Config& config, RunStats& stats) {
  std::vector<Triangle> triangles;
  RunStats unused;
  scene.draw(index, frame, config, unused,
             [&](const ShadedTriangle& triangle) { triangles.push_back(triangle.triangle); });
  add_prediction(triangles, frame, config, stats);
  if (scene.frames() > 1) return;  // the statistics have the sum
  const RunStats::Prediction& p = *stats.predicted;
  fmt::print(stderr,
             "halfspace: note: {:.0f} clocks predicted, {:.0f} to {:.0f} with {:.0f} % confidence, "
             "from {} of {} triangles at level cycle{}\n",
             p.clocks, p.low, p.high, 100 * p.confidence, p.triangles_at_cycle, triangles.size(),
             rtl_text(p.rtl));
}

void add_prediction(std::span<const Triangle> triangles, const FrameState& frame,
                    const Config& config, RunStats& stats) {
  const ClockEstimate e = estimate_clocks(triangles, frame, config, 1);
  RunStats::Prediction all = stats.predicted.value_or(RunStats::Prediction{});
  all.clocks += e.clocks;
  all.low += e.low;  // of several frames: wider than it need be
  all.high += e.high;
  all.confidence = ClockEstimate::kConfidence;
  all.triangles_at_cycle += e.triangles_at_cycle;
  const bool agreed = all.rtl.mismatch.empty();
  replay_stretches(
      e, triangles,
      [&](std::span<const Triangle> some) { return compare_with_rtl(some, frame, config); },
      all.rtl);
  if (agreed && !all.rtl.mismatch.empty()) {
    fmt::print(stderr, "halfspace: RTL and level cycle differ in frame {}: {}\n", stats.cases,
               all.rtl.mismatch);
  }
  stats.predicted = all;
}

int exit_status(const RunStats& stats) {
  return stats.predicted && !stats.predicted->rtl.mismatch.empty() ? 1 : 0;
}

}  // namespace halfspace
