// SPDX-License-Identifier: Apache-2.0
//
// A scene where a command line names one: a file, or "-" for standard input.
#pragma once

#include <string>

#include "options.hpp"

namespace halfspace {

// --format, the format of a scene from standard input.
void add_format_option(Command& command, std::string& format);

// The file to read for a scene of that name: the name, or, for "-", a file of what standard input
// holds, gone at the end of the program. Notes it as an input. Throws Error(kUsage) when "-" has no
// format, or a file one, Error(kFileRead) and Error(kFileWrite).
std::string scene_file(const std::string& name, const std::string& format);

// A message with "-" where the file of standard input is named.
std::string with_scene_names(const std::string& text);

}  // namespace halfspace
