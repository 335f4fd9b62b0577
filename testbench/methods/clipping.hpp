// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "method.hpp"

namespace halfspace::methods {

// The half-space dot(normal, p) >= 0 of clip space: a plane through the eye's point in four
// dimensions, so no division comes before the cut.
struct Plane4 {
  glm::dvec4 normal{0.0};
};

// The six planes of the view volume, near first; the near plane; near and far with the four sides
// moved out to +-band px of the window.
std::span<const Plane4> view_volume();
std::span<const Plane4> near_plane();
std::vector<Plane4> guard_band(const View& view, double band);

// The part of a convex polygon inside one plane. Where f(a) and f(b) differ in sign the edge is cut
// at t = f(a) / (f(a) - f(b)), attributes alike.
std::vector<ClipPoint> clip_polygon(std::span<const ClipPoint> polygon, const Plane4& plane);

// The part of a triangle inside all planes, as a fan of new triangles.
std::vector<ClipFacet> clip_facet(const ClipFacet& facet, std::span<const Plane4> planes);

}  // namespace halfspace::methods
