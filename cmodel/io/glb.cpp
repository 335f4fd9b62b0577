// SPDX-License-Identifier: Apache-2.0
#include "glb.hpp"

#include "error.hpp"

namespace halfspace {
namespace {

constexpr std::uint32_t kMagic = 0x46546c67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;  // "JSON"
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
  if (word(bytes, 4) != 2) fail("is not GLB version 2");
  if (word(bytes, 8) != bytes.size()) {
    fail("the header says " + std::to_string(word(bytes, 8)) + " bytes, the file has " +
         std::to_string(bytes.size()));
  }
  if (word(bytes, 16) != kJsonChunk) fail("the first chunk is not JSON");
  GlbParts parts;
  int index = 0;
  for (std::size_t at = kFileHeader; at < bytes.size(); ++index) {
    if (bytes.size() - at < kChunkHeader) fail("the file ends inside a chunk");
    const std::size_t size = word(bytes, at);
    at += kChunkHeader;
    if (size > bytes.size() - at) fail("a chunk reaches beyond the end of the file");
    if (index == 0) {
      parts.json = bytes.substr(at, size);
      parts.others = bytes.substr(at + size);
    }
    if (index == 1) parts.binary_size = size;
    at += size;
  }
  return parts;
}

std::string close_glb(std::string json, std::string_view others) {
  while (json.size() % 4 != 0) json += ' ';
  std::string bytes;
  const auto append = [&bytes](std::uint64_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
      bytes += static_cast<char>(static_cast<std::uint8_t>(value >> shift));
    }
  };
  append(kMagic);
  append(2);
  append(kFileHeader + kChunkHeader + json.size() + others.size());
  append(json.size());
  append(kJsonChunk);
  return bytes.append(json).append(others);
}

}  // namespace halfspace
