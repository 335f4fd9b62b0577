// SPDX-License-Identifier: Apache-2.0
//
// glTF 2.0: the meshes of the scene's nodes, in their pose, as triangles of the world.
#include <algorithm>
#include <array>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <set>

#include "../io/scan.hpp"
#include "glb.hpp"
#include "gltf_shape.hpp"
#include "raw_mesh.hpp"

namespace halfspace {
namespace {

using nlohmann::json;

// Triangles that instances of a mesh may make: they take memory, but nearly no file.
constexpr double kMostInstanced = 1e7;

class GltfReader {
 public:
  GltfReader(const MeshSource& source, std::string_view text, std::string_view chunk)
      : source_(source), file_(source.path, text, chunk), nodes_(file_) {}

  RawMesh read() {
    bound_instances();
    std::size_t done = 0;
    for (const std::size_t node : nodes_.in_scene()) {
      source_.report(source_.bytes.size() -
                     source_.bytes.size() * done++ / nodes_.in_scene().size());
      const json& object = file_.list("nodes")[node];
      note_instances(object);
      if (!object.contains("mesh")) continue;
      const json& mesh = file_.list("meshes")[file_.index(object, "mesh", "meshes")];
      for (const json& primitive : mesh.value("primitives", json::array())) {
        if (is_drawn(primitive)) add(node, mesh, primitive);
      }
    }
    return std::move(mesh_);
  }

 private:
  std::uint64_t corners(const json& primitive) const {
    if (primitive.contains("indices")) {
      return file_.count(file_.index(primitive, "indices", "accessors"));
    }
    return file_.count(file_.index(primitive.at("attributes"), "POSITION", "accessors"));
  }

  // Triangles of meshes with each of their nodes, against those of the meshes themselves.
  void bound_instances() const {
    double all = 0, own = 0;
    std::set<std::size_t> seen;
    for (const std::size_t node : nodes_.in_scene()) {
      const json& object = file_.list("nodes")[node];
      if (!object.contains("mesh")) continue;
      const std::size_t at = file_.index(object, "mesh", "meshes");
      const bool is_new = seen.insert(at).second;
      for (const json& primitive : file_.list("meshes")[at].value("primitives", json::array())) {
        const json attributes = primitive.value("attributes", json::object());
        if (!attributes.contains("POSITION")) continue;
        const auto vertices = file_.count(file_.index(attributes, "POSITION", "accessors"));
        const double triangles = static_cast<double>(std::max(corners(primitive), vertices)) / 3.0;
        all += triangles;
        own += is_new ? triangles : 0.0;
      }
    }
    const double most = std::max(kMostInstanced, 2.0 * own);
    if (all > most) {
      file_.fail("its nodes make " + std::to_string(static_cast<std::uint64_t>(all)) +
                 " triangles, more than the " + std::to_string(static_cast<std::uint64_t>(most)) +
                 " that are read");
    }
  }

  void note_instances(const json& node) const {
    if (node.value("extensions", json::object()).contains("EXT_mesh_gpu_instancing")) {
      source_.left_out.add("instances", "node's instances (EXT_mesh_gpu_instancing)",
                           "nodes' instances (EXT_mesh_gpu_instancing)");
    }
  }

  bool is_drawn(const json& primitive) const {
    const std::uint64_t mode = file_.whole(primitive, "mode", 4);
    const json attributes = primitive.value("attributes", json::object());
    if (mode > 6) file_.fail("a primitive has an unknown mode");
    if (!attributes.contains("POSITION")) {
      source_.left_out.add("primitives_without_positions", "primitive without positions",
                           "primitives without positions");
      return false;
    }
    require_no_draco(primitive, file_.index(attributes, "POSITION", "accessors"));
    if (mode < 4) {
      source_.left_out.add("lines_and_points", "primitive of lines or points",
                           "primitives of lines or points");
      return false;
    }
    if (corners(primitive) < 3) {
      source_.left_out.add("primitives_of_fewer_than_3_corners",
                           "primitive of fewer than 3 corners",
                           "primitives of fewer than 3 corners");
      return false;
    }
    return true;
  }

  // Where nothing else is there, the positions would be zeros.
  void require_no_draco(const json& primitive, std::size_t positions) const {
    const json& accessor = file_.list("accessors")[positions];
    const json extensions = primitive.value("extensions", json::object());
    if (extensions.contains("KHR_draco_mesh_compression") && !accessor.contains("bufferView") &&
        !accessor.contains("sparse")) {
      file_.fail("needs the extension 'KHR_draco_mesh_compression', which is not supported");
    }
  }

  void add(std::size_t node, const json& mesh, const json& primitive) {
    const GltfShape shape = gltf_shape(file_, nodes_, node, mesh, primitive);
    const glm::dmat4 world = shape.skinned ? glm::dmat4(1.0) : nodes_.world(node);
    const auto first = mesh_.positions.size();
    if (first + shape.positions.size() >= kNoIndex) file_.fail("has more than 2^32 - 2 vertices");
    for (const glm::dvec3& position : shape.positions) {
      mesh_.positions.emplace_back(world * glm::dvec4(position, 1.0));
    }
    add_normals(shape, world);
    add_colors(shape, primitive);
    const bool mirrored = glm::determinant(glm::dmat3(world)) < 0.0;
    add_triangles(primitive, shape, static_cast<std::uint32_t>(first), mirrored);
  }

  void add_normals(const GltfShape& shape, const glm::dmat4& world) {
    if (shape.normals.empty() && mesh_.normals.empty()) return;
    mesh_.normals.resize(mesh_.positions.size() - shape.positions.size(), glm::vec3(0.0F));
    for (const glm::dvec3& normal : shape.normals) {
      mesh_.normals.emplace_back(transformed_normal(world, normal));
    }
    mesh_.normals.resize(mesh_.positions.size(), glm::vec3(0.0F));
  }

  void add_colors(const GltfShape& shape, const json& primitive) {
    const glm::vec3 base = base_color(primitive);
    for (const glm::vec3& color : shape.colors) mesh_.colors.push_back(base * color);
    mesh_.colors.resize(mesh_.positions.size(), base);
  }

  glm::vec3 base_color(const json& primitive) const {
    if (!primitive.contains("material")) return glm::vec3(1.0F);
    const json& material = file_.list("materials")[file_.index(primitive, "material", "materials")];
    const json none = json::object();
    json paint = material.value("pbrMetallicRoughness", none);
    const char* name = "baseColorFactor";
    const json old =
        material.value("extensions", none).value("KHR_materials_pbrSpecularGlossiness", none);
    if (!paint.contains(name) && old.contains("diffuseFactor")) {
      paint = old;
      name = "diffuseFactor";
    }
    const std::vector<double> factor = file_.numbers(paint, name, 4, {1.0, 1.0, 1.0, 1.0});
    return {static_cast<float>(factor[0]), static_cast<float>(factor[1]),
            static_cast<float>(factor[2])};
  }

  void add_triangles(const json& primitive, const GltfShape& shape, std::uint32_t first,
                     bool mirrored) {
    const std::size_t vertices = shape.positions.size();
    std::vector<std::uint32_t> index;
    if (primitive.contains("indices")) {
      index = file_.indices(file_.index(primitive, "indices", "accessors"));
    }
    const std::size_t count = primitive.contains("indices") ? index.size() : vertices;
    const auto corner = [&](std::size_t i) {
      const std::size_t at = index.empty() ? i : index[i];
      if (at >= vertices) {
        file_.fail("index " + std::to_string(at) + ", but the primitive has " +
                       std::to_string(vertices) + " vertices",
                   ErrorCode::kMeshIndex);
      }
      return static_cast<std::uint32_t>(at);
    };
    const std::uint64_t mode = file_.whole(primitive, "mode", 4);
    const std::size_t triangles = mode == 4 ? count / 3 : count - 2;
    if (mode == 4) {
      source_.left_out.add("corners_of_no_triangle", "corner after the last triangle",
                           "corners after the last triangle", count % 3);
    }
    for (std::size_t i = 0; i < triangles; ++i) {
      std::array<std::uint32_t, 3> t{};
      if (mode == 4) t = {corner(3 * i), corner(3 * i + 1), corner(3 * i + 2)};
      if (mode == 5) t = {corner(i), corner(i + 1 + i % 2), corner(i + 2 - i % 2)};
      if (mode == 6) t = {corner(i + 1), corner(i + 2), corner(0)};
      const bool turned = shape.skinned ? shape.mirrored[t[0]] : mirrored;
      if (turned) std::swap(t[1], t[2]);
      mesh_.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }

  const MeshSource& source_;
  GltfFile file_;
  GltfNodes nodes_;
  RawMesh mesh_;
};

}  // namespace

RawMesh read_gltf(const MeshSource& source, bool binary) {
  GlbParts parts{source.bytes, {}, 0};
  if (binary) parts = open_glb(source.path, source.bytes);
  source.left_out.add("bytes_after_the_data", "byte after the data", "bytes after the data",
                      parts.after);
  try {
    return GltfReader(source, parts.json, parts.binary).read();
  } catch (const json::exception& error) {  // a value of the wrong type
    throw Error(ErrorCode::kMeshBroken, source.path, json_error_text(error.what()));
  }
}

}  // namespace halfspace
