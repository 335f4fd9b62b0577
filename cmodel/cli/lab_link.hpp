// SPDX-License-Identifier: Apache-2.0
//
// The program's only door to the lab (testbench/lab), which needs CGAL: a build without it has
// lab_absent.cpp behind it instead of lab_link.cpp.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "../framebuffer.hpp"
#include "../methods/method.hpp"
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

// Every suite: name, title, reason; a line each.
std::string stability_list();

// The cells of the methods and suites named, all where a list is empty. Shows its progress. Throws
// Error(kLabCell) for an unknown name.
nlohmann::ordered_json stability_data(const std::vector<std::string>& methods,
                                      const std::vector<std::string>& suites);

// stability_data() for people: a line per cell.
std::string stability_table(const nlohmann::ordered_json& data);

// The worst case of a cell as a picture, and what it shows. Throws Error(kLabCell) when the method
// does not take the suite's input, or crashes on it.
struct StabilityPicture {
  Image image;
  std::string text;
};
StabilityPicture stability_picture(const std::string& method, const std::string& suite);

// What a method made of every triangle of a scene's first frame at pixel (x, y), which is in the
// frame: docs/02_use/explain.md. all: also of the triangles that have nothing to do with it. Throws
// Error(kMethodGaveUp).
nlohmann::ordered_json method_explanation(const std::string& scene_name, const Scene& scene,
                                          const methods::Method& method, const FrameState& frame,
                                          int x, int y, bool all);

// method_explanation() for people; ends in a newline.
std::string method_explanation_text(const nlohmann::ordered_json& data);

// The scene under one method, magnified where most is wrong. Throws as opening the scene does.
Image scene_picture(const SceneOptions& scene, const std::string& method);

}  // namespace halfspace
