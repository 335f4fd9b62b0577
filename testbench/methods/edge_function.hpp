// SPDX-License-Identifier: Apache-2.0
//
// E(x, y) = A x + B y + C for an edge i -> j with A = yi - yj and B = xj - xi, positive inside
// (y down, clockwise as seen), and the loop over the bounding box that tests three of them.
#pragma once

#include <type_traits>

#include "arithmetic.hpp"

namespace halfspace::methods {

// How C is found, or that it is not: kRelative evaluates A (x - xi) + B (y - yi).
enum class Constant { kCross, kVertex, kAverage, kRelative };

// One edge as its line's coefficients.
template <class Number>
struct EdgeLine {
  Number a{};
  Number b{};
  Number c{};
  Number x{};  // of its first vertex
  Number y{};
  bool relative = false;

  Number at(Number px, Number py) const {
    return relative ? a * (px - x) + b * (py - y) : a * px + b * py + c;
  }
  // The line owns samples on it: the inside is at its right, or below it when it is horizontal.
  bool top_left() const { return a > 0 || (a == 0 && b > 0); }
};

template <class Number>
EdgeLine<Number> edge_line(const Corners<Number>& c, std::size_t i, Constant constant) {
  const std::size_t j = (i + 1) % 3;
  EdgeLine<Number> e{c.y[i] - c.y[j], c.x[j] - c.x[i], 0, c.x[i], c.y[i], false};
  switch (constant) {
    case Constant::kCross: e.c = c.x[i] * c.y[j] - c.x[j] * c.y[i]; break;
    case Constant::kVertex: e.c = -e.a * c.x[i] - e.b * c.y[i]; break;
    case Constant::kAverage: e.c = -(e.a * (c.x[i] + c.x[j]) + e.b * (c.y[i] + c.y[j])) / 2; break;
    case Constant::kRelative: e.relative = true; break;
  }
  return e;
}

template <class Number>
bool inside(const EdgeLine<Number>& edge, Number e, Rule rule) {
  if (rule == Rule::kSkipTies) return e > 0;
  return e > 0 || (e == 0 && (rule == Rule::kDrawTies || edge.top_left()));
}

// The whole triangle: every pixel of the box against every edge.
template <class Arithmetic>
void draw_edge_function(const Facet& facet, Canvas& canvas, const Arithmetic& arithmetic,
                        Constant constant, Rule rule) {
  using Number = typename Arithmetic::Number;
  if (!arithmetic.holds(facet)) return;
  const Corners<Number> corners = oriented(facet, arithmetic);
  if (!(corners.area > 0)) return;
  std::array<EdgeLine<Number>, 3> edge;
  for (std::size_t i = 0; i < 3; ++i) edge[i] = edge_line(corners, i, constant);
  // The pixels that the box touches; a snapped vertex is within half a pixel of the one given.
  const PixelBox box = pixel_box(facet, canvas, 0.5);
  for (int y = box.y_first; y <= box.y_last; ++y) {
    if (!canvas.spend(box.empty() ? 1 : box.width())) return;
    const Number py = arithmetic.centre(y);
    for (int x = box.x_first; x <= box.x_last; ++x) {
      const Number px = arithmetic.centre(x);
      if (inside(edge[0], edge[0].at(px, py), rule) && inside(edge[1], edge[1].at(px, py), rule) &&
          inside(edge[2], edge[2].at(px, py), rule)) {
        canvas.hit(x, y);
      }
    }
  }
}

// Edge i of the facet among the edges of its oriented corners: those of a flipped one run the other
// way round.
template <class Number>
std::size_t corner_edge(const Corners<Number>& corners, std::size_t i) {
  return corners.vertex[1] == 1 ? i : 2 - i;
}

// What draw_edge_function() finds at one pixel.
template <class Arithmetic>
OwnEdges own_edges(const Facet& facet, int x, int y, const Arithmetic& arithmetic,
                   Constant constant, Rule rule) {
  using Number = typename Arithmetic::Number;
  if (!arithmetic.holds(facet)) return std::nullopt;
  const Corners<Number> corners = oriented(facet, arithmetic);
  if (!(corners.area > 0)) return std::nullopt;
  std::array<OwnEdge, 3> out;
  for (std::size_t i = 0; i < 3; ++i) {
    const EdgeLine<Number> edge = edge_line(corners, corner_edge(corners, i), constant);
    const Number e = edge.at(arithmetic.centre(x), arithmetic.centre(y));
    out[i] = {arithmetic.px2(e), std::nullopt, inside(edge, e, rule)};
    if constexpr (std::is_integral_v<Number>) {
      const bool ties = rule == Rule::kDrawTies || (rule == Rule::kTopLeft && edge.top_left());
      out[i].biased = arithmetic.px2(e - (ties ? 0 : 1));
    }
  }
  return out;
}

// As Method::edges.
template <class Arithmetic>
EdgesAt edges_at(const Arithmetic& arithmetic, Constant constant, Rule rule) {
  return [=](const Facet& facet, int x, int y) {
    return own_edges(facet, x, y, arithmetic, constant, rule);
  };
}

}  // namespace halfspace::methods
