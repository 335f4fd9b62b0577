// SPDX-License-Identifier: Apache-2.0
#include "frame_planes.hpp"

namespace halfspace {
namespace {

InterpolationSetup plain_planes(const FrameTriangle& triangle, const FrameConstants& constants,
                                int count) {
  const std::array<std::uint32_t, 3> inverse_w = packed_inverse_w(triangle, constants);
  Triangle points;
  std::array<VertexAttributes, 3> attributes;
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexRecord& vertex = *triangle.vertex[i];
    points.vertex[i] = vertex.point;
    attributes[i].depth = vertex.depth;
    attributes[i].inverse_w = inverse_w[i];
    for (std::size_t n = 0; n < 3; ++n) attributes[i].value[n] = vertex.value_of(n);
  }
  SetupTriangle setup;
  const FrameEdges edges = frame_edges(triangle, constants);
  const auto slope = [](std::int64_t a, std::int64_t b) {
    return EdgeSlope{static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)};
  };
  setup.slope = {slope(edges.a0, edges.b0), slope(-edges.a0 - edges.a2, -edges.b0 - edges.b2),
                 slope(edges.a2, edges.b2)};
  const std::array<Point, 3>& v = points.vertex;
  setup.flipped = (std::int64_t{v[1].x} - v[0].x) * (std::int64_t{v[2].y} - v[0].y) -
                      (std::int64_t{v[1].y} - v[0].y) * (std::int64_t{v[2].x} - v[0].x) <
                  0;
  return interpolation_setup(setup, points, attributes, count, constants.config);
}

}  // namespace

FramePlane plain_depth_plane(const FrameTriangle& triangle, const FrameConstants& constants) {
  const Plane plane = plain_planes(triangle, constants, 0).depth;
  return frame_plane(plane.at_origin, plane.dx, plane.dy, frame_edges(triangle, constants),
                     constants);
}

ShadePlanes plain_shade_planes(const FrameTriangle& triangle, const FrameConstants& constants) {
  const InterpolationSetup setup = plain_planes(triangle, constants, constants.colors);
  const FrameEdges e = frame_edges(triangle, constants);
  ShadePlanes out;
  for (std::size_t n = 0; n < 3; ++n) out.level |= std::uint32_t{setup.level[n]} << (8 * n);
  for (std::size_t n = 0; n < kShades; ++n) {
    const Plane& plane = n < 3 ? setup.attribute[n] : setup.inverse_w;
    const FramePlane at = frame_plane(plane.at_origin, plane.dx, plane.dy, e, constants);
    out.origin[n] = at.origin;
    out.dx[n] = at.dx;
    out.dy[n] = at.dy;
    out.lane_dx[n] = at.lane_dx;
    out.lane_dy[n] = at.lane_dy;
  }
  return out;
}

}  // namespace halfspace
