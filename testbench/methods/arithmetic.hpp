// SPDX-License-Identifier: Apache-2.0
//
// The numbers a method computes with, and what every triangle method needs first: the box of pixels
// and the orientation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "fixed.hpp"
#include "method.hpp"

namespace halfspace::methods {

// Coordinates as float or double, in px.
template <class Real>
struct Floating {
  using Number = Real;
  double px2(Number e) const { return static_cast<double>(e); }  // a product of two, in px^2
  Number coordinate(double px) const { return static_cast<Real>(px); }
  Number centre(int pixel) const { return static_cast<Real>(pixel) + Real(0.5); }
  bool holds(const Facet&) const { return true; }
};

// Coordinates snapped half to even to 2^-bits px, 0..12, in units of half of that, so that pixel
// centres are integers too. Triangles that reach beyond +-2^16 px are not drawn: sums of two
// products then fit 63 bits.
struct Fixed {
  using Number = std::int64_t;
  int bits = 8;
  double px2(Number e) const { return std::ldexp(static_cast<double>(e), -2 * (bits + 1)); }
  Number coordinate(double px) const {
    return 2 * static_cast<Number>(std::nearbyint(std::ldexp(px, bits)));
  }
  Number centre(int pixel) const { return (2 * Number{pixel} + 1) << bits; }
  bool holds(const Facet& facet) const {
    return std::all_of(facet.begin(), facet.end(), [](const Vertex& v) {
      return std::abs(v.x) <= 65536 && std::abs(v.y) <= 65536;  // false for NaN
    });
  }
};

// Pixels first..last in each direction, both included; empty when a first is beyond its last.
struct PixelBox {
  int x_first = 0;
  int y_first = 0;
  int x_last = -1;
  int y_last = -1;
  bool empty() const { return x_first > x_last || y_first > y_last; }
  std::uint64_t width() const { return static_cast<std::uint64_t>(x_last - x_first + 1); }
  std::uint64_t height() const { return static_cast<std::uint64_t>(y_last - y_first + 1); }
};

// Least pixel at or after `px` whose centre is at or beyond it, greatest at or before; both cut to
// first - 1..last + 1. Any px but NaN.
inline int first_centre(double px, int first, int last) {
  return static_cast<int>(std::clamp(std::ceil(px - 0.5), first - 0.0, last + 1.0));
}
inline int last_centre(double px, int first, int last) {
  return static_cast<int>(std::clamp(std::floor(px - 0.5), first - 1.0, last - 0.0));
}

// The canvas's pixels with centres in the closed bounding box of the vertices; empty when a
// coordinate is NaN. margin: px added on every side.
inline PixelBox pixel_box(const Facet& f, const Canvas& canvas, double margin = 0) {
  for (const Vertex& v : f) {
    if (std::isnan(v.x) || std::isnan(v.y)) return {};
  }
  const auto [left, right] = std::minmax({f[0].x, f[1].x, f[2].x});
  const auto [top, bottom] = std::minmax({f[0].y, f[1].y, f[2].y});
  return {first_centre(left - margin, canvas.x_first(), canvas.x_last()),
          first_centre(top - margin, canvas.y_first(), canvas.y_last()),
          last_centre(right + margin, canvas.x_first(), canvas.x_last()),
          last_centre(bottom + margin, canvas.y_first(), canvas.y_last())};
}

// A triangle's corners as numbers, with the inside of every edge i -> i + 1 on its positive side.
template <class Number>
struct Corners {
  std::array<Number, 3> x{};
  std::array<Number, 3> y{};
  std::array<std::size_t, 3> vertex{0, 1, 2};  // which vertex of the facet each one is
  Number area{};                               // doubled; 0 or more (or NaN)
};

template <class Arithmetic>
Corners<typename Arithmetic::Number> oriented(const Facet& facet, const Arithmetic& arithmetic) {
  Corners<typename Arithmetic::Number> c;
  for (std::size_t i = 0; i < 3; ++i) {
    c.x[i] = arithmetic.coordinate(facet[i].x);
    c.y[i] = arithmetic.coordinate(facet[i].y);
  }
  c.area = (c.x[1] - c.x[0]) * (c.y[2] - c.y[0]) - (c.x[2] - c.x[0]) * (c.y[1] - c.y[0]);
  if (c.area < 0) {
    std::swap(c.x[1], c.x[2]);
    std::swap(c.y[1], c.y[2]);
    std::swap(c.vertex[1], c.vertex[2]);
    c.area = -c.area;
  }
  return c;
}

// The facet with every vertex moved to the nearest multiple of 2^-bits px, halves to even.
inline Facet snapped(Facet facet, int bits) {
  for (Vertex& v : facet) {
    v.x = std::ldexp(std::nearbyint(std::ldexp(v.x, bits)), -bits);
    v.y = std::ldexp(std::nearbyint(std::ldexp(v.y, bits)), -bits);
  }
  return facet;
}

}  // namespace halfspace::methods
