// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scene_options.hpp"

namespace halfspace {

// The levels of modelling on one scene: covered pixels and clocks per second of CPU time, and what
// each gets right, compared with level bit (coverage) and with the RTL where it can be built
// (clocks). scene.path empty is not allowed. Throws what opening the scene throws.
nlohmann::ordered_json ladder_chart(const SceneOptions& scene);

}  // namespace halfspace
