// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// When a fragment replaces what is stored. Nearer is smaller.
enum class DepthFunction : std::uint8_t { kLess, kLessEqual, kAlways };

// Units to a depth-buffer value: rounded to nearest, clamped to 0..2^depth_bits - 1.
std::uint32_t depth_value(std::int32_t units, const Config& config);

// One sample plane of one tile: compare, and store where the fragment wins. Early: runs before any
// attribute is evaluated, on the same coverage bits.
//
//   covered  lanes to test
//   plane    depth over the tile, moved to the sample (TilePlane::base + sample_delta)
//   stored   the tile's depth buffer; replaced where the test passes
//   return   lanes that passed, a subset of `covered`
//
// Cost: one add, one compare per lane. Twin: none yet in rtl/.
GridMask depth_test(GridMask covered, const TilePlane& plane, DepthFunction function,
                    DepthTile& stored, const Config& config);

}  // namespace halfspace
