// SPDX-License-Identifier: Apache-2.0
//
// What travels between the stages: one struct per arrow of the data flow. Up to coverage they have
// the same fields in the same order as the packed structs of rtl/hs_pkg.sv. Formats name the widths
// of Config. s = subpixel_bits, q = sample_bits().
#pragma once

#include <array>
#include <cstdint>

namespace halfspace {

// Which triangles triangle_setup drops by the way they face. A front face winds counter-clockwise
// as seen on the screen (y down: its doubled area is negative).
enum class Cull : std::uint8_t { kNone, kBack, kFront };

// State that holds for a whole frame; registers in the RTL, changed only while it is empty.
struct FrameState {
  int width = 0;   // pixels, 1..2^viewport_bits
  int height = 0;  // pixels, 1..2^viewport_bits
  Cull cull = Cull::kNone;
};

// A snapped position: x right, y down, origin at the frame's top-left corner. S.s px,
// vertex_bits().
struct Point {
  std::int32_t x = 0;
  std::int32_t y = 0;
  bool operator==(const Point&) const = default;
};

// Host to triangle_setup. Coordinates must be in [coordinate_min(), coordinate_max()]: the host
// clips or refuses, setup checks.
struct Triangle {
  std::array<Point, 3> vertex;
  std::uint32_t tag = 0;  // tag_bits; the host numbers triangles in submission order
  bool operator==(const Triangle&) const = default;
};

// The topmost of three points, of two the one to the left: the same one in whatever order they
// come.
inline std::size_t first_vertex(const std::array<Point, 3>& v) {
  const auto before = [&v](std::size_t i, std::size_t j) {
    return v[i].y < v[j].y || (v[i].y == v[j].y && v[i].x < v[j].x);
  };
  const std::size_t first = before(1, 0) ? 1 : 0;
  return before(2, first) ? 2 : first;
}

inline constexpr int kMaxAttributes = 8;

// Every interpolated quantity is aligned to U0.30 ("units" below are 2^-30 of full scale).
inline constexpr int kPlaneBits = 30;
inline constexpr int kAttributeFractionBits = 8;  // of a vertex's attribute below one level of 255

// What a vertex may hold. A vertex that clipping made may lie beyond the values of its triangle,
// because snapping moved it off the triangle: by half of full scale at most.
inline constexpr std::int32_t kDepthLeast = -(1 << (kPlaneBits - 1));
inline constexpr std::int32_t kDepthMost = 3 * (1 << (kPlaneBits - 1)) - 1;
inline constexpr std::int32_t kValueLeast = -(128 << kAttributeFractionBits);
inline constexpr std::int32_t kValueMost = (384 << kAttributeFractionBits) - 1;

// What interpolation needs at one vertex; made by the host, checked by interpolation_setup().
struct VertexAttributes {
  std::int32_t depth = 0;       // units: window depth 0..1 times (2^depth_bits - 1) / 2^depth_bits
  std::uint32_t inverse_w = 0;  // U0.<inverse_w_bits>, scaled by one power of two per triangle so
                                // that the greatest of the three has its top bit set; never 0
  std::array<std::int32_t, kMaxAttributes> value{};  // S9.8: 0..255 in units of 1/256
  bool operator==(const VertexAttributes&) const = default;
};

// geometry to triangle_setup and interpolation.
struct ShadedTriangle {
  Triangle triangle;
  std::array<VertexAttributes, 3> attributes;
  bool operator==(const ShadedTriangle&) const = default;
};

// Pixels first..last in each direction, both included; inside the frame, never empty.
struct Box {
  std::int32_t x_first = 0;
  std::int32_t y_first = 0;
  std::int32_t x_last = 0;
  std::int32_t y_last = 0;
  bool operator==(const Box&) const = default;
};

// True when a box is not empty and lies in the frame.
inline bool inside(const Box& box, const FrameState& frame) {
  return box.x_first >= 0 && box.x_first <= box.x_last && box.x_last < frame.width &&
         box.y_first >= 0 && box.y_first <= box.y_last && box.y_last < frame.height;
}

// The slopes of one edge function, inside positive: E(x + 1 px, y) = E + a 2^q.
struct EdgeSlope {
  std::int32_t a = 0;  // S.s px, delta_bits()
  std::int32_t b = 0;  // S.s px, delta_bits()
  bool operator==(const EdgeSlope&) const = default;
};

// triangle_setup to tile_traversal. Edge i runs from vertex i to vertex (i + 1) mod 3 of the
// submitted triangle, negated when the triangle was clockwise the other way (`flipped`).
struct SetupTriangle {
  std::array<EdgeSlope, 3> slope;
  // Biased edge values at the root's origin: pixel (0,0)'s centre for one sample, its top-left
  // corner otherwise. S.(s+q) px^2, node_bits(root), saturated.
  std::array<std::int64_t, 3> e{};
  Box box;
  bool flipped = false;  // the doubled area was negative: A, B, C were negated
  std::uint32_t tag = 0;
  bool operator==(const SetupTriangle&) const = default;
};

// One node of the pyramid on its way down, and, at the leaf level, the tile handed to coverage.
struct Node {
  std::int32_t x = 0;  // pixel column of the node's origin, a multiple of its side
  std::int32_t y = 0;
  std::array<std::int64_t, 3> e{};  // S.(s+q) px^2 at the origin, node_bits(side), saturated
  bool operator==(const Node&) const = default;
};

// Lane j * grid + i of a grid, i right and j down. A 4x4 grid uses the low 16 bits.
using GridMask = std::uint64_t;

inline constexpr int kMaxSamples = 16;

// A mask for each sample; those beyond Config::samples are 0.
using SampleMasks = std::array<GridMask, kMaxSamples>;

// coverage to interpolation: one tile of one triangle, at least one bit set.
struct CoverageTile {
  std::int32_t x = 0;  // pixel column of the tile's first pixel
  std::int32_t y = 0;
  SampleMasks mask{};
  std::uint32_t tag = 0;
  bool operator==(const CoverageTile&) const = default;
};

// One quantity over the whole triangle. Modulo 2^64.
struct Plane {
  std::uint64_t at_origin = 0;  // S.F units at InterpolationSetup::origin
  std::uint64_t dx = 0;         // S.F units per pixel
  std::uint64_t dy = 0;
  bool operator==(const Plane&) const = default;
};

// One triangle's planes. inverse_w and attribute are set only when asked for.
struct InterpolationSetup {
  Point origin;  // S.s px: first_vertex()
  Plane depth;
  Plane inverse_w;
  std::array<Plane, kMaxAttributes> attribute;       // (attribute - level) / 256 / w
  std::array<std::uint8_t, kMaxAttributes> level{};  // least of the vertices, whole and in 0..255
  bool operator==(const InterpolationSetup&) const = default;
};

// One quantity over one tile, in units, modulo 2^32: base + dx i + dy j at the centre of pixel
// (i, j).
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

using Rgb = std::array<std::uint8_t, 3>;

// The same with what each sample adds to its pixel's centre.
struct SampledPlane {
  TilePlane center;
  std::array<std::uint32_t, kMaxSamples> offset{};
  bool operator==(const SampledPlane&) const = default;

  // A negative sample is the pixel's centre.
  std::int32_t at(int i, int j, int sample) const {
    const std::uint32_t by = sample < 0 ? 0 : offset[static_cast<std::size_t>(sample)];
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(center.at(i, j)) + by);
  }
};

// interpolation to shading: what colours one tile.
struct ShadingPlanes {
  SampledPlane inverse_w;
  std::array<SampledPlane, 3> color;  // red, green, blue, each less its level, / 256 / w
  Rgb level{};
  bool operator==(const ShadingPlanes&) const = default;
};

// framebuffer to depth and back: depths of one sample of every pixel of a tile, U0.depth_bits.
using DepthTile = std::array<std::uint32_t, 64>;

// shading to framebuffer: the colours of a tile's pixels; black where there is no fragment.
using ColorTile = std::array<Rgb, 64>;

// A Plane as the RTL hands it on: its start moved to the frame's first pixel, so that a tile needs
// no product as wide as a gradient. F = gradient_bits, f = position_bits().
struct CornerPlane {
  std::uint64_t at_pixel0 = 0;  // S.(F+f) units at the centre of pixel (0, 0), modulo 2^(32+F+f)
  std::uint64_t dx = 0;         // S.F units per pixel, modulo 2^(32+F), several samples 2^(36+F)
  std::uint64_t dy = 0;
  bool operator==(const CornerPlane&) const = default;
};

}  // namespace halfspace
