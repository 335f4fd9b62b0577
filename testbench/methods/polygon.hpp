// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arithmetic.hpp"

namespace halfspace::methods {

// An edge of a polygon with its lower end last (y down): top.y <= bottom.y.
struct PolygonEdge {
  Position top;
  Position bottom;
};

// All edges of all rings, also horizontal ones. Nothing when a coordinate is not finite or beyond
// +-2^16 px.
inline std::vector<PolygonEdge> polygon_edges(const Polygon& polygon) {
  std::vector<PolygonEdge> edges;
  for (const std::vector<Position>& ring : polygon.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Position a = ring[i], b = ring[(i + 1) % ring.size()];
      if (!(std::abs(a.x) <= 65536 && std::abs(a.y) <= 65536)) return {};
      edges.push_back(a.y <= b.y ? PolygonEdge{a, b} : PolygonEdge{b, a});
    }
  }
  return edges;
}

// x of the edge at a row's centre; top.y < bottom.y.
inline double crossing_x(const PolygonEdge& e, double y) {
  return e.top.x + (y - e.top.y) / (e.bottom.y - e.top.y) * (e.bottom.x - e.top.x);
}

// Least pixel whose centre is at or right of the edge at row y, an exact quotient; the edge snapped
// to 1/256 px and not horizontal.
inline std::int64_t crossing_pixel(const PolygonEdge& e, int y) {
  const Fixed fixed{8};
  const auto x0 = fixed.coordinate(e.top.x), y0 = fixed.coordinate(e.top.y);
  const auto x1 = fixed.coordinate(e.bottom.x), y1 = fixed.coordinate(e.bottom.y);
  const std::int64_t unit = std::int64_t{2} << fixed.bits, dy = y1 - y0;
  const std::int64_t numerator = (x1 - x0) * (fixed.centre(y) - y0) + (x0 - unit / 2) * dy;
  return static_cast<std::int64_t>(-floor_div(-__int128{numerator}, __int128{dy} * unit));
}

}  // namespace halfspace::methods
