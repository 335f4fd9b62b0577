// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "../io/config_json.hpp"
#include "../scene/scene.hpp"
#include "files.hpp"

namespace halfspace::capi {
namespace {

constexpr std::size_t kBatch = 1024;
constexpr std::uint32_t kAllFlags = HS_CAMERA_EYE | HS_CAMERA_TARGET | HS_CAMERA_UP |
                                    HS_CAMERA_FOV | HS_CAMERA_ORTHO | HS_CAMERA_FLAT_LIGHT;

glm::dvec3 vector(const double (&v)[3]) {
  for (const double x : v) {
    require(std::isfinite(x), HS_ERROR_RANGE, "a camera vector is not finite");
  }
  return {v[0], v[1], v[2]};
}

CameraOptions camera_options(const hs_camera& camera) {
  require((camera.flags & ~kAllFlags) == 0, HS_ERROR_RANGE, "camera->flags has an unknown bit");
  require(camera.reserved == 0, HS_ERROR_ARGUMENT, "camera->reserved is not 0");
  CameraOptions out;
  if ((camera.flags & HS_CAMERA_EYE) != 0) out.eye = vector(camera.eye);
  if ((camera.flags & HS_CAMERA_TARGET) != 0) out.target = vector(camera.target);
  if ((camera.flags & HS_CAMERA_UP) != 0) out.up = vector(camera.up);
  if ((camera.flags & HS_CAMERA_FOV) != 0) {
    require(camera.fov_y_degrees > 0 && camera.fov_y_degrees < 180, HS_ERROR_RANGE,
            "fov_y_degrees is not above 0 and below 180");
    out.fov_y_degrees = camera.fov_y_degrees;
  }
  if ((camera.flags & HS_CAMERA_ORTHO) != 0) {
    require(camera.ortho_height >= 0 && camera.ortho_height < 1e30, HS_ERROR_RANGE,
            "ortho_height is negative");
    out.orthographic = true;
    if (camera.ortho_height > 0) out.ortho_height = camera.ortho_height;
  }
  return out;
}

void draw(Frame& frame, const Config& config, const Scene& scene) {
  RunStats stats;
  std::vector<ShadedTriangle> batch;
  batch.reserve(kBatch);
  std::uint64_t sent = 0;
  try {
    scene.draw(0, frame.state(), config, stats, [&](const ShadedTriangle& triangle) {
      ++sent;
      batch.push_back(triangle);
      if (batch.size() < kBatch) return;
      frame.draw(batch);
      batch.clear();
    });
  } catch (const Error&) {
    frame.draw(batch);
    GeometryStats in;  // the scene counts its frame as a whole
    in.triangles_in = sent;
    frame.count_in(in);
    throw;
  }
  frame.draw(batch);
  frame.count_in(stats.geometry);
}

}  // namespace

Config config_of_json(const char* text) { return parse_config(text, "configuration"); }

void draw_scene(Frame& frame, const Config& config, const char* path, const hs_camera* camera) {
  hs_camera wanted{};
  if (camera != nullptr) wanted = read_struct(camera, sizeof(hs_camera), "camera");
  const Lighting lighting =
      (wanted.flags & HS_CAMERA_FLAT_LIGHT) != 0 ? Lighting::kFlat : Lighting::kGouraud;
  const FrameState& state = frame.state();
  const auto scene =
      make_mesh_scene(path, state.width, state.height, camera_options(wanted), lighting);
  draw(frame, config, *scene);
}

}  // namespace halfspace::capi
