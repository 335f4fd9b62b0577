// SPDX-License-Identifier: Apache-2.0
//
// Meshes from files: OBJ, glTF (.gltf, .glb), PLY and STL.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace halfspace {

// Triangles over shared vertices, each used by one or more; positions, normals and colors have one
// entry per vertex.
struct Mesh {
  std::vector<glm::vec3> positions;  // world units, finite
  std::vector<glm::vec3> normals;    // unit length; zero where only degenerate triangles meet
  std::vector<glm::vec3> colors;     // red, green, blue, 0..1; white when the file has none
  std::vector<std::array<std::uint32_t, 3>> triangles;  // at least one; indices in range
};

// Reads a mesh file; the extension, in either case, decides the format.
//
// Polygons are triangulated, points, lines and unused vertices left out, node transforms applied.
// Missing normals are made, smooth up to a crease of 66 degrees; an STL's are always made. Colours
// are the vertices', else the material's diffuse or base colour. Triangles keep the file's order
// within a material.
//
// Throws nothing but Error, with the place `path` or `path:line`: kFileRead (missing, unreadable),
// kMeshBroken (not a format read here, syntax, truncation), kMeshEmpty (no triangles),
// kMeshNotFinite (NaN or infinity in a vertex), kMeshIndex (a face names a vertex that is not
// there).
Mesh load_mesh(const std::string& path);

}  // namespace halfspace
