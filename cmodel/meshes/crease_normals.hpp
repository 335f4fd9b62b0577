// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace halfspace {

// The normals of triangles that meet at a point and have none: for each the mean of those of the
// triangles whose planes differ from its own by at most 66 degrees, each counted once. Time is
// linear in the triangles that meet: where their planes have more than 256 directions, these are
// first gathered in 384.
class CreaseNormals {
 public:
  // faces: the triangles' unit normals, zero for one without an area, which gets any of the
  // others' normals. The result has one for each, zero when all are; valid until the next call.
  const std::vector<glm::vec3>& at_point(const std::vector<glm::vec3>& faces);

 private:
  void find_directions(const std::vector<glm::vec3>& faces);
  void gather_directions();
  void sum_directions();

  struct Direction {
    glm::vec3 unit;
    glm::dvec3 sum;  // of the faces that have it
    glm::vec3 normal{0.0F};
  };
  std::vector<std::uint32_t> order_;      // faces sorted by direction
  std::vector<std::uint32_t> direction_;  // of each face
  std::vector<Direction> directions_;
  std::vector<glm::vec3> out_;
};

}  // namespace halfspace
