// SPDX-License-Identifier: Apache-2.0
#include "manners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "io/error.hpp"
#include "io/input_files.hpp"

namespace halfspace {

void say_no_effect(const std::string& option, const std::string& why) {
  static std::set<std::string> said;
  if (!said.insert(option).second) return;
  fmt::print(stderr, "halfspace: note: {} has no effect: {}\n", option, why);
}

void require_png_name(const std::string& path, const char* option) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension.empty() || extension == ".png") return;
  throw Error(ErrorCode::kUsage, option,
              fmt::format("'{:.60}' does not end in .png: pictures are written as PNG", path));
}

std::FILE* talk(std::initializer_list<std::string> outputs) {
  return std::find(outputs.begin(), outputs.end(), kStandardStream) == outputs.end() ? stdout
                                                                                     : stderr;
}

}  // namespace halfspace
