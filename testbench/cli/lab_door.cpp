// SPDX-License-Identifier: Apache-2.0
#include "lab_door.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "io/error.hpp"
#include "lab/charts.hpp"
#include "lab/lab_picture.hpp"
#include "lab/real_scene.hpp"
#include "lab/stability.hpp"
#include "ladder_chart.hpp"

namespace halfspace {
namespace {

lab::RealScene open_real(const SceneOptions& options) {
  const Config config;
  const std::unique_ptr<Scene> scene = options.open(config, Lighting::kGouraud);
  if (scene->frames() != 1) {
    throw Error(ErrorCode::kScene, options.path,
                fmt::format("the file has {} cases: choose one with --case", scene->frames()));
  }
  const FrameState frame = scene->frame(0, config);
  if (is_tcov(options.file())) {
    RunStats unused;  // a coordinate beyond the configuration is refused as render refuses it
    scene->draw(0, frame, config, unused, [](const ShadedTriangle&) {});
  }
  lab::RealScene real = lab::real_scene(*scene, frame, options.path);
  if (!real.triangles.empty()) return real;
  throw Error(ErrorCode::kScene, options.path, "nothing of it is in the frame");
}

}  // namespace

Image scene_picture(const SceneOptions& options, const std::string& name) {
  const lab::RealScene scene = open_real(options);
  const lab::Suite suite = lab::scene_suite(scene);
  for (const methods::Method& method : lab::lab_methods()) {
    if (method.name == name) return lab::case_picture(method, suite, suite.make().front());
  }
  return {};
}

const std::vector<ChartKind>& chart_kinds() {
  static const std::vector<ChartKind> kinds{
      {"methods", "every method: wrong pixels against time per triangle"},
      {"subpixel", "wrong pixels by subpixel bits"},
      {"ladder", "levels of modelling: speed against what is right"},
      {"efficiency", "tile sides: tests wasted, pixels per clock"},
      {"interpolation", "reciprocal and gradient bits: attribute and depth error"},
      {"accumulator", "edge values in too few bits"},
      {"stability", "every method over every suite, or over the scene"},
  };
  return kinds;
}

nlohmann::ordered_json chart_data(const ChartKind& kind, const SceneOptions& options) {
  if (kind.name == "ladder") {
    if (options.path.empty()) {
      throw Error(ErrorCode::kChart, "--scene", "chart ladder is measured on a scene: name one");
    }
    return ladder_chart(options);
  }
  std::optional<lab::RealScene> scene;
  if (!options.path.empty()) scene = open_real(options);
  const lab::RealScene* chosen = scene ? &*scene : nullptr;
  if (kind.name == "stability")
    return chosen ? lab::scene_stability(*chosen) : stability_data({}, {});
  if (kind.name == "methods") return lab::methods_chart(chosen);
  if (kind.name == "subpixel") return lab::subpixel_chart(chosen);
  if (kind.name == "efficiency") return lab::efficiency_chart(chosen);
  if (kind.name == "interpolation") return lab::interpolation_chart(chosen);
  return lab::accumulator_chart(chosen);
}

}  // namespace halfspace
