// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "method.hpp"

namespace halfspace::methods {

// f_ij(x, y) = (yi - yj) x + (xj - xi) y + xi yj - xj yi: zero on the line through both points, its
// sign the side. As the notes on barycentric coordinates write it.
template <class Real>
struct ImplicitLine {
  Real a{};
  Real b{};
  Real c{};
  Real at(Position p) const { return a * static_cast<Real>(p.x) + b * static_cast<Real>(p.y) + c; }
};

template <class Real>
ImplicitLine<Real> implicit_line(Position i, Position j) {
  const auto xi = static_cast<Real>(i.x), yi = static_cast<Real>(i.y);
  const auto xj = static_cast<Real>(j.x), yj = static_cast<Real>(j.y);
  return {yi - yj, xj - xi, xi * yj - xj * yi};
}

}  // namespace halfspace::methods
