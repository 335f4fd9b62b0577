// SPDX-License-Identifier: Apache-2.0
//
// Polygons as triangles. The pieces share edges, so the top-left rule puts them together again
// without a seam.
#include "decomposition.hpp"

#include <algorithm>
#include <cmath>

#include "catalogue.hpp"
#include "covered.hpp"

namespace halfspace::methods {
namespace {

// Doubled area; exact for multiples of 2^-8 px within +-2^16 px.
double turn(Position a, Position b, Position c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

bool in_closed(Position a, Position b, Position c, Position p) {
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

// Vertex `at` can go: it is convex and no other vertex lies in the triangle it makes. Of a straight
// corner nothing is lost.
bool is_ear(const Ring& ring, std::size_t at) {
  const std::size_t n = ring.size();
  const Position a = ring[(at + n - 1) % n], b = ring[at], c = ring[(at + 1) % n];
  const double area = turn(a, b, c);
  if (area <= 0) return area == 0;
  return std::none_of(ring.begin(), ring.end(), [&](const Position& p) {
    return p != a && p != b && p != c && in_closed(a, b, c, p);
  });
}

void add(std::vector<Method>& list, const char* name, const char* title, const char* complexity,
         const char* use, const char* fails, DrawPolygon draw) {
  Method m;
  m.name = std::string("decompose_") + name;
  m.row = 14;
  m.family = "polygons";
  m.title = std::string("Polygons as triangles: ") + title;
  m.source = std::string(kPolygons) + "; " + kLuebke + "; " + kMao;
  m.complexity = complexity;
  m.use = use;
  m.fails = fails;
  m.rule = Rule::kTopLeft;
  m.precision = "fixed, 8 subpixel bits";
  m.subpixel_bits = 8;
  m.draw = std::move(draw);
  list.push_back(std::move(m));
}

}  // namespace

Polygon snapped_polygon(const Polygon& polygon) {
  Polygon out = polygon;
  for (Ring& ring : out.rings) {
    const bool legal = std::all_of(ring.begin(), ring.end(), [](const Position& p) {
      return std::abs(p.x) <= 65536 && std::abs(p.y) <= 65536;
    });
    if (!legal) ring.clear();
    for (Position& p : ring) p = {std::nearbyint(p.x * 256) / 256, std::nearbyint(p.y * 256) / 256};
  }
  return out;
}

Pieces fan_pieces(std::span<const Position> ring) {
  Pieces pieces;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    pieces.push_back({ring[0], ring[i], ring[i + 1]});
  }
  return pieces;
}

Pieces ear_pieces(std::span<const Position> ring) {
  Ring rest(ring.begin(), ring.end());
  double area = 0;
  for (const auto& piece : fan_pieces(ring)) area += turn(piece[0], piece[1], piece[2]);
  if (area < 0) std::reverse(rest.begin(), rest.end());
  Pieces pieces;
  while (rest.size() > 3) {
    std::size_t ear = 0;
    while (ear < rest.size() && !is_ear(rest, ear)) ++ear;
    if (ear == rest.size()) return pieces;
    const std::size_t n = rest.size();
    pieces.push_back({rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  if (rest.size() == 3) pieces.push_back({rest[0], rest[1], rest[2]});
  return pieces;
}

void draw_pieces(const Pieces& pieces, Canvas& canvas) {
  for (const auto& piece : pieces) {
    Facet facet;
    for (std::size_t i = 0; i < 3; ++i) facet[i].x = piece[i].x, facet[i].y = piece[i].y;
    draw_exact(facet, canvas);
    if (canvas.exhausted()) return;
  }
}

void add_decomposition(std::vector<Method>& list) {
  add(list, "fan", "a fan around the first vertex", "O(n)", "convex polygons",
      "concave polygons: triangles outside, and pixels drawn more than once; holes are filled",
      [](const Polygon& polygon, Canvas& canvas) {
        for (const Ring& ring : snapped_polygon(polygon).rings) {
          draw_pieces(fan_pieces(ring), canvas);
        }
      });
  add(list, "ear", "ears cut off", "O(n^2), O(n^3) at worst", "simple polygons, also concave",
      "polygons that cross themselves; holes are filled as polygons of their own",
      [](const Polygon& polygon, Canvas& canvas) {
        for (const Ring& ring : snapped_polygon(polygon).rings) {
          const auto n = static_cast<std::uint64_t>(ring.size());
          if (!canvas.spend(n * n)) return;
          draw_pieces(ear_pieces(ring), canvas);
        }
      });
}

}  // namespace halfspace::methods
