// SPDX-License-Identifier: Apache-2.0
//
// What everybody writes first: 64-bit edge functions at every pixel of the bounding box, the
// masks collected per 8x8 tile so that the output is an engine's. The
// yardstick of the benchmarks; one sample per pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// The same records as an engine's, one per 8x8 tile.
struct ScalarRecord {
  std::uint64_t mask;
  std::uint32_t place;  // row of tiles in the upper, column in the lower 16 bits
};

// Appends the tiles of one triangle and returns the number of covered pixels.
std::uint64_t scalar_cover(const Triangle& triangle, const FrameState& frame, const Config& config,
                           std::vector<ScalarRecord>& records);

}  // namespace halfspace
