// SPDX-License-Identifier: Apache-2.0
#include "number_checks.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace halfspace {
namespace {

// The whole text as a number, or NaN.
double number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  return read.ec == std::errc() && read.ptr == end ? value : std::nan("");
}

}  // namespace

Check not_negative() {
  return {[](const std::string& text) {
            const double value = number(text);
            return std::isfinite(value) && value >= 0
                       ? std::string()
                       : fmt::format("'{:.40}' is not a number of 0 or more", text);
          },
          ""};
}

Check above_zero() {
  return {[](const std::string& text) {
            const double value = number(text);
            return std::isfinite(value) && value > 0
                       ? std::string()
                       : fmt::format("'{:.40}' is not a number above 0", text);
          },
          ""};
}

Check whole(std::uint64_t low) {
  return {[low](const std::string& text) {
            std::uint64_t value = 0;
            const char* end = text.data() + text.size();
            const auto read = std::from_chars(text.data(), end, value);
            return read.ec == std::errc() && read.ptr == end && value >= low
                       ? std::string()
                       : fmt::format("'{:.40}' is not a whole number from {} on", text, low);
          },
          ""};
}

Check whole_between(int low, int high) {
  return {[low, high](const std::string& text) {
            const double value = number(text);
            return value >= low && value <= high && value == std::floor(value)
                       ? std::string()
                       : fmt::format("'{:.40}' is not a whole number in {}..{}", text, low, high);
          },
          fmt::format("{}..{}", low, high)};
}

}  // namespace halfspace
