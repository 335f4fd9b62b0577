// SPDX-License-Identifier: Apache-2.0
//
// halfspace explain: why a sample of a pixel is what it is, triangle by triangle.
#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "explain.hpp"
#include "explain_report.hpp"
#include "io/error.hpp"
#include "lab_door.hpp"
#include "manners.hpp"
#include "method_picture.hpp"
#include "pictures.hpp"
#include "scene_options.hpp"

namespace halfspace {
namespace {

struct ExplainOptions {
  SceneOptions scene;
  std::string x, y;  // numbers, as text: so that -1 is out of range and not an unknown option
  int sample = 0;
  std::string cull = "none";
  DepthOptions depth;
  bool all = false;
  bool json = false;
  std::string method;
  ConfigOptions config;
};

// A pixel coordinate, 0..size - 1. Throws Error(kPixel).
int parse_pixel(const std::string& text, const char* name, int size) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || value < 0 || value >= size) {
    throw Error(ErrorCode::kPixel, name,
                fmt::format("'{:.20}' is not a pixel of the frame (0..{})", text, size - 1));
  }
  return value;
}

// By a method of the gallery, drawn as render --method draws it.
int explain_by_method(const LabDoor& lab, const ExplainOptions& options) {
  const methods::Method& method = find_method(options.method, "");
  const Config config = options.config.load();
  const std::unique_ptr<Scene> scene = options.scene.open_one(config, Lighting::kGouraud);
  const FrameState frame = scene->frame(0, config);
  const nlohmann::ordered_json told = lab.method_explanation(
      options.scene.path, *scene, method, frame, parse_pixel(options.x, "X", frame.width),
      parse_pixel(options.y, "Y", frame.height), options.all || options.json);
  fmt::print("{}", options.json ? told.dump(1) + "\n" : lab.method_explanation_text(told));
  return 0;
}

int run_explain(const LabDoor* lab, const ExplainOptions& options) {
  if (!options.method.empty()) return explain_by_method(require_lab(lab), options);
  const Cull cull = parse_cull(options.cull);
  Config config = options.config.load();
  const DepthState depth = options.depth.load(config);
  if (options.sample < 0 || options.sample >= config.samples) {
    throw Error(ErrorCode::kSample, "--sample",
                fmt::format("{} is out of range (0..{})", options.sample, config.samples - 1));
  }
  const std::unique_ptr<Scene> scene = options.scene.open_one(config, Lighting::kGouraud);
  ExplainedFrame about{options.scene.path, scene->frame(0, config), config, {}};
  about.frame.cull = cull;
  about.at = {parse_pixel(options.x, "X", about.frame.width),
              parse_pixel(options.y, "Y", about.frame.height), options.sample};

  config.tag_bits = 32;  // tags are the indices of submitted triangles
  Explainer explainer(about.frame, config, depth, kBackground, about.at,
                      options.all || options.json);
  RunStats stats;
  scene->draw(0, about.frame, config, stats,
              [&](const ShadedTriangle& triangle) { explainer.add(triangle); });
  explainer.finish(scene->triangles(0));
  if (const auto index = explainer.disagreement()) {
    throw Error(ErrorCode::kInternal, "explain",
                fmt::format("the stages and the definition disagree on triangle {}", *index));
  }
  if (options.all && options.json) say_no_effect("--all", "--json has every triangle");
  if (options.json) {
    fmt::print("{}\n", explain_json(explainer, about).dump(1));
  } else {
    fmt::print("{}", explain_text(explainer, about));
  }
  return 0;
}

}  // namespace

Action add_explain_command(Command& program, const LabDoor* lab) {
  Command* command =
      program.add_subcommand("explain", "Why a pixel is what it is, triangle by triangle");
  auto o = std::make_shared<ExplainOptions>();
  o->scene.add_to(*command);
  command->add_option("X", o->x, "Pixel column, 0 at the left")->required();
  command->add_option("Y", o->y, "Pixel row, 0 at the top")->required();
  command->add_option("--sample", o->sample, "Sample of the pixel")->capture_default_str();
  o->config.add_to(*command);
  add_cull_option(*command, o->cull);
  o->depth.add_to(*command);
  command->add_flag("--all", o->all, "Details of every triangle, not only of those near");
  command->add_flag("--json", o->json, "Everything, as JSON");
  Option* method =
      command->add_option("--method", o->method,
                          "By a method of the gallery, beside the exact rule (halfspace methods)");
  for (const char* other : {"--sample", "--samples", "--cull", "--depth-test", "--depth-clear"}) {
    method->excludes(command->get_option(other));  // it samples centres, and has its own way
  }
  command->footer(
      "Edge values are exact integers in units of 2^-(s+f) px^2 (s subpixel bits, f position "
      "bits).\n"
      "With --method they are px^2, and what the method decided stands beside the exact rule.\n"
      "Examples: halfspace explain tests/scenes/teapot.obj 270 200\n"
      "          halfspace explain tests/scenes/teapot.obj 270 200 --method walk_closed");
  return [o, lab] { return run_explain(lab, *o); };
}

}  // namespace halfspace
