// SPDX-License-Identifier: Apache-2.0
//
// The materials of OBJ files: what mtllib names, and the colours in it.
#pragma once

#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "../io/left_out.hpp"

namespace halfspace {

// Diffuse colours by the names of materials. A material never refuses a mesh.
class MtlColors {
 public:
  // mesh: the path of the OBJ file, which materials are beside.
  MtlColors(std::string mesh, LeftOut& left_out) : mesh_(std::move(mesh)), left_out_(left_out) {}

  // What follows mtllib: one name, with blanks or in quotes, or several. The first material of a
  // name counts.
  void add_libraries(std::string_view names, std::size_t line);
  // What follows usemtl. Nothing where no file defines it.
  std::optional<glm::vec3> find(std::string_view name) const;

 private:
  bool add_library(std::string_view name);
  void read(std::string_view text);

  std::string mesh_;
  LeftOut& left_out_;
  std::map<std::string, glm::vec3, std::less<>> colors_;
  std::map<std::string, bool> known_;  // libraries, and whether they were read
};

// The name without blanks around it and without quotes; with_comment: and a comment after it.
std::string_view trimmed_name(std::string_view text, bool with_comment);

}  // namespace halfspace
