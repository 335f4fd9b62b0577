// SPDX-License-Identifier: Apache-2.0
//
// The header of a PLY file: what its data are.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };

struct PlyType {
  std::size_t size = 0;  // bytes; 0: no such type
  bool is_float = false;
  bool is_signed = false;
};

// What a property is to a mesh. Others are read over.
enum class PlyRole {
  kNone,
  kX,
  kY,
  kZ,
  kNormalX,
  kNormalY,
  kNormalZ,
  kRed,
  kGreen,
  kBlue,
  kIndices,
};

struct PlyProperty {
  std::string name;
  PlyType type;
  PlyType count;  // of a list; size 0 for a single value
  PlyRole role = PlyRole::kNone;
};

enum class PlyKind { kOther, kVertex, kFace, kStrips };

struct PlyElement {
  std::string name;
  PlyKind kind = PlyKind::kOther;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool has(PlyRole role) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  // bytes, with the end of its last line
  std::size_t lines = 0;

  const PlyElement* find(PlyKind kind) const;
};

// Lines may end in LF, CR LF or CR; comments may stand anywhere after the first one. Throws
// Error(kMeshBroken), also when there is no vertex with x, y and z.
PlyHeader read_ply_header(const std::string& path, std::string_view bytes);

}  // namespace halfspace
