// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// Lanes of the tile whose first pixel is (x, y) that lie inside a box.
GridMask scissor_lanes(const Box& box, std::int32_t x, std::int32_t y, int grid_log2);

// The pixels of a tile inside the scissor rectangle.
//
//   tile    as coverage() returned it
//   box     first..last pixel, both included, inside the frame
//   return  the tile with the bits outside the box cleared, or nothing when none is left
//
// Exact. Cost: an AND per sample. Twin: none yet in rtl/.
std::optional<CoverageTile> scissor(const CoverageTile& tile, const Box& box, const Config& config);

}  // namespace halfspace
