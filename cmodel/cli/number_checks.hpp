// SPDX-License-Identifier: Apache-2.0
//
// What CLI11 lets through and no option means: NaN and infinity where a number is asked for, a
// minus sign that an unsigned option would wrap. Checked only when the user gives the option, so a
// default may lie outside.
#pragma once

#include <CLI/CLI.hpp>

namespace halfspace {

// A finite number, 0 or more.
CLI::Validator not_negative();
// A finite number above 0.
CLI::Validator above_zero();
// Digits alone, low at least, below 2^64.
CLI::Validator whole(std::uint64_t low = 0);

}  // namespace halfspace
