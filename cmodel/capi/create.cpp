// SPDX-License-Identifier: Apache-2.0
//
// Models and frames.
#include "files.hpp"

namespace halfspace::capi {
namespace {

hs_info info_of(const Config& c) {
  hs_info info{};
  info.struct_size = sizeof info;
  info.subpixel_bits = c.subpixel_bits;
  info.viewport_bits = c.viewport_bits;
  info.guard_bits = c.guard_bits;
  info.samples = c.samples;
  info.grid_log2 = c.grid_log2;
  info.setup_interval = c.setup_interval;
  info.tag_bits = c.tag_bits;
  info.depth_bits = c.depth_bits;
  info.attributes = c.attributes;
  info.inverse_w_bits = c.inverse_w_bits;
  info.gradient_bits = c.gradient_bits;
  info.reciprocal_bits = c.reciprocal_bits;
  info.snap = static_cast<int32_t>(c.snap);
  info.grid = c.grid();
  info.levels = c.levels();
  info.max_size = c.max_size();
  info.vertex_bits = c.vertex_bits();
  info.delta_bits = c.delta_bits();
  info.area_bits = c.area_bits();
  info.edge_bits = c.edge_bits();
  info.lane_bits = c.lane_bits();
  info.root_bits = c.node_bits(c.node_log2(0));
  info.coordinate_min = static_cast<int32_t>(c.coordinate_min());
  info.coordinate_max = static_cast<int32_t>(c.coordinate_max());
  info.extent_bits = c.extent_bits;
  return info;
}

Stalls stalls(double probability, std::uint64_t seed) {
  return probability >= 0 && probability < 1 ? Stalls(probability, seed) : Stalls();
}

}  // namespace
}  // namespace halfspace::capi

using namespace halfspace;
using namespace halfspace::capi;

hs_status hs_create_preset(const char* name, hs_model** model) {
  if (model != nullptr) *model = nullptr;
  return call([&] {
    require_pointer(name, "name");
    require_pointer(model, "model");
    const std::optional<Config> preset = find_preset(name);
    if (!preset) {
      throw Refusal(HS_ERROR_CONFIG, "no preset '" + std::string(name).substr(0, 40) +
                                         "' (there are tiny, full, d3d, msaa4)");
    }
    *model = new hs_model(*preset);
    return HS_OK;
  });
}

hs_status hs_create_json(const char* text, hs_model** model) {
  if (model != nullptr) *model = nullptr;
  return call([&] {
    require_pointer(text, "text");
    require_pointer(model, "model");
    if constexpr (kHasFiles) {
      *model = new hs_model(config_of_json(text));
      return HS_OK;
    } else {
      return failed(HS_ERROR_UNSUPPORTED, "this build reads no JSON (HALFSPACE_CLI=OFF)");
    }
  });
}

void hs_destroy(hs_model* model) { delete model; }

hs_status hs_get_info(const hs_model* model, hs_info* info) {
  return call([&] {
    require_pointer(model, "model");
    write_struct(info_of(model->config), sizeof(hs_info), info, "info");
    return HS_OK;
  });
}

hs_status hs_begin_frame(hs_model* model, const hs_frame* frame) {
  return call([&] {
    require_pointer(model, "model");
    const hs_frame request = read_struct(frame, offsetof(hs_frame, flags), "frame");
    model->frame = std::make_unique<Frame>(request, model->config);
    return HS_OK;
  });
}

hs_status hs_reset(hs_model* model) {
  return call([&] {
    const hs_frame request = frame_of(model).request();
    model->frame = std::make_unique<Frame>(request, model->config);
    return HS_OK;
  });
}

uint32_t hs_stall_gap(double probability, uint64_t seed, uint64_t triangle) {
  return static_cast<uint32_t>(stalls(probability, seed).gap(triangle));
}

int hs_stall_ready(double probability, uint64_t seed, uint64_t clock) {
  return stalls(probability, seed).ready(clock) ? 1 : 0;
}
