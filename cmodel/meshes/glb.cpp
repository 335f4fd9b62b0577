// SPDX-License-Identifier: Apache-2.0
#include "glb.hpp"

#include "../io/error.hpp"

namespace halfspace {
namespace {

constexpr std::uint32_t kMagic = 0x46546c67;        // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004e4942;  // "BIN"
constexpr std::size_t kFileHeader = 12, kChunkHeader = 8;

std::uint32_t word(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

}  // namespace

GlbParts open_glb(const std::string& path, std::string_view bytes) {
  const auto fail = [&path](const std::string& text) {
    throw Error(ErrorCode::kMeshBroken, path, text);
  };
  if (bytes.size() < kFileHeader + kChunkHeader || word(bytes, 0) != kMagic) {
    fail("does not start with a GLB header");
  }
  if (word(bytes, 4) == 1) fail("is glTF 1.0, which is not read: export it as glTF 2.0");
  if (word(bytes, 4) != 2) fail("is not GLB version 2");
  const std::size_t size = word(bytes, 8);
  if (size > bytes.size() || size < kFileHeader + kChunkHeader) {
    fail("the header says " + std::to_string(size) + " bytes, the file has " +
         std::to_string(bytes.size()));
  }
  if (word(bytes, 16) != kJsonChunk) fail("the first chunk is not JSON");
  GlbParts parts;
  parts.after = bytes.size() - size;
  bytes = bytes.substr(0, size);
  int index = 0;
  for (std::size_t at = kFileHeader; at < bytes.size(); ++index) {
    if (bytes.size() - at < kChunkHeader) fail("the file ends inside a chunk");
    const std::size_t length = word(bytes, at);
    const std::uint32_t type = word(bytes, at + 4);
    at += kChunkHeader;
    if (length > bytes.size() - at) fail("a chunk reaches beyond the end of the file");
    if (index == 0) parts.json = bytes.substr(at, length);
    if (index == 1 && type == kBinaryChunk) parts.binary = bytes.substr(at, length);
    at += length;
  }
  // Some writers pad with zeros.
  while (!parts.json.empty() && parts.json.back() == '\0') parts.json.remove_suffix(1);
  return parts;
}

}  // namespace halfspace
