// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "config.hpp"
#include "interpolation.hpp"
#include "packets.hpp"

namespace halfspace {

// When a fragment replaces what is stored. Nearer is smaller.
enum class DepthFunction : std::uint8_t { kLess, kLessEqual, kAlways };

// Depths of one sample of every pixel of a tile, U0.depth_bits, lane j * grid() + i.
using DepthTile = std::array<std::uint32_t, 64>;

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
