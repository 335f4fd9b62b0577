// SPDX-License-Identifier: Apache-2.0
//
// Tiles whose partial masks are looked up, one table entry per edge, and ANDed.
#include "mask_table.hpp"

#include <bit>
#include <cmath>

#include "catalogue.hpp"
#include "edge_function.hpp"

namespace halfspace::methods {
namespace {

constexpr int kSide = 8;
constexpr double kAround = 4.0 * kSide;
constexpr TileMask kFullTile = ~TileMask{0};

Position border_point(double t) {
  if (t < kSide) return {t, 0};
  if (t < 2 * kSide) return {kSide, t - kSide};
  if (t < 3 * kSide) return {3 * kSide - t, kSide};
  return {0, kAround - t};
}

// Every entry at one resolution: 512 KB for n = 8, 2 MB for n = 16.
template <int n>
const std::vector<TileMask>& table() {
  static const std::vector<TileMask> entries = [] {
    std::vector<TileMask> out;
    for (int in = 0; in < 32 * n; ++in) {
      for (int out_at = 0; out_at < 32 * n; ++out_at) out.push_back(table_entry(in, out_at, n));
    }
    return out;
  }();
  return entries;
}

// A function rather than the table itself, so that nothing is computed before it is drawn with.
using Table = const std::vector<TileMask>& (*)();

template <class Lookup>
TileMask looked_up(const TileLine& line, int n, Crossing rounding, Lookup&& lookup) {
  const std::optional<BorderCrossing> crossing = border_crossing(line);
  const bool centre_inside = line.a * 4 + line.b * 4 + line.c >= 0;
  if (!crossing) return centre_inside ? kFullTile : 0;
  const int around = 32 * n;
  const double half = rounding == Crossing::kNearest ? 0.5 : 0.0;
  const int in = static_cast<int>(crossing->in * n + half) % around;
  const int out = static_cast<int>(crossing->out * n + half) % around;
  if (in == out) return centre_inside ? kFullTile : 0;
  return lookup(in, out);
}

// The exact mask of one edge: the crossing of each row as a quotient of integers, then one of nine
// prefixes per side.
TileMask exact_mask(const EdgeLine<std::int64_t>& edge, int x, int y, const Fixed& fixed) {
  const std::int64_t bias = edge.top_left() ? 0 : 1;
  const std::int64_t step = edge.a * (std::int64_t{2} << fixed.bits);
  TileMask mask = 0;
  for (int j = 0; j < kSide; ++j) {
    const std::int64_t e = edge.at(fixed.centre(x), fixed.centre(y + j)) - bias;
    // Columns i with e + step i >= 0.
    TileMask row = e >= 0 ? 0xff : 0;
    if (step > 0 && e < 0) {
      const auto first = static_cast<std::int64_t>(-floor_div(e, step));
      row = first >= kSide ? 0 : (TileMask{0xff} << first) & 0xff;
    } else if (step < 0 && e >= 0) {
      const auto last = static_cast<std::int64_t>(floor_div(e, -step));
      row = last >= kSide - 1 ? 0xff : (TileMask{1} << (last + 1)) - 1;
    }
    mask |= row << (j * kSide);
  }
  return mask;
}

// The tiles of the box; mask(edge, x, y) is one edge's mask of the tile at (x, y).
template <class Mask>
void draw_tiles(const Facet& facet, Canvas& canvas, Mask&& mask) {
  const Fixed fixed{8};
  if (!fixed.holds(facet)) return;
  const Corners<std::int64_t> corners = oriented(facet, fixed);
  if (corners.area <= 0) return;
  std::array<EdgeLine<std::int64_t>, 3> edge;
  for (std::size_t i = 0; i < 3; ++i) edge[i] = edge_line(corners, i, Constant::kRelative);
  const PixelBox box = pixel_box(facet, canvas, 0.5);
  if (box.empty()) return;
  for (int y = box.y_first & ~(kSide - 1); y <= box.y_last; y += kSide) {
    for (int x = box.x_first & ~(kSide - 1); x <= box.x_last; x += kSide) {
      if (!canvas.spend(kSide)) return;
      TileMask all = kFullTile;
      for (std::size_t i = 0; i < 3 && all != 0; ++i) all &= mask(edge[i], x, y);
      for (; all != 0; all &= all - 1) {
        const int bit = std::countr_zero(all);
        canvas.hit(x + bit % kSide, y + bit / kSide);
      }
    }
  }
}

// The edge in px, relative to the tile: exact for edges of 8 subpixel bits.
TileLine tile_line(const EdgeLine<std::int64_t>& edge, int x, int y, const Fixed& fixed) {
  const std::int64_t unit = std::int64_t{2} << fixed.bits;
  const double at_corner = static_cast<double>(edge.at(x * unit, y * unit));
  const double scale = static_cast<double>(unit);
  return {static_cast<double>(edge.a), static_cast<double>(edge.b), at_corner / scale};
}

void draw_table(const Facet& facet, Canvas& canvas, int n, Table table) {
  draw_tiles(facet, canvas, [n, table](const EdgeLine<std::int64_t>& edge, int x, int y) {
    return looked_up(tile_line(edge, x, y, Fixed{8}), n, Crossing::kNearest, [&](int in, int out) {
      return table != nullptr ? table()[static_cast<std::size_t>(in * 32 * n + out)]
                              : table_entry(in, out, n);
    });
  });
}

Method base(const std::string& name, const std::string& title) {
  Method m;
  m.name = "table_" + name;
  m.row = 11;
  m.family = "tiled";
  m.title = "8 x 8 tiles, one precomputed mask per edge: " + title;
  m.source = kDrawing;
  m.complexity = "O(tiles of the box), no work per pixel";
  m.use = "software with cheap loads and no lanes; antialiasing by masks";
  m.precision = "fixed, 8 subpixel bits";
  m.subpixel_bits = 8;
  m.rule = Rule::kUnspecified;
  return m;
}

}  // namespace

std::optional<BorderCrossing> border_crossing(const TileLine& line) {
  // Corners clockwise; the border goes inside where the sign rises and outside where it falls.
  std::array<double, 4> e;
  for (std::size_t i = 0; i < 4; ++i) {
    const Position p = border_point(static_cast<double>(i) * kSide);
    e[i] = line.a * p.x + line.b * p.y + line.c;
  }
  std::optional<double> rise, fall;
  for (std::size_t i = 0; i < 4; ++i) {
    const double from = e[i], to = e[(i + 1) % 4];
    if ((from >= 0) == (to >= 0)) continue;
    const double t = kSide * (static_cast<double>(i) + from / (from - to));
    (to >= 0 ? rise : fall) = t;
  }
  if (!rise || !fall) return std::nullopt;
  // Clockwise from the rise to the fall the border is inside, so the chord back leaves it right.
  return BorderCrossing{*fall, *rise};
}

TileMask table_entry(int in, int out, int n) {
  const Position p = border_point(static_cast<double>(in) / n);
  const Position q = border_point(static_cast<double>(out) / n);
  const double a = p.y - q.y, b = q.x - p.x;
  const bool owns_ties = a > 0 || (a == 0 && b > 0);
  TileMask mask = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const double e = a * (i % kSide + 0.5 - p.x) + b * (i / kSide + 0.5 - p.y);
    if (e > 0 || (e == 0 && owns_ties)) mask |= TileMask{1} << i;
  }
  return mask;
}

TileMask table_mask(const TileLine& line, int n, Crossing rounding) {
  return looked_up(line, n, rounding, [n](int in, int out) { return table_entry(in, out, n); });
}

void add_mask_table(std::vector<Method>& list) {
  for (const int n : {8, 16, 64}) {
    const std::string number = std::to_string(n);
    Method m = base(std::string("n") += number,
                    std::string("border crossings to 1/").append(number).append(" px"));
    m.fails = "every edge moves by up to half a step of the table: gaps and doubles along edges";
    // The table of n = 64 would be 32 MB: its entries are computed when they are needed.
    const Table entries = n == 8 ? table<8> : n == 16 ? table<16> : nullptr;
    m.draw = DrawFacet([n, entries](const Facet& facet, Canvas& canvas) {
      draw_table(facet, canvas, n, entries);
    });
    list.push_back(std::move(m));
  }
  Method m = base("exact", "nine prefixes per row, the crossing as an exact quotient");
  m.rule = Rule::kTopLeft;
  m.exact = true;
  m.complexity = "O(tiles of the box), 8 divisions per edge and tile";
  m.draw = DrawFacet([](const Facet& facet, Canvas& canvas) {
    draw_tiles(facet, canvas, [](const EdgeLine<std::int64_t>& edge, int x, int y) {
      return exact_mask(edge, x, y, Fixed{8});
    });
  });
  list.push_back(std::move(m));
}

}  // namespace halfspace::methods
