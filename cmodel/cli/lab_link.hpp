// SPDX-License-Identifier: Apache-2.0
//
// The program's only door to the lab (testbench/lab), which needs CGAL: a build without it has
// lab_absent.cpp behind it instead of lab_link.cpp.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scene_options.hpp"

namespace halfspace {

struct ChartKind {
  std::string name;
  std::string title;
};
// The charts that this build can measure.
const std::vector<ChartKind>& chart_kinds();

// One chart's data; scene.path empty: the seeded triangles of docs/charts. Throws Error.
nlohmann::ordered_json chart_data(const ChartKind& kind, const SceneOptions& scene);

}  // namespace halfspace
