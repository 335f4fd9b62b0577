// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "../camera.hpp"
#include "../geometry.hpp"
#include "../meshes/mesh.hpp"

namespace halfspace {

// How vertices get their colour.
enum class Lighting { kFlat, kGouraud };

// A mesh's vertices as a camera sees them. Keeps nothing per vertex, so that memory does not grow
// with the mesh, which must outlive it.
class VertexShader {
 public:
  // aspect: width / height of the frame.
  VertexShader(const Mesh& mesh, const Camera& camera, double aspect);

  // Clip space is matrix() * (position, 1).
  const glm::dmat4& matrix() const { return world_to_clip_; }
  const Camera& camera() const { return camera_; }

  // Vertex `index` in clip space; its colour 0..255 under a two-sided diffuse light from over the
  // viewer's shoulder.
  ClipVertex vertex(std::uint32_t index) const;

  // The colour that a whole triangle has: the light on its face, on its vertices' mean colour.
  std::array<double, kMaxAttributes> flat_color(const std::array<std::uint32_t, 3>& index) const;

 private:
  std::array<double, kMaxAttributes> shade(const glm::dvec3& color, const glm::dvec3& normal) const;

  const Mesh& mesh_;
  Camera camera_;
  glm::dmat4 world_to_clip_;
  glm::dvec3 light_;  // towards it
};

}  // namespace halfspace
