// SPDX-License-Identifier: Apache-2.0
//
// A mesh as a file has it: what each format's reader hands on, in double precision. One function
// for each format; finish_mesh() makes of it what is drawn.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh.hpp"

namespace halfspace {

using TriangleIndices = std::array<std::uint32_t, 3>;

inline constexpr std::uint32_t kNoIndex = UINT32_MAX;

struct RawMesh {
  std::vector<glm::dvec3> positions;
  std::vector<TriangleIndices> triangles;  // in range
  // Of the vertices; empty when the file has none. NaN or zero: this one has none.
  std::vector<glm::vec3> normals;
  // Where normals are not the vertices': into `normals` for each corner, or kNoIndex.
  std::vector<TriangleIndices> corner_normals;
  // Of the vertices; empty when the file has none.
  std::vector<glm::vec3> colors;
  // Where there are none: into palette, for each triangle; empty: all are white.
  std::vector<std::uint32_t> triangle_colors;
  std::vector<glm::vec3> palette;
  // Vertices that are not finite, in order, by line.
  struct NotFinite {
    std::uint32_t vertex;
    std::size_t line;  // 0: the format has no lines
  };
  std::vector<NotFinite> not_finite;
};

// What a reader is given, and where it says what it left out.
struct MeshSource {
  const std::string& path;
  std::string_view bytes;
  const MeshProgress& progress;
  LeftOut& left_out;

  void report(std::size_t bytes_left) const {
    if (progress) progress("reading the mesh", bytes.size() - bytes_left, bytes.size());
  }
};
// Items between two reports.
inline constexpr std::size_t kReportEvery = 4096;

// Each throws what load_mesh() does. The mesh may be without triangles.
RawMesh read_obj(const MeshSource& source);
RawMesh read_ply(const MeshSource& source);
RawMesh read_stl(const MeshSource& source);
RawMesh read_gltf(const MeshSource& source, bool binary);

// Chooses the origin, makes the normals that are missing and merges vertices that are the same.
// Throws Error(kMeshEmpty, kMeshNotFinite, kMeshBroken).
Mesh finish_mesh(const std::string& path, RawMesh raw, const MeshProgress& progress);

// Colours of a format that does not say whether they are 0..1 or 0..255: the latter when all are
// whole and one is above 1.
void scale_colors(std::vector<glm::vec3>& colors);

// The text of a number that is none, as C libraries write it: nan, -nan(ind), 1.#QNAN, 1.#INF.
bool is_not_finite_text(std::string_view token);

// A number of a text format: NaN for is_not_finite_text(), nothing for what is no number.
std::optional<double> parse_coordinate(std::string_view token);

}  // namespace halfspace
