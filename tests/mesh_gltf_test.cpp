// SPDX-License-Identifier: Apache-2.0
//
// glTF 2.0: accessors of every kind, files beside it, and what is refused by name.
#include "gltf_fixture.hpp"

namespace halfspace {
namespace {

using nlohmann::json;

TEST_F(Gltf, PositionsAreOfEveryComponentType) {
  struct Type {
    int type;
    double unit;
  };
  for (const Type& type : {Type{5120, 127}, {5121, 255}, {5122, 32767}, {5123, 65535}, {5126, 1}}) {
    for (const bool normalized : {false, true}) {
      for (const std::size_t stride : {std::size_t{0}, std::size_t{12}, std::size_t{28}}) {
        GltfMaker maker;
        const double u = normalized ? type.unit : 100;
        maker.primitive()["attributes"]["POSITION"] =
            maker.accessor(type.type, "VEC3", 3, {0, 0, 0, u, 0, 0, 0, u, 0}, stride, normalized);
        maker.root["extensionsRequired"] = {"KHR_mesh_quantization"};
        const Mesh mesh = load_both(maker);
        const double right = normalized && type.type != 5126 ? 1.0 : u;
        EXPECT_EQ(corner(mesh, 0, 1), glm::dvec3(right, 0, 0)) << type.type << normalized << stride;
        EXPECT_EQ(corner(mesh, 0, 2), glm::dvec3(0, right, 0)) << type.type << normalized << stride;
      }
    }
  }
}

TEST_F(Gltf, NormalsAreOfEveryComponentType) {
  for (const auto& [type, unit] : {std::pair{5120, 127.0}, {5122, 32767.0}, {5126, 1.0}}) {
    GltfMaker maker;
    maker.with_triangle();
    maker.primitive()["attributes"]["NORMAL"] =
        maker.accessor(type, "VEC3", 3, {-unit, 0, 0, 0, -unit, 0, 0, 0, unit},
                       type == 5120 ? 4 : 12, type != 5126);
    const Mesh mesh = load_both(maker);
    EXPECT_EQ(normal(mesh, 0, 0), glm::vec3(-1, 0, 0)) << type;
    EXPECT_EQ(normal(mesh, 0, 1), glm::vec3(0, -1, 0)) << type;
  }
}

TEST_F(Gltf, ColoursTimesTheBaseColour) {
  for (const auto& [type, unit] : {std::pair{5121, 255.0}, {5123, 65535.0}, {5126, 1.0}}) {
    for (const std::size_t components : {std::size_t{3}, std::size_t{4}}) {
      for (const bool flag : {false, true}) {
        GltfMaker maker;
        maker.with_triangle();
        std::vector<double> values(3 * components, unit);
        values[0] = 0;
        maker.primitive()["attributes"]["COLOR_0"] =
            maker.accessor(type, components == 3 ? "VEC3" : "VEC4", components, values, 16, flag);
        maker.primitive()["material"] = 0;
        maker.root["materials"] = {
            {{"pbrMetallicRoughness", {{"baseColorFactor", {1.0, 0.5, 0.25, 1.0}}}}}};
        const Mesh mesh = load_both(maker);
        EXPECT_EQ(color(mesh, 0, 0), glm::vec3(0, 0.5, 0.25)) << type << components << flag;
        EXPECT_EQ(color(mesh, 0, 1), glm::vec3(1, 0.5, 0.25)) << type << components << flag;
      }
    }
  }
}

TEST_F(Gltf, SparseAccessorsReplaceElements) {
  for (const int index_type : {5121, 5123, 5125}) {
    for (const bool on_zeros : {false, true}) {
      GltfMaker maker;
      maker.with_triangle();
      if (on_zeros) maker.primitive()["attributes"]["POSITION"] = maker.zeros("VEC3", 3);
      const int at = maker.view(index_type, {1, 2}, 1),
                values = maker.view(5126, {5, 0, 0, 0, 7, 0}, 3);
      maker.last_accessor()["sparse"] = {
          {"count", 2},
          {"indices", {{"bufferView", at}, {"componentType", index_type}}},
          {"values", {{"bufferView", values}}}};
      const Mesh mesh = load_both(maker);
      EXPECT_EQ(corner(mesh, 0, 1), glm::dvec3(5, 0, 0)) << index_type << on_zeros;
      EXPECT_EQ(corner(mesh, 0, 2), glm::dvec3(0, 7, 0)) << index_type << on_zeros;
    }
  }
}

TEST_F(Gltf, SparseAccessorsStayInTheirBounds) {
  for (const auto& change :
       std::vector<std::pair<const char*, json>>{{"/count", 4},
                                                 {"/indices/componentType", 5126},
                                                 {"/indices/byteOffset", 100},
                                                 {"/values/bufferView", 99},
                                                 {"/indices/bufferView", "x"},
                                                 {"/indices", 3}}) {
    GltfMaker maker;
    maker.with_triangle();
    const int at = maker.view(5121, {1, 9}, 1), values = maker.view(5126, {5, 0, 0, 0, 7, 0}, 3);
    json sparse = {{"count", 1},
                   {"indices", {{"bufferView", at}, {"componentType", 5121}}},
                   {"values", {{"bufferView", values}}}};
    maker.last_accessor()["sparse"] = sparse;
    EXPECT_EQ(error_of(write("t.gltf", maker.gltf())), 0);
    sparse[json::json_pointer(change.first)] = change.second;
    maker.last_accessor()["sparse"] = sparse;
    EXPECT_NE(refusal(maker), "") << change.first;
    maker.last_accessor()["sparse"]["count"] = 2;  // the second index is 9
    EXPECT_NE(refusal(maker), "");
  }
}

TEST_F(Gltf, IndicesAndModes) {
  for (const int type : {5121, 5123, 5125}) {
    for (const auto& [mode, triangles] : {std::pair{4, 2}, {5, 4}, {6, 4}}) {
      GltfMaker maker;
      maker.primitive()["attributes"]["POSITION"] =
          maker.vectors({1, 1, 0, 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0});
      const std::vector<double> list = mode == 4   ? std::vector<double>{0, 1, 2, 0, 2, 3}
                                       : mode == 5 ? std::vector<double>{1, 2, 0, 3, 4, 4}
                                                   : std::vector<double>{0, 1, 2, 3, 4, 1};
      maker.primitive()["indices"] = maker.accessor(type, "SCALAR", 1, list);
      maker.primitive()["mode"] = mode;
      const Mesh mesh = load_both(maker);
      ASSERT_EQ(mesh.triangles.size(), static_cast<std::size_t>(triangles)) << mode;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) EXPECT_GE(facing(mesh, t), 0) << mode;
    }
  }
}

TEST_F(Gltf, BuffersAreFoundByTheirUri) {
  GltfMaker maker;
  maker.with_triangle();
  maker.gltf();
  std::filesystem::create_directory(directory_ / "sub");
  for (const auto& [file, uri] : {std::pair{"my data (1).bin", "my%20data%20(1).bin"},
                                  {"my data (1).bin", "my data (1).bin"},
                                  {"d\xc3\xa4ta.bin", "d%C3%A4ta.bin"},
                                  {"d\xc3\xa4ta.bin", "d\xc3\xa4ta.bin"},
                                  {"a%20b.bin", "a%2520b.bin"},
                                  {"100%.bin", "100%.bin"},
                                  {"sub/x.bin", "./sub/../sub/x.bin"},
                                  {"c%zz.bin", "c%zz.bin"},
                                  {"e%41.bin", "e%41.bin"}}) {
    const std::string path = write(file, maker.bytes());
    maker.root["buffers"][0]["uri"] = uri;
    EXPECT_EQ(load("t.gltf", maker.root.dump()).triangles.size(), 1U) << uri;
    std::filesystem::remove(path);
  }
  for (const char* uri :
       {"/dev/zero", "none.bin", "http://x/y.bin", ".", "data:,abc", "data:;base64,A\x1b[31m"}) {
    maker.root["buffers"][0]["uri"] = uri;
    std::string what;
    EXPECT_EQ(error_of(write("t.gltf", maker.root.dump()), &what), 11) << uri;
    EXPECT_EQ(what.find('\x1b'), std::string::npos);
  }
}

TEST_F(Gltf, WhatIsRequiredAndNotUnderstoodIsRefusedByName) {
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                           "EXT_mesh_gpu_instancing", "XYZ_secret", "KHR_node_visibility"}) {
    GltfMaker maker;
    maker.with_triangle().root["extensionsUsed"] = {name};
    EXPECT_EQ(load_both(maker).triangles.size(), 1U) << name;
    maker.root["extensionsRequired"] = {name};
    EXPECT_NE(refusal(maker).find(name), std::string::npos);
  }
  for (const char* name : {"KHR_materials_unlit", "KHR_texture_transform", "KHR_lights_punctual",
                           "EXT_texture_webp", "KHR_mesh_quantization"}) {
    GltfMaker maker;
    maker.with_triangle().root["extensionsRequired"] = {name};
    EXPECT_EQ(load_both(maker).triangles.size(), 1U) << name;
  }
  GltfMaker maker;
  maker.primitive()["attributes"]["POSITION"] = maker.zeros("VEC3", 3);
  maker.primitive()["extensions"]["KHR_draco_mesh_compression"]["bufferView"] = 0;
  EXPECT_NE(refusal(maker).find("KHR_draco"), std::string::npos);
}

TEST_F(Gltf, VersionsAreNamed) {
  for (const json& asset : {json{{"version", "1.0"}}, json{{"version", 1.0}}}) {
    GltfMaker maker;
    maker.with_triangle().root["asset"] = asset;
    EXPECT_NE(refusal(maker).find("glTF 1.0"), std::string::npos) << asset;
  }
  GltfMaker maker;
  maker.with_triangle().root["asset"] = {{"version", "2.1"}, {"minVersion", "2.1"}};
  EXPECT_NE(refusal(maker).find("2.1"), std::string::npos);
  maker.root["asset"] = {{"version", "2.1"}, {"minVersion", "2.0"}};
  EXPECT_EQ(load_both(maker).triangles.size(), 1U);
  std::string glb = maker.glb();
  glb[4] = 1;
  std::string what;
  error_of(write("t.glb", glb), &what);
  EXPECT_NE(what.find("glTF 1.0"), std::string::npos);
}

TEST_F(Gltf, WhatIsNotUsedRefusesNothing) {
  GltfMaker maker;
  maker.with_triangle();
  maker.root["accessors"].push_back({{"componentType", 9}, {"count", 1e15}, {"type", "?"}});
  maker.root["bufferViews"].push_back({{"buffer", 77}});
  maker.root["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", 99}}}}}}});
  maker.primitive()["attributes"]["TEXCOORD_0"] = 1;
  maker.primitive()["attributes"]["_X"] = 99;
  maker.primitive()["targets"] = {{{"POSITION", 99}}};
  maker.root["animations"] = "no list";
  maker.root["skins"] = 3;
  EXPECT_EQ(load_both(maker).triangles.size(), 1U);
}

TEST_F(Gltf, InstancesAreBounded) {
  GltfMaker maker;
  maker.primitive()["attributes"]["POSITION"] = maker.vectors(std::vector<double>(9000, 1.0));
  for (int i = 0; i < 20000; ++i) maker.root["nodes"][static_cast<std::size_t>(i)]["mesh"] = 0;
  maker.root.erase("scenes");
  EXPECT_NE(refusal(maker).find("20000000 triangles"), std::string::npos);
}

TEST_F(Gltf, ErrorsAreLinesAPersonCanRead) {
  const std::string head = "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"data:;base64,";
  std::string what;
  EXPECT_EQ(error_of(write("t.gltf", head + std::string(3'000'000, 'A')), &what), 11);
  EXPECT_LT(what.size(), 300U);
  error_of(write("t.gltf",
                 "{\"asset\":{\"version\":\"2.0\"},\"extensionsRequired\":[\"a\\u001b[31m\\nb\"]}"),
           &what);
  for (const char c : what) EXPECT_TRUE(c >= ' ' && c <= '~') << what;
}

}  // namespace
}  // namespace halfspace
