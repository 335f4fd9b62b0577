// SPDX-License-Identifier: Apache-2.0
//
// Which arithmetic finds the crossings of an edge with the pixel rows, and the bounds that allow
// it. Proofs: docs/03_design/coverage_engine.md.
#pragma once

#include <algorithm>
#include <cstdint>

#include "../../config.hpp"

namespace halfspace {

enum class CrossingPath : std::uint8_t {
  kFloat,   // int32 setup, float crossings, windows of 32 px
  kDouble,  // double setup, double crossings, strips of 8 rows
};

// The widest triangle, in pixels, that the window kernel is built for: from the start of its first
// tile it spans at most 64 rows and 64 columns.
inline constexpr int kWindowReach = 56;

// True when float crossings of every triangle at most `extent` px wide and high are exact, with f
// fraction bits (Config::position_bits()). All magnitudes are bounds, in the order of the proof.
constexpr bool float_is_exact(int extent, int f) {
  constexpr double u = 0x1p-24;  // unit roundoff
  const double one = static_cast<double>(1 << f);
  const double reach = extent + 8;    // from the window's first sample to any sample of the box
  const double slope = extent * one;  // |A|, |B|
  const double edge = 2 * slope * reach * one;                  // |E| at the window's first sample
  const double numerator = edge / one + slope + 1;              // |floor(E / 2^f) - A| + 1/2
  if (edge + 1 >= 0x1p31 || numerator >= 0x1p22) return false;  // int32; exact in float
  const double error = 3 * u * slope * reach                    // B y: reciprocal, product, product
                       + 3 * u * numerator   // N: reciprocal, product, the window's column
                       + u * reach * slope;  // the sum
  return 1.001 * error < 0.5;                // 1.001: terms of second order
}

// The same for double crossings of every triangle of a configuration, at every row of the frame.
constexpr bool double_is_exact(const Config& config) {
  constexpr double u = 0x1p-53;
  const int k = config.has_guard_band() ? config.guard_bits : config.viewport_bits;
  const int f = config.position_bits();
  const double one = static_cast<double>(1 << f);
  const double reach = static_cast<double>(std::int64_t{1} << (k + 1));  // px between two positions
  const double slope = reach * one;
  const double numerator = 2 * slope * reach + slope + 1;
  const double error = 3 * u * slope * reach + 3 * u * numerator + u * reach * slope;
  return numerator < 0x1p51 && 1.001 * error < 0.5;
}

// The widest triangle, in pixels, that takes the float path.
constexpr int float_extent(const Config& config) {
  int extent = kWindowReach;
  while (extent > 0 && !float_is_exact(extent, config.position_bits())) --extent;
  return extent;
}

// The path of a triangle whose bounding box is width x height subpixels (before any clipping).
constexpr CrossingPath crossing_path(const Config& config, std::int64_t width,
                                     std::int64_t height) {
  const std::int64_t extent = std::int64_t{float_extent(config)} << config.subpixel_bits;
  return std::max(width, height) <= extent ? CrossingPath::kFloat : CrossingPath::kDouble;
}

// The hardest legal configuration is within double's reach, so no other path is needed.
static_assert(double_is_exact(Config{
    .subpixel_bits = 12, .viewport_bits = 15, .guard_bits = 16, .samples = 16}));
static_assert(float_extent(kFull) >= 48);

}  // namespace halfspace
