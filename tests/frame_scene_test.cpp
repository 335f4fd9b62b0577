// SPDX-License-Identifier: Apache-2.0
//
// The frame engine from vertices on, and on several threads: what GeometryStage and Rasterizer
// make of the same mesh.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "batch/coverage_engine.hpp"
#include "batch/frame_engine.hpp"
#include "batch/threads.hpp"
#include "camera.hpp"
#include "frame_compare.hpp"
#include "generators.hpp"
#include "io/mesh.hpp"

namespace halfspace {
namespace {

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

ShadedMesh scene(const std::string& name, const FrameState& frame, const CameraOptions& camera) {
  const Mesh mesh = load_mesh(std::string(HALFSPACE_TEST_DIR) + "/scenes/" + name);
  ShadedMesh out;
  out.positions = mesh.positions;
  out.triangles = mesh.triangles;
  for (const glm::vec3& normal : mesh.normals) out.colors.push_back(127.5f * (normal + 1.0f));
  const double aspect = static_cast<double>(frame.width) / frame.height;
  out.matrix = world_to_clip(frame_camera(mesh.bounds, aspect, camera), aspect);
  return out;
}

// Positions and colours as GeometryStage must expect them: far out, behind the eye, on planes, not
// finite; colours below 0 and above 255.
ShadedMesh hostile(std::uint64_t seed, int vertices, int triangles) {
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
ShadedMesh strip(std::uint64_t seed, int triangles) {
  ShadedMesh out = hostile(seed, triangles + 2, 0);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(triangles); ++i) {
    out.triangles.push_back({i, i + 1, i + 2});
  }
  return out;
}

// Draws the mesh through the stages and through the engine, every way it takes.
void expect_same_frame(const ShadedMesh& mesh, const FrameState& frame, const Config& config,
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
std::vector<std::string_view> fast_isas() {
  std::vector<std::string_view> out = coverage_isas();
  std::erase(out, "emu128");
  return out;
}

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

TEST(FrameScene, PicturesInBothFormatsAgree) {
  for (const Config& config : {kFull, kMsaa4, kTiny}) {
    const FrameState frame{117, 61, Cull::kNone};
    const ShadedMesh mesh = scene("teapot.obj", frame, {});
    FrameEngine engine(frame, config);
    engine.draw(mesh.view(), mesh.matrix);
    std::vector<std::uint32_t> rgba(117 * 61);
    engine.framebuffer().resolve_rgba(rgba);
    const Image image = engine.framebuffer().resolve();
    for (std::size_t i = 0; i < rgba.size(); ++i) {
      const Rgb p = image.pixel[i];
      ASSERT_EQ(rgba[i], 0xff000000u | unsigned{p[2]} << 16 | unsigned{p[1]} << 8 | p[0]);
    }
  }
}

}  // namespace
}  // namespace halfspace
