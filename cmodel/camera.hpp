// SPDX-License-Identifier: Apache-2.0
//
// From the world to clip space: camera matrices, and a camera that frames a scene by itself.
// OpenGL's conventions: right-handed, the camera looks along -z, clip volume -w <= x, y, z <= w.
// Double precision. Page: docs/03_design/geometry.md.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace halfspace {

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

// What a user fixes; orbit_cameras() finds the rest.
struct CameraOptions {
  std::optional<glm::dvec3> eye;
  std::optional<glm::dvec3> target;
  std::optional<glm::dvec3> up;
  std::optional<double> fov_y_degrees;
  bool orthographic = false;
  std::optional<double> ortho_height;
};

// World to camera space. The camera must not be at its target; an `up` along the view direction is
// replaced by the axis that is furthest from it.
glm::dmat4 look_at(const Camera& camera);

// Camera to clip space; aspect = width / height. The top of the near rectangle is at
// near * tan(fov_y / 2).
glm::dmat4 perspective(double fov_y_degrees, double aspect, double near, double far);
glm::dmat4 orthographic(double height, double aspect, double near, double far);

// World to clip space: the camera's projection times its look_at().
glm::dmat4 world_to_clip(const Camera& camera, double aspect);

// Cameras that show all of `points`, a mesh's vertices (finite; none count as one at the origin),
// as large as the frame allows: at the tighter pair of opposite sides they leave 2.5 % of the frame
// on either side. What `options` fix is left alone; of the rest
// - the first view is from the front, right and above, turned with `up`, and the others (`views` >=
// 1 in all) are
//   turned around the target, about `up`, counter-clockwise as seen from above, in equal steps;
// - with one view and no target, eye and target move across the view until `points` are as far from
//   the left as from the right side of the view volume, from the bottom as from the top;
// - with a target, or more views, which turn around the middle of the points' box, the distance
//   alone is fitted, or ortho_height: the least at which every view shows all, the same for all
//   (a turntable does not zoom). With an eye only ortho_height is;
// - an eye that is found stays before all points, by 2 % of their depth or more;
// - near and far of each view enclose `points`; near is at least far / 1000, so that depth keeps
//   its precision when the eye is among them.
// An eye on its target looks along -z. Points in one place count as a tiny ball.
std::vector<Camera> orbit_cameras(std::span<const glm::vec3> points, double aspect,
                                  const CameraOptions& options, int views);

// The camera of one view.
Camera frame_camera(std::span<const glm::vec3> points, double aspect,
                    const CameraOptions& options = {});

}  // namespace halfspace
