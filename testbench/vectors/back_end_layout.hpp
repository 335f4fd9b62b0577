// SPDX-License-Identifier: Apache-2.0
//
// The packed structs of the back end in rtl/hs_pkg.sv by their fields.
#pragma once

#include "layout.hpp"

namespace halfspace {

// One quantity on its way to a plane: hs_pkg::gradient_t.
struct GradientInput {
  std::array<std::int32_t, 3> value{};  // units
  int first = 0;                        // the vertex that the plane starts at
  EdgeSlope slope0;
  EdgeSlope slope2;
  Point centre;                // from that vertex to the centre of pixel (0, 0), S.f px
  std::uint32_t reciprocal{};  // r of area_reciprocal()
  int length = 0;              // of the doubled area, bits
};

Layout gradient_layout(const Config& config);
Layout corner_plane_layout(const Config& config);

// Planes side by side, the last in the lowest bits, and what rides along in 8 bits.
Layout tile_plane_in_layout(int planes, const Config& config);
Layout tile_plane_out_layout(int planes);

Values values_of(const GradientInput& input);
Values values_of(const CornerPlane& plane);
Values values_of(const TilePlane& plane);

}  // namespace halfspace
