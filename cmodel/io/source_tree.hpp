// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace halfspace {

// The folder that holds `relative`: one around the running program (a build inside its source
// tree), or share/halfspace of the installation that the program belongs to. Empty when there is
// none.
std::filesystem::path folder_with(const std::filesystem::path& relative);

}  // namespace halfspace
