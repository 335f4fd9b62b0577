// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "method.hpp"

namespace halfspace::methods {

using Ring = std::vector<Position>;
using Pieces = std::vector<std::array<Position, 3>>;

// Triangles (v0, vi, vi + 1): right for convex rings. O(n).
Pieces fan_pieces(std::span<const Position> ring);

// Ears cut off one after another: right for simple rings of either winding. Vertices must be
// multiples of 2^-8 px within +-2^16 px, so that orientation is exact. O(n^2) typically, O(n^3) at
// worst. A ring that crosses itself may end early, with the pieces found so far.
Pieces ear_pieces(std::span<const Position> ring);

// Triangles of a polygon with holes by a constrained triangulation (CGAL), those inside by parity.
// Vertices as ear_pieces(). Only in a build with CGAL.
Pieces constrained_pieces(const Polygon& polygon);

// Vertices to multiples of 2^-8 px, halves to even; rings with a coordinate that is not finite or
// beyond +-2^16 px become empty.
Polygon snapped_polygon(const Polygon& polygon);

// Every piece by exact edge functions, 8 subpixel bits.
void draw_pieces(const Pieces& pieces, Canvas& canvas);

}  // namespace halfspace::methods
