// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "charts.hpp"
#include "cycle_model.hpp"
#include "fixed.hpp"

namespace halfspace::lab {
namespace {

constexpr std::uint64_t kSeed = 840;
constexpr int kFrame = 2048;

struct Work {
  std::uint64_t triangles = 0;
  std::uint64_t covered = 0;
  std::uint64_t tested = 0;
  std::uint64_t tiles = 0;
  std::uint64_t clocks = 0;
};

// What the model does with tiles of 2^log2 px.
Work model_work(const std::vector<Triangle>& triangles, const RealScene& scene, int log2) {
  Config config;
  config.grid_log2 = log2;
  config.guard_bits = 14;
  struct Quiet {
    void accepted(std::uint64_t) const {}
    void setup(std::uint64_t, const SetupTriangle&) const {}
    void node(int, std::uint64_t, const Node&) const {}
    void tile(std::uint64_t, const CoverageTile&) const {}
  };
  CycleModel model({scene.width, scene.height, Cull::kNone}, config, Stalls());
  for (const Triangle& t : triangles) model.draw(t, Quiet());
  const RasterStats& s = model.stats();
  return {s.triangles, s.samples_covered, s.samples_tested, s.tiles_visited, model.clocks()};
}

// A tile side that the design does not have: the tiles that its corner test would keep, a clock
// each. 2^log2 px; the triangle's setup in the widths of kFull.
Work counted_work(const std::vector<Triangle>& triangles, const RealScene& scene, int log2) {
  Config config;
  config.guard_bits = 14;
  const FrameState frame{scene.width, scene.height, Cull::kNone};
  const int side = 1 << log2;
  Work work;
  for (const Triangle& t : triangles) {
    ++work.triangles;
    std::uint64_t tiles = 0;
    const auto setup = triangle_setup(t, frame, config);
    if (!setup) {
      ++work.clocks;
      continue;
    }
    const Box& box = setup->box;
    for (int y = box.y_first & -side; y <= box.y_last; y += side) {
      for (int x = box.x_first & -side; x <= box.x_last; x += side) {
        bool live = true;
        for (std::size_t i = 0; i < 3; ++i) {
          const std::int64_t a = setup->slope[i].a;
          const std::int64_t b = setup->slope[i].b;
          // The last sample inside, in the direction in which E grows.
          const std::int64_t cx = x + (a > 0 ? side - 1 : 0);
          const std::int64_t cy = y + (b > 0 ? side - 1 : 0);
          live = live && setup->e[i] + a * cx + b * cy >= 0;
        }
        tiles += live ? 1u : 0u;
      }
    }
    RasterStats stats;
    rasterize(t, frame, config, stats, [](const CoverageTile&) {});
    work.covered += stats.samples_covered;
    work.tiles += tiles;
    work.tested += tiles << (2 * log2);
    work.clocks += std::max<std::uint64_t>(tiles, 1);
  }
  return work;
}

Json row(const Work& w, const std::string& size_class, double side) {
  const double covered = static_cast<double>(w.covered);
  return {{"size", size_class},
          {"side_px", side},
          {"triangles", w.triangles},
          {"samples_covered", w.covered},
          {"samples_tested", w.tested},
          {"tiles_tested", w.tiles},
          {"clocks", w.clocks},
          {"efficiency", w.tested == 0 ? 0.0 : covered / static_cast<double>(w.tested)},
          {"pixels_per_clock", w.clocks == 0 ? 0.0 : covered / static_cast<double>(w.clocks)}};
}

// The scene's triangles by the power of two that holds the longer side of their bounding box.
std::map<int, RealScene> by_size(const RealScene& scene) {
  std::map<int, RealScene> classes;
  for (const oracle::Corners& t : scene.triangles) {
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
    const double side = std::max({right - left, bottom - top, 1.0});
    const int log2 = static_cast<int>(std::ceil(std::log2(side)));
    RealScene& part = classes[log2];
    part.width = scene.width;
    part.height = scene.height;
    part.triangles.push_back(t);
  }
  return classes;
}

std::map<int, RealScene> synthetic() {
  std::map<int, RealScene> classes;
  for (int log2 = 1; log2 <= 10; ++log2) {
    const double side = std::ldexp(1.0, log2);
    const int count = std::clamp(static_cast<int>(4e6 / (side * side)), 20, 2000);
    classes[log2] =
        random_scene(kSeed + static_cast<std::uint64_t>(log2), count, side, kFrame, kFrame);
  }
  return classes;
}

}  // namespace

Json efficiency_chart(const RealScene* scene) {
  const std::map<int, RealScene> classes = scene == nullptr ? synthetic() : by_size(*scene);
  Config config;
  config.guard_bits = 14;
  Json data;
  data["chart"] = "efficiency";
  data["scene"] = scene == nullptr ? "random triangles in a 2048x2048 frame" : scene->name;
  for (const int log2 : {2, 3, 4}) {
    Json rows = Json::array();
    Work total;
    for (const auto& [size, part] : classes) {
      const auto triangles = snapped(part, config);
      const Work w =
          log2 == 4 ? counted_work(triangles, part, log2) : model_work(triangles, part, log2);
      rows.push_back(row(w, "up to " + std::to_string(1 << size) + " px", std::ldexp(1.0, size)));
      total.triangles += w.triangles;
      total.covered += w.covered;
      total.tested += w.tested;
      total.tiles += w.tiles;
      total.clocks += w.clocks;
    }
    data["tiles"].push_back({{"tile_px", 1 << log2},
                             {"lanes", 1 << (2 * log2)},
                             {"how", log2 == 4 ? "counted" : "model, level cycle"},
                             {"rows", rows},
                             {"total", row(total, "all", 0)}});
  }
  return data;
}

}  // namespace halfspace::lab
