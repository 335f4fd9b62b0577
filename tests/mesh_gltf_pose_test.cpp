// SPDX-License-Identifier: Apache-2.0
//
// glTF 2.0: what nodes, morph targets and skins make of a mesh.
#include "gltf_fixture.hpp"

namespace halfspace {
namespace {

using nlohmann::json;

// What a negative determinant turns around is turned back, however it comes about.
TEST_F(Gltf, MirroredNodesKeepTheirOutside) {
  const std::vector<json> scales{{-1, 1, 1},  {1, -1, 1},   {1, 1, -1},
                                 {-1, -1, 1}, {-1, -2, -3}, {2, 1, 1}};
  for (const json& scale : scales) {
    for (const json& parent : scales) {
      GltfMaker maker;
      maker.primitive()["attributes"]["POSITION"] =
          maker.vectors({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
      maker.primitive()["indices"] =
          maker.accessor(5121, "SCALAR", 1, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
      maker.root["nodes"] = {{{"scale", parent}, {"children", {1}}},
                             {{"mesh", 0}, {"scale", scale}, {"translation", {1, 2, 3}}}};
      EXPECT_GT(volume(load_both(maker)), 0.0) << scale << parent;
      json matrix = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 5, 6, 1};
      for (std::size_t i = 0; i < 3; ++i) matrix[5 * i] = scale[i];
      maker.root["nodes"][1] = {{"mesh", 0}, {"matrix", matrix}};
      EXPECT_GT(volume(load_both(maker)), 0.0) << "matrix" << scale << parent;
    }
  }
}

TEST_F(Gltf, NormalsFollowStretchedAndMirroredNodes) {
  GltfMaker maker;
  maker.with_triangle();
  const double r = std::sqrt(0.5);
  maker.primitive()["attributes"]["NORMAL"] = maker.vectors({r, 0, r, r, 0, r, r, 0, r});
  maker.root["nodes"][0]["scale"] = {-2, 1, 1};
  const Mesh mesh = load_both(maker);
  EXPECT_LT(glm::length(normal(mesh, 0, 0) - glm::normalize(glm::vec3(-0.5, 0, 1))), 1e-5);
  EXPECT_GT(facing(mesh), 0.0);
}

TEST_F(Gltf, MorphTargetsByTheWeightsOfNodeOrMesh) {
  struct Case {
    json node, mesh;
    double x;
  };
  for (const Case& c : {Case{nullptr, nullptr, 1},
                        {nullptr, {1.0, 0.0}, 3},
                        {nullptr, {0.5, 1.0}, 12},
                        {{0.0, 1.0}, {1.0, 0.0}, 11},
                        {{0.5}, nullptr, 2},
                        {{0, 0}, {1, 1}, 1}}) {
    GltfMaker maker;
    maker.with_triangle();
    const int first = maker.vectors({0, 0, 0, 2, 0, 0, 0, 0, 0});
    const int second = maker.zeros("VEC3", 3);
    const int at = maker.view(5121, {1}, 1), values = maker.view(5126, {10, 0, 0}, 3);
    maker.last_accessor()["sparse"] = {{"count", 1},
                                       {"indices", {{"bufferView", at}, {"componentType", 5121}}},
                                       {"values", {{"bufferView", values}}}};
    maker.primitive()["targets"] = {{{"POSITION", first}}, {{"POSITION", second}}};
    if (!c.node.is_null()) maker.root["nodes"][0]["weights"] = c.node;
    if (!c.mesh.is_null()) maker.root["meshes"][0]["weights"] = c.mesh;
    EXPECT_EQ(corner(load_both(maker), 0, 1), glm::dvec3(c.x, 0, 0)) << c.node << c.mesh;
  }
}

// The joints place a skinned mesh, its node does not.
TEST_F(Gltf, SkinsAreInTheirPose) {
  for (const int joint_type : {5121, 5123}) {
    for (const int weight_type : {5121, 5123, 5126}) {
      for (const bool has_inverse : {false, true}) {
        GltfMaker maker;
        maker.with_triangle();
        const double unit = weight_type == 5121 ? 255 : weight_type == 5123 ? 65535 : 1;
        json& attributes = maker.primitive()["attributes"];
        attributes["JOINTS_0"] =
            maker.accessor(joint_type, "VEC4", 4, {0, 0, 0, 0, 1, 0, 0, 0, 1, 7, 9, 0});
        attributes["WEIGHTS_0"] = maker.accessor(
            weight_type, "VEC4", 4, {unit, 0, 0, 0, unit, 0, 0, 0, unit, 0, 0, 0}, 0, true);
        maker.root["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"scale", {100, 100, 100}}},
                               {{"children", {2}}, {"translation", {0, 0, 1}}},
                               {{"translation", {5, 0, 0}}}};
        maker.root["scenes"][0]["nodes"] = {0, 1};
        maker.root["skins"] = {{{"joints", {1, 2}}}};
        if (has_inverse) {
          std::vector<double> matrices(32, 0.0);
          for (std::size_t i = 0; i < 32; i += 16) {
            for (std::size_t k = 0; k < 4; ++k) matrices[i + 5 * k] = 1;
            matrices[i + 13] = -3;  // three down
          }
          maker.root["skins"][0]["inverseBindMatrices"] =
              maker.accessor(5126, "MAT4", 16, matrices);
        }
        const Mesh mesh = load_both(maker);
        const double y = has_inverse ? -3 : 0;
        EXPECT_EQ(corner(mesh, 0, 0), glm::dvec3(0, y, 1)) << joint_type << weight_type;
        EXPECT_EQ(corner(mesh, 0, 1), glm::dvec3(6, y, 1)) << joint_type << weight_type;
        EXPECT_EQ(corner(mesh, 0, 2), glm::dvec3(5, y + 1, 1)) << joint_type << weight_type;
      }
    }
  }
}

}  // namespace
}  // namespace halfspace
