// SPDX-License-Identifier: Apache-2.0
//
// The frame engine from vertices on, and on several threads: what GeometryStage and Rasterizer
// make of the same mesh.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "engines/common/threads.hpp"
#include "frame_meshes.hpp"

namespace halfspace {
namespace {

TEST(FrameScene, DrawsMeshesAsTheStagesDo) {
  for (const char* name : {"teapot.obj", "bunny.obj"}) {
    const FrameState frame{301, 207, Cull::kNone};
    for (const Config& config : {kFull, kMsaa4}) {
      SCOPED_TRACE(name);
      expect_same_frame(scene(name, frame, {}), frame, config, fast_isas());
    }
  }
}

TEST(FrameScene, DrawsAMeshThatTheCameraIsInside) {
  CameraOptions inside;
  inside.eye = glm::dvec3(0.3, 0.5, 0.2);
  inside.fov_y_degrees = 120;
  for (const Config& config : {kFull, kTiny}) {
    const FrameState frame{160, 120, Cull::kBack};
    expect_same_frame(scene("teapot.obj", frame, inside), frame, config, fast_isas());
  }
}

TEST(FrameScene, TreatsEveryVertexAsGeometryStageDoes) {
  for (const SnapMode snap : {SnapMode::kNearestEven, SnapMode::kHalfAway, SnapMode::kTruncate}) {
    for (Config config : {kFull, kTiny, kD3d}) {
      config.snap = snap;
      const FrameState frame{48, 40, Cull::kNone};
      const std::uint64_t seed = 77 + static_cast<std::uint64_t>(snap);
      SCOPED_TRACE("seed " + std::to_string(seed));
      expect_same_frame(hostile(seed, 500, 700), frame, config, coverage_isas());
    }
  }
}

TEST(FrameScene, ProjectsEveryVertexBeforeItsFirstTriangle) {
  expect_same_frame(strip(8, 6001), {48, 40, Cull::kNone}, kFull, fast_isas());
}

TEST(FrameScene, KeepsFewerThanThreeAttributes) {
  for (const int attributes : {0, 1, 2, 8}) {
    Config config = kFull;
    config.attributes = attributes;
    const FrameState frame{80, 60, Cull::kNone};
    expect_same_frame(scene("teapot.obj", frame, {}), frame, config, coverage_isas());
  }
}

// Every sample's depth and colour, the hits and the counts, as words.
std::vector<std::uint64_t> everything(const ShadedMesh& mesh, const FrameState& frame,
                                      const Config& config, int threads) {
  FrameOptions options;
  options.count_hits = true;
  options.threads = threads;
  options.run = run_on_threads;
  FrameEngine engine(frame, config, options);
  engine.draw(mesh.view(), mesh.matrix);
  engine.draw(mesh.clip(), std::span(mesh.triangles).first(mesh.triangles.size() / 3));
  std::vector<std::uint64_t> words;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      for (int m = 0; m < config.samples; ++m) {
        words.push_back(engine.framebuffer().depth_at(x, y, m));
        for (const std::uint8_t c : engine.framebuffer().color_at(x, y, m)) words.push_back(c);
      }
    }
  }
  for (const std::uint8_t hits : engine.hits()) words.push_back(hits);
  const RasterStats& s = engine.stats();
  const GeometryStats& g = engine.geometry();
  for (const std::uint64_t count :
       {s.triangles, s.triangles_zero_area, s.triangles_no_sample, s.tiles_covered,
        s.samples_covered, s.fragments, s.fragments_shaded, g.triangles_in, g.triangles_out,
        g.outside, g.clipped, g.dropped_not_finite}) {
    words.push_back(count);
  }
  return words;
}

// One thread draws what the stages draw: the tests above.
TEST(FrameScene, SameBytesForAnyNumberOfThreads) {
  const FrameState frame{333, 251, Cull::kNone};
  const ShadedMesh bunny = scene("bunny.obj", frame, {});
  const ShadedMesh rough = strip(5, 30001);
  for (const Config& config : {kFull, kMsaa4, kTiny}) {
    const FrameState small{40, 30, Cull::kNone};
    const auto one = everything(bunny, frame, config, 1);
    const auto one_rough = everything(rough, small, config, 1);
    for (const int threads : {2, 3, 4, 9}) {
      EXPECT_TRUE(one == everything(bunny, frame, config, threads)) << threads;
      EXPECT_TRUE(one_rough == everything(rough, small, config, threads)) << threads;
    }
  }
}

// Several rounds of pieces, of which later ones need fewer vertices than earlier ones.
TEST(FrameScene, RoundsMayGoBackToTheFirstVertices) {
  ShadedMesh mesh = strip(6, 35001);
  const std::vector<TriangleIndices> forth = mesh.triangles;
  mesh.triangles.insert(mesh.triangles.end(), forth.rbegin(), forth.rend());
  const FrameState frame{40, 30, Cull::kNone};
  EXPECT_TRUE(everything(mesh, frame, kFull, 1) == everything(mesh, frame, kFull, 2));
}

TEST(FrameScene, ClearLeavesNothingOfTheLastFrame) {
  const FrameState frame{120, 90, Cull::kNone};
  const ShadedMesh teapot = scene("teapot.obj", frame, {});
  const ShadedMesh bunny = scene("bunny.obj", frame, {});
  FrameEngine once(frame, kFull);
  once.draw(bunny.view(), bunny.matrix);
  FrameEngine again(frame, kFull);
  again.draw(teapot.view(), teapot.matrix);
  again.clear();
  again.draw(bunny.view(), bunny.matrix);
  EXPECT_EQ(once.framebuffer().resolve().pixel, again.framebuffer().resolve().pixel);
  EXPECT_EQ(once.framebuffer().depth(), again.framebuffer().depth());
  EXPECT_EQ(once.framebuffer().tiles_touched(), again.framebuffer().tiles_touched());
  expect_equal(once.stats(), again.stats());
  EXPECT_EQ(once.geometry(), again.geometry());
}

// More than a piece keeps or draws at a time.
TEST(FrameScene, ManyLargeTrianglesInAnyOrderOfSteps) {
  const FrameState frame{400, 300, Cull::kNone};
  const ShadedMesh mesh = hostile(9, 700, 1300);
  for (const Config& config : {kFull, kMsaa4}) {
    if (config.samples > 1) expect_same_frame(mesh, frame, config, coverage_isas());
    const auto one = everything(mesh, frame, config, 1);
    for (const int threads : {2, 3}) {
      EXPECT_TRUE(one == everything(mesh, frame, config, threads)) << threads;
    }
  }
}

TEST(FrameScene, ClearForgetsADrawThatThrew) {
  const FrameState frame{40, 30, Cull::kNone};
  const ShadedMesh mesh = strip(4, 40000);
  const std::span<const TriangleIndices> one = std::span(mesh.triangles).first(1);
  FrameEngine fresh(frame, kFull);
  fresh.draw(MeshView{mesh.positions, mesh.colors, one}, mesh.matrix);
  for (const int threads : {1, 2}) {
    SCOPED_TRACE(std::to_string(threads) + " threads");
    int calls = 0;
    FrameOptions options;
    options.threads = threads;
    options.run = run_on_threads;
    options.on_triangles = [&calls](std::span<const Triangle>) {
      if (++calls == 3) throw std::runtime_error("enough");
    };
    FrameEngine engine(frame, kFull, options);
    EXPECT_THROW(engine.draw(mesh.view(), mesh.matrix), std::runtime_error);
    engine.clear();
    expect_equal(RasterStats{}, engine.stats());
    EXPECT_EQ(GeometryStats{}, engine.geometry());
    engine.draw(MeshView{mesh.positions, mesh.colors, one}, mesh.matrix);
    expect_equal(fresh.stats(), engine.stats());
    EXPECT_EQ(fresh.geometry(), engine.geometry());
    EXPECT_EQ(fresh.framebuffer().resolve().pixel, engine.framebuffer().resolve().pixel);
  }
}

TEST(FrameScene, MeshTrianglesHaveNoTagOfAnEarlierDraw) {
  const ShadedMesh mesh = scene("teapot.obj", {40, 30, Cull::kNone}, {});
  std::size_t told = 0;
  std::uint32_t tags = 0;
  FrameOptions options;
  options.on_triangles = [&](std::span<const Triangle> triangles) {
    told += triangles.size();
    for (const Triangle& triangle : triangles) tags |= triangle.tag;
  };
  FrameEngine engine({40, 30, Cull::kNone}, kFull, options);
  ShadedTriangle packed;
  packed.triangle = {{{{0, 0}, {900, 0}, {0, 900}}}, 77};
  for (VertexAttributes& vertex : packed.attributes) vertex.inverse_w = 1;
  engine.draw(std::vector<ShadedTriangle>(100, packed));
  EXPECT_EQ(77u, tags);
  tags = 0;
  engine.draw(mesh.view(), mesh.matrix);
  EXPECT_GT(told, 200u);
  EXPECT_EQ(0u, tags);
}

TEST(FrameScene, DrawsAddUp) {
  const FrameState frame{150, 110, Cull::kNone};
  const ShadedMesh mesh = scene("bunny.obj", frame, {});
  FrameEngine whole(frame, kFull);
  whole.draw(mesh.view(), mesh.matrix);
  FrameEngine parts(frame, kFull);
  const std::span<const TriangleIndices> triangles = mesh.triangles;
  for (std::size_t first = 0; first < triangles.size(); first += 700) {
    const auto some =
        triangles.subspan(first, std::min<std::size_t>(700, triangles.size() - first));
    parts.draw(MeshView{mesh.positions, mesh.colors, some}, mesh.matrix);
  }
  EXPECT_EQ(whole.framebuffer().resolve().pixel, parts.framebuffer().resolve().pixel);
  EXPECT_EQ(whole.framebuffer().depth(), parts.framebuffer().depth());
  expect_equal(whole.stats(), parts.stats());
  EXPECT_EQ(whole.geometry(), parts.geometry());
}

// More tiles than a piece sorts, between draws that it does sort.
TEST(FrameScene, LargeTrianglesAndSmallOnesMix) {
  const FrameState frame{801, 603, Cull::kNone};
  ShadedMesh mesh = scene("teapot.obj", frame, {});
  const std::vector<TriangleIndices> small = mesh.triangles;
  for (auto& position : mesh.positions) {  // to clip space, where a frame is easily filled
    const glm::dvec4 p = mesh.matrix * glm::dvec4(glm::dvec3(position), 1.0);
    position = glm::vec3(p / p.w);
  }
  mesh.matrix = glm::dmat4(1.0);
  const auto corner = [&](float x, float y, float z, glm::vec3 color) {
    mesh.positions.push_back({x, y, z});
    mesh.colors.push_back(color);
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  for (int i = 0; i < 12; ++i) {
    const float z = 0.9f - 0.01f * static_cast<float>(i * 5 % 12);
    mesh.triangles.push_back({corner(-1, -3, z, {20 * i, 90, 0}), corner(-1, 1, z, {0, 20 * i, 9}),
                              corner(3, 1, z, {255, 30, 20 * i})});
  }
  mesh.triangles.insert(mesh.triangles.end(), small.begin(), small.end());
  expect_same_frame(mesh, frame, kFull, coverage_isas());
  const auto one = everything(mesh, frame, kFull, 1);
  EXPECT_TRUE(one == everything(mesh, frame, kFull, 2));
}

}  // namespace
}  // namespace halfspace
