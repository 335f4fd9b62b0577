// SPDX-License-Identifier: Apache-2.0
//
// A scene drawn by a method of the gallery.
#pragma once

#include <string>
#include <string_view>

#include "command.hpp"
#include "methods/method.hpp"
#include "pictures.hpp"
#include "scene/scene.hpp"

namespace halfspace {

// The method of that name, able to draw the shade: empty (whatever it has), gouraud, flat or depth
// (methods with attributes) or coverage. Throws Error(kMethod) and Error(kMethodOption).
const methods::Method& find_method(std::string_view name, std::string_view shade);

// A frame before snapping, in every form that a method may take.
methods::Drawing scene_drawing(const Scene& scene, std::size_t index, const FrameState& frame);

// A fresh canvas of the frame with a budget that ends; require_finished() throws
// Error(kMethodGaveUp) when it did.
methods::Canvas method_canvas(const FrameState& frame);
void require_finished(const methods::Method& method, const methods::Canvas& canvas);

// A fragment's colour as the picture has it; NaN is magenta.
Rgb picture_color(const methods::Color& color);

// One frame, geometry before snapping. Without attributes the picture is that of the hit counts.
// Adds to stats.cases, stats.crc (of the hit counts, saturated at 255), stats.geometry.triangles_in
// (the primitives drawn) and stats.simulate_seconds. Throws Error(kMethodGaveUp).
Image method_picture(const Scene& scene, std::size_t index, const FrameState& frame,
                     const methods::Method& method, const std::string& shade, RunStats& stats);

// The two for render, which is built without the gallery too.
extern const MethodDrawing kMethodDrawing;

}  // namespace halfspace
