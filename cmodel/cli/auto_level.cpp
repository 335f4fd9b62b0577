// SPDX-License-Identifier: Apache-2.0
#include "auto_level.hpp"

#include <fmt/format.h>

#include <vector>

#include "../fit/estimate.hpp"

namespace halfspace {

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
             "from {} of {} triangles at level cycle\n",
             p.clocks, p.low, p.high, 100 * p.confidence, p.triangles_at_cycle, triangles.size());
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
  stats.predicted = all;
}

}  // namespace halfspace
