// SPDX-License-Identifier: Apache-2.0
//
// What the tests of mesh files share: files of their own, and what came of them.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <string>

#include "io/error.hpp"
#include "meshes/mesh.hpp"

namespace halfspace {

// A directory of the test's own, gone at its end.
class MeshFile : public testing::Test {
 protected:
  MeshFile()
      : directory_(std::filesystem::temp_directory_path() /
                   ("halfspace_mesh_test_" + std::to_string(getpid()))) {
    std::filesystem::create_directory(directory_);
  }
  ~MeshFile() override { std::filesystem::remove_all(directory_); }

  std::string write(const std::string& name, const std::string& text) const {
    const std::string path = (directory_ / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  Mesh load(const std::string& name, const std::string& text) const {
    return load_mesh(write(name, text));
  }
  Mesh load_obj(const std::string& text) const { return load("test.obj", text); }

  std::filesystem::path directory_;
};

// The error that loading ends in, or 0; its text in `what`.
inline int error_of(const std::string& path, std::string* what = nullptr) {
  try {
    load_mesh(path);
  } catch (const Error& error) {
    if (what != nullptr) *what = error.what();
    return static_cast<int>(error.code());
  }
  return 0;
}

// Six times the enclosed volume, positive when the faces of a closed mesh look outwards.
inline double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum;
}

// A corner of a triangle, in the world.
inline glm::dvec3 corner(const Mesh& mesh, std::size_t triangle, std::size_t i) {
  return mesh.origin + glm::dvec3(mesh.positions[mesh.triangles.at(triangle)[i]]);
}

inline glm::vec3 normal(const Mesh& mesh, std::size_t triangle, std::size_t i) {
  return mesh.normals[mesh.triangles.at(triangle)[i]];
}

inline glm::vec3 color(const Mesh& mesh, std::size_t triangle, std::size_t i) {
  return mesh.colors[mesh.triangles.at(triangle)[i]];
}

// How often a kind was left out.
inline std::uint64_t left_out(const Mesh& mesh, const std::string& key) {
  for (const LeftOut::Kind& kind : mesh.left_out.kinds()) {
    if (kind.key == key) return kind.count;
  }
  return 0;
}

}  // namespace halfspace
