// SPDX-License-Identifier: Apache-2.0
//
// Configurations in JSON, and scenes from files as the program draws them. Only in a build with
// file formats (HALFSPACE_CLI).
#pragma once

#include "model.hpp"

namespace halfspace::capi {

// Throws Error.
Config config_of_json(const char* text);

// camera: null for the default view. Throws Error, and Refusal for a camera out of range.
void draw_scene(Frame& frame, const Config& config, const char* path, const hs_camera* camera);

#ifdef HALFSPACE_HAS_FILES
inline constexpr bool kHasFiles = true;
#else
inline constexpr bool kHasFiles = false;
#endif

}  // namespace halfspace::capi
