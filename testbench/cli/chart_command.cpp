// SPDX-License-Identifier: Apache-2.0
//
// halfspace chart: one chart's data, measured, as JSON or drawn.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "drawing_script.hpp"
#include "io/error.hpp"
#include "io/input_files.hpp"
#include "io/output_file.hpp"
#include "lab_door.hpp"
#include "scene_options.hpp"

namespace halfspace {
namespace {

struct ChartOptions {
  std::string name;
  std::string out;
  bool list = false;
  SceneOptions scene;
};

bool ends_with(const std::string& text, const char* end) {
  return std::filesystem::path(text).extension() == end;
}

const ChartKind& find_chart(const LabDoor& lab, const std::string& name) {
  std::string names;
  for (const ChartKind& kind : lab.chart_kinds()) {
    if (kind.name == name) return kind;
    names += (names.empty() ? "" : ", ") + kind.name;
  }
  throw Error(ErrorCode::kChart, "NAME", fmt::format("'{:.40}' is not one of {}", name, names));
}

int run_chart(const LabDoor& lab, const ChartOptions& options) {
  if (options.list) {
    for (const ChartKind& kind : lab.chart_kinds()) {
      fmt::print("{:<14} {}\n", kind.name, kind.title);
    }
    return 0;
  }
  if (options.name.empty()) throw Error(ErrorCode::kUsage, "NAME", "is required (see --list)");
  const ChartKind& kind = find_chart(lab, options.name);
  if (options.out.empty()) throw Error(ErrorCode::kUsage, "--out", "is required");
  note_input(options.scene.path);
  const bool to_stdout = options.out == kStandardStream;
  const bool drawn = ends_with(options.out, ".svg") || ends_with(options.out, ".png");
  if (!drawn && !to_stdout && !ends_with(options.out, ".json")) {
    throw Error(ErrorCode::kUsage, "--out",
                fmt::format("'{}' does not end in .json, .svg or .png", options.out));
  }
  if (drawn) require_drawing_script();
  check_writable(options.out);
  const nlohmann::ordered_json data = lab.chart_data(kind, options.scene);
  if (drawn) {
    draw_chart(options.name, data, options.out);
  } else {
    write_text(options.out, data.dump(1) + "\n");
  }
  return 0;
}

}  // namespace

Action add_chart_command(Command& program, const LabDoor* lab) {
  Command* command = program.add_subcommand("chart", "Measure one chart's data, draw it");
  auto o = std::make_shared<ChartOptions>();
  command->add_option("NAME", o->name, "Which chart: see --list");
  Option* list = command->add_flag("--list", o->list, "Name every chart and stop");
  command->add_option("--out", o->out,
                      "File to write: .json for the data, as -, standard output; .svg or .png need "
                      "python3-matplotlib");
  o->scene.add_to(*command, "--scene");
  command->stands_alone(list);
  for (const char* other :
       {"--size", "--eye", "--target", "--up", "--fov", "--ortho", "--case", "--format"}) {
    command->get_option(other)->needs(command->get_option("--scene"));
  }
  command->footer(
      "Without --scene the charts of docs/charts are measured again, on seeded triangles.\n"
      "Drawing is done by testbench/charts/charts.py of the source tree the program was built in, "
      "or the "
      "one that HALFSPACE_CHARTS names.\n"
      "Example: halfspace chart subpixel --scene tests/scenes/teapot.obj --out out/subpixel.svg");
  return [o, lab] { return run_chart(require_lab(lab), *o); };
}

}  // namespace halfspace
