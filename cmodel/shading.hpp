// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// The colours of a tile's fragments: of the pixels with a sample that passed the depth test.
//
//   tile    as coverage() returned it: says where in the pixel the colour is evaluated
//   passed  lanes of each sample that passed; subsets of tile.mask
//   planes  of this triangle over this tile
//   colors  attributes that are colours, 0..3; the channels beyond are 0
//   return  8 bits a channel; black at pixels without a fragment
//
// A pixel's colour is evaluated once: at its centre when the triangle covers every sample, else at
// the first covered sample. Both lie in the triangle, so no attribute is ever extrapolated.
// Cost: a reciprocal a fragment, a product a channel. Twin: rtl/hs_shade.sv, of one sample.
ColorTile shading(const CoverageTile& tile, const SampleMasks& passed, const ShadingPlanes& planes,
                  int colors, const Config& config);

// Lanes with a sample that passed.
GridMask any_sample(const SampleMasks& passed);

// floor(2^(2R) / (2 mantissa + 1)), the reciprocal of the middle of [mantissa, mantissa + 1), for
// an R-bit mantissa in [2^(R-1), 2^R), R = reciprocal_bits.
std::uint32_t reciprocal(std::uint32_t mantissa, const Config& config);

// (attribute - level) / w over 1 / w, both in units at the same sample, rounded to nearest, and
// level added: an 8-bit attribute, clamped to 0..255. inverse_w is taken as 1 when it is below.
std::uint8_t perspective(std::int32_t attribute, std::int32_t inverse_w, std::uint8_t level,
                         const Config& config);

}  // namespace halfspace
