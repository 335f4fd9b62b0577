// SPDX-License-Identifier: Apache-2.0
#include "workload.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>

#include "bumpy_torus.hpp"
#include "scene/vertex_shader.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

constexpr FrameState kSquare{1024, 1024, Cull::kNone};
constexpr FrameState kScreen{1920, 1080, Cull::kNone};

double uniform(Random& random, double low, double high) {
  return low + (high - low) * std::ldexp(static_cast<double>(random.next() >> 11), -53);
}

// Vertices anywhere in a square of `side` px, itself anywhere in the frame.
Triangle in_square(Random& random, double side) {
  const double x = uniform(random, 0, kSquare.width - side);
  const double y = uniform(random, 0, kSquare.height - side);
  Triangle t;
  for (Point& p : t.vertex) {
    const double px = uniform(random, x, x + side);
    p = snap_px(px, uniform(random, y, y + side), kBenchConfig);
  }
  return t;
}

// Nearly equilateral, radius about 430 px, turned at random, whole in the frame.
Triangle large(Random& random) {
  const double turn = uniform(random, 0, 2 * std::numbers::pi);
  const double radius = uniform(random, 415, 445);
  const double x = uniform(random, 462, 562);
  const double y = uniform(random, 462, 562);
  Triangle t;
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = turn + 2 * std::numbers::pi / 3 * static_cast<double>(i);
    t.vertex[i] = snap_px(x + radius * std::cos(angle), y + radius * std::sin(angle), kBenchConfig);
  }
  return t;
}

Triangle full_screen(Random& random) {
  Triangle t;
  const double out = -uniform(random, 0, 1);
  t.vertex = {snap_px(out, out, kBenchConfig),
              snap_px(2100 + uniform(random, 0, 1), out, kBenchConfig),
              snap_px(out, 2100 + uniform(random, 0, 1), kBenchConfig)};
  return t;
}

// 330 px long and 1.6 px wide at the middle, in any direction.
Triangle sliver(Random& random) {
  const double turn = uniform(random, 0, 2 * std::numbers::pi);
  const double x = uniform(random, 332, 692);
  const double y = uniform(random, 332, 692);
  const double dx = std::cos(turn);
  const double dy = std::sin(turn);
  Triangle t;
  t.vertex = {snap_px(x, y, kBenchConfig), snap_px(x + 330 * dx, y + 330 * dy, kBenchConfig),
              snap_px(x + 165 * dx - 1.6 * dy, y + 165 * dy + 1.6 * dx, kBenchConfig)};
  return t;
}

// Vertices anywhere in a square of `side` px; for side 8 the square is a tile.
Triangle on_screen(Random& random, int side) {
  const int s = kBenchConfig.subpixel_bits;
  const std::int64_t step = side == 8 ? 8 << s : 1;
  const std::int64_t x = random.in(0, ((1900 - side) << s) / step) * step;
  const std::int64_t y = random.in(0, ((1060 - side) << s) / step) * step;
  Triangle t;
  for (Point& v : t.vertex) {
    v.x = static_cast<std::int32_t>(x + random.in(0, (side << s) - 1));
    v.y = static_cast<std::int32_t>(y + random.in(0, (side << s) - 1));
  }
  return t;
}

// The frame's two halves, in turn.
Triangle half_screen(Random& random) {
  const auto at = [](int x, int y) { return snap_px(x, y, kBenchConfig); };
  const bool upper = (random.next() & 1) != 0;
  return {{at(0, 0), upper ? at(1920, 0) : at(1920, 1080), upper ? at(1920, 1080) : at(0, 1080)},
          0};
}

struct Kind {
  FrameState frame;
  double count;
  std::function<Triangle(Random&)> make;
};

const Kind& kind_of(std::string_view name) {
  // The mean area of a triangle in a unit square is 11/144.
  static const std::map<std::string_view, Kind> kinds{
      {"small", {kSquare, 1e6, [](Random& r) { return in_square(r, std::sqrt(10 * 144.0 / 11)); }}},
      {"medium",
       {kSquare, 1e5, [](Random& r) { return in_square(r, std::sqrt(200 * 144.0 / 11)); }}},
      {"large", {kSquare, 500, large}},
      {"fullscreen", {kSquare, 200, full_screen}},
      {"sliver", {kSquare, 10000, sliver}},
      {"quad", {kScreen, 40, half_screen}},
      {"px32", {kScreen, 40000, [](Random& r) { return on_screen(r, 32); }}},
      {"px16", {kScreen, 40000, [](Random& r) { return on_screen(r, 16); }}},
      {"tile", {kScreen, 40000, [](Random& r) { return on_screen(r, 8); }}}};
  const auto kind = kinds.find(name);
  if (kind == kinds.end()) throw std::runtime_error("no such workload: " + std::string(name));
  return kind->second;
}

Mesh scene_mesh(std::string_view name, const std::string& folder, double scale) {
  if (name == "million") return bumpy_torus(std::max(1.0, kMillion * scale));
  return load_mesh(folder + "/" + std::string(name) + ".obj");
}

}  // namespace

ClipVertex FrameMesh::vertex(std::uint32_t index) const {
  ClipVertex out;
  out.position = matrix * glm::dvec4(glm::dvec3(positions[index]), 1.0);
  for (int c = 0; c < 3; ++c) out.attribute[static_cast<std::size_t>(c)] = colors[index][c];
  return out;
}

Workload make_workload(std::string_view name, double scale) {
  const Kind& kind = kind_of(name);
  Workload work{std::string(name), kind.frame, {}, {}};
  Random random(0x5eed);
  const auto count = static_cast<std::size_t>(std::max(1.0, kind.count * scale));
  work.triangles.reserve(count);
  while (work.triangles.size() < count) work.triangles.push_back(kind.make(random));
  return work;
}

std::vector<Triangle> bench_triangles(std::string_view name, double scale) {
  return make_workload(name, scale).triangles;
}

Workload make_scene_workload(std::string_view name, int width, int height,
                             const std::string& folder, double scale) {
  Workload work{std::string(name), {width, height, Cull::kNone}, {}, FrameMesh{}};
  Mesh mesh = scene_mesh(name, folder, scale);
  const double aspect = static_cast<double>(width) / height;
  const VertexShader shader(mesh, frame_camera(mesh.positions, aspect), aspect);
  FrameMesh& out = *work.mesh;
  out.matrix = shader.matrix();
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    const auto color = shader.vertex(i).attribute;
    out.colors.emplace_back(color[0], color[1], color[2]);
  }
  out.positions = std::move(mesh.positions);
  out.triangles = std::move(mesh.triangles);
  GeometryStage stage(work.frame, kBenchConfig);
  std::vector<ShadedTriangle> pieces;
  std::uint32_t tag = 0;
  for (const auto& index : out.triangles) {
    pieces.clear();
    stage.process({out.vertex(index[0]), out.vertex(index[1]), out.vertex(index[2])}, tag++,
                  pieces);
    for (const ShadedTriangle& piece : pieces) work.triangles.push_back(piece.triangle);
  }
  return work;
}

}  // namespace halfspace
