// SPDX-License-Identifier: Apache-2.0
//
// Planes of interpolation_setup() and tile_plane(), by a rounded guess and an exact remainder
// instead of a 128-bit division. Proofs: docs/03_design/frame.md.
#pragma once

#include <algorithm>
#include <bit>

#include "../../interpolation.hpp"
#include "frame_records.hpp"

namespace halfspace {

// The slopes that weigh vertices 1 and 2, oriented, and the doubled area they belong to.
struct FrameEdges {
  std::int64_t a0 = 0, b0 = 0;  // of edge 0, opposite vertex 2. S.s px
  std::int64_t a2 = 0, b2 = 0;  // of edge 2, opposite vertex 1
  std::int64_t area = 1;        // above 0, S.2s px^2
  double scale = 0;             // 2^(s + F) / area, rounded
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
  const int shift = c.config.subpixel_bits + c.gradient_bits;
  e.scale = static_cast<double>(std::uint64_t{1} << shift) / static_cast<double>(e.area);
  const int up = c.f - c.config.subpixel_bits;
  const std::int64_t half = std::int64_t{1} << (c.f - 1);
  e.x = half - (std::int64_t{p.x} << up);
  e.y = half - (std::int64_t{p.y} << up);
  return e;
}

// Guesses are right when the quotient is below this; greater ones are divided.
inline constexpr double kGuessLimit = 0x1p49;
// Adding it rounds a double below 2^51 to an integer, in its low bits.
inline constexpr double kRounder = 0x1.8p52;

// floor(numerator 2^shift / area): guess rounds numerator times 2^shift / area to an integer, which
// is the floor or one more, and the remainder's sign tells which.
inline std::uint64_t guessed_gradient(std::int64_t numerator, int shift, const FrameEdges& e,
                                      bool& wild) {
  const double q = static_cast<double>(numerator) * e.scale;
  wild |= !(q < kGuessLimit && q > -kGuessLimit);
  const std::uint64_t g =
      std::bit_cast<std::uint64_t>(q + kRounder) - std::bit_cast<std::uint64_t>(kRounder);
  const std::uint64_t rest =
      (static_cast<std::uint64_t>(numerator) << shift) - g * static_cast<std::uint64_t>(e.area);
  return g - (rest >> 63);
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

// The same planes by interpolation_setup(), for quotients beyond the guess; count 0 or 3.
InterpolationSetup plain_planes(const FrameTriangle& triangle, const FrameConstants& constants,
                                int count);

// The same for the depth plane.
FramePlane plain_depth_plane(const FrameTriangle& triangle, const FrameConstants& constants);

// The depth plane of a triangle that covers a sample.
inline FramePlane depth_plane(const FrameTriangle& triangle, const FrameConstants& c) {
  const FrameEdges e = frame_edges(triangle, c);
  const auto value = [&](std::size_t i) { return std::int64_t{triangle.vertex[i]->depth}; };
  const std::int64_t d1 = value(1) - value(0);
  const std::int64_t d2 = value(2) - value(0);
  const int shift = c.config.subpixel_bits + c.gradient_bits;
  bool wild = false;
  const std::uint64_t dx = guessed_gradient(d1 * e.a2 + d2 * e.a0, shift, e, wild);
  const std::uint64_t dy = guessed_gradient(d1 * e.b2 + d2 * e.b0, shift, e, wild);
  if (wild) [[unlikely]]
    return plain_depth_plane(triangle, c);
  return frame_plane(static_cast<std::uint64_t>(value(0)) << c.gradient_bits, dx, dy, e, c);
}

// Its red, green, blue and 1/w without guesses: the definition, and the scalar kernel's way.
ShadePlanes plain_shade_planes(const FrameTriangle& triangle, const FrameConstants& constants);

// What to add at sample m, as sample_delta().
inline std::uint32_t frame_delta(std::uint64_t dx, std::uint64_t dy, int m,
                                 const FrameConstants& c) {
  return sample_delta(Plane{0, dx, dy}, m, c.config);
}

}  // namespace halfspace
