// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "gltf_file.hpp"
#include "gltf_nodes.hpp"

namespace halfspace {

// The vertices of a primitive as a node shows them: morphed by its weights, and in its own
// coordinates, or, skinned, in the world's.
struct GltfShape {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;  // empty, or one for each; not of unit length
  std::vector<glm::vec3> colors;    // empty, or one for each
  bool skinned = false;
  std::vector<bool> mirrored;  // skinned: the vertex's joints turn its triangles around
};

// node: for its weights and skin. Throws Error.
GltfShape gltf_shape(GltfFile& file, const GltfNodes& nodes, std::size_t node,
                     const nlohmann::json& mesh, const nlohmann::json& primitive);

// A normal under `matrix`, whatever it does to lengths and angles.
glm::dvec3 transformed_normal(const glm::dmat4& matrix, const glm::dvec3& normal);

}  // namespace halfspace
