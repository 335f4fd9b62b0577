// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// One edge over one grid: bit j * grid() + i is set when base + a i + b j >= 0.
//
//   base    lane (0, 0)'s value, lane_bits() (checked)
//   slope   a per lane to the right, b per lane down, delta_bits()
//   config  grid_log2 and widths
//
// Exact: every lane fits lane_bits(). Cost: one add and a sign per lane.
// Twin: rtl/hs_half_plane_grid.sv.
GridMask half_plane_grid(std::int64_t base, EdgeSlope slope, const Config& config);

// Lanes whose pixels x + i c .. x + i c + c - 1 (and rows alike) overlap the box.
//
//   x, y        pixel of the grid's origin
//   child_log2  log2 of c, the side of a lane in pixels
//
// Twin: rtl/hs_box_range.sv.
GridMask box_mask(std::int32_t x, std::int32_t y, int child_log2, const Box& box,
                  const Config& config);

}  // namespace halfspace
