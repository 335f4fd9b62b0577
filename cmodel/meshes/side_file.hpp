// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

// The path of a regular file that `mesh`, the path of another, calls `name`: relative to its
// folder, with slashes either way, its own folder where the path of another machine leads nowhere,
// and capitals ignored where no file has them so. Never a device or a pipe, which might not end.
std::optional<std::string> find_side_file(const std::string& mesh, std::string_view name);

}  // namespace halfspace
