// SPDX-License-Identifier: Apache-2.0
//
// The program's only door to the lab (testbench/lab), which needs CGAL and may be left out
// (HALFSPACE_LAB=OFF). Commands are handed the door, or null.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "framebuffer.hpp"
#include "methods/method.hpp"
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

// The functions above, where a build has them.
struct LabDoor {
  decltype(&halfspace::chart_kinds) chart_kinds;
  decltype(&halfspace::chart_data) chart_data;
  decltype(&halfspace::stability_list) stability_list;
  decltype(&halfspace::stability_data) stability_data;
  decltype(&halfspace::stability_table) stability_table;
  decltype(&halfspace::stability_picture) stability_picture;
  decltype(&halfspace::method_explanation) method_explanation;
  decltype(&halfspace::method_explanation_text) method_explanation_text;
  decltype(&halfspace::scene_picture) scene_picture;
};
inline constexpr LabDoor kLabDoor{
    &chart_kinds,     &chart_data,        &stability_list,     &stability_data,
    &stability_table, &stability_picture, &method_explanation, &method_explanation_text,
    &scene_picture};

// The door. Throws Error(kNoLab) where there is none.
const LabDoor& require_lab(const LabDoor* lab);

}  // namespace halfspace
