// SPDX-License-Identifier: Apache-2.0
//
// The packed structs of the back end in rtl/hs_pkg.sv by their fields.
#pragma once

#include "depth.hpp"
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

// A triangle on its way to the plane of its depth, what its planes share, and that plane:
// hs_pkg::depth_setup_t, triangle_area_t, triangle_depth_t.
Layout depth_setup_layout(const Config& config);
Layout triangle_area_layout(const Config& config);
Layout triangle_depth_layout(const Config& config);

// How depths are compared, a tile to test, and its lanes that passed: hs_pkg::depth_state_t,
// depth_tile_t, depth_passed_t.
Layout depth_state_layout(const Config& config);
Layout depth_tile_layout(const Config& config);
Layout depth_passed_layout(const Config& config);

// A tile to shade, and one of its groups: hs_pkg::shade_tile_t, and hs_shade's group_o.
Layout shade_tile_layout(const Config& config);
Layout shade_group_layout(int fragments, const Config& config);

Values values_of(const GradientInput& input);
Values values_of(const CornerPlane& plane);
Values values_of(const TilePlane& plane);
Values values_of(const DepthState& state, const Config& config);

}  // namespace halfspace
