// SPDX-License-Identifier: Apache-2.0
#include "gltf_shape.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <optional>

namespace halfspace {
namespace {

using nlohmann::json;

class ShapeReader {
 public:
  ShapeReader(GltfFile& file, const GltfNodes& nodes, const json& node, const json& mesh,
              const json& primitive)
      : file_(file), nodes_(nodes), node_(node), mesh_(mesh), primitive_(primitive) {}

  GltfShape read() {
    const json& attributes = primitive_.at("attributes");
    const std::size_t positions = file_.index(attributes, "POSITION", "accessors");
    vertices_ = file_.count(positions);
    shape_.positions = vectors(positions);
    if (attributes.contains("NORMAL")) shape_.normals = vectors(accessor(attributes, "NORMAL"));
    if (attributes.contains("COLOR_0")) {
      for (const glm::dvec3& color : vectors(accessor(attributes, "COLOR_0"), true)) {
        shape_.colors.emplace_back(color);
      }
    }
    morph();
    if (node_.contains("skin") && attributes.contains("JOINTS_0")) skin(attributes);
    return std::move(shape_);
  }

 private:
  // One that has an element for each vertex.
  std::size_t accessor(const json& attributes, const char* name) const {
    const std::size_t at = file_.index(attributes, name, "accessors");
    if (file_.count(at) != vertices_) {
      file_.fail("a primitive's attributes differ in their number of vertices");
    }
    return at;
  }

  std::vector<glm::dvec3> vectors(std::size_t accessor, bool as_unit = false) const {
    if (file_.components(accessor) < 3) {
      file_.fail("accessor " + std::to_string(accessor) + " is not of vectors");
    }
    const std::vector<float> values = file_.floats(accessor, 3, as_unit);
    std::vector<glm::dvec3> out(values.size() / 3);
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
    }
    return out;
  }

  // By the weights of the node, else of the mesh. Targets of weight 0 are not looked at.
  void morph() {
    const json targets = primitive_.value("targets", json::array());
    const json& owner = node_.contains("weights") ? node_ : mesh_;
    const json weights = owner.value("weights", json::array());
    for (std::size_t i = 0; i < std::min(targets.size(), weights.size()); ++i) {
      const auto weight = weights[i].get<double>();
      if (weight == 0.0) continue;
      add(targets[i], "POSITION", weight, shape_.positions);
      if (!shape_.normals.empty()) add(targets[i], "NORMAL", weight, shape_.normals);
      if (shape_.colors.empty() || !targets[i].contains("COLOR_0")) continue;
      const std::vector<glm::dvec3> moves = vectors(accessor(targets[i], "COLOR_0"), true);
      for (std::size_t v = 0; v < moves.size(); ++v) {
        shape_.colors[v] += glm::vec3(weight * moves[v]);
      }
    }
  }

  void add(const json& target, const char* name, double weight, std::vector<glm::dvec3>& to) const {
    if (!target.contains(name)) return;
    const std::vector<glm::dvec3> moves = vectors(accessor(target, name));
    for (std::size_t v = 0; v < moves.size(); ++v) to[v] += weight * moves[v];
  }

  // What each joint does to a vertex: the node's own place counts for nothing.
  std::vector<glm::dmat4> joint_matrices() const {
    const json& skin = file_.list("skins")[file_.index(node_, "skin", "skins")];
    const json joints = skin.value("joints", json::array());
    std::vector<float> inverse;
    if (skin.contains("inverseBindMatrices")) {
      const std::size_t at = file_.index(skin, "inverseBindMatrices", "accessors");
      if (file_.count(at) < joints.size() || file_.components(at) != 16) {
        file_.fail("a skin has fewer matrices than joints");
      }
      inverse = file_.floats(at, 16);
    }
    std::vector<glm::dmat4> out;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      if (!joints[j].is_number_unsigned() ||
          joints[j].get<std::uint64_t>() >= file_.list("nodes").size()) {
        file_.fail("a skin has a joint that is not there", ErrorCode::kMeshIndex);
      }
      glm::dmat4 bind(1.0);
      for (int i = 0; i < 16 && !inverse.empty(); ++i) {
        bind[i / 4][i % 4] = static_cast<double>(inverse[16 * j + static_cast<std::size_t>(i)]);
      }
      out.push_back(nodes_.world(joints[j].get<std::size_t>()) * bind);
    }
    return out;
  }

  void skin(const json& attributes) {
    const std::vector<glm::dmat4> joints = joint_matrices();
    std::vector<glm::dmat4> blend(vertices_, glm::dmat4(0.0));
    std::vector<double> sum(vertices_, 0.0);
    for (int set = 0;; ++set) {
      const std::string joint = "JOINTS_" + std::to_string(set);
      const std::string weight = "WEIGHTS_" + std::to_string(set);
      if (!attributes.contains(joint) || !attributes.contains(weight)) break;
      const auto which = file_.floats(accessor(attributes, joint.c_str()), 4);
      const auto weights = file_.floats(accessor(attributes, weight.c_str()), 4, true);
      for (std::size_t i = 0; i < which.size(); ++i) {
        const auto by = static_cast<double>(weights[i]);
        if (!(by > 0.0)) continue;
        if (!(which[i] >= 0.0F && which[i] < static_cast<float>(joints.size()))) {
          file_.fail("a vertex names a joint that is not there", ErrorCode::kMeshIndex);
        }
        blend[i / 4] += by * joints[static_cast<std::size_t>(which[i])];
        sum[i / 4] += by;
      }
    }
    shape_.skinned = true;
    shape_.mirrored.resize(vertices_);
    for (std::size_t v = 0; v < vertices_; ++v) {
      if (sum[v] == 0.0) continue;  // no joint holds it: it stays where it is
      const glm::dmat4 matrix = blend[v] / sum[v];
      shape_.positions[v] = glm::dvec3(matrix * glm::dvec4(shape_.positions[v], 1.0));
      shape_.mirrored[v] = glm::determinant(glm::dmat3(matrix)) < 0.0;
      if (!shape_.normals.empty()) {
        shape_.normals[v] = transformed_normal(matrix, shape_.normals[v]);
      }
    }
  }

  GltfFile& file_;
  const GltfNodes& nodes_;
  const json& node_;
  const json& mesh_;
  const json& primitive_;
  GltfShape shape_;
  std::size_t vertices_ = 0;
};

}  // namespace

glm::dvec3 transformed_normal(const glm::dmat4& matrix, const glm::dvec3& normal) {
  // The cofactors: the inverse transpose times the determinant, there for flattening ones too.
  const glm::dvec3 a(matrix[0]), b(matrix[1]), c(matrix[2]);
  const glm::dvec3 out =
      normal.x * glm::cross(b, c) + normal.y * glm::cross(c, a) + normal.z * glm::cross(a, b);
  const double length = glm::length(out);
  const double side = glm::dot(a, glm::cross(b, c)) < 0.0 ? -1.0 : 1.0;
  return length > 0.0 ? side * out / length : glm::dvec3(0.0);
}

GltfShape gltf_shape(GltfFile& file, const GltfNodes& nodes, std::size_t node, const json& mesh,
                     const json& primitive) {
  return ShapeReader(file, nodes, file.list("nodes")[node], mesh, primitive).read();
}

}  // namespace halfspace
