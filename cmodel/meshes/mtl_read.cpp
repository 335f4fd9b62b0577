// SPDX-License-Identifier: Apache-2.0
#include "mtl_read.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "../io/error.hpp"
#include "../io/output_file.hpp"
#include "../io/scan.hpp"
#include "side_file.hpp"

namespace halfspace {
namespace {

// Names of libraries: each that is not there costs a look through the folder.
constexpr std::size_t kMostLibraries = 256;

// One, two or three numbers: a colour, or a grey for one.
std::optional<glm::vec3> color_of(std::string_view text) {
  glm::vec3 color(0.0F);
  int count = 0;
  for (; count < 3; ++count) {
    const std::string_view token = next_token(text);
    if (token.empty() || token[0] == '#') break;
    const std::optional<double> value = parse_number(token);
    if (!value || !is_finite_float(*value)) return {};
    color[count] = static_cast<float>(*value);
  }
  if (count == 0) return {};
  for (int i = count; i < 3; ++i) color[i] = color[0];
  return color;
}

}  // namespace

std::string_view trimmed_name(std::string_view text, bool with_comment) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  if (!with_comment) {
    for (std::size_t i = 1; i < text.size(); ++i) {
      if (text[i] == '#' && is_blank(text[i - 1])) text = text.substr(0, i);
    }
  }
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = text.substr(1, text.size() - 2);
  }
  return text;
}

void MtlColors::add_libraries(std::string_view names, std::size_t line) {
  if (add_library(trimmed_name(names, true)) || add_library(trimmed_name(names, false))) return;
  std::string_view rest = trimmed_name(names, false);
  for (std::string_view name = next_token(rest); !name.empty(); name = next_token(rest)) {
    if (add_library(name)) continue;
    left_out_.add("material_files", "material file that cannot be read",
                  "material files that cannot be read", 1, line);
  }
}

bool MtlColors::add_library(std::string_view name) {
  if (known_.size() > kMostLibraries) return false;
  const auto [known, is_new] = known_.try_emplace(std::string(name), false);
  if (!is_new) return known->second;
  const std::optional<std::string> path = find_side_file(mesh_, name);
  if (!path) return false;
  try {
    read(read_file(*path));
  } catch (const Error&) {  // no permission
    return false;
  }
  known->second = true;
  return true;
}

void MtlColors::read(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  std::string name;
  std::optional<glm::vec3> color;
  bool has_name = false, has_map = false;
  const auto finish = [&] {
    if (!has_name) return;
    // A texture is not drawn; the black that some writers put under it would hide the shape.
    if (!color || (has_map && *color == glm::vec3(0.0F))) color = glm::vec3(1.0F);
    colors_.emplace(name, *color);
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(text.size(), end + 1));
    std::string keyword(next_token(line).substr(0, 16));
    for (char& c : keyword) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (keyword == "newmtl") {
      finish();
      name = trimmed_name(line, true);
      has_name = true;
      has_map = false;
      color.reset();
    } else if (keyword == "kd") {
      color = color_of(line);
    } else if (keyword == "map_kd") {
      has_map = true;
    }
  }
  finish();
}

std::optional<glm::vec3> MtlColors::find(std::string_view name) const {
  for (const bool with_comment : {true, false}) {
    const auto found = colors_.find(trimmed_name(name, with_comment));
    if (found != colors_.end()) return found->second;
  }
  return {};
}

}  // namespace halfspace
