// SPDX-License-Identifier: Apache-2.0
//
// Small PLY files of every type and format.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "mesh_fixture.hpp"

namespace halfspace {

struct Type {
  const char* name;
  std::size_t size;
  bool is_float;
  bool is_signed;
};
inline const Type kTypes[] = {
    {"char", 1, false, true},    {"int8", 1, false, true},    {"uchar", 1, false, false},
    {"uint8", 1, false, false},  {"short", 2, false, true},   {"int16", 2, false, true},
    {"ushort", 2, false, false}, {"uint16", 2, false, false}, {"int", 4, false, true},
    {"int32", 4, false, true},   {"uint", 4, false, false},   {"uint32", 4, false, false},
    {"float", 4, true, true},    {"float32", 4, true, true},  {"double", 8, true, true},
    {"float64", 8, true, true}};

inline const Type& type_of(const std::string& name) {
  for (const Type& type : kTypes) {
    if (type.name == name) return type;
  }
  throw std::runtime_error(name);
}

// Values in one of the three formats.
class Data {
 public:
  explicit Data(std::string format) : format_(std::move(format)) {}

  Data& put(const std::string& type_name, double value) {
    const Type& type = type_of(type_name);
    if (format_ == "ascii") {
      std::string text = std::to_string(value);
      if (value == std::floor(value)) text = std::to_string(static_cast<long>(value));
      bytes += text + ' ';
      return *this;
    }
    std::uint64_t bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
    if (type.is_float && type.size == 4)
      bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    if (type.is_float && type.size == 8) bits = std::bit_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < type.size; ++i) {
      const std::size_t at = format_ == "binary_big_endian" ? type.size - 1 - i : i;
      bytes += static_cast<char>(static_cast<std::uint8_t>(bits >> (8 * at)));
    }
    return *this;
  }
  std::string bytes;

 private:
  std::string format_;
};

inline const char* const kFormats[] = {"ascii", "binary_little_endian", "binary_big_endian"};

// Two triangles over four corners of a square.
inline const int kSquare[4][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};

inline void expect_square(const Mesh& mesh) {
  ASSERT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(corner(mesh, 0, 0), glm::dvec3(0, 0, 0));
  EXPECT_EQ(corner(mesh, 0, 1), glm::dvec3(2, 0, 0));
  EXPECT_EQ(corner(mesh, 0, 2), glm::dvec3(2, 2, 0));
  EXPECT_EQ(corner(mesh, 1, 2), glm::dvec3(0, 2, 0));
  EXPECT_EQ(normal(mesh, 0, 0), glm::vec3(0, 0, 1));
}

class Ply : public MeshFile {
 protected:
  std::string header(const std::string& format, const std::string& elements) const {
    return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
  }
};

}  // namespace halfspace
