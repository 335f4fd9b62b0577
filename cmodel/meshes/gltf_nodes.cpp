// SPDX-License-Identifier: Apache-2.0
#include "gltf_nodes.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace halfspace {

using nlohmann::json;

GltfNodes::GltfNodes(const GltfFile& file) : file_(file) {
  place_all();
  list_scene();
}

std::vector<std::size_t> GltfNodes::children(std::size_t node) const {
  const json& nodes = file_.list("nodes");
  std::vector<std::size_t> out;
  if (!nodes[node].is_object()) file_.fail("a node is not a JSON object");
  for (const json& child : nodes[node].value("children", json::array())) {
    if (!child.is_number_unsigned() || child.get<std::uint64_t>() >= nodes.size()) {
      file_.fail("a node has a child that is not there", ErrorCode::kMeshIndex);
    }
    out.push_back(child.get<std::size_t>());
  }
  return out;
}

glm::dmat4 GltfNodes::local(std::size_t node) const {
  const json& object = file_.list("nodes")[node];
  if (object.contains("matrix")) {
    const std::vector<double> values = file_.numbers(object, "matrix", 16, {});
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = values[static_cast<std::size_t>(i)];
    return matrix;
  }
  const auto t = file_.numbers(object, "translation", 3, {0.0, 0.0, 0.0});
  const auto r = file_.numbers(object, "rotation", 4, {0.0, 0.0, 0.0, 1.0});
  const auto s = file_.numbers(object, "scale", 3, {1.0, 1.0, 1.0});
  const glm::dquat rotation(r[3], r[0], r[1], r[2]);
  const bool turns = glm::length(rotation) > 0.0;
  const glm::dmat4 turned = turns ? glm::mat4_cast(glm::normalize(rotation)) : glm::dmat4(1.0);
  return glm::translate(glm::dmat4(1.0), glm::dvec3(t[0], t[1], t[2])) * turned *
         glm::scale(glm::dmat4(1.0), glm::dvec3(s[0], s[1], s[2]));
}

void GltfNodes::place_all() {
  const std::size_t count = file_.list("nodes").size();
  std::vector<std::size_t> parents(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (const std::size_t child : children(i)) ++parents[child];
  }
  struct Open {
    std::size_t node;
    int depth;
    glm::dmat4 parent;
  };
  std::vector<Open> open;
  for (std::size_t i = 0; i < count; ++i) {
    if (parents[i] > 1) file_.fail("node " + std::to_string(i) + " has more than one parent");
    if (parents[i] != 0) continue;
    open.push_back({i, 1, glm::dmat4(1.0)});
    roots_.push_back(i);
  }
  // With one parent at most, whatever the roots do not reach is on a cycle.
  world_.assign(count, glm::dmat4(1.0));
  std::size_t reached = 0;
  while (!open.empty()) {
    const Open at = open.back();
    open.pop_back();
    ++reached;
    if (at.depth > kGltfDeepest) file_.fail("the nodes are nested too deeply");
    world_[at.node] = at.parent * local(at.node);
    for (const std::size_t child : children(at.node)) {
      open.push_back({child, at.depth + 1, world_[at.node]});
    }
  }
  if (reached != count) file_.fail("the nodes form a cycle");
}

void GltfNodes::list_scene() {
  std::vector<std::size_t> open;
  if (file_.list("scenes").empty()) {
    open.assign(roots_.rbegin(), roots_.rend());
  } else {
    const json& root = file_.root();
    const std::size_t at = root.contains("scene") ? file_.index(root, "scene", "scenes") : 0;
    const json& scene = file_.list("scenes")[at];
    const json nodes = scene.is_object() ? scene.value("nodes", json::array()) : json::array();
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
      if (!node->is_number_unsigned() || node->get<std::uint64_t>() >= world_.size()) {
        file_.fail("the scene has a node that is not there", ErrorCode::kMeshIndex);
      }
      open.push_back(node->get<std::size_t>());
    }
  }
  std::vector<bool> listed(world_.size(), false);
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    if (listed[node]) continue;
    listed[node] = true;
    in_scene_.push_back(node);
    const std::vector<std::size_t> below = children(node);
    open.insert(open.end(), below.rbegin(), below.rend());
  }
}

}  // namespace halfspace
