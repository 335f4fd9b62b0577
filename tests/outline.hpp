// SPDX-License-Identifier: Apache-2.0
//
// Where a camera puts points in its picture.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "camera.hpp"
#include "splitmix.hpp"

namespace halfspace {

using Points = std::vector<glm::vec3>;

// -1..1, in 53 bits.
inline double unit(std::uint64_t& state) {
  return std::ldexp(static_cast<double>(splitmix_next(state) >> 11), -52) - 1.0;
}

// A cloud in a box that may be flat, long or far away.
inline Points random_points(std::uint64_t& state) {
  const auto any = [&state] { return glm::dvec3{unit(state), unit(state), unit(state)}; };
  const glm::dvec3 size = glm::exp2(4.0 * any());
  const glm::dvec3 middle = 20.0 * any();
  Points points(3 + splitmix_next(state) % 200);
  for (glm::vec3& point : points) point = middle + size * any();
  return points;
}

// The outermost of the points in the picture: x and y of -1..1 from edge to edge.
struct Outline {
  glm::dvec2 low{HUGE_VAL};
  glm::dvec2 high{-HUGE_VAL};
  double near = HUGE_VAL;  // depths
  double far = 0.0;
  // From the middle to the furthest.
  double widest() const { return std::max({-low.x, -low.y, high.x, high.y}); }
  // The same of the side that is less reached, of the pair of opposite sides that is more so.
  double pair() const { return std::max(std::min(-low.x, high.x), std::min(-low.y, high.y)); }
  // Is the eye as near to the points as it goes?
  bool is_close() const { return near <= 0.02001 * (far - near); }
};

// Every point must be in the clip volume.
inline Outline expect_in_frame(const Points& points, const Camera& camera, double aspect) {
  Outline outline;
  const glm::dmat4 matrix = world_to_clip(camera, aspect);
  EXPECT_TRUE(camera.near < camera.far && (camera.orthographic || camera.near > 0.0));
  for (const glm::vec3& point : points) {
    const glm::dvec4 p = matrix * glm::dvec4(glm::dvec3(point), 1.0);
    EXPECT_GT(p.w, 0.0);
    for (int axis = 0; axis < 3; ++axis) EXPECT_LE(std::abs(p[axis]), p.w);
    outline.low = glm::min(outline.low, glm::dvec2(p) / p.w);
    outline.high = glm::max(outline.high, glm::dvec2(p) / p.w);
    outline.near = std::min(outline.near, p.w);
    outline.far = std::max(outline.far, p.w);
  }
  return outline;
}

}  // namespace halfspace
