// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

namespace halfspace::methods {

// Bit y * 8 + x: pixel (x, y) of an 8 x 8 tile.
using TileMask = std::uint64_t;

// An edge a x + b y + c >= 0 in px relative to the tile's top-left corner.
struct TileLine {
  double a = 0;
  double b = 0;
  double c = 0;
};

// Where a line crosses the tile's border: distance along it, clockwise from the top-left corner,
// 0..32 px, at which the inside is to the right of the way from `in` to `out`.
struct BorderCrossing {
  double in = 0;
  double out = 0;
};

// Nothing when the line misses the tile or touches it at one point.
std::optional<BorderCrossing> border_crossing(const TileLine& line);

// The pixels whose centres are right of the way between two points of the border, both in units of
// 1/n px along it. The table's entry: what a line that crosses exactly there covers.
TileMask table_entry(int in, int out, int n);

// How a crossing becomes a multiple of 1/n px.
enum class Crossing { kNearest, kTruncated };

// The mask of a line with its crossings moved to 1/n px: what a table of (32 n)^2 entries gives.
// Full or empty when it misses the tile or its crossings round together.
TileMask table_mask(const TileLine& line, int n, Crossing rounding = Crossing::kNearest);

}  // namespace halfspace::methods
