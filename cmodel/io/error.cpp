// SPDX-License-Identifier: Apache-2.0
#include "error.hpp"

#include "printable.hpp"

namespace halfspace {

namespace {

std::string line_of(const std::string& place, const std::string& text) {
  std::string line = place.empty() ? "" : place + ": ";
  return printable(line.append(first_line(text)));
}

}  // namespace

Error::Error(ErrorCode code, const std::string& place, const std::string& text)
    : std::runtime_error(line_of(place, text)), code_(code) {}

}  // namespace halfspace
