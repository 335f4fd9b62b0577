// SPDX-License-Identifier: Apache-2.0
//
// From the world to clip space: camera matrices, and a camera that frames a scene by itself.
// OpenGL's conventions: right-handed, the camera looks along -z, clip volume -w <= x, y, z <= w.
// Double precision. Page: docs/03_design/geometry.md.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace halfspace {

// An axis-parallel box in world units.
struct Bounds {
  glm::dvec3 min{0.0};
  glm::dvec3 max{0.0};
};

// Where the picture is taken from, in world units. near and far are distances from the eye along
// the view direction: 0 < near < far, or just near < far when orthographic.
struct Camera {
  glm::dvec3 eye{0.0, 0.0, 1.0};
  glm::dvec3 target{0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};  // need not be normal to the view direction
  double fov_y_degrees = 40.0;   // full vertical angle, 0 < fov < 180
  bool orthographic = false;
  double ortho_height = 2.0;  // world units from the bottom of the picture to its top
  double near = 0.1;
  double far = 10.0;
};

// What a user fixes; frame_camera() finds the rest.
struct CameraOptions {
  std::optional<glm::dvec3> eye;
  std::optional<glm::dvec3> target;
  std::optional<glm::dvec3> up;
  std::optional<double> fov_y_degrees;
  bool orthographic = false;
  std::optional<double> ortho_height;
};

// The camera moved around its target, about the axis `up`, by `turn` of a full circle, counter-
// clockwise as seen from above.
Camera orbited(const Camera& camera, double turn);

// World to camera space. The camera must not be at its target; an `up` along the view direction is
// replaced by the axis that is furthest from it.
glm::dmat4 look_at(const Camera& camera);

// Camera to clip space; aspect = width / height. The top of the near rectangle is at
// near * tan(fov_y / 2).
glm::dmat4 perspective(double fov_y_degrees, double aspect, double near, double far);
glm::dmat4 orthographic(double height, double aspect, double near, double far);

// World to clip space: the camera's projection times its look_at().
glm::dmat4 world_to_clip(const Camera& camera, double aspect);

// A camera that shows all of `bounds`: a three-quarter view from slightly above, at the distance
// at which the box's bounding sphere just fits. near and far enclose the sphere wherever the
// options put the eye; near is at least far / 1000 so that depth keeps its precision when the eye
// is inside. An eye on its target looks along -z. Empty or flat bounds count as a tiny sphere.
Camera frame_camera(const Bounds& bounds, double aspect, const CameraOptions& options = {});

}  // namespace halfspace
