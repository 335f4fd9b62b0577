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
  std::string_view others;        // every chunk after the first, with headers
  std::uint64_t binary_size = 0;  // bytes of data in the second chunk
};

// Throws Error(kMeshBroken) when the sizes in `bytes`, the contents of `path`, do not add up.
GlbParts open_glb(const std::string& path, std::string_view bytes);

// The container of `json` and the chunks `others`.
std::string close_glb(std::string json, std::string_view others);

}  // namespace halfspace
