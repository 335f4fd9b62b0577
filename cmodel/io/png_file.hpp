// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "../framebuffer.hpp"
#include "output_file.hpp"

namespace halfspace {

// An 8-bit RGB PNG. Throws Error(kFileWrite); the second never leaves a partial file.
void write_png(OutputFile& file, const Image& image);
void write_png(const std::string& path, const Image& image);

// Reads what write_png() wrote (8-bit RGB, no interlace). Throws Error(kFileRead).
Image read_png(const std::string& path);

}  // namespace halfspace
