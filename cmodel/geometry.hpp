// SPDX-License-Identifier: Apache-2.0
//
// The host stage: vertices in clip space in, fixed-point triangles out. Homogeneous clipping,
// viewport, snapping and the packing of attributes. Double precision throughout. Twin: none,
// the host's.
// Conventions are OpenGL's up to the viewport (clip volume -w <= x, y, z <= w), then y points
// down. Page: docs/03_design/geometry.md.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <tuple>
#include <vector>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// A vertex in clip space, before the division by w.
struct ClipVertex {
  glm::dvec4 position{0.0};
  std::array<double, kMaxAttributes> attribute{};  // 0..255
};

// Keeps sign * (limit * w - position[axis]) >= 0; for axis 3 keeps w >= limit.
struct ClipPlane {
  int axis = 0;
  double limit = 0.0;
  double sign = 1.0;
};

inline double plane_bound(const ClipPlane& plane, const glm::dvec4& position) {
  return plane.axis == 3 ? plane.limit : plane.limit * position.w;
}
// Above 0 inside.
inline double plane_distance(const ClipPlane& plane, const glm::dvec4& position) {
  return plane.sign * (plane_bound(plane, position) - position[plane.axis]);
}

inline constexpr int kClipPlanes = 7;
inline constexpr int kDepthPlanes = 3;  // of those, the first: w, near, far
using ClipVolume = std::array<ClipPlane, kClipPlanes>;

// The volume that `config` can represent: w at least a tiny positive number, near, far, then the
// guard band's four sides, or the frame's when there is no guard band. The order is part of the
// contract: both triangles at an edge are cut by the same planes in the same order.
ClipVolume clip_volume(const FrameState& frame, const Config& config);

// A convex polygon; every plane adds at most one vertex to a triangle's three.
struct ClipPolygon {
  std::array<ClipVertex, 3 + kClipPlanes> vertex{};
  int count = 0;
};

// The part of a triangle inside all planes (at most kClipPlanes of them), Sutherland-Hodgman. A cut
// point depends on its edge's two end points only, not on their order nor on the rest of the
// triangle, and lies on its plane exactly. Positions must be finite and at most kMaxMagnitude.
ClipPolygon clip(const std::array<ClipVertex, 3>& triangle, std::span<const ClipPlane> planes);

// Beyond this a coordinate counts as not finite: products of two still fit a double.
inline constexpr double kMaxMagnitude = 1e100;
// The least w kept. Far below the w of any near plane, so only triangles that reach the eye's own
// plane (w = 0) are cut here.
inline constexpr double kMinW = 1e-100;

// px in subpixels, rounded as config.snap says; halves are exact ties. px must not be NaN; beyond
// +-2^40 px the result is that of +-2^40 px, so it never overflows. The caller checks the range.
std::int64_t snap(double px, const Config& config);

// Where a position with w > 0 is in the frame, px: x right, y down. What is snapped.
inline glm::dvec2 window_position(const glm::dvec4& p, double half_width, double half_height) {
  return {(p.x / p.w + 1.0) * half_width, (1.0 - p.y / p.w) * half_height};
}

class UncutPlane;

struct GeometryStats {
  std::uint64_t triangles_in = 0;
  std::uint64_t dropped_not_finite = 0;  // a coordinate is NaN, infinite or above kMaxMagnitude
  std::uint64_t outside = 0;             // nothing of it is in the frame and between near and far
  std::uint64_t clipped = 0;             // cut by a plane, and something was left
  std::uint64_t beyond_sides = 0;        // between near and far, a vertex is beyond a side of the
                                         // range: what is left, if anything, was cut there
  std::uint64_t triangles_out = 0;
  bool operator==(const GeometryStats&) const = default;
  GeometryStats& operator+=(const GeometryStats& other);
};

// Clips, projects, snaps and packs one triangle after another. Holds what depends on the frame
// and the configuration alone, so that the common triangle, cut by nothing, costs three
// projections and no allocation but the output's own. One object per thread.
class GeometryStage {
 public:
  // frame: 1..2^viewport_bits px a side; config: legal (checked).
  GeometryStage(const FrameState& frame, const Config& config);

  // Appends 0..8 triangles to `out`: none when the triangle is outside, has a coordinate that is
  // not finite, or was cut into pieces without area. All carry `tag`, the index of the submitted
  // triangle, truncated to tag_bits. Order of vertices, so the way it faces, is kept. A triangle
  // that was not cut is passed on whatever its area; setup drops it. Attributes that are NaN count
  // as 0. Every coordinate is in [coordinate_min(), coordinate_max()] (checked).
  void process(const std::array<ClipVertex, 3>& triangle, std::uint32_t tag,
               std::vector<ShadedTriangle>& out);

  const GeometryStats& stats() const { return stats_; }

 private:
  // A vertex after the division by w; inverse_w still real, because its scale is the triangle's.
  struct Projected {
    Point point;
    double inverse_w = 0.0;
    VertexAttributes attributes;
  };

  // An order of projected vertices.
  static auto key(const Projected& v) {
    return std::tie(v.point.y, v.point.x, v.inverse_w, v.attributes.depth, v.attributes.value);
  }

  unsigned outside_planes(const glm::dvec4& position) const;
  bool beyond_sides(const ClipPolygon& polygon) const;
  Projected project(const ClipVertex& vertex) const;
  void emit(const Projected& a, const Projected& b, const Projected& c, std::uint32_t tag,
            std::vector<ShadedTriangle>& out);
  bool take_plane(const UncutPlane& plane, std::span<Projected> polygon) const;
  void emit_polygon(const ClipPolygon& polygon, const UncutPlane& plane, std::uint32_t tag,
                    std::vector<ShadedTriangle>& out);

  Config config_;
  ClipVolume volume_;
  double half_width_;
  double half_height_;
  double depth_scale_;  // of ndc z + 1, units
  std::uint32_t tag_mask_;
  GeometryStats stats_;
};

}  // namespace halfspace
