// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raw_mesh.hpp"
#include "triangulate.hpp"

namespace halfspace {

// Adds the polygons of a file to a mesh, as triangles. They may come before the vertices.
class PolygonSink {
 public:
  PolygonSink(RawMesh& mesh, const MeshSource& source) : mesh_(mesh), source_(source) {}

  // vertices: one for each corner, in range. A polygon of fewer than three is left out and counted.
  // line: of the file, 0: it has none.
  void add(std::span<const std::uint32_t> vertices, std::size_t line) {
    if (vertices.size() < 3) {
      source_.left_out.add("faces_of_fewer_than_3_corners", "face of fewer than 3 corners",
                           "faces of fewer than 3 corners", 1, line);
      cuts_ = {};
      return;
    }
    cuts_ = triangulator_.cut(vertices, mesh_.positions);
    for (const Triangulator::Cut& cut : cuts_) {
      mesh_.triangles.push_back({vertices[cut.a], vertices[cut.b], vertices[cut.c]});
    }
  }
  // What the last polygon became.
  std::span<const Triangulator::Cut> cuts() const { return cuts_; }

 private:
  RawMesh& mesh_;
  const MeshSource& source_;
  Triangulator triangulator_;
  std::span<const Triangulator::Cut> cuts_;
};

}  // namespace halfspace
