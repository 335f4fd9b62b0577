// SPDX-License-Identifier: Apache-2.0
//
// What CLI11 lets through and no option means: NaN and infinity where a number is asked for, a
// minus sign that an unsigned option would wrap.
#pragma once

#include <cstdint>

#include "options.hpp"

namespace halfspace {

// A finite number, 0 or more.
Check not_negative();
// A finite number above 0.
Check above_zero();
// Digits alone, low at least, below 2^64.
Check whole(std::uint64_t low = 0);
// A whole number, both ends included.
Check whole_between(int low, int high);

}  // namespace halfspace
