// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// Why triangle_setup let a triangle go, or that it did not.
enum class SetupOutcome : std::uint8_t { kDrawn, kZeroArea, kCulled, kNoSample };

// Three snapped vertices to three biased edge functions and the box of pixels they may cover.
//
//   triangle  vertices S.s px, each in [coordinate_min(), coordinate_max()] (checked)
//   frame     size 1..2^viewport_bits (checked), culling
//   outcome   when not null: why nothing was returned; reasons are tried in the enum's order
//   return    the packet, or nothing when the triangle has no area, is culled, or its box holds no
//             sample
//
// Exact, no rounding: the floor that drops bits keeps the sign of every sample's edge value, and
// saturation keeps it over the whole frame (docs/03_design/config.md).
// Cost: six products. Twin: rtl/hs_triangle_setup.sv. Source: Pineda, "A Parallel Algorithm for
// Polygon Rasterization", SIGGRAPH 1988; the top-left rule from the Direct3D 11.3 specification.
std::optional<SetupTriangle> triangle_setup(const Triangle& triangle, const FrameState& frame,
                                            const Config& config, SetupOutcome* outcome = nullptr);

}  // namespace halfspace
