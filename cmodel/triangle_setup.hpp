// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// Why triangle_setup let a triangle go, or that it did not.
enum class SetupOutcome : std::uint8_t { kDrawn, kZeroArea, kCulled, kNoSample };

// True when no two vertices are further apart than config.extent_max() in x or in y. Coordinates of
// magnitude below 2^31.
inline bool within_extent(const Triangle& triangle, const Config& config) {
  const std::int64_t most = config.extent_max();
  for (std::size_t i = 0; i < 3; ++i) {
    const Point from = triangle.vertex[i];
    const Point to = triangle.vertex[i < 2 ? i + 1 : 0];
    const std::int64_t dx = std::int64_t{to.x} - from.x;
    const std::int64_t dy = std::int64_t{to.y} - from.y;
    if (dx > most || -dx > most || dy > most || -dy > most) return false;
  }
  return true;
}

// Three snapped vertices to three biased edge functions and the box of pixels they may cover.
//
//   triangle  vertices S.s px, each in [coordinate_min(), coordinate_max()], no two further apart
//             than extent_max() in x or in y (checked)
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
