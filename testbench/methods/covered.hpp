// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "edge_function.hpp"

namespace halfspace::methods {

// Calls pixel(x, y) for every pixel of the canvas that the triangle, snapped to 2^-bits px, owns by
// the top-left rule: exact, row by row. For methods that are about something else than coverage.
template <class Pixel>
void for_each_covered(const Facet& facet, Canvas& canvas, Pixel&& pixel, int bits = 8) {
  const Fixed fixed{bits};
  if (!fixed.holds(facet)) return;
  const Corners<std::int64_t> corners = oriented(facet, fixed);
  if (corners.area <= 0) return;
  std::array<EdgeLine<std::int64_t>, 3> edge;
  for (std::size_t i = 0; i < 3; ++i) edge[i] = edge_line(corners, i, Constant::kRelative);
  const PixelBox box = pixel_box(facet, canvas, 0.5);
  const std::int64_t step = std::int64_t{2} << bits;
  for (int y = box.y_first; y <= box.y_last; ++y) {
    if (!canvas.spend(box.empty() ? 1 : box.width())) return;
    std::array<std::int64_t, 3> e;
    for (std::size_t i = 0; i < 3; ++i) {
      e[i] = edge[i].at(fixed.centre(box.x_first), fixed.centre(y)) - (edge[i].top_left() ? 0 : 1);
    }
    for (int x = box.x_first; x <= box.x_last; ++x) {
      if ((e[0] | e[1] | e[2]) >= 0) pixel(x, y);
      for (std::size_t i = 0; i < 3; ++i) e[i] += edge[i].a * step;
    }
  }
}

// The same as plain hits.
inline void draw_exact(const Facet& facet, Canvas& canvas, int bits = 8) {
  const auto hit = [&canvas](int x, int y) { canvas.hit(x, y); };
  for_each_covered(facet, canvas, hit, bits);
}

}  // namespace halfspace::methods
