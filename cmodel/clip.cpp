// SPDX-License-Identifier: Apache-2.0
//
// The planes that geometry cuts by, and the cutting.
#include <algorithm>
#include <cmath>

#include "fixed.hpp"
#include "geometry.hpp"

namespace halfspace {

namespace {

// Where the edge meets the plane. Both weights are positive, so w, positive from the first plane
// on, suffers no cancellation, and limits that both ends keep are kept to a few units in the last
// place. The last step makes the limit of this plane hold exactly.
ClipVertex cut(const ClipPlane& plane, const ClipVertex& inside, double inside_distance,
               const ClipVertex& outside, double outside_distance) {
  const double span = inside_distance - outside_distance;
  const double to_outside = inside_distance / span;
  const double to_inside = -outside_distance / span;
  ClipVertex vertex;
  vertex.position = to_inside * inside.position + to_outside * outside.position;
  for (std::size_t i = 0; i < kMaxAttributes; ++i) {
    vertex.attribute[i] = to_inside * inside.attribute[i] + to_outside * outside.attribute[i];
  }
  vertex.position[plane.axis] = plane_bound(plane, vertex.position);
  return vertex;
}

void clip_plane(const ClipPlane& plane, const ClipPolygon& in, ClipPolygon& out) {
  out.count = 0;
  const auto append = [&out](const ClipVertex& vertex) {
    HS_CHECK(out.count < static_cast<int>(out.vertex.size()));
    out.vertex[static_cast<std::size_t>(out.count++)] = vertex;
  };
  for (int i = 0; i < in.count; ++i) {
    const ClipVertex& from = in.vertex[static_cast<std::size_t>(i)];
    const ClipVertex& to = in.vertex[static_cast<std::size_t>(i + 1 < in.count ? i + 1 : 0)];
    const double from_distance = plane_distance(plane, from.position);
    const double to_distance = plane_distance(plane, to.position);
    if (from_distance >= 0.0) append(from);
    // Always from the inside to the outside; an inside vertex on the plane is its own cut point.
    if (from_distance > 0.0 && to_distance < 0.0) {
      append(cut(plane, from, from_distance, to, to_distance));
    } else if (from_distance < 0.0 && to_distance > 0.0) {
      append(cut(plane, to, to_distance, from, from_distance));
    }
  }
}

}  // namespace

ClipVolume clip_volume(const FrameState& frame, const Config& config) {
  double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0;
  if (config.has_guard_band()) {
    // Window x = (x/w + 1) width / 2 and y = (1 - y/w) height / 2, both within +-limit.
    const double limit =
        std::ldexp(static_cast<double>(config.coordinate_max()), -config.subpixel_bits);
    right = 2.0 * limit / frame.width - 1.0;
    left = -2.0 * limit / frame.width - 1.0;
    top = 1.0 + 2.0 * limit / frame.height;
    bottom = 1.0 - 2.0 * limit / frame.height;
  }
  return {{{3, kMinW, -1.0},
           {2, -1.0, -1.0},
           {2, 1.0, 1.0},
           {0, left, -1.0},
           {0, right, 1.0},
           {1, bottom, -1.0},
           {1, top, 1.0}}};
}

ClipPolygon clip(const std::array<ClipVertex, 3>& triangle, std::span<const ClipPlane> planes) {
  ClipPolygon polygon;
  std::copy(triangle.begin(), triangle.end(), polygon.vertex.begin());
  polygon.count = 3;
  ClipPolygon next;
  for (const ClipPlane& plane : planes) {
    clip_plane(plane, polygon, next);
    std::swap(polygon, next);
    if (polygon.count < 3) return {};
  }
  return polygon;
}

}  // namespace halfspace
