// SPDX-License-Identifier: Apache-2.0
//
// Vertices made once for the triangles near each other that share them, in memory that does not
// grow with the mesh.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vertex_shader.hpp"

namespace halfspace {

// The last vertices made, by the low bits of their index: most are used again within a few
// triangles, and memory does not grow with the mesh.
class VertexCache {
 public:
  explicit VertexCache(const VertexShader& shader) : shader_(shader) {}

  const ClipVertex& vertex(std::uint32_t index) {
    Entry& entry = entries_[index & (kEntries - 1)];
    if (entry.key != index + std::uint64_t{1}) {
      entry.vertex = shader_.vertex(index);
      entry.key = index + std::uint64_t{1};
    }
    return entry.vertex;
  }

 private:
  static constexpr std::uint32_t kEntries = 1 << 13;
  struct Entry {
    std::uint64_t key = 0;  // the index plus 1; 0: nothing yet
    ClipVertex vertex;
  };
  const VertexShader& shader_;
  std::vector<Entry> entries_ = std::vector<Entry>(kEntries);
};

// Some triangles of a mesh with the vertices that they use, each once as a rule: what a frame
// engine draws at a time, so that memory does not grow with the mesh.
inline constexpr std::size_t kPartTriangles = 32768;

class MeshPart {
 public:
  explicit MeshPart(const VertexShader& shader) : shader_(shader) {}

  void add(const std::array<std::uint32_t, 3>& triangle) {
    std::array<std::uint32_t, 3> local{};
    for (std::size_t i = 0; i < 3; ++i) local[i] = place(triangle[i]);
    triangles_.push_back(local);
  }

  void clear() {
    vertices_.clear();
    triangles_.clear();
    ++part_;
  }

  const std::vector<ClipVertex>& vertices() const { return vertices_; }
  const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }

 private:
  static constexpr std::uint32_t kEntries = 1 << 15;
  struct Entry {
    std::uint32_t part = 0;  // 0: nothing yet
    std::uint32_t index = 0;
    std::uint32_t place = 0;
  };

  // Where the vertex is in vertices_.
  std::uint32_t place(std::uint32_t index) {
    Entry& entry = entries_[index & (kEntries - 1)];
    if (entry.part != part_ || entry.index != index) {
      entry = {part_, index, static_cast<std::uint32_t>(vertices_.size())};
      vertices_.push_back(shader_.vertex(index));
    }
    return entry.place;
  }

  const VertexShader& shader_;
  std::uint32_t part_ = 1;
  std::vector<Entry> entries_ = std::vector<Entry>(kEntries);
  std::vector<ClipVertex> vertices_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace halfspace
