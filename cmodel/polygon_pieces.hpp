// SPDX-License-Identifier: Apache-2.0
//
// A clipped polygon as triangles, after its vertices were snapped. Part of geometry.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "packets.hpp"

namespace halfspace {

// Three places in the polygon.
using Piece = std::array<std::size_t, 3>;

// At most as many as a polygon has vertices, less two.
struct Pieces {
  static constexpr std::size_t kMost = 8;
  std::array<Piece, kMost> piece;
  std::size_t count = 0;

  void add(const Piece& p) { piece[count++] = p; }
  std::span<const Piece> all() const { return {piece.data(), count}; }
};

// Triangles with the polygon's vertices, none of which share an inner point, so that a sample is
// covered once at most. They are the polygon when its edges do not cross. Snapping makes them cross
// where the polygon is about a subpixel across; there a sliver may be left out, or added.
// All face as the polygon does, by the sign of its area. They are the same triangles in the same
// order whichever vertex comes first; of the reversed polygon they are the same, reversed.
//
//   ring    3 to 10 vertices, subpixels, |x|, |y| <= 2^28; in order around the polygon, which
//           snapping may have dented. Equal ones may stand in it.
//   return  pieces with an area; none when the polygon has none
//   cost    a fan when the polygon is convex; else O(n^5), n <= 10
Pieces polygon_pieces(std::span<const Point> ring);

}  // namespace halfspace
