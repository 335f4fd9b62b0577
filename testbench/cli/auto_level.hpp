// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "io/stats_json.hpp"
#include "scene/scene.hpp"

namespace halfspace {

// Level auto: predicts the clocks of one frame (fit/estimate.hpp), replays some of what that rests
// on on the RTL where it can be built (fit/replay.hpp), and adds both to stats.predicted. Prints
// the first difference of a run on stderr.
void add_prediction(std::span<const Triangle> triangles, const FrameState& frame,
                    const Config& config, RunStats& stats);

// The same for a frame of a scene; says them on stderr when it is the only one.
void add_prediction(const Scene& scene, std::size_t index, const FrameState& frame,
                    const Config& config, RunStats& stats);

// The program's exit status: 1 when the RTL and level cycle differed.
int exit_status(const RunStats& stats);

}  // namespace halfspace
