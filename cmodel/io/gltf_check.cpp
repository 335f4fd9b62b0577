// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "error.hpp"
#include "glb.hpp"
#include "mesh_checks.hpp"

namespace halfspace {
namespace {

using nlohmann::json;

constexpr int kDeepest = 500;

class GltfChecker {
 public:
  // chunk_size: bytes of the GLB's binary chunk, the buffer that has no uri.
  GltfChecker(const std::string& path, std::uint64_t chunk_size)
      : path_(path), chunk_size_(chunk_size) {}

  PlainGltf check(std::string_view text) {
    try {
      // Deep nesting would exhaust the stack of the library's recursive parser.
      root_ = json::parse(text, [this](int depth, json::parse_event_t, const json&) {
        if (depth > kDeepest) fail("the JSON is nested too deeply");
        return true;
      });
    } catch (const json::exception& error) {
      fail(without_tag(error.what()));
    }
    if (!root_.is_object()) fail("is not a JSON object");
    try {
      check_extensions();
      check_buffers();
      check_views();
      check_accessors();
      check_primitives();
      check_nodes();
      reduce();
      return {root_.dump(), faces_};
    } catch (const json::exception& error) {  // a value of the wrong type
      fail(without_tag(error.what()));
    }
  }

 private:
  [[noreturn]] void fail(const std::string& text, ErrorCode code = ErrorCode::kMeshBroken) const {
    throw Error(code, path_, text);
  }
  // The JSON library's text without its "[json.exception...] ".
  static std::string without_tag(const std::string& text) {
    const std::size_t end = text.find("] ");
    return end == std::string::npos ? text : text.substr(end + 2);
  }
  static std::string named(const char* what, std::size_t index) {
    return std::string(what) + " " + std::to_string(index);
  }

  // The array of that name, empty when there is none.
  const json& list(const char* name) const {
    static const json none = json::array();
    const auto found = root_.find(name);
    if (found == root_.end()) return none;
    if (!found->is_array()) fail(std::string(name) + " is not an array");
    return *found;
  }

  // A member that counts or points: a whole number from 0 to 2^53.
  std::uint64_t whole(const json& object, const char* name, std::uint64_t fallback) const {
    const auto found = object.find(name);
    if (found == object.end()) return fallback;
    const double value = found->get<double>();
    if (!(value >= 0 && value <= 9007199254740992.0)) {
      fail(std::string(name) + " is out of range");
    }
    return static_cast<std::uint64_t>(value);
  }
  std::uint64_t index(const json& object, const char* name, const char* into) const {
    const std::uint64_t value = whole(object, name, UINT64_MAX);
    if (value >= list(into).size()) {
      fail(std::string(name) + " names no element of " + into, ErrorCode::kMeshIndex);
    }
    return value;
  }

  // The library would need an optional decoder for these.
  void check_extensions() const {
    for (const json& name : list("extensionsRequired")) {
      const auto text = name.get<std::string>();
      if (text == "KHR_draco_mesh_compression" || text == "EXT_meshopt_compression") {
        fail("needs the extension " + text + ", which is not supported");
      }
    }
  }

  void check_buffers() const {
    for (std::size_t i = 0; i < list("buffers").size(); ++i) {
      const json& buffer = list("buffers")[i];
      const std::uint64_t declared = whole(buffer, "byteLength", 0);
      std::uint64_t present = declared;  // a file beside this one: the library opens it
      if (!buffer.contains("uri")) {
        present = chunk_size_;
      } else if (const auto uri = buffer["uri"].get<std::string>(); uri.starts_with("data:")) {
        const std::size_t comma = uri.find(";base64,");
        if (comma == std::string::npos) fail(named("buffer", i) + ": its data is not base64");
        std::string_view data = std::string_view(uri).substr(comma + 8);
        while (!data.empty() && data.back() == '=') data.remove_suffix(1);
        present = data.size() * 3 / 4;
      }
      if (present < declared) {
        fail(named("buffer", i) + ": " + std::to_string(declared) + " bytes declared, " +
             std::to_string(present) + " present");
      }
    }
  }

  void check_views() const {
    for (std::size_t i = 0; i < list("bufferViews").size(); ++i) {
      const json& view = list("bufferViews")[i];
      const json& buffer = list("buffers")[index(view, "buffer", "buffers")];
      if (whole(view, "byteOffset", 0) + whole(view, "byteLength", 0) >
          whole(buffer, "byteLength", 0)) {
        fail(named("bufferView", i) + " reaches beyond its buffer");
      }
    }
  }

  void check_accessors() const {
    for (std::size_t i = 0; i < list("accessors").size(); ++i) {
      const json& accessor = list("accessors")[i];
      const std::uint64_t size = element_size(accessor);
      if (size == 0) fail(named("accessor", i) + " has an unknown type");
      if (accessor.contains("sparse")) fail(named("accessor", i) + " is sparse: not supported");
      const std::uint64_t count = whole(accessor, "count", 0);
      if (count == 0 || !accessor.contains("bufferView")) continue;
      const json& view = list("bufferViews")[index(accessor, "bufferView", "bufferViews")];
      const std::uint64_t stride = whole(view, "byteStride", size);
      const double end = static_cast<double>(whole(accessor, "byteOffset", 0)) +
                         static_cast<double>(stride) * static_cast<double>(count - 1) +
                         static_cast<double>(size);
      if (end > static_cast<double>(whole(view, "byteLength", 0))) {
        fail(named("accessor", i) + " reaches beyond its bufferView");
      }
    }
  }

  std::uint64_t element_size(const json& accessor) const {
    static const std::array<std::pair<const char*, std::uint64_t>, 7> kTypes{{{"SCALAR", 1},
                                                                              {"VEC2", 2},
                                                                              {"VEC3", 3},
                                                                              {"VEC4", 4},
                                                                              {"MAT2", 4},
                                                                              {"MAT3", 9},
                                                                              {"MAT4", 16}}};
    const auto name = accessor.value("type", std::string());
    const std::uint64_t type = whole(accessor, "componentType", 0);
    const std::uint64_t bytes = type == 5120 || type == 5121                   ? 1
                                : type == 5122 || type == 5123                 ? 2
                                : type == 5124 || type == 5125 || type == 5126 ? 4
                                                                               : 0;
    for (const auto& [known, components] : kTypes) {
      if (name == known) return bytes * components;
    }
    return 0;
  }

  void check_primitives() {
    for (const json& mesh : list("meshes")) {
      for (const json& primitive : mesh.value("primitives", json::array())) {
        check_primitive(primitive);
      }
    }
    if (faces_ == 0) fail("has no triangles", ErrorCode::kMeshEmpty);
  }

  void check_primitive(const json& primitive) {
    const json attributes = primitive.value("attributes", json::object());
    const std::uint64_t vertices =
        whole(list("accessors")[index(attributes, "POSITION", "accessors")], "count", 0);
    for (const auto& [name, value] : attributes.items()) {
      if (whole(list("accessors")[index(attributes, name.c_str(), "accessors")], "count", 0) !=
          vertices) {
        fail("a primitive's attributes differ in their number of vertices");
      }
    }
    std::uint64_t corners = vertices;
    if (primitive.contains("indices")) {
      corners = whole(list("accessors")[index(primitive, "indices", "accessors")], "count", 0);
    }
    const std::uint64_t mode = whole(primitive, "mode", 4);
    const std::uint64_t least = mode >= 4 ? 3 : mode >= 1 ? 2 : 1;
    if (mode > 6) fail("a primitive has an unknown mode");
    if (corners < least) fail("a primitive has too few vertices");
    const std::array<std::uint64_t, 7> faces{corners,     corners / 2, corners,    corners - 1,
                                             corners / 3, corners - 2, corners - 2};
    faces_ += faces[mode];
  }

  // A node that is its own descendant would send the library into endless recursion.
  void check_nodes() {
    const json& nodes = list("nodes");
    std::vector<std::uint32_t> parents(nodes.size(), 0);
    for (const json& node : nodes) {
      if (node.contains("mesh")) index(node, "mesh", "meshes");
      for (const json& child : node.value("children", json::array())) {
        const auto at = child.get<std::uint64_t>();
        if (at >= nodes.size()) fail("a node has a child that is not there", ErrorCode::kMeshIndex);
        ++parents[at];
      }
    }
    // With one parent at most, whatever the roots do not reach is on a cycle.
    std::vector<std::pair<std::size_t, int>> open;  // node, depth
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (parents[i] > 1) fail(named("node", i) + " has more than one parent");
      if (parents[i] == 0) open.emplace_back(i, 1);
      if (parents[i] == 0) roots_.push_back(i);
    }
    std::size_t reached = 0;
    while (!open.empty()) {
      const auto [node, depth] = open.back();
      open.pop_back();
      ++reached;
      if (depth > kDeepest) fail("the nodes are nested too deeply");
      for (const json& child : nodes[node].value("children", json::array())) {
        open.emplace_back(child.get<std::size_t>(), depth + 1);
      }
    }
    if (reached != nodes.size()) fail("the nodes form a cycle");
  }

  // Only what a mesh is made of is left for the library to interpret.
  void reduce() {
    for (const char* name : {"animations", "skins", "cameras", "images", "textures", "samplers",
                             "extensions", "extensionsUsed", "extensionsRequired"}) {
      root_.erase(name);
    }
    for (json& node : root_["nodes"]) {
      for (const char* name : {"skin", "camera", "weights", "extensions"}) node.erase(name);
    }
    for (json& mesh : root_["meshes"]) {
      mesh.erase("weights");
      for (json& primitive : mesh["primitives"]) {
        for (const char* name : {"targets", "extensions"}) primitive.erase(name);
        json kept = json::object();
        for (const char* name : {"POSITION", "NORMAL", "COLOR_0"}) {
          if (primitive["attributes"].contains(name)) kept[name] = primitive["attributes"][name];
        }
        primitive["attributes"] = kept;
      }
    }
    for (json& material : root_["materials"]) {
      json kept = json::object();
      const json pbr = material.value("pbrMetallicRoughness", json::object());
      if (pbr.contains("baseColorFactor")) {
        kept["pbrMetallicRoughness"]["baseColorFactor"] = pbr["baseColorFactor"];
      }
      material = kept;
    }
    for (const char* name : {"nodes", "materials"}) {
      if (root_[name].empty()) root_.erase(name);
    }
    // A scene is optional in the format, but not in the library.
    if (list("scenes").empty()) root_["scenes"] = json::array({{{"nodes", roots_}}});
    if (!root_.contains("scene")) root_["scene"] = 0;
  }

  const std::string& path_;
  json root_;
  std::uint64_t chunk_size_;
  std::vector<std::size_t> roots_;
  std::size_t faces_ = 0;
};

}  // namespace

PlainGltf plain_gltf(const std::string& path, std::string_view bytes, bool binary) {
  if (!binary) return GltfChecker(path, 0).check(bytes);
  const GlbParts parts = open_glb(path, bytes);
  PlainGltf plain = GltfChecker(path, parts.binary_size).check(parts.json);
  plain.bytes = close_glb(std::move(plain.bytes), parts.others);
  return plain;
}

}  // namespace halfspace
