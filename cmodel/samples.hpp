// SPDX-License-Identifier: Apache-2.0
//
// Standard sample positions. Source: Vulkan 1.3, "Standard sample locations"; Direct3D 11.3
// functional specification, 19.2.4.1. Twin: rtl/hs_pkg.sv (SAMPLE_X, SAMPLE_Y).
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "config.hpp"

namespace halfspace {

// A position within a pixel, from its top-left corner, in 1/16 px: 0..15.
struct SamplePosition {
  int x = 8;
  int y = 8;
};

// The positions for 1, 2, 4, 8 or 16 samples, in the standards' order.
std::span<const SamplePosition> sample_positions(int samples);

// The same in units of 2^-sample_bits() px (q = 0: zero, the centre is folded into C).
inline SamplePosition sample_offset(const Config& config, int sample) {
  if (config.samples == 1) return {0, 0};
  const SamplePosition p = sample_positions(config.samples)[static_cast<std::size_t>(sample)];
  const int shift = 4 - config.sample_bits();
  return {p.x >> shift, p.y >> shift};
}

// The least and greatest sample coordinate of any sample in each direction, in 1/16 px.
struct SampleExtent {
  SamplePosition low{15, 15};
  SamplePosition high{0, 0};
};
inline SampleExtent sample_extent(int samples) {
  SampleExtent extent;
  for (const SamplePosition p : sample_positions(samples)) {
    extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y)};
    extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y)};
  }
  return extent;
}

}  // namespace halfspace
