// SPDX-License-Identifier: Apache-2.0
//
// What needs file formats, in a build without them.
#include "model.hpp"

using namespace halfspace::capi;

hs_status hs_create_json(const char* text, hs_model** model) {
  if (model != nullptr) *model = nullptr;
  return call([&] {
    require_pointer(text, "text");
    require_pointer(model, "model");
    return failed(HS_ERROR_UNSUPPORTED, "this build reads no JSON (HALFSPACE_CLI=OFF)");
  });
}

hs_status hs_draw_scene(hs_model* model, const char* path, const hs_camera*) {
  return call([&] {
    frame_of(model);
    require_pointer(path, "path");
    return failed(HS_ERROR_UNSUPPORTED, "this build reads no scenes (HALFSPACE_CLI=OFF)");
  });
}
