// SPDX-License-Identifier: Apache-2.0
//
// Depth and attributes as fixed-point planes: once per triangle, once per tile, then one addition
// per lane. Formats, roundings and the proof of the error bound: docs/03_design/interpolation.md.
// All sums are taken modulo a power of two: a plane's slope may not fit its register, its value at
// a covered sample always does. Twin: rtl/hs_reciprocal.sv, rtl/hs_gradient.sv,
// rtl/hs_tile_plane.sv.
#pragma once

#include <array>
#include <cstdint>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// The planes of one triangle: the same bits whatever the order of its vertices.
//
//   setup       oriented slopes, as triangle_setup() returned them for this triangle
//   triangle    its vertices
//   attributes  depth in units, inverse_w U0.<inverse_w_bits> (1 at least), value S9.8 (ranges
//               checked)
//   count       attributes to set up, 0..config.attributes; 0 sets up depth alone
//
// Rounding: gradients are the floor of an exact product with area_reciprocal(), which is within
// 2^-31 of the reciprocal. Cost: a division per triangle, four products per quantity.
InterpolationSetup interpolation_setup(const SetupTriangle& setup, const Triangle& triangle,
                                       const std::array<VertexAttributes, 3>& attributes, int count,
                                       const Config& config);

// The reciprocal of a triangle's doubled area, once for all of its gradients.
struct AreaReciprocal {
  std::uint64_t factor = 0;  // 2 r + 1, below 2^33
  int shift = 0;             // 1 / area is about factor / 2^shift
};

// The triangle's doubled area, above 0: the cross product of two edges.
std::int64_t doubled_area(const SetupTriangle& setup);

// area above 0 and below 2^62: with L its bits and m the top 32 of them (zeros appended to a
// narrower one), r = floor(2^64 / (2 m + 1)) and the shift is 32 + L.
AreaReciprocal area_reciprocal(std::int64_t area);

// A plane moved to the tile whose first pixel is (x, y). Cost: two products.
TilePlane tile_plane(const Plane& plane, Point origin, std::int32_t x, std::int32_t y,
                     const Config& config);

// The same plane from the frame's first pixel on. Exact: the bits it drops reach no tile.
CornerPlane corner_plane(const Plane& plane, Point origin, const Config& config);

// tile_plane() of the Plane that it was made of, bit for bit.
TilePlane tile_plane(const CornerPlane& plane, std::int32_t x, std::int32_t y,
                     const Config& config);

// What to add to TilePlane::at() for sample m: its offset from the pixel's centre, in units, floor.
// Zero for one sample.
std::uint32_t sample_delta(const Plane& plane, int sample, const Config& config);

// What colours the tile whose first pixel is (x, y): `setup` with its first `colors` attributes,
// 0..3; the others stay 0.
ShadingPlanes shading_planes(const InterpolationSetup& setup, int colors, std::int32_t x,
                             std::int32_t y, const Config& config);

}  // namespace halfspace
