// SPDX-License-Identifier: Apache-2.0
//
// A triangle's depth, 1/w and attributes anywhere in its plane: for geometry, which cuts triangles
// and must not lose their planes. Formulas: docs/03_design/geometry.md.
#pragma once

#include <array>

#include "geometry.hpp"
#include "packets.hpp"

namespace halfspace {

// A sum of two doubles, the second below the last place of the first: about 106 bits. Without fused
// operations, so the same bits everywhere.
struct Twofold {
  double high = 0.0;
  double low = 0.0;
};

// From clip-space coordinates alone, so vertices behind the eye are no exception. The results
// depend on the three vertices, not on their order.
class UncutPlane {
 public:
  // Positions finite and at most kMaxMagnitude. half_width, half_height: of the frame, subpixels.
  UncutPlane(const std::array<ClipVertex, 3>& triangle, double half_width, double half_height);

  struct Values {
    double depth = 0.0;  // (z/w + 1) / 2
    double inverse_w = 0.0;
    std::array<double, kMaxAttributes> attribute{};
  };
  // At a position in the frame, subpixels. Not finite where the triangle is seen edge-on; 1/w may
  // be negative beyond the eye's plane.
  Values at(const Point& point, int attributes) const;

 private:
  struct Corner {
    Twofold x, y, z;  // (x + w) half_width, (w - y) half_height, z + w
    double w = 0.0;
    std::array<double, kMaxAttributes> attribute{};
  };
  std::array<Corner, 3> corner_;
  double unit_ = 1.0;  // positions were multiplied by it
};

}  // namespace halfspace
