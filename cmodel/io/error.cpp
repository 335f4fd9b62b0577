// SPDX-License-Identifier: Apache-2.0
#include "error.hpp"

#include "escape.hpp"

namespace halfspace {

namespace {

constexpr std::size_t kLongestText = 600;

std::string line_of(const std::string& place, const std::string& text) {
  const std::string shown = printable(text, kLongestText);
  return place.empty() ? shown : printable(place) + ": " + shown;
}

}  // namespace

Error::Error(ErrorCode code, const std::string& place, const std::string& text)
    : std::runtime_error(line_of(place, text)), code_(code) {}

}  // namespace halfspace
