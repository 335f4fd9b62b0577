// SPDX-License-Identifier: Apache-2.0
//
// Planes of interpolation_setup() and tile_plane() for FrameTriangles. Proofs:
// docs/03_design/frame_engine.md.
#pragma once

#include <algorithm>
#include <bit>

#include "../../interpolation.hpp"
#include "../../scissor.hpp"
#include "frame_records.hpp"

namespace halfspace {

// The slopes that weigh vertices 1 and 2, oriented, and the doubled area they belong to.
struct FrameEdges {
  std::int64_t a0 = 0, b0 = 0;  // of edge 0, opposite vertex 2. S.s px
  std::int64_t a2 = 0, b2 = 0;  // of edge 2, opposite vertex 1
  std::int64_t area = 1;        // above 0, S.2s px^2
  std::int64_t x = 0, y = 0;    // from vertex 0 to the centre of pixel (0, 0), S.f px
};

inline FrameEdges frame_edges(const FrameTriangle& triangle, const FrameConstants& c) {
  const Point p = triangle.vertex[0]->point;
  const Point q = triangle.vertex[1]->point;
  const Point r = triangle.vertex[2]->point;
  FrameEdges e;
  e.a0 = std::int64_t{p.y} - q.y;
  e.b0 = std::int64_t{q.x} - p.x;
  e.a2 = std::int64_t{r.y} - p.y;
  e.b2 = std::int64_t{p.x} - r.x;
  const std::int64_t area = e.a2 * e.b0 - e.a0 * e.b2;
  const std::int64_t flip = area >> 63;
  const auto oriented = [flip](std::int64_t v) { return (v ^ flip) - flip; };
  e.a0 = oriented(e.a0);
  e.b0 = oriented(e.b0);
  e.a2 = oriented(e.a2);
  e.b2 = oriented(e.b2);
  e.area = oriented(area);
  const int up = c.f - c.config.subpixel_bits;
  const std::int64_t half = std::int64_t{1} << (c.f - 1);
  e.x = half - (std::int64_t{p.x} << up);
  e.y = half - (std::int64_t{p.y} << up);
  return e;
}

// Adding it rounds a double below 2^51 to an integer, in its low bits.
inline constexpr double kRounder = 0x1.8p52;

// What a numerator's product with the factor is shifted by: units / px, F fraction bits.
inline AreaReciprocal frame_reciprocal(const FrameEdges& e, const FrameConstants& c) {
  const AreaReciprocal r = area_reciprocal(e.area);
  return {r.factor, r.shift - c.config.subpixel_bits - c.gradient_bits};
}

// The gradient of interpolation_setup() for its numerator.
inline std::uint64_t gradient(std::int64_t numerator, const AreaReciprocal& r) {
  return static_cast<std::uint64_t>(
      static_cast<__int128>(numerator) * static_cast<std::int64_t>(r.factor) >> r.shift);
}

// A plane as the tiles want it.
inline FramePlane frame_plane(std::uint64_t at_vertex0, std::uint64_t dx, std::uint64_t dy,
                              const FrameEdges& e, const FrameConstants& c) {
  const int F = c.gradient_bits;
  const std::uint64_t half = F > 0 ? std::uint64_t{1} << (F - 1) : 0;
  const std::uint64_t move =
      dx * static_cast<std::uint64_t>(e.x) + dy * static_cast<std::uint64_t>(e.y);
  return {at_vertex0 + (move >> c.f), dx, dy, static_cast<std::uint32_t>((dx + half) >> F),
          static_cast<std::uint32_t>((dy + half) >> F)};
}

// 1/w of the three vertices as GeometryStage packs it: U0.inverse_w_bits, the greatest with its top
// bit set, at least 1.
inline std::array<std::uint32_t, 3> packed_inverse_w(const FrameTriangle& t,
                                                     const FrameConstants& c) {
  const std::array<double, 3> w{t.vertex[0]->inverse_w, t.vertex[1]->inverse_w,
                                t.vertex[2]->inverse_w};
  double scale = 1;
  if (!c.packed) {
    // 2^(bits - exponent), where the greatest is in [2^(exponent - 1), 2^exponent).
    const double greatest = std::max({w[0], w[1], w[2]});
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(greatest) >> 52;
    scale = std::bit_cast<double>(
        (2045 + static_cast<std::uint64_t>(c.config.inverse_w_bits) - exponent) << 52);
  }
  const double most = static_cast<double>((1u << c.config.inverse_w_bits) - 1u);
  std::array<std::uint32_t, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto units =
        static_cast<std::uint32_t>(static_cast<std::int64_t>(std::min(w[i] * scale, most) + 0.5));
    out[i] = std::max(units, 1u);
  }
  return out;
}

// The depth plane of a triangle that covers a sample.
inline FramePlane depth_plane(const FrameTriangle& triangle, const FrameConstants& c) {
  const FrameEdges e = frame_edges(triangle, c);
  const auto value = [&](std::size_t i) { return std::int64_t{triangle.vertex[i]->depth}; };
  const std::int64_t d1 = value(1) - value(0);
  const std::int64_t d2 = value(2) - value(0);
  const AreaReciprocal r = frame_reciprocal(e, c);
  const std::uint64_t dx = gradient(d1 * e.a2 + d2 * e.a0, r);
  const std::uint64_t dy = gradient(d1 * e.b2 + d2 * e.b0, r);
  return frame_plane(static_cast<std::uint64_t>(value(0)) << c.gradient_bits, dx, dy, e, c);
}

// The same by interpolation_setup() itself: the definition, and the scalar kernel's way.
FramePlane plain_depth_plane(const FrameTriangle& triangle, const FrameConstants& constants);
// Its red, green, blue and 1/w likewise.
ShadePlanes plain_shade_planes(const FrameTriangle& triangle, const FrameConstants& constants);

// Lanes of a tile that the scissor leaves. word: tile row << 16 | tile column.
inline std::uint64_t open_lanes(const FrameConstants& c, std::uint32_t word) {
  if (!c.scissored) return ~std::uint64_t{0};
  const int g = c.config.grid_log2;
  return scissor_lanes(c.scissor, static_cast<std::int32_t>((word & 0xffff) << g),
                       static_cast<std::int32_t>((word >> 16) << g), g);
}

// What to add at sample m, as sample_delta().
inline std::uint32_t frame_delta(std::uint64_t dx, std::uint64_t dy, int m,
                                 const FrameConstants& c) {
  return sample_delta(Plane{0, dx, dy}, m, c.config);
}

}  // namespace halfspace
