// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace halfspace {

// Why nothing of a mesh is in the picture: "all 12 triangles are behind the eye". Empty when a
// sample is covered, and for TCOV files. stats: of the frame `index`, alone.
std::string why_nothing_is_drawn(const Scene& scene, std::size_t index, const RunStats& stats);

}  // namespace halfspace
