// SPDX-License-Identifier: Apache-2.0
//
// Fixed-point helpers shared by every stage. Two's complement; a format S<i>.<f> has a sign, i
// integer and f fraction bits (i + f + 1 in all), U<i>.<f> has no sign.
// Twin: rtl/hs_setup_edge.sv (gen_saturate) and rtl/hs_child_step.sv saturate; the rest has none.
#pragma once

#include <cstdint>

namespace halfspace {

// True when value is representable in `bits` bits, two's complement. 1 <= bits <= 64.
constexpr bool fits(std::int64_t value, int bits) {
  if (bits >= 64) return true;
  const std::int64_t limit = std::int64_t{1} << (bits - 1);
  return value >= -limit && value < limit;
}

// value clamped to the range of `bits` bits, two's complement. 1 <= bits <= 63.
constexpr std::int64_t saturate(std::int64_t value, int bits) {
  const std::int64_t limit = std::int64_t{1} << (bits - 1);
  return value < -limit ? -limit : (value >= limit ? limit - 1 : value);
}

// floor(value / 2^shift): an arithmetic shift, spelled out because the rounding matters.
constexpr std::int64_t floor_shift(std::int64_t value, int shift) { return value >> shift; }

// floor(numerator / denominator) for denominator > 0.
constexpr __int128 floor_div(__int128 numerator, __int128 denominator) {
  const __int128 quotient = numerator / denominator;
  return quotient - ((numerator % denominator) < 0 ? 1 : 0);
}

// Stops the program with the failed condition. Widths never wrap: this is how the model says so.
[[noreturn]] void check_failed(const char* condition, const char* file, int line);

}  // namespace halfspace

// Always on, in release builds too: a width that wraps in silence is the bug this project exists
// to exclude. Per packet, not per sample, so the cost is below measurement.
#define HS_CHECK(condition)               \
  (static_cast<bool>(condition) ? void(0) \
                                : ::halfspace::check_failed(#condition, __FILE__, __LINE__))
