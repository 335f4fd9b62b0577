// SPDX-License-Identifier: Apache-2.0
#include "camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace halfspace {
namespace {

// The axis whose direction differs most from `direction`.
glm::dvec3 furthest_axis(const glm::dvec3& direction) {
  const glm::dvec3 size = glm::abs(direction);
  if (size.y <= size.x && size.y <= size.z) return {0.0, 1.0, 0.0};
  return size.z <= size.x ? glm::dvec3{0.0, 0.0, 1.0} : glm::dvec3{1.0, 0.0, 0.0};
}

double length_or(double value, double fallback) { return value > 0.0 ? value : fallback; }

}  // namespace

Camera orbited(const Camera& camera, double turn) {
  const glm::dmat4 around =
      glm::rotate(glm::dmat4(1.0), glm::radians(360.0 * turn), glm::normalize(camera.up));
  Camera moved = camera;
  moved.eye = camera.target + glm::dvec3(around * glm::dvec4(camera.eye - camera.target, 0.0));
  return moved;
}

glm::dmat4 look_at(const Camera& camera) {
  const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
  const double up_length = glm::length(camera.up);
  const bool parallel = !(glm::length(glm::cross(forward, camera.up)) > 1e-9 * up_length);
  return glm::lookAtRH(camera.eye, camera.target, parallel ? furthest_axis(forward) : camera.up);
}

// The _RH_NO forms do not depend on GLM's configuration macros.
glm::dmat4 perspective(double fov_y_degrees, double aspect, double near, double far) {
  return glm::perspectiveRH_NO(glm::radians(fov_y_degrees), aspect, near, far);
}

glm::dmat4 orthographic(double height, double aspect, double near, double far) {
  const double top = height / 2.0;
  return glm::orthoRH_NO(-top * aspect, top * aspect, -top, top, near, far);
}

glm::dmat4 world_to_clip(const Camera& camera, double aspect) {
  const glm::dmat4 projection =
      camera.orthographic ? orthographic(camera.ortho_height, aspect, camera.near, camera.far)
                          : perspective(camera.fov_y_degrees, aspect, camera.near, camera.far);
  return projection * look_at(camera);
}

Camera frame_camera(const Bounds& bounds, double aspect, const CameraOptions& options) {
  constexpr double kMargin = 1.03;        // of the sphere, so that nothing touches the frame
  constexpr double kDepthRange = 1000.0;  // far / near at most, where the eye is in the sphere
  const glm::dvec3 view_from = glm::normalize(glm::dvec3{0.5, 0.45, 0.9});

  const glm::dvec3 centre = 0.5 * bounds.min + 0.5 * bounds.max;
  const double least = length_or(1e-6 * glm::length(centre), 1e-6);
  const double radius = kMargin * std::max(0.5 * glm::length(bounds.max - bounds.min), least);

  Camera camera;
  camera.orthographic = options.orthographic;
  camera.fov_y_degrees = options.fov_y_degrees.value_or(camera.fov_y_degrees);
  camera.up = options.up.value_or(camera.up);
  camera.ortho_height = options.ortho_height.value_or(2.0 * radius / std::min(1.0, aspect));

  // The narrower of the two half angles decides how far away the sphere fits.
  const double half_y = glm::radians(camera.fov_y_degrees) / 2.0;
  const double half_x = std::atan(std::tan(half_y) * aspect);
  const double fit = radius / std::sin(std::min(half_x, half_y));
  camera.target = options.target.value_or(centre);
  camera.eye = options.eye.value_or(camera.target + fit * view_from);
  if (camera.eye == camera.target) camera.target.z -= radius;

  const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
  const double depth = glm::dot(centre - camera.eye, forward);
  camera.near = depth - radius;
  camera.far = depth + radius;
  if (!camera.orthographic) {
    // A sphere behind the eye still gets a legal, if empty, depth range.
    if (!(camera.far > 0.0)) camera.far = radius;
    camera.near = std::max(camera.near, camera.far / kDepthRange);
  }
  return camera;
}

}  // namespace halfspace
