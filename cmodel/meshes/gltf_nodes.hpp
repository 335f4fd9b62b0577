// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <vector>

#include "gltf_file.hpp"

namespace halfspace {

// Where the nodes of a glTF file are.
class GltfNodes {
 public:
  // Throws Error(kMeshBroken) when nodes form a cycle, have two parents or are nested too deeply,
  // kMeshIndex when one is not there.
  explicit GltfNodes(const GltfFile& file);

  // From the node's coordinates to the world's.
  const glm::dmat4& world(std::size_t node) const { return world_[node]; }
  // Those of the file's scene, parents before children. Of a file without scenes: all.
  const std::vector<std::size_t>& in_scene() const { return in_scene_; }

 private:
  std::vector<std::size_t> children(std::size_t node) const;
  glm::dmat4 local(std::size_t node) const;
  void place_all();
  void list_scene();

  const GltfFile& file_;
  std::vector<glm::dmat4> world_;
  std::vector<std::size_t> roots_;
  std::vector<std::size_t> in_scene_;
};

}  // namespace halfspace
