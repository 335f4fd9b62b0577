// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "lab/method_accounts.hpp"
#include "lab/suite_shapes.hpp"

namespace halfspace::lab {

using methods::Canvas;
using methods::Drawing;
using methods::Method;

// Pixels (0, 0) to (7, 7): two triangles whose shared edge holds eight centres.
inline std::vector<Facet> quad() {
  return {facet_of({8, 0}, {8, 8}, {0, 8}), facet_of({8, 0}, {0, 8}, {0, 0})};
}

inline MethodPixel pixel_of(const Method& method, const Drawing& drawing, std::uint64_t triangles,
                            int x, int y, int size, bool all = true) {
  Canvas canvas(size, size);
  if (method.attributes) canvas.keep_attributes();
  return method_pixel(method, drawing, triangles, canvas, x, y, all);
}

inline MethodPixel quad_pixel(const Method& method, int x, int y, bool all = true) {
  return pixel_of(method, methods::drawing_of(quad(), 8, 8), 2, x, y, 8, all);
}

inline std::uint64_t count(const MethodPixel& pixel, MethodFate fate) {
  return pixel.counts[static_cast<std::size_t>(fate)];
}

// A method made for a test: what `hits` says of each triangle at each pixel.
inline Method invented(std::function<int(const Facet&, int, int)> hits) {
  Method m;
  m.name = "invented";
  m.draw = methods::DrawFacet([hits](const Facet& f, Canvas& canvas) {
    for (int y = 0; y < canvas.height(); ++y) {
      for (int x = 0; x < canvas.width(); ++x) {
        for (int n = hits(f, x, y); n > 0; --n) canvas.hit(x, y);
      }
    }
  });
  return m;
}

// The half of the quad that holds its lower right corner.
inline bool lower(const Facet& f) {
  return std::any_of(f.begin(), f.end(), [](const auto& v) { return v.x == 8 && v.y == 8; });
}

}  // namespace halfspace::lab
