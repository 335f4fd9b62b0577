// SPDX-License-Identifier: Apache-2.0
#include "raw_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "../io/scan.hpp"

namespace halfspace {

void scale_colors(std::vector<glm::vec3>& colors) {
  bool above_one = false;
  for (const glm::vec3& color : colors) {
    for (int i = 0; i < 3; ++i) {
      if (!std::isfinite(color[i])) continue;
      if (color[i] != std::floor(color[i])) return;
      above_one = above_one || color[i] > 1.0F;
    }
  }
  if (!above_one) return;
  for (glm::vec3& color : colors) color /= 255.0F;
}

bool is_not_finite_text(std::string_view token) {
  if (!token.empty() && (token[0] == '-' || token[0] == '+')) token.remove_prefix(1);
  const auto starts_with = [token](std::string_view word) {
    return token.size() >= word.size() &&
           std::equal(word.begin(), word.end(), token.begin(), [](char w, char c) {
             return w == (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
           });
  };
  return starts_with("nan") || starts_with("inf") || starts_with("1.#");
}

std::optional<double> parse_coordinate(std::string_view token) {
  const std::optional<double> value = parse_number(token);
  if (!value && is_not_finite_text(token)) return std::numeric_limits<double>::quiet_NaN();
  return value;
}

}  // namespace halfspace
