// SPDX-License-Identifier: Apache-2.0
//
// Meshes for the frame engine, and what GeometryStage and Rasterizer make of them.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "camera.hpp"
#include "engines/coverage/coverage_engine.hpp"
#include "engines/frame/frame_engine.hpp"
#include "frame_compare.hpp"
#include "meshes/mesh.hpp"
#include "vectors/generators.hpp"

namespace halfspace {

struct ShadedMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> colors;
  std::vector<TriangleIndices> triangles;
  glm::dmat4 matrix{1.0};
  MeshView view() const { return {positions, colors, triangles}; }
  std::vector<ClipVertex> clip() const {
    std::vector<ClipVertex> out(positions.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].position = matrix * glm::dvec4(glm::dvec3(positions[i]), 1.0);
      for (int c = 0; c < 3; ++c) {
        out[i].attribute[static_cast<std::size_t>(c)] = static_cast<double>(colors[i][c]);
      }
    }
    return out;
  }
};

inline ShadedMesh scene(const std::string& name, const FrameState& frame,
                        const CameraOptions& camera) {
  const Mesh mesh = load_mesh(std::string(HALFSPACE_TEST_DIR) + "/scenes/" + name);
  ShadedMesh out;
  out.positions = mesh.positions;
  out.triangles = mesh.triangles;
  for (const glm::vec3& normal : mesh.normals) out.colors.push_back(127.5f * (normal + 1.0f));
  const double aspect = static_cast<double>(frame.width) / frame.height;
  out.matrix = world_to_clip(frame_camera(mesh.positions, aspect, camera), aspect);
  return out;
}

// Positions and colours as GeometryStage must expect them: far out, behind the eye, on planes, not
// finite; colours below 0 and above 255.
inline ShadedMesh hostile(std::uint64_t seed, int vertices, int triangles) {
  Random random(seed);
  ShadedMesh out;
  const std::vector<float> special{0.0f,
                                   -0.0f,
                                   1.0f,
                                   -1.0f,
                                   0.5f,
                                   1e-30f,
                                   1e30f,
                                   -1e30f,
                                   3.5e37f,
                                   -1e-42f,
                                   std::numeric_limits<float>::infinity(),
                                   std::numeric_limits<float>::quiet_NaN()};
  const auto number = [&](double reach) {
    if (random.in(0, 99) < 2) {
      return special[static_cast<std::size_t>(
          random.in(0, static_cast<std::int64_t>(special.size()) - 1))];
    }
    return static_cast<float>(reach * static_cast<double>(random.in(-1000000, 1000000)) / 1e6);
  };
  for (int i = 0; i < vertices; ++i) {
    const double reach = i % 7 == 0 ? 40.0 : i % 5 == 0 ? 4.0 : 1.2;
    out.positions.push_back({number(reach), number(reach), number(reach)});
    out.colors.push_back(128.0f + glm::vec3(number(170), number(170), number(170)));
  }
  const auto index = [&] { return static_cast<std::uint32_t>(random.in(0, vertices - 1)); };
  for (int i = 0; i < triangles; ++i) out.triangles.push_back({index(), index(), index()});
  return out;
}

// A strip of such vertices in their order: each piece and each round needs new ones.
inline ShadedMesh strip(std::uint64_t seed, int triangles) {
  ShadedMesh out = hostile(seed, triangles + 2, 0);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(triangles); ++i) {
    out.triangles.push_back({i, i + 1, i + 2});
  }
  return out;
}

// Draws the mesh through the stages and through the engine, every way it takes.
inline void expect_same_frame(const ShadedMesh& mesh, const FrameState& frame, const Config& config,
                              std::span<const std::string_view> isas) {
  GeometryStage stage(frame, config);
  Rasterizer plain(frame, config, DepthFunction::kLess, {1, 2, 3});
  const std::vector<ClipVertex> clip = mesh.clip();
  std::vector<ShadedTriangle> pieces;
  for (const TriangleIndices& t : mesh.triangles) {
    pieces.clear();
    stage.process({clip[t[0]], clip[t[1]], clip[t[2]]}, 0, pieces);
    for (const ShadedTriangle& piece : pieces) plain.draw(piece);
  }
  ASSERT_GT(plain.stats().fragments_shaded, 0u);
  const std::size_t touched = plain.framebuffer().tiles_touched();
  for (const std::string_view isa : isas) {
    SCOPED_TRACE(isa);
    FrameOptions options;
    options.background = {1, 2, 3};
    options.isa = isa;
    options.count_hits = true;
    FrameEngine fast(frame, config, options);
    for (int way = 0; way < 2; ++way) {
      fast.clear();
      way == 0 ? fast.draw(mesh.view(), mesh.matrix) : fast.draw(clip, mesh.triangles);
      EXPECT_EQ(stage.stats(), fast.geometry());
      expect_equal(plain.stats(), fast.stats());
      EXPECT_EQ(plain.hit_count().count(), fast.hits());
      EXPECT_EQ(touched, fast.framebuffer().tiles_touched());
      expect_equal(plain.framebuffer(), fast.framebuffer(), frame, config);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

// Without the slow portable one, which the small cases run.
inline std::vector<std::string_view> fast_isas() {
  std::vector<std::string_view> out = coverage_isas();
  std::erase(out, "emu128");
  return out;
}

}  // namespace halfspace
