// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boundary.hpp"
#include "frame.hpp"

// What the handle of the C interface points to.
struct hs_model {
  explicit hs_model(const halfspace::Config& c) : config(c) {}

  halfspace::Config config;
  std::unique_ptr<halfspace::capi::Frame> frame;  // null before hs_begin_frame()
};

namespace halfspace::capi {

// The model's frame. Throws Refusal: null handle, or no frame begun.
template <class Handle>
Frame& frame_of(Handle* model) {
  require_pointer(model, "model");
  require(model->frame != nullptr, HS_ERROR_ORDER, "no frame: call hs_begin_frame() first");
  return *model->frame;
}

}  // namespace halfspace::capi
