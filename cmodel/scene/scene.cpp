// SPDX-License-Identifier: Apache-2.0
#include "scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <utility>

#include "../io/error.hpp"
#include "../io/fit_range.hpp"
#include "../io/tcov.hpp"
#include "../meshes/mesh.hpp"
#include "../meshes/simplify.hpp"
#include "progress.hpp"
#include "vertex_cache.hpp"

namespace halfspace {
namespace {

using WallClock = std::chrono::steady_clock;

double seconds_since(WallClock::time_point start) {
  return std::chrono::duration<double>(WallClock::now() - start).count();
}

// Progress bars, one after the other, of what a mesh's reader does.
MeshProgress loading_progress() {
  struct Bar {
    std::string what;
    std::unique_ptr<Progress> progress;
    std::uint64_t done = 0;
  };
  return
      [bar = std::make_shared<Bar>()](const char* what, std::uint64_t done, std::uint64_t total) {
        if (!bar->progress || bar->what != what || done < bar->done) {
          bar->progress = nullptr;  // erased before the next is drawn
          bar->progress = std::make_unique<Progress>(what, total);
          bar->what = what;
          bar->done = 0;
        }
        bar->progress->advance(done - bar->done);
        bar->done = done;
      };
}

// As the mesh's origin has it.
CameraOptions moved(CameraOptions camera, const glm::dvec3& origin) {
  if (camera.eye) *camera.eye -= origin;
  if (camera.target) *camera.target -= origin;
  return camera;
}

class MeshScene : public Scene {
 public:
  MeshScene(const std::string& path, int width, int height, const CameraOptions& camera,
            Lighting lighting, int views, double simplify_px)
      : path_(path),
        mesh_(load_mesh(path, loading_progress())),
        frame_{width, height, Cull::kNone},
        lighting_(lighting) {
    const double aspect = static_cast<double>(width) / static_cast<double>(height);
    const std::vector<Camera> cameras =
        orbit_cameras(mesh_.positions, aspect, moved(camera, mesh_.origin), views);
    for (const Camera& view : cameras) shader_.emplace_back(mesh_, view, aspect);
    if (simplify_px > 0) simplify(mesh_, simplify_px * pixel_size(cameras.front(), height));
  }

  std::size_t frames() const override { return shader_.size(); }
  std::uint64_t triangles(std::size_t) const override { return mesh_.triangles.size(); }
  int case_id(std::size_t) const override { return -1; }

  FrameState frame(std::size_t, const Config& config) const override {
    require_size(frame_.width, frame_.height, config, "--size");
    return frame_;
  }

  using Scene::draw;
  void draw(std::size_t frame_index, const FrameState& frame, const Config& config, RunStats& stats,
            const TriangleSink& sink) const override {
    const WallClock::time_point start = WallClock::now();
    VertexCache vertices(shader_[frame_index]);
    GeometryStage stage(frame, config);
    std::vector<ShadedTriangle> out;
    Progress progress("drawing triangles", mesh_.triangles.size());
    std::uint32_t tag = 0;
    for (const auto& index : mesh_.triangles) {
      const std::array<ClipVertex, 3> triangle = corners(index, frame_index, vertices);
      out.clear();
      stage.process(triangle, tag, out);
      if (config.extent_bits != 0 && stage.stats().beyond_sides != 0) {
        refuse_cut(tag, config, path_);
      }
      for (const ShadedTriangle& piece : out) {
        require_extent(piece.triangle, tag, config, path_);
        sink(piece);
      }
      ++tag;
      progress.advance();
    }
    stats.geometry += stage.stats();
    stats.simulate_seconds += seconds_since(start);
  }

  using Scene::real;
  void real(std::size_t index, int guard_bits, const RealSink& sink) const override {
    VertexCache vertices(shader_[index]);
    std::uint64_t number = 0;
    for (const auto& triangle : mesh_.triangles) {
      real_triangles(corners(triangle, index, vertices), number++, frame_, guard_bits, sink);
    }
  }

  void draw(std::size_t index, const FrameState& frame, const Config& config, RunStats& stats,
            FrameEngine& engine) const override {
    // A flat triangle shares no vertex, and a fitted range is checked triangle by triangle.
    if (lighting_ == Lighting::kFlat || config.extent_bits != 0) {
      return Scene::draw(index, frame, config, stats, engine);
    }
    const WallClock::time_point start = WallClock::now();
    MeshPart part(shader_[index]);
    for (const auto& triangle : mesh_.triangles) {
      part.add(triangle);
      if (part.triangles().size() < kPartTriangles) continue;
      engine.draw(part.vertices(), part.triangles());
      part.clear();
    }
    engine.draw(part.vertices(), part.triangles());
    stats.geometry += engine.geometry();
    stats.simulate_seconds += seconds_since(start);
  }

  LeftOut left_out() const override { return mesh_.left_out; }
  const Camera* camera(std::size_t index) const override { return &shader_[index].camera(); }

  void faces(std::size_t index, const FaceSink& sink) const override {
    VertexCache vertices(shader_[index]);
    for (const auto& triangle : mesh_.triangles) {
      MeshFace face{corners(triangle, index, vertices), {}};
      for (std::size_t i = 0; i < 3; ++i) face.world[i] = glm::dvec3(mesh_.positions[triangle[i]]);
      sink(face);
    }
  }

 private:
  std::array<ClipVertex, 3> corners(const std::array<std::uint32_t, 3>& index,
                                    std::size_t frame_index, VertexCache& vertices) const {
    std::array<ClipVertex, 3> triangle{vertices.vertex(index[0]), vertices.vertex(index[1]),
                                       vertices.vertex(index[2])};
    if (lighting_ == Lighting::kFlat) {
      const auto color = shader_[frame_index].flat_color(index);
      for (ClipVertex& vertex : triangle) vertex.attribute = color;
    }
    return triangle;
  }

  std::string path_;
  Mesh mesh_;
  FrameState frame_;
  Lighting lighting_;
  std::vector<VertexShader> shader_;  // one for each frame
};

// A colour per triangle, spread around the hue circle by the golden angle.
std::array<std::int32_t, kMaxAttributes> triangle_color(std::size_t index) {
  std::array<std::int32_t, kMaxAttributes> out{};
  const double hue = std::fmod(static_cast<double>(index) * 0.618033988749895, 1.0);
  for (int c = 0; c < 3; ++c) {
    const double phase = std::fmod(hue + static_cast<double>(c) / 3.0, 1.0);
    const double level = 150.0 + 90.0 * std::cos(2.0 * 3.14159265358979 * phase);
    out[static_cast<std::size_t>(c)] =
        static_cast<std::int32_t>(std::lround(level * (1 << kAttributeFractionBits)));
  }
  return out;
}

class TcovScene : public Scene {
 public:
  TcovScene(std::string path, int case_id)
      : path_(std::move(path)),
        cases_(read_tcov(path_, {.max_size = kTcovMaxSize, .hits = false})) {
    if (case_id < 0) return;
    std::erase_if(cases_, [case_id](const TcovCase& tcov) { return tcov.id != case_id; });
    if (cases_.empty()) {
      throw Error(ErrorCode::kScene, path_, fmt::format("has no case {}", case_id));
    }
  }

  std::size_t frames() const override { return cases_.size(); }
  std::uint64_t triangles(std::size_t index) const override {
    return cases_[index].triangles.size();
  }
  int case_id(std::size_t index) const override { return cases_[index].id; }
  FrameState frame(std::size_t index, const Config& config) const override {
    const TcovCase& tcov = cases_[index];
    require_size(tcov.width, tcov.height, config, fmt::format("{}:{}", path_, tcov.line));
    return {tcov.width, tcov.height, Cull::kNone};
  }

  using Scene::draw;
  void draw(std::size_t index, const FrameState&, const Config& config, RunStats& stats,
            const TriangleSink& sink) const override {
    const TcovTriangles input = tcov_triangles(cases_[index], config, path_);
    stats.resnapped += input.resnapped;
    stats.geometry.triangles_in += input.triangles.size();
    stats.geometry.triangles_out += input.triangles.size();
    const WallClock::time_point start = WallClock::now();
    for (std::size_t i = 0; i < input.triangles.size(); ++i) {
      VertexAttributes vertex;
      vertex.depth = 1 << (kPlaneBits - 1);
      vertex.inverse_w = 1u << (config.inverse_w_bits - 1);
      vertex.value = triangle_color(i);
      sink({input.triangles[i], {vertex, vertex, vertex}});
    }
    stats.simulate_seconds += seconds_since(start);
  }

  using Scene::real;
  void real(std::size_t index, int, const RealSink& sink) const override {
    std::uint64_t number = 0;
    for (const auto& source : cases_[index].triangles) {
      RealTriangle triangle;
      const auto color = triangle_color(number);
      triangle.index = number++;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          triangle.vertex[i].attribute[c] = std::ldexp(color[c], -kAttributeFractionBits);
        }
        triangle.vertex[i].x = std::ldexp(static_cast<double>(source[2 * i]), -kTcovFractionBits);
        triangle.vertex[i].y =
            std::ldexp(static_cast<double>(source[2 * i + 1]), -kTcovFractionBits);
      }
      sink(triangle);
    }
  }

 private:
  std::string path_;
  std::vector<TcovCase> cases_;
};

}  // namespace

void Scene::draw(std::size_t index, const FrameState& frame, const Config& config, RunStats& stats,
                 FrameEngine& engine) const {
  constexpr std::size_t kAtOnce = 8192;
  std::vector<ShadedTriangle> waiting;
  draw(index, frame, config, stats, [&](const ShadedTriangle& triangle) {
    waiting.push_back(triangle);
    if (waiting.size() < kAtOnce) return;
    engine.draw(waiting);
    waiting.clear();
  });
  const WallClock::time_point start = WallClock::now();
  engine.draw(waiting);
  stats.simulate_seconds += seconds_since(start);
}

std::unique_ptr<Scene> make_mesh_scene(const std::string& path, int width, int height,
                                       const CameraOptions& camera, Lighting lighting, int views,
                                       double simplify_px) {
  return std::make_unique<MeshScene>(path, width, height, camera, lighting, views, simplify_px);
}

std::unique_ptr<Scene> make_tcov_scene(const std::string& path, int case_id) {
  return std::make_unique<TcovScene>(path, case_id);
}

bool is_tcov(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".tcov";
}

std::unique_ptr<Scene> open_scene(const std::string& path, int case_id, const FrameSize& size,
                                  const CameraOptions& camera, Lighting lighting, int views,
                                  double simplify_px) {
  if (is_tcov(path)) return make_tcov_scene(path, case_id);
  if (case_id >= 0) {
    throw Error(ErrorCode::kUsage, "--case", fmt::format("{} is no TCOV file: no cases", path));
  }
  return make_mesh_scene(path, size.width, size.height, camera, lighting, views, simplify_px);
}

}  // namespace halfspace
