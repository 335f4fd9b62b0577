// SPDX-License-Identifier: Apache-2.0
#include "source_tree.hpp"

#include <system_error>

namespace halfspace {

namespace fs = std::filesystem;

fs::path folder_with(const fs::path& relative) {
  std::error_code error;
  for (fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
       folder.has_relative_path(); folder = folder.parent_path()) {
    for (const fs::path& candidate : {folder, folder / "share" / "halfspace"}) {
      if (fs::exists(candidate / relative, error)) return fs::canonical(candidate);
    }
  }
  return {};
}

}  // namespace halfspace
