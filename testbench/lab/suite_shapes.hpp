// SPDX-License-Identifier: Apache-2.0
//
// Building blocks of the suites. Coordinates are multiples of 1/256 px unless said.
#pragma once

#include <cmath>
#include <vector>

#include "suites.hpp"
#include "vectors/generators.hpp"

namespace halfspace::lab {

using methods::Facet;
using methods::Position;
using methods::Vertex;

// The configuration whose subpixels the shapes are on.
inline constexpr Config kShapeGrid{.viewport_bits = 15, .guard_bits = 16};

inline double on_grid(double px) { return std::nearbyint(px * 256) / 256; }

inline Facet facet_of(Position a, Position b, Position c) {
  const auto v = [](Position p) { return Vertex{p.x, p.y, 0.5, 1, {128, 128, 128}}; };
  return {v(a), v(b), v(c)};
}

inline std::vector<Facet> facets_of(const std::vector<Triangle>& triangles, double dx = 0,
                                    double dy = 0) {
  std::vector<Facet> out;
  for (const Triangle& t : triangles) {
    const auto at = [&](std::size_t i) {
      return Position{t.vertex[i].x / 256.0 + dx, t.vertex[i].y / 256.0 + dy};
    };
    out.push_back(facet_of(at(0), at(1), at(2)));
  }
  return out;
}

inline void add_quad(std::vector<Facet>& out, Position a, Position b, Position c, Position d) {
  out.push_back(facet_of(a, b, c));
  out.push_back(facet_of(a, c, d));
}

// Disjoint triangles, one in each cell of `cells` x `cells` of `cell` px: without neighbours that
// make up for a moved edge. Vertices are multiples of `step` px; 0: of nothing.
inline std::vector<Facet> separate(std::uint64_t seed, int cell, int cells, double step) {
  Random random(seed);
  std::vector<Facet> out;
  for (int n = 0; n < cells * cells; ++n) {
    const auto at = [&](double part_x, double part_y) {
      const auto jitter = [&] { return std::ldexp(static_cast<double>(random.next() >> 12), -55); };
      const auto place = [&](int index, double part) {
        const double px = (index + part + jitter()) * cell;
        return step > 0 ? std::nearbyint(px / step) * step : px;
      };
      const double x = place(n % cells, part_x);
      return Position{x, place(n / cells, part_y)};
    };
    const Position a = at(0.05, 0.15);
    const Position b = at(0.75, 0.3);
    out.push_back(facet_of(a, b, at(0.3, 0.8)));
  }
  return out;
}

// The facets as a case of every kind but lines, seen in a window of a frame that holds it.
inline SuiteCase area_case(std::string name, const std::vector<Facet>& facets,
                           const oracle::Window& window) {
  SuiteCase one;
  one.name = std::move(name);
  one.drawing =
      methods::drawing_of(facets, window.x_first + window.width, window.y_first + window.height);
  one.window = window;
  return one;
}

}  // namespace halfspace::lab
