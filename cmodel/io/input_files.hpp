// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace halfspace {

// What stands for standard input and standard output where a file is named.
inline constexpr const char* kStandardStream = "-";

// From here on the file counts as read by this run, so that no output may replace it. read_file()
// says so by itself; a command says it of what it will read before it checks its outputs. A file
// that is not there is none, and pipes and devices cannot be replaced.
void note_input(const std::string& path);

// Whether an output of that name would replace such a file, under whatever name: through a link, a
// hard link, "..", or a descriptor. Not when the file has changed since it was read.
bool is_input(const std::string& path);

}  // namespace halfspace
