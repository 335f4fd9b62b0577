// SPDX-License-Identifier: Apache-2.0
#include "lab_link.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "../io/error.hpp"
#include "lab/charts.hpp"

namespace halfspace {
namespace {

lab::RealScene open_real(const SceneOptions& options) {
  const Config config;
  if (std::filesystem::path(options.path).extension() == ".tcov") {
    return lab::tcov_scene(options.path, options.case_id);
  }
  const FrameSize size = frame_size(options.size, config);
  return lab::mesh_scene(options.path, size.width, size.height, options.camera());
}

}  // namespace

const std::vector<ChartKind>& chart_kinds() {
  static const std::vector<ChartKind> kinds{
      {"subpixel", "wrong pixels by subpixel bits"},
      {"efficiency", "tile sides: tests wasted, pixels per clock"},
      {"interpolation", "reciprocal and gradient bits: attribute and depth error"},
      {"accumulator", "edge values in too few bits"},
  };
  return kinds;
}

nlohmann::ordered_json chart_data(const ChartKind& kind, const SceneOptions& options) {
  std::optional<lab::RealScene> scene;
  if (!options.path.empty()) scene = open_real(options);
  const lab::RealScene* chosen = scene ? &*scene : nullptr;
  if (kind.name == "subpixel") return lab::subpixel_chart(chosen);
  if (kind.name == "efficiency") return lab::efficiency_chart(chosen);
  if (kind.name == "interpolation") return lab::interpolation_chart(chosen);
  return lab::accumulator_chart(chosen);
}

}  // namespace halfspace
