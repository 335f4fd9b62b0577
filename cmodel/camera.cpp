// SPDX-License-Identifier: Apache-2.0
#include "camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <limits>

namespace halfspace {
namespace {

// The axis whose direction differs most from `direction`.
glm::dvec3 furthest_axis(const glm::dvec3& direction) {
  const glm::dvec3 size = glm::abs(direction);
  if (size.y <= size.x && size.y <= size.z) return {0.0, 1.0, 0.0};
  return size.z <= size.x ? glm::dvec3{0.0, 0.0, 1.0} : glm::dvec3{1.0, 0.0, 0.0};
}

constexpr double kFill = 0.95;          // of the frame, between the sides that are fitted
constexpr double kBefore = 0.02;        // the eye is before the points, of their depth, at least
constexpr double kDepthRange = 1000.0;  // far / near at most, where the eye is among the points
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// An axis-parallel box around points, with its middle.
struct Box {
  glm::dvec3 middle{0.0};
  double size = 0.0;   // its diagonal, at least `least`
  double least = 0.0;  // a length that is small beside it, but not lost in rounding
};

Box box_of(std::span<const glm::vec3> points) {
  glm::vec3 low = points.front();
  glm::vec3 high = low;
  for (const glm::vec3& point : points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  Box box;
  box.middle = 0.5 * glm::dvec3(low) + 0.5 * glm::dvec3(high);
  const double diagonal = glm::length(glm::dvec3(high) - glm::dvec3(low));
  const double scale = diagonal + glm::length(box.middle);
  box.least = 1e-8 * (scale > 0.0 ? scale : 1.0);
  box.size = std::max(diagonal, box.least);
  return box;
}

// The sides of a view volume: |x| = slope.x * depth and |y| = slope.y * depth; with slope 0 they
// are parallel. The axes are of the camera, in the world.
struct Sides {
  glm::dvec3 right, up, forward;
  glm::dvec2 slope;
};

// from: to the eye, from what it looks at.
Sides sides_of(const glm::dvec3& from, const glm::dvec3& up, const glm::dvec2& slope) {
  Camera camera;
  camera.eye = from;
  camera.up = up;
  const glm::dmat4 view = look_at(camera);
  const auto axis = [&view](int row) {
    return glm::dvec3(view[0][row], view[1][row], view[2][row]);
  };
  return {axis(0), axis(1), -axis(2), slope};
}

// How far points reach beyond the four sides of a view volume whose tip is at an origin: each is
// inside when the eye is so far back that it takes all of this up. And their depths from there.
struct Reach {
  glm::dvec2 high{-kInfinity};  // beyond the right side and the top
  glm::dvec2 low{-kInfinity};   // beyond the left side and the bottom
  double near = kInfinity;
  double far = -kInfinity;
};

// Of balls of radius `least` around the points.
Reach reach_of(std::span<const glm::vec3> points, const glm::dvec3& origin, const Sides& sides,
               double least) {
  Reach reach;
  for (const glm::vec3& point : points) {
    const glm::dvec3 p = glm::dvec3(point) - origin;
    const glm::dvec2 across{glm::dot(sides.right, p), glm::dot(sides.up, p)};
    const double depth = glm::dot(sides.forward, p);
    reach.high = glm::max(reach.high, across - depth * sides.slope);
    reach.low = glm::max(reach.low, -across - depth * sides.slope);
    reach.near = std::min(reach.near, depth);
    reach.far = std::max(reach.far, depth);
  }
  reach.high += least * (1.0 + sides.slope);
  reach.low += least * (1.0 + sides.slope);
  reach.near -= least;
  reach.far += least;
  return reach;
}

// A view through the target, and what of the points it sees from there.
struct View {
  Sides sides;
  Reach reach;
};

// Moves the target to where opposite sides are reached alike, in the middle of the depths.
void centre(View& view, glm::dvec3& target) {
  const auto& [right, up, forward, slope] = view.sides;
  Reach& reach = view.reach;
  const glm::dvec2 across = 0.5 * (reach.high - reach.low);
  const double depth = 0.5 * (reach.near + reach.far);
  target += across.x * right + across.y * up + depth * forward;
  reach.high = reach.low = 0.5 * (reach.high + reach.low) + depth * slope;
  reach.near -= depth;
  reach.far -= depth;
}

// Of all sides of all views, each in units of its `by`.
double greatest_reach(const std::vector<View>& views, const glm::dvec2& by) {
  double greatest = -kInfinity;
  for (const View& view : views) {
    const glm::dvec2 reach = glm::max(view.reach.high, view.reach.low) / by;
    greatest = std::max({greatest, reach.x, reach.y});
  }
  return greatest;
}

// How far before the target the eye must be for a perspective view of all.
double distance_for(const std::vector<View>& views, const glm::dvec2& slope) {
  double distance = greatest_reach(views, slope);
  for (const View& view : views) {
    const Reach& reach = view.reach;
    distance = std::max(distance, kBefore * (reach.far - reach.near) - reach.near);
  }
  return distance;
}

// Of a view whose eye is `distance` before the target.
void set_depths(double distance, const Reach& reach, double size, Camera& camera) {
  camera.near = distance + reach.near;
  camera.far = distance + reach.far;
  // Far from the target the reach alone would be lost in rounding.
  const double pad = 1e-9 * std::max(std::abs(camera.near), std::abs(camera.far));
  camera.near -= pad;
  camera.far += pad;
  if (camera.orthographic) return;
  // Points behind the eye still get a legal, if empty, depth range.
  if (!(camera.far > 0.0)) camera.far = size;
  camera.near = std::max(camera.near, camera.far / kDepthRange);
}

// What the options fix; the target is the box's middle where they do not.
Camera as_fixed(const CameraOptions& options, const Box& box) {
  Camera camera;
  camera.orthographic = options.orthographic;
  camera.fov_y_degrees = options.fov_y_degrees.value_or(camera.fov_y_degrees);
  camera.up = options.up.value_or(camera.up);
  camera.target = options.target.value_or(box.middle);
  camera.eye = options.eye.value_or(camera.eye);
  if (options.eye && camera.eye == camera.target) camera.target.z -= box.size;
  return camera;
}

// `from` after a part of a full circle around `axis`.
glm::dvec3 turned(const glm::dvec3& from, const glm::dvec3& axis, double turn) {
  const double angle = glm::radians(360.0 * turn);
  return glm::dvec3(glm::rotate(glm::dmat4(1.0), angle, glm::normalize(axis)) *
                    glm::dvec4(from, 0.0));
}

// The direction from which a view is by itself: the front, right and above, as `up` has it. Where
// that is not y, all is turned the shortest way.
glm::dvec3 from_of(const glm::dvec3& up) {
  const glm::dvec3 from{0.5, 0.45, 0.9};
  const glm::dvec3 y{0.0, 1.0, 0.0};
  const glm::dvec3 to = glm::normalize(up);
  const glm::dvec3 axis = glm::cross(y, to);
  if (glm::length(axis) < 1e-9) return to.y > 0.0 ? from : glm::dvec3{-from.x, -from.y, from.z};
  const double angle = std::atan2(glm::length(axis), glm::dot(y, to));
  return turned(from, axis, angle / glm::radians(360.0));
}

}  // namespace

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

std::vector<Camera> orbit_cameras(std::span<const glm::vec3> points, double aspect,
                                  const CameraOptions& options, int views) {
  const glm::vec3 lone(0.0F);
  if (points.empty()) points = {&lone, 1};
  const Box box = box_of(points);
  Camera camera = as_fixed(options, box);
  const glm::dvec3 from = options.eye ? camera.eye - camera.target : from_of(camera.up);
  const double tangent = std::tan(glm::radians(camera.fov_y_degrees) / 2.0);
  const glm::dvec2 shape{kFill * aspect, kFill};
  const glm::dvec2 slope = (camera.orthographic ? 0.0 : tangent) * shape;

  std::vector<View> seen;
  for (int i = 0; i < views; ++i) {
    const double turn = static_cast<double>(i) / views;
    const Sides sides = sides_of(i == 0 ? from : turned(from, camera.up, turn), camera.up, slope);
    seen.push_back({sides, reach_of(points, camera.target, sides, box.least)});
  }
  if (views == 1 && !options.eye && !options.target) centre(seen[0], camera.target);

  double distance = box.size;  // orthographic: any
  if (options.eye) {
    distance = glm::length(from);
  } else if (!camera.orthographic) {
    const double least = 1e-8 * (box.size + glm::length(camera.target));
    distance = std::max(distance_for(seen, slope), least);
  }
  if (camera.orthographic) {
    camera.ortho_height = options.ortho_height.value_or(2.0 * greatest_reach(seen, shape));
  }
  std::vector<Camera> cameras;
  for (const View& view : seen) {
    if (!options.eye || !cameras.empty()) {
      camera.eye = camera.target - distance * view.sides.forward;
    }
    set_depths(distance, view.reach, box.size, camera);
    cameras.push_back(camera);
  }
  return cameras;
}

Camera frame_camera(std::span<const glm::vec3> points, double aspect,
                    const CameraOptions& options) {
  return orbit_cameras(points, aspect, options, 1).front();
}

}  // namespace halfspace
