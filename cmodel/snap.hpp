// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "config.hpp"

namespace halfspace {

// value / 2^shift as an integer, rounded by mode. shift >= 0. Exact for every value; no overflow
// for |value| < 2^62 and shift < 62.
constexpr std::int64_t snap_shift(std::int64_t value, int shift, SnapMode mode) {
  const std::int64_t unit = std::int64_t{1} << shift;
  const std::int64_t magnitude = value < 0 ? -value : value;
  std::int64_t quotient = magnitude >> shift;
  const std::int64_t twice_rest = 2 * (magnitude - quotient * unit);
  if (mode == SnapMode::kHalfAway && twice_rest >= unit && shift > 0) ++quotient;
  if (mode == SnapMode::kNearestEven &&
      (twice_rest > unit || (twice_rest == unit && (quotient & 1) != 0))) {
    ++quotient;
  }
  return value < 0 ? -quotient : quotient;
}

}  // namespace halfspace
