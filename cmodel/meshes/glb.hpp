// SPDX-License-Identifier: Apache-2.0
//
// The container of binary glTF: a 12-byte header, then chunks of 8 bytes and their data, the first
// one JSON, the second one usually the buffer.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace halfspace {

struct GlbParts {
  std::string_view json;
  std::string_view binary;  // the data of the chunk BIN; empty when there is none
  std::uint64_t after = 0;  // bytes after those that the header counts
};

// Throws Error(kMeshBroken) when the sizes in `bytes`, the contents of `path`, do not add up.
GlbParts open_glb(const std::string& path, std::string_view bytes);

}  // namespace halfspace
