// SPDX-License-Identifier: Apache-2.0
#include "side_file.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

namespace halfspace {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 4096;

bool is_regular(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// The first, by name, that differs in capitals only.
std::optional<fs::path> ignoring_capitals(const fs::path& path) {
  const std::string wanted = lower(path.filename().string());
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code error;
  std::optional<fs::path> found;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const fs::path& candidate = at->path();
    if (lower(candidate.filename().string()) != wanted || !is_regular(candidate)) continue;
    if (!found || candidate < *found) found = candidate;
  }
  return found;
}

}  // namespace

std::optional<std::string> find_side_file(const std::string& mesh, std::string_view name) {
  if (name.empty() || name.size() > kLongestName || name.find('\0') != std::string_view::npos) {
    return {};
  }
  std::string slashes(name);
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  const fs::path folder = fs::path(mesh).parent_path();
  for (const fs::path& path :
       {folder / std::string(name), folder / slashes, folder / fs::path(slashes).filename()}) {
    if (is_regular(path)) return path.string();
  }
  for (const fs::path& path : {folder / slashes, folder / fs::path(slashes).filename()}) {
    if (const std::optional<fs::path> found = ignoring_capitals(path)) return found->string();
  }
  return {};
}

}  // namespace halfspace
