// SPDX-License-Identifier: Apache-2.0
#include "real_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace halfspace {
namespace {

bool representable(const glm::dvec4& p) {
  for (int i = 0; i < 4; ++i) {
    if (!(std::abs(p[i]) <= kMaxMagnitude)) return false;
  }
  return true;
}

bool outside(const ClipPlane& plane, const glm::dvec4& p) {
  const double bound = plane.axis == 3 ? plane.limit : plane.limit * p.w;
  return plane.sign * (bound - p[plane.axis]) < 0.0;
}

RealVertex project(const ClipVertex& vertex, const FrameState& frame) {
  const glm::dvec2 at = window_position(vertex.position, frame.width / 2.0, frame.height / 2.0);
  return {at.x, at.y, 1.0 / vertex.position.w, vertex.attribute};
}

}  // namespace

void real_triangles(const std::array<ClipVertex, 3>& triangle, std::uint64_t index,
                    const FrameState& frame, int guard_bits, const RealSink& sink) {
  for (const ClipVertex& vertex : triangle) {
    if (!representable(vertex.position)) return;
  }
  const auto count_outside = [&](const ClipPlane& plane) {
    return std::count_if(triangle.begin(), triangle.end(),
                         [&](const ClipVertex& vertex) { return outside(plane, vertex.position); });
  };
  // Without a guard band the volume's sides are the frame's.
  for (const ClipPlane& plane : clip_volume(frame, Config{.guard_bits = 0})) {
    if (count_outside(plane) == 3) return;
  }
  const ClipVolume volume = clip_volume(frame, Config{.guard_bits = guard_bits});
  const auto cutting = std::span(volume).first(guard_bits == 0 ? kDepthPlanes : kClipPlanes);
  if (std::all_of(cutting.begin(), cutting.end(),
                  [&](const ClipPlane& plane) { return count_outside(plane) == 0; })) {
    sink({{project(triangle[0], frame), project(triangle[1], frame), project(triangle[2], frame)},
          index,
          true});
    return;
  }
  const ClipPolygon polygon = clip(triangle, cutting);
  for (int i = 1; i + 1 < polygon.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    sink({{project(polygon.vertex[0], frame), project(polygon.vertex[at], frame),
           project(polygon.vertex[at + 1], frame)},
          index,
          false});
  }
}

}  // namespace halfspace
