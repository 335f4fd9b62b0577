// SPDX-License-Identifier: Apache-2.0
//
// What the mesh library does not check by itself, or checks after it is too late, for the formats
// other than OBJ. Each function takes the contents of `path`, returns the number of faces that the
// library must find when it can be trusted with them, and throws Error otherwise: kMeshBroken
// (syntax, truncation, counts that contradict each other), kMeshEmpty, kMeshNotFinite, kMeshIndex.
// Linear in the size of the file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace halfspace {

// PLY, ASCII and binary: reads every value that the header promises, and requires nothing after it.
// The result is 0, unknown, when there are triangle strips.
std::size_t check_ply(const std::string& path, std::string_view bytes);

// STL: ASCII facets are three vertices each, up to `endsolid`; binary size is 84 + 50 per triangle.
std::size_t check_stl(const std::string& path, std::string_view bytes);

// glTF JSON, or GLB with `binary`: chunk sizes, ranges of accessors in views in buffers, embedded
// data as long as declared, equal numbers of vertices, scene graph without cycles; sparse accessors
// and compression extensions are refused. Indices are left to the library: it drops the faces that
// name a vertex that is not there, so the number of faces tells.
struct PlainGltf {
  // The file reduced to what a mesh is made of: nodes, positions, normals, colours, indices and
  // base colours, without skins, textures, animations or morph targets; and with a scene.
  std::string bytes;
  std::size_t faces = 0;  // points and lines count
};
PlainGltf plain_gltf(const std::string& path, std::string_view bytes, bool binary);

}  // namespace halfspace
