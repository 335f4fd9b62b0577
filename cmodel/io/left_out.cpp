// SPDX-License-Identifier: Apache-2.0
#include "left_out.hpp"

#include <algorithm>

namespace halfspace {

void LeftOut::add(std::string_view key, std::string_view one, std::string_view many,
                  std::uint64_t count, std::size_t line) {
  if (count == 0) return;
  const auto found = std::find_if(kinds_.begin(), kinds_.end(),
                                  [key](const Kind& kind) { return kind.key == key; });
  if (found != kinds_.end()) {
    found->count += count;
  } else {
    kinds_.push_back({std::string(key), std::string(one), std::string(many), count, line});
  }
}

std::string LeftOut::note() const {
  std::string text = "left out:";
  for (const Kind& kind : kinds_) {
    text += &kind == kinds_.data() ? " " : ", ";
    text += std::to_string(kind.count) + " " + (kind.count == 1 ? kind.one : kind.many);
    if (kind.line != 0) {
      text += (kind.count == 1 ? " (line " : " (the first in line ") + std::to_string(kind.line);
      text += ")";
    }
  }
  return text;
}

}  // namespace halfspace
