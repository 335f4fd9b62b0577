// SPDX-License-Identifier: Apache-2.0
#include "bumpy_torus.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <string_view>

#include "io/output_file.hpp"

namespace halfspace {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// around x across quads, twice as many around as across.
struct Grid {
  explicit Grid(double triangles)
      : across(static_cast<std::uint32_t>(std::ceil(std::max(3.0, std::sqrt(triangles / 4))))),
        around(2 * across) {}

  std::uint32_t vertex(std::uint32_t i, std::uint32_t j) const {
    return i % around * across + j % across;
  }
  // The two triangles of quad (i, j), counter-clockwise from outside.
  std::array<std::array<std::uint32_t, 3>, 2> quad(std::uint32_t i, std::uint32_t j) const {
    const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j);
    const std::uint32_t c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
    return {{{a, b, c}, {a, c, d}}};
  }

  std::uint32_t across;
  std::uint32_t around;
};

// u around the ring, v around the tube, in turns. y is up.
glm::dvec3 surface(double u, double v) {
  const double a = kTurn * u, b = kTurn * v;
  const double tube =
      0.42 + 0.035 * std::sin(12 * a) * std::sin(8 * b) + 0.008 * std::sin(47 * a + 31 * b);
  const double ring = 1 + tube * std::cos(b);
  return {ring * std::cos(a), tube * std::sin(b), -ring * std::sin(a)};
}

struct Vertex {
  glm::vec3 position, normal, color;
};

Vertex vertex_at(const Grid& grid, std::uint32_t i, std::uint32_t j) {
  const double u = static_cast<double>(i) / grid.around;
  const double v = static_cast<double>(j) / grid.across;
  constexpr double kStep = 1e-5;
  const glm::dvec3 along = surface(u + kStep, v) - surface(u - kStep, v);
  const glm::dvec3 across = surface(u, v + kStep) - surface(u, v - kStep);
  Vertex out;
  out.position = surface(u, v);
  out.normal = glm::normalize(glm::cross(along, across));
  for (int c = 0; c < 3; ++c) {
    out.color[c] = static_cast<float>(0.6 + 0.4 * std::cos(kTurn * (u - c / 3.0)));
  }
  return out;
}

// Little endian, whatever the machine.
template <class Word>
void append(std::string& to, Word word) {
  static_assert(std::endian::native == std::endian::little);
  char bytes[sizeof word];
  std::memcpy(bytes, &word, sizeof word);
  to.append(bytes, sizeof word);
}

std::string header(const Grid& grid) {
  const std::uint64_t quads = std::uint64_t{grid.around} * grid.across;
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment bumpy torus\n";
  text += "element vertex " + std::to_string(quads) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) {
    text += std::string("property float ") + name + "\n";
  }
  for (const char* name : {"red", "green", "blue"}) {
    text += std::string("property uchar ") + name + "\n";
  }
  return text + "element face " + std::to_string(2 * quads) +
         "\nproperty list uchar uint vertex_indices\nend_header\n";
}

}  // namespace

Mesh bumpy_torus(double triangles) {
  const Grid grid(triangles);
  Mesh mesh;
  for (std::uint32_t i = 0; i < grid.around; ++i) {
    for (std::uint32_t j = 0; j < grid.across; ++j) {
      const Vertex vertex = vertex_at(grid, i, j);
      mesh.positions.push_back(vertex.position);
      mesh.normals.push_back(vertex.normal);
      mesh.colors.push_back(vertex.color);
      for (const auto& triangle : grid.quad(i, j)) mesh.triangles.push_back(triangle);
    }
  }
  return mesh;
}

void write_bumpy_torus(const std::string& path, double triangles) {
  const Grid grid(triangles);
  OutputFile file(path);
  std::string bytes = header(grid);
  for (std::uint32_t i = 0; i < grid.around; ++i) {
    for (std::uint32_t j = 0; j < grid.across; ++j) {
      const Vertex vertex = vertex_at(grid, i, j);
      for (int c = 0; c < 3; ++c) append(bytes, vertex.position[c]);
      for (int c = 0; c < 3; ++c) append(bytes, vertex.normal[c]);
      for (int c = 0; c < 3; ++c) {
        append(bytes, static_cast<std::uint8_t>(std::lround(255 * vertex.color[c])));
      }
    }
    file.write(bytes);
    bytes.clear();
  }
  for (std::uint32_t i = 0; i < grid.around; ++i) {
    for (std::uint32_t j = 0; j < grid.across; ++j) {
      for (const auto& triangle : grid.quad(i, j)) {
        append(bytes, std::uint8_t{3});
        for (const std::uint32_t index : triangle) append(bytes, index);
      }
    }
    file.write(bytes);
    bytes.clear();
  }
  file.commit();
}

}  // namespace halfspace
