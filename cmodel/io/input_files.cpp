// SPDX-License-Identifier: Apache-2.0
#include "input_files.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <set>

namespace halfspace {
namespace {

// Device, file, and what changes when another file gets its number or it is written anew.
using Identity = std::array<std::int64_t, 5>;

// stream: the descriptor that "-" stands for.
std::optional<Identity> identity_of(const std::string& path, int stream) {
  struct stat s = {};
  const bool found =
      path == kStandardStream ? ::fstat(stream, &s) == 0 : ::stat(path.c_str(), &s) == 0;
  if (!found || !S_ISREG(s.st_mode)) return std::nullopt;
  return Identity{static_cast<std::int64_t>(s.st_dev), static_cast<std::int64_t>(s.st_ino),
                  s.st_mtim.tv_sec, s.st_mtim.tv_nsec, s.st_size};
}

std::mutex mutex;
std::set<Identity>& inputs() {
  static std::set<Identity> all;
  return all;
}

}  // namespace

void note_input(const std::string& path) {
  const auto identity = identity_of(path, STDIN_FILENO);
  if (!identity) return;
  const std::lock_guard lock(mutex);
  inputs().insert(*identity);
}

bool is_input(const std::string& path) {
  const auto identity = identity_of(path, STDOUT_FILENO);
  if (!identity) return false;
  const std::lock_guard lock(mutex);
  return inputs().count(*identity) != 0;
}

}  // namespace halfspace
