// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "error.hpp"

namespace halfspace {

// Arrays and objects in each other; more would take a stack's worth of calls to compare or print.
inline constexpr int kMostJsonDepth = 64;

// What JSON that does not hold together is called.
struct JsonFaults {
  ErrorCode broken;  // not JSON, or nested deeper than kMostJsonDepth
  ErrorCode twice;   // a key that an object has twice
  ErrorCode range;   // a number beyond a double
};

// JSON text from outside. Throws Error with the place, `place:line` where a line is known.
nlohmann::json parse_json(std::string_view text, const std::string& place,
                          const JsonFaults& faults);

}  // namespace halfspace
