// SPDX-License-Identifier: Apache-2.0
//
// halfspace fit: the smallest configuration that is right for given scenes.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "fit/emit.hpp"
#include "fit/fit.hpp"
#include "fit/outputs.hpp"
#include "fit/report.hpp"
#include "io/child_process.hpp"
#include "io/config_json.hpp"
#include "io/error.hpp"
#include "io/escape.hpp"
#include "io/input_files.hpp"
#include "io/output_file.hpp"
#include "io/source_tree.hpp"
#include "manners.hpp"
#include "number_checks.hpp"
#include "scene_file.hpp"
#include "scene_options.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

struct FitArguments {
  std::vector<std::string> scenes;
  std::string size, format, out, emit, report, throughput;
  std::string source = folder_with("rtl/rtl.f").string();
  std::string cull = "none";
  CameraArguments camera;
  int views = 1;
  int case_id = -1;
  int samples = 1;
  int attributes = -1;
  int subpixel_bits = -1;
  double max_error = -1;
  double max_attribute_error = -1;
  double simplify = 0;
  bool synth = false;
  bool cosim = false;
};

std::vector<FitView> open_views(const FitArguments& a, double simplify_px) {
  const FrameSize size = a.size.empty() ? FrameSize{640, 480} : parse_size(a.size);
  std::vector<FitView> views;
  for (const std::string& path : a.scenes) {
    const std::string file = scene_file(path, path == kStandardStream ? a.format : "");
    std::shared_ptr<const Scene> scene = noted(open_scene(file, a.case_id, size, a.camera.options(),
                                                          Lighting::kGouraud, a.views, simplify_px),
                                               path);
    const std::vector<FitView> more = fit_views(scene, path, parse_cull(a.cull));
    views.insert(views.end(), more.begin(), more.end());
  }
  if (views.empty()) throw Error(ErrorCode::kScene, a.scenes.front(), "has no cases");
  return views;
}

FitOptions fit_options(const FitArguments& a) {
  FitOptions options;
  options.base.samples = a.samples;
  const bool meshes = !std::all_of(a.scenes.begin(), a.scenes.end(), is_tcov);
  options.base.attributes = a.attributes >= 0 ? a.attributes : meshes ? 3 : 0;
  if (a.subpixel_bits >= 0) options.base.subpixel_bits = a.subpixel_bits;
  require_legal(options.base, "fit");
  if (a.max_error >= 0) options.max_error = a.max_error;
  if (a.max_attribute_error >= 0) options.max_attribute_error = a.max_attribute_error;
  if (!a.throughput.empty()) options.target = parse_target(a.throughput);
  options.curves = !a.report.empty();
  return options;
}

// Whether the camera and the frame of the command line are of no scene.
void say_without_effect(const FitArguments& a) {
  if (!std::all_of(a.scenes.begin(), a.scenes.end(), is_tcov)) return;
  say_no_camera(a.size, a.camera, a.views);
  if (a.simplify > 0) say_no_effect("--simplify", kTcovHasNoCamera);
}

void check(const FitArguments& a) {
  const bool reads_input = std::count(a.scenes.begin(), a.scenes.end(), kStandardStream) != 0;
  if (reads_input && !a.emit.empty()) {
    throw Error(ErrorCode::kUsage, "--emit-rtl",
                "cosim.sh draws the scenes again: not of standard input (-)");
  }
  if (!reads_input && !a.format.empty()) scene_file(a.scenes.front(), a.format);  // refuses
  for (const std::string& scene : a.scenes) note_input(scene);
  for (const char* unit : {"px/clk", "fps@"}) {
    if (a.camera.target.find(unit) == std::string::npos) continue;
    throw Error(ErrorCode::kUsage, "--target",
                "is the point that the camera looks at: a throughput is --throughput");
  }
  if (a.max_error >= 0 && a.subpixel_bits >= 0) {
    throw Error(ErrorCode::kUsage, "--subpixel-bits", "--max-error chooses them: give one");
  }
  if ((a.synth || a.cosim) && a.emit.empty()) {
    throw Error(ErrorCode::kUsage, a.synth ? "--synth" : "--cosim", "needs --emit-rtl DIR");
  }
  if (a.out.empty() && a.emit.empty() && a.report.empty()) {
    throw Error(ErrorCode::kUsage, "fit",
                "nothing to write: give --out FILE, --emit-rtl DIR or --report DIR");
  }
}

// What cosim.sh and --cosim run.
std::vector<EmitRun> emit_runs(const FitArguments& a) {
  std::vector<EmitRun> runs;
  for (const std::string& scene : a.scenes) {
    std::string options;
    if (!is_tcov(scene)) {
      options = a.camera.text() + (a.size.empty() ? " --size 640x480" : " --size " + a.size);
      if (a.views != 1) options += fmt::format(" --orbit {}", a.views);
    } else if (a.case_id >= 0) {
      options = fmt::format(" --case {}", a.case_id);
    }
    if (a.cull != "none") options += " --cull " + a.cull;
    runs.push_back({scene, options});
  }
  return runs;
}

nlohmann::ordered_json read_json(const fs::path& path) {
  return nlohmann::ordered_json::parse(read_file(path.string()));
}

// yosys's figures of the emitted RTL, and of `full` as the project's documentation has them, when
// those are of the same yosys.
void synthesise(const FitArguments& a, FitReport& report) {
  const fs::path work = fs::path(a.emit) / "synth";
  fs::create_directories(work);
  const fs::path area = work / "area.json";
  fmt::print(stderr, "halfspace: note: yosys takes some minutes\n");
  run_tool(fmt::format("python3 {}/testbench/synth/synth_ecp5.py {} --work {} --out {}",
                       quoted(a.source), quoted((fs::path(a.emit) / "hs_config_pkg.sv").string()),
                       quoted(work.string()), quoted(area.string())),
           (work / "log").string(), "--synth");
  report.measured = read_json(area);
  const fs::path known = fs::path(a.source) / "docs/charts/area.json";
  if (!fs::exists(known)) return;
  const nlohmann::ordered_json figures = read_json(known);
  if (figures["tools"]["yosys"] != (*report.measured)["yosys"]) return;
  report.measured_full = figures["presets"]["full"]["flat"];
}

// The command that makes the same configuration.
std::string command_text(const FitArguments& a) {
  std::string text = "halfspace fit";
  for (const std::string& scene : a.scenes) text += " " + scene;
  if (!a.size.empty()) text += " --size " + a.size;
  if (a.max_error >= 0) text += fmt::format(" --max-error {}", a.max_error);
  if (a.max_attribute_error >= 0) {
    text += fmt::format(" --max-attribute-error {}", a.max_attribute_error);
  }
  if (a.subpixel_bits >= 0) text += fmt::format(" --subpixel-bits {}", a.subpixel_bits);
  if (!a.throughput.empty()) text += " --throughput " + a.throughput;
  if (a.samples != 1) text += fmt::format(" --samples {}", a.samples);
  if (a.views != 1) text += fmt::format(" --orbit {}", a.views);
  if (a.attributes >= 0) text += fmt::format(" --attributes {}", a.attributes);
  if (a.case_id >= 0) text += fmt::format(" --case {}", a.case_id);
  if (a.cull != "none") text += " --cull " + a.cull;
  return text + a.camera.text();
}

// --cosim: false when the RTL and the model differ, which cosim has said.
bool run_cosim_script(const FitArguments& a, FitReport& report) {
  const fs::path folder = fs::absolute(a.emit);
  const bool good = run_child({(folder / "cosim.sh").string()}) == 0;
  bool identical = true;
  for (std::size_t i = 0; i < a.scenes.size() && fs::exists(folder / emitted_stats(i)); ++i) {
    report.cosim.push_back(read_json(folder / emitted_stats(i)));
    identical = identical && report.cosim.back().at("identical").get<bool>();
  }
  if (good || !identical) return identical;
  throw Error(ErrorCode::kFitTool, "--cosim", (folder / "cosim.sh").string() + " failed");
}

void say_summary(const FitArguments& a, const FitReport& report) {
  std::FILE* out = talk({a.out});
  fmt::print(out, "{}", fit_summary(report));
  if (!a.out.empty()) fmt::print(out, "wrote {}\n", a.out);
  if (!a.emit.empty()) fmt::print(out, "wrote {0}: RTL, and {0}/cosim.sh to check it\n", a.emit);
  if (!a.report.empty()) fmt::print(out, "wrote {}/index.html\n", a.report);
}

int run_fit(const FitArguments& a) {
  check(a);
  say_without_effect(a);
  const FitOptions options = fit_options(a);
  FitOutputs outputs(a.out, a.report, a.emit, a.source);
  const std::vector<FitView> views = open_views(a, 0);
  const FitResult result = fit(views, options);
  FitReport report{.command = command_text(a),
                   .options = options,
                   .result = result,
                   .views = views.size(),
                   .measured = {},
                   .lod = {},
                   .measured_full = {},
                   .cosim = {}};
  if (a.simplify > 0) report.lod = compare_lod(views, open_views(a, a.simplify));
  if (a.synth) {  // takes minutes: what is known is in place before
    outputs.write(report, emit_runs(a));
    synthesise(a, report);
  }
  say_summary(a, report);  // before the files: they are written when this is
  a.synth ? outputs.rewrite(report) : outputs.write(report, emit_runs(a));
  if (!a.cosim) return 0;
  const bool identical = run_cosim_script(a, report);
  outputs.rewrite(report);
  return identical ? 0 : 1;
}

}  // namespace

Action add_fit_command(Command& program) {
  Command* command = program.add_subcommand(
      "fit", "Find the smallest configuration that is right for the scenes, and emit its RTL");
  auto a = std::make_shared<FitArguments>();
  command->add_option("SCENE", a->scenes, "Meshes or TCOV files, all to be right for")->required();
  command->add_option("--size", a->size, "Frame size in pixels (default 640x480)")
      ->type_name("WxH");
  command->add_option("--out", a->out, "Configuration to write, JSON");
  command->add_option("--emit-rtl", a->emit, "Folder for the RTL of it, and cosim.sh");
  command->add_option("--report", a->report, "Folder for index.html and report.json");
  command
      ->add_option("--max-error", a->max_error,
                   "Choose the fewest subpixel bits that keep coverage within this of unsnapped "
                   "vertices, ppm of covered samples")
      ->check(not_negative())
      ->type_name("PPM");
  command
      ->add_option("--max-attribute-error", a->max_attribute_error,
                   "Choose the fewest bits of 1/w, gradient and reciprocal that keep attributes "
                   "within this, levels of 255")
      ->check(not_negative())
      ->type_name("LEVELS");
  command->add_option("--throughput", a->throughput,
                      "Throughput to reach: 2.5px/clk or 60fps@100MHz");
  command->add_option("--subpixel-bits", a->subpixel_bits, "Subpixel bits (default 8)")
      ->check(whole());
  command->add_option("--samples", a->samples, "Samples per pixel")
      ->type_name("1|2|4|8|16")
      ->capture_default_str();
  command->add_option("--attributes", a->attributes,
                      "Attributes used (default 3, and 0 for TCOV files)");
  add_cull_option(*command, a->cull);
  add_format_option(*command, a->format);
  a->camera.add_to(*command);
  command->add_option("--orbit", a->views, "Cameras around the target, all to be right for")
      ->check(whole_between(1, 4096))
      ->capture_default_str();
  command->add_option("--case", a->case_id, "The case of a TCOV file (default: all)")
      ->check(whole());
  command
      ->add_option("--simplify", a->simplify,
                   "Also say what simplification to this error would save and get wrong, pixels")
      ->check(not_negative())
      ->type_name("PX");
  command->add_flag("--synth", a->synth, "Measure the area with yosys");
  command->add_flag("--cosim", a->cosim, "Run the emitted cosim.sh: lint, compare with the model");
  command->add_option("--source", a->source, "The project's source tree")
      ->needs(command->get_option("--emit-rtl"));
  command->footer(
      "A scene or view that was not given may be refused by the configuration (HS022).\n"
      "Example: halfspace fit tests/scenes/teapot.obj --size 320x240 --max-error 1000 "
      "--emit-rtl out/fit");
  return [a] { return run_fit(*a); };
}

}  // namespace halfspace
