// SPDX-License-Identifier: Apache-2.0
//
// Small glTF files, made a part at a time.
#pragma once

#include <bit>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mesh_fixture.hpp"

namespace halfspace {

// A file of one buffer, whose accessors are added one by one.
class GltfMaker {
 public:
  nlohmann::json root = {{"asset", {{"version", "2.0"}}},
                         {"nodes", {{{"mesh", 0}}}},
                         {"scenes", {{{"nodes", {0}}}}},
                         {"meshes", {{{"primitives", {nlohmann::json::object()}}}}}};

  nlohmann::json& primitive() { return root["meshes"][0]["primitives"][0]; }

  // A view of values, `stride` bytes apart (0: tight); its number.
  int view(int type, const std::vector<double>& values, std::size_t components,
           std::size_t stride = 0) {
    while (bytes_.size() % 4 != 0) bytes_ += '\0';
    const std::size_t offset = bytes_.size();
    const std::size_t size = components * size_of(type);
    for (std::size_t i = 0; i < values.size(); ++i) {
      put(type, values[i]);
      if (stride != 0 && (i + 1) % components == 0) bytes_.append(stride - size, '\x5a');
    }
    nlohmann::json view = {
        {"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes_.size() - offset}};
    if (stride != 0) view["byteStride"] = stride;
    root["bufferViews"].push_back(view);
    return static_cast<int>(root["bufferViews"].size()) - 1;
  }

  // An accessor of values of its own, or of `count` zeros; its number.
  int accessor(int type, const char* kind, std::size_t components,
               const std::vector<double>& values, std::size_t stride = 0, bool normalized = false) {
    nlohmann::json accessor = {{"bufferView", view(type, values, components, stride)},
                               {"componentType", type},
                               {"count", values.size() / components},
                               {"type", kind}};
    if (normalized) accessor["normalized"] = true;
    root["accessors"].push_back(accessor);
    return static_cast<int>(root["accessors"].size()) - 1;
  }
  int vectors(const std::vector<double>& values) { return accessor(5126, "VEC3", 3, values); }
  int zeros(const char* kind, std::size_t count) {
    root["accessors"].push_back({{"componentType", 5126}, {"count", count}, {"type", kind}});
    return static_cast<int>(root["accessors"].size()) - 1;
  }
  nlohmann::json& last_accessor() { return root["accessors"].back(); }

  // A triangle in the plane z = 0, counter-clockwise.
  GltfMaker& with_triangle() {
    primitive()["attributes"]["POSITION"] = vectors({0, 0, 0, 1, 0, 0, 0, 1, 0});
    return *this;
  }

  std::string gltf() {
    root["buffers"] = {{{"byteLength", bytes_.size()}, {"uri", "data:;base64," + base64()}}};
    return root.dump();
  }
  std::string glb() {
    root["buffers"] = {{{"byteLength", bytes_.size()}}};
    std::string json = root.dump(), binary = bytes_;
    while (json.size() % 4 != 0) json += ' ';
    while (binary.size() % 4 != 0) binary += '\0';
    std::string out = "glTF";
    const auto word = [&out](std::size_t value) {
      for (int i = 0; i < 4; ++i)
        out += static_cast<char>(static_cast<std::uint8_t>(value >> (8 * i)));
    };
    word(2);
    word(28 + json.size() + binary.size());
    word(json.size());
    out += "JSON" + json;
    word(binary.size());
    return out + std::string("BIN\0", 4) + binary;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  static std::size_t size_of(int type) { return type <= 5121 ? 1 : type <= 5123 ? 2 : 4; }

  void put(int type, double value) {
    auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
    if (type == 5126) bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    for (std::size_t i = 0; i < size_of(type); ++i) {
      bytes_ += static_cast<char>(static_cast<std::uint8_t>(bits >> (8 * i)));
    }
  }

  std::string base64() const {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : bytes_) {
      bits = bits << 8 | static_cast<std::uint8_t>(c);
      for (held += 8; held >= 6; held -= 6) out += digits[bits >> (held - 6) & 63U];
    }
    if (held != 0) out += digits[bits << (6 - held) & 63U];
    while (out.size() % 4 != 0) out += '=';
    return out;
  }

  std::string bytes_;
};

class Gltf : public MeshFile {
 protected:
  Mesh load_both(GltfMaker& maker) const {
    Mesh mesh = load("t.gltf", maker.gltf());
    const Mesh glb = load("t.glb", maker.glb());
    EXPECT_EQ(glb.positions, mesh.positions);
    EXPECT_EQ(glb.triangles, mesh.triangles);
    EXPECT_EQ(glb.colors, mesh.colors);
    return mesh;
  }
  std::string refusal(GltfMaker& maker) const {
    std::string what;
    EXPECT_NE(error_of(write("t.gltf", maker.gltf()), &what), 0);
    return what;
  }
};

// Twice the area of the first triangle, positive when it faces +z.
inline double facing(const Mesh& mesh, std::size_t triangle = 0) {
  return glm::cross(corner(mesh, triangle, 1) - corner(mesh, triangle, 0),
                    corner(mesh, triangle, 2) - corner(mesh, triangle, 0))
      .z;
}

}  // namespace halfspace
