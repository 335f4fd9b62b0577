// SPDX-License-Identifier: Apache-2.0
//
// A scene drawn by a method of the gallery.
#pragma once

#include <string>

#include "../methods/method.hpp"
#include "pictures.hpp"
#include "scene.hpp"

namespace halfspace {

// The method of that name, able to draw the shade: empty (whatever it has), gouraud, flat or depth
// (methods with attributes) or coverage. Throws Error(kMethod) and Error(kMethodOption).
const methods::Method& find_method(const std::string& name, const std::string& shade);

// One frame, geometry before snapping. Without attributes the picture is that of the hit counts.
// Adds to stats.cases, stats.crc (of the hit counts, saturated at 255), stats.geometry.triangles_in
// (the primitives drawn) and stats.simulate_seconds. Throws Error(kMethodGaveUp).
Image method_picture(const Scene& scene, std::size_t index, const FrameState& frame,
                     const methods::Method& method, const std::string& shade, RunStats& stats);

}  // namespace halfspace
