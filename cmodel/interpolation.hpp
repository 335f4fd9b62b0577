// SPDX-License-Identifier: Apache-2.0
//
// Depth and attributes as fixed-point planes: once per triangle, once per tile, then one addition
// per lane. Formats, roundings and the proof of the error bound: docs/03_design/interpolation.md.
// All sums are taken modulo a power of two: a plane's slope may not fit its register, its value at
// a covered sample always does. Twin: none yet in rtl/ (host-side model of the planned stage).
#pragma once

#include <array>
#include <cstdint>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// Every interpolated quantity is aligned to U0.30 ("units" below are 2^-30 of full scale).
inline constexpr int kPlaneBits = 30;

// One quantity over the whole triangle. Modulo 2^64.
struct Plane {
  std::uint64_t at_vertex0 = 0;  // U.F units at vertex 0
  std::uint64_t dx = 0;          // S.F units per pixel: floor of the exact quotient
  std::uint64_t dy = 0;
  bool operator==(const Plane&) const = default;
};

// One triangle's planes. inverse_w and attribute are set only when asked for.
struct InterpolationSetup {
  Point origin;  // vertex 0, S.s px
  Plane depth;
  Plane inverse_w;
  std::array<Plane, kMaxAttributes> attribute;  // attribute / 256 / w
  bool operator==(const InterpolationSetup&) const = default;
};

// One quantity over one tile, in units, modulo 2^32: base + dx i + dy j + offset[m] at sample m of
// pixel (i, j). base is at the centre of the tile's first pixel.
struct TilePlane {
  std::uint32_t base = 0;
  std::uint32_t dx = 0;
  std::uint32_t dy = 0;
  bool operator==(const TilePlane&) const = default;

  // In units; meaningful at covered samples, where it is within the bound of the true value.
  std::int32_t at(int i, int j) const {
    return static_cast<std::int32_t>(base + dx * static_cast<std::uint32_t>(i) +
                                     dy * static_cast<std::uint32_t>(j));
  }
};

// The planes of one triangle.
//
//   setup       oriented slopes, as triangle_setup() returned them for this triangle
//   triangle    its vertices
//   attributes  depth U<depth_bits>.6, inverse_w U0.<inverse_w_bits> (1 at least), value U8.8
//               (ranges checked)
//   count       attributes to set up, 0..config.attributes; 0 sets up depth alone
//
// Rounding: gradients are floor(2^(s+F) * sum(V_i A_i) / area2), exact integers.
// Cost: two divisions per quantity.
InterpolationSetup interpolation_setup(const SetupTriangle& setup, const Triangle& triangle,
                                       const std::array<VertexAttributes, 3>& attributes, int count,
                                       const Config& config);

// A plane moved to the tile whose first pixel is (x, y). Cost: two products.
TilePlane tile_plane(const Plane& plane, Point origin, std::int32_t x, std::int32_t y,
                     const Config& config);

// What to add to TilePlane::at() for sample m: its offset from the pixel's centre, in units, floor.
// Zero for one sample.
std::uint32_t sample_delta(const Plane& plane, int sample, const Config& config);

// Units to a depth-buffer value: rounded to nearest, clamped to 0..2^depth_bits - 1.
std::uint32_t depth_value(std::int32_t units, const Config& config);

// floor(2^(2R) / (2 mantissa + 1)), the reciprocal of the middle of [mantissa, mantissa + 1), for
// an R-bit mantissa in [2^(R-1), 2^R), R = reciprocal_bits.
std::uint32_t reciprocal(std::uint32_t mantissa, const Config& config);

// attribute / w over 1 / w, both in units at the same sample, to an 8-bit attribute, rounded to
// nearest and clamped to 0..255. inverse_w is taken as 1 when it is below.
std::uint8_t perspective(std::int32_t attribute, std::int32_t inverse_w, const Config& config);

}  // namespace halfspace
