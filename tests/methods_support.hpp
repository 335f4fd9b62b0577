// SPDX-License-Identifier: Apache-2.0
//
// What the tests of the gallery share: drawing the oracle's triangles with a method by name.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "methods/arithmetic.hpp"
#include "methods/method.hpp"
#include "metrics.hpp"
#include "reproducers.hpp"

namespace halfspace::methods {

// The least that can be asked: a name that is not there ends the test program.
inline const Method& method(const std::string& name) {
  const Method* found = find(name);
  if (found == nullptr) throw std::runtime_error("no method " + name);
  return *found;
}

inline std::vector<Facet> facets_of(const std::vector<oracle::Corners>& triangles) {
  std::vector<Facet> facets;
  for (const oracle::Corners& t : triangles) {
    Facet& f = facets.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) f[i].x = t[i].x, f[i].y = t[i].y;
  }
  return facets;
}

// A canvas of the window with all triangles drawn; far more steps than any method needs.
inline Canvas drawn(const Method& m, const std::vector<oracle::Corners>& triangles,
                    const oracle::Window& window) {
  Canvas canvas(window.width, window.height, window.x_first, window.y_first,
                std::uint64_t{1} << 34);
  draw(m, drawing_of(facets_of(triangles), window.width, window.height), canvas);
  EXPECT_FALSE(canvas.exhausted()) << m.name;
  return canvas;
}

// Hits against the oracle's on the same real-valued vertices.
inline oracle::HitErrors errors_of(const std::string& name,
                                   const std::vector<oracle::Corners>& triangles,
                                   const oracle::Window& window) {
  const Canvas canvas = drawn(method(name), triangles, window);
  return oracle::compare_hits(canvas.hits(), oracle::exact_hits(triangles, window));
}

inline constexpr oracle::Window kMegapixel{1024, 1024, 0, 0};

// measured is within a factor of two of the figure that docs/05_methods quotes.
inline void expect_about(double measured, double figure, const std::string& what) {
  EXPECT_GE(measured, figure / 2) << what;
  EXPECT_LE(measured, figure * 2) << what;
}

}  // namespace halfspace::methods
