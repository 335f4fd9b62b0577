// SPDX-License-Identifier: Apache-2.0
//
// halfspace report: one page about a scene, without network.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "command.hpp"
#include "io/error.hpp"
#include "io/output_file.hpp"
#include "io/output_folder.hpp"
#include "io/png_file.hpp"
#include "lab_door.hpp"
#include "level_run.hpp"
#include "pictures.hpp"
#include "report_html.hpp"
#include "scene/progress.hpp"
#include "scene_options.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  SceneOptions scene;
  std::string out;
};

// The three pictures, and the statistics of level cycle.
void draw_pictures(const Scene& scene, OutputFolder& folder, ReportData& data) {
  data.stats.command = "report";
  data.stats.level = "cycle";
  Rasterizer rasterizer(data.frame, data.config, DepthFunction::kLess, kBackground);
  LevelRun run(
      Fidelity::kCycle, data.frame, data.config, data.stats,
      [&](const ShadedTriangle& triangle, const SetupTriangle& setup) {
        rasterizer.begin(triangle, setup);
      },
      [&](const CoverageTile& tile) { rasterizer.draw_tile(tile); });
  TilePicture tiles(data.frame.width, data.frame.height, data.config);
  RasterStats unused;
  scene.draw(0, data.frame, data.config, data.stats, [&](const ShadedTriangle& triangle) {
    run.draw(triangle);
    rasterize(
        triangle.triangle, data.frame, data.config, unused, [](const SetupTriangle&) {},
        [&](const Node& node, int level, bool covered) { tiles.visit(node, level, covered); },
        [](const CoverageTile&) {});
  });
  run.finish();
  write_png(folder.file("picture.png"), rasterizer.framebuffer().resolve());
  write_png(folder.file("hits.png"), picture_of_hits(rasterizer.hit_count()));
  write_png(folder.file("tiles.png"), tiles.image());
}

nlohmann::ordered_json measure(const LabDoor& lab, const std::string& name,
                               const SceneOptions& scene) {
  for (const ChartKind& kind : lab.chart_kinds()) {
    if (kind.name == name) return lab.chart_data(kind, scene);
  }
  throw Error(ErrorCode::kChart, name, "is not a chart of this build");
}

// The method with the most wrong pixels, where it is wrong.
void draw_worst(const LabDoor& lab, const SceneOptions& scene, OutputFolder& folder,
                const ReportData& data) {
  const auto& cells = data.stability["cells"];
  const auto worst = std::max_element(cells.begin(), cells.end(), [](const auto& a, const auto& b) {
    return a["wrong_ppm"].template get<double>() < b["wrong_ppm"].template get<double>();
  });
  if (worst == cells.end() || (*worst)["wrong_ppm"] == 0.0) return;
  write_png(folder.file("worst.png"),
            lab.scene_picture(scene, (*worst)["method"].get<std::string>()));
}

int run_report(const LabDoor& lab, const ReportOptions& options) {
  const Config config;
  const std::unique_ptr<Scene> scene = options.scene.open_one(config, Lighting::kGouraud);
  std::uint64_t in_view = 0;
  scene->real(0, [&](const RealTriangle&) { ++in_view; });
  if (in_view == 0) {
    throw Error(ErrorCode::kScene, options.scene.path, "nothing of it is in the frame");
  }
  OutputFolder folder(options.out);
  ReportData data;
  data.scene = fs::path(options.scene.path).filename().string();
  data.command = fmt::format("halfspace report {} --out {}", options.scene.path, options.out);
  if (!options.scene.format.empty()) data.command += " --format " + options.scene.format;
  if (!options.scene.size.empty()) data.command += " --size " + options.scene.size;
  if (options.scene.case_id >= 0) data.command += fmt::format(" --case {}", options.scene.case_id);
  data.command += options.scene.camera.text();
  data.config = config;
  data.frame = scene->frame(0, config);
  draw_pictures(*scene, folder, data);
  Progress progress("measuring charts", 6);
  const auto chart = [&](const char* name) {
    progress.advance(1);
    return measure(lab, name, options.scene);
  };
  data.ladder = chart("ladder");
  data.subpixel = chart("subpixel");
  data.efficiency = chart("efficiency");
  data.interpolation = chart("interpolation");
  data.accumulator = chart("accumulator");
  data.stability = chart("stability");
  draw_worst(lab, options.scene, folder, data);
  write_text(folder.file("index.html"), report_html(data));
  fmt::print("{}\n", (fs::path(options.out) / "index.html").string());
  folder.commit();
  return 0;
}

}  // namespace

Action add_report_command(Command& program, const LabDoor* lab) {
  Command* command =
      program.add_subcommand("report", "A page about a scene: what accuracy costs, what suffices");
  auto o = std::make_shared<ReportOptions>();
  o->scene.add_to(*command);
  command->add_option("--out", o->out, "Folder to write, whole or not at all")
      ->required()
      ->type_name("DIR");
  command->footer(
      "Example: halfspace report tests/scenes/teapot.obj --size 320x240 --out out/report");
  return [o, lab] { return run_report(require_lab(lab), *o); };
}

}  // namespace halfspace
