// SPDX-License-Identifier: Apache-2.0
//
// Meshes from files: OBJ, glTF (.gltf, .glb), PLY and STL.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "../io/left_out.hpp"

namespace halfspace {

// Triangles over shared vertices, each used by one or more; positions, normals and colors have one
// entry per vertex.
struct Mesh {
  // The world's coordinates are origin + positions. Not 0 where the mesh is far from the world's
  // origin for its size, so that a float holds its shape.
  glm::dvec3 origin{0.0};
  std::vector<glm::vec3> positions;  // world units, finite
  std::vector<glm::vec3> normals;    // unit length; zero where only degenerate triangles meet
  std::vector<glm::vec3> colors;     // red, green, blue, 0..1; white when the file has none
  std::vector<std::array<std::uint32_t, 3>> triangles;  // at least one; indices in range
  LeftOut left_out;
};

enum class MeshFormat { kObj, kGltf, kGlb, kPly, kStl };

// The format that the extension names, in capitals or not. Throws Error(kMeshBroken) for another.
MeshFormat mesh_format(const std::string& path);

// Called now and then while a mesh is read: what is being done, and how much of it is.
using MeshProgress = std::function<void(const char* what, std::uint64_t done, std::uint64_t total)>;

// Reads a mesh file; the extension decides the format.
//
// Polygons are triangulated, points, lines and unused vertices left out, node transforms applied;
// triangles keep the file's order. Normals are the file's; where it has none that is usable they
// are made, smooth up to a crease of 66 degrees, and an STL's always are. Colours are the
// vertices', else the face's or the material's diffuse or base colour. What is not used is not
// looked at.
//
// Throws, but for std::bad_alloc, nothing but Error, with the place `path` or `path:line`:
// kFileRead (missing, unreadable), kMeshBroken (not a format read here, syntax, truncation),
// kMeshEmpty (no triangles), kMeshNotFinite (NaN or infinity in a vertex of a face), kMeshIndex (a
// face names a vertex that is not there).
Mesh load_mesh(const std::string& path, const MeshProgress& progress = {});

// The same of a file's contents; `path` is for messages and for the files beside it.
Mesh parse_mesh(const std::string& path, MeshFormat format, std::string bytes,
                const MeshProgress& progress = {});

}  // namespace halfspace
