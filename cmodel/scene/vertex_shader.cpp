// SPDX-License-Identifier: Apache-2.0
#include "vertex_shader.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace halfspace {
namespace {

glm::dvec3 over_the_shoulder(const Camera& camera) {
  const glm::dvec3 back = glm::normalize(camera.eye - camera.target);
  const glm::dmat4 view = look_at(camera);
  const glm::dvec3 right{view[0][0], view[1][0], view[2][0]};
  const glm::dvec3 up{view[0][1], view[1][1], view[2][1]};
  return glm::normalize(back + 0.55 * up - 0.45 * right);
}

}  // namespace

VertexShader::VertexShader(const Mesh& mesh, const Camera& camera, double aspect)
    : mesh_(mesh),
      camera_(camera),
      world_to_clip_(world_to_clip(camera_, aspect)),
      light_(over_the_shoulder(camera_)) {}

ClipVertex VertexShader::vertex(std::uint32_t index) const {
  ClipVertex out;
  out.position = world_to_clip_ * glm::dvec4(glm::dvec3(mesh_.positions[index]), 1.0);
  out.attribute = shade(glm::dvec3(mesh_.colors[index]), glm::dvec3(mesh_.normals[index]));
  return out;
}

std::array<double, kMaxAttributes> VertexShader::flat_color(
    const std::array<std::uint32_t, 3>& index) const {
  std::array<glm::dvec3, 3> p;
  glm::dvec3 color{0.0};
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = glm::dvec3(mesh_.positions[index[i]]);
    color += glm::dvec3(mesh_.colors[index[i]]) / 3.0;
  }
  return shade(color, glm::cross(p[1] - p[0], p[2] - p[0]));
}

std::array<double, kMaxAttributes> VertexShader::shade(const glm::dvec3& color,
                                                       const glm::dvec3& normal) const {
  const double length = glm::length(normal);
  const double diffuse = length > 0 ? std::abs(glm::dot(normal, light_)) / length : 0.5;
  const double light = 0.18 + 0.82 * diffuse;
  std::array<double, kMaxAttributes> out{};
  for (int c = 0; c < 3; ++c) out[static_cast<std::size_t>(c)] = 255.0 * light * color[c];
  return out;
}

}  // namespace halfspace
