// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "../io/stats_json.hpp"
#include "scene.hpp"

namespace halfspace {

// Level auto: predicts the clocks of one frame (fit/estimate.hpp), adds them to stats.predicted and
// says them on stderr.
void add_prediction(const Scene& scene, std::size_t index, const FrameState& frame,
                    const Config& config, RunStats& stats);

}  // namespace halfspace
