// SPDX-License-Identifier: Apache-2.0
//
// halfspace render: a scene in, a picture and its statistics out.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <span>

#include "auto_level.hpp"
#include "bit_frame.hpp"
#include "choice.hpp"
#include "command.hpp"
#include "io/error.hpp"
#include "io/input_files.hpp"
#include "io/output_file.hpp"
#include "io/png_file.hpp"
#include "io/tcov.hpp"
#include "io/trace_formats.hpp"
#include "level_run.hpp"
#include "manners.hpp"
#include "nothing_drawn.hpp"
#include "number_checks.hpp"
#include "pictures.hpp"
#include "rtl_link.hpp"
#include "scene_options.hpp"

namespace halfspace {
namespace {

using WallClock = std::chrono::steady_clock;

enum class Shade { kFlat, kGouraud, kDepth, kCoverage, kTiles };
constexpr Choice<Shade> kShadeNames[] = {{"gouraud", Shade::kGouraud},
                                         {"flat", Shade::kFlat},
                                         {"depth", Shade::kDepth},
                                         {"coverage", Shade::kCoverage},
                                         {"tiles", Shade::kTiles}};

struct RenderOptions {
  SceneOptions scene;
  std::string out;
  std::string level = "bit";
  std::string stats;
  std::string trace;
  std::string cull = "none";
  std::string shade;
  DepthOptions depth;
  std::string scissor;
  int threads = 0;
  bool threads_given = false;
  bool depth_test_given = false;
  std::string method;
  double simplify = 0;
  ConfigOptions config;
};

Shade parse_shade(const RenderOptions& options, Fidelity level) {
  if (level == Fidelity::kCoverage) {
    if (options.shade.empty() || options.shade == "coverage") return Shade::kCoverage;
    throw Error(ErrorCode::kUsage, "--shade",
                "level coverage computes no depth, colour or tile order: only --shade coverage");
  }
  if (options.shade.empty()) return Shade::kGouraud;
  const Shade shade = chosen(std::span(kShadeNames), options.shade, "--shade");
  if (shade == Shade::kTiles && level != Fidelity::kBit) {
    throw Error(
        ErrorCode::kUsage, "--shade",
        fmt::format("tiles are those that level bit tests: not at level {}", options.level));
  }
  return shade;
}

void say_without_effect(const RenderOptions& options, Fidelity level, Shade shade) {
  const bool depth = shade != Shade::kCoverage && shade != Shade::kTiles;
  if (options.threads_given && (level != Fidelity::kBit || !depth)) {
    say_no_effect("--threads", "only level bit's colour and depth are drawn by several");
  }
  if (options.depth_test_given && !depth) {
    say_no_effect("--depth-test", "this picture has no depth");
  }
}

// One frame drawn: its picture, with the hit counts and the counts of work added to stats.
class FrameRun {
 public:
  FrameRun(const Scene& scene, std::size_t index, const FrameState& frame, const Config& config,
           RunStats& stats)
      : scene_(scene), index_(index), frame_(frame), config_(config), stats_(stats) {}

  Image coverage(Fidelity level) {
    HitCount hits(frame_.width, frame_.height);
    LevelRun run(level, frame_, config_, stats_, {},
                 [&](const CoverageTile& tile) { hits.add(tile, config_); });
    draw(run);
    return finish(hits.count(), picture_of_hits(hits));
  }

  Image tiles() {
    HitCount hits(frame_.width, frame_.height);
    TilePicture picture(frame_.width, frame_.height, config_);
    scene_.draw(index_, frame_, config_, stats_, [&](const ShadedTriangle& triangle) {
      rasterize(
          triangle.triangle, frame_, config_, stats_.raster, [](const SetupTriangle&) {},
          [&](const Node& node, int level, bool covered) { picture.visit(node, level, covered); },
          [&](const CoverageTile& tile) { hits.add(tile, config_); });
    });
    return finish(hits.count(), picture.image());
  }

  Image bit(const BitFrameOptions& options) {
    BitFrame drawn = draw_bit_frame(scene_, index_, frame_, config_, options, stats_);
    return finish(drawn.hits, std::move(drawn.image));
  }

  // By the stages one after the other.
  Image full(Fidelity level, const BitFrameOptions& options) {
    Rasterizer rasterizer(frame_, config_, options.depth, options.background, options.scissor);
    LevelRun run(
        level, frame_, config_, stats_,
        [&](const ShadedTriangle& triangle, const SetupTriangle& setup) {
          rasterizer.begin(triangle, setup);
        },
        [&](const CoverageTile& tile) { rasterizer.draw_tile(tile); });
    draw(run);
    stats_.raster.fragments_shaded += rasterizer.stats().fragments_shaded;
    const Framebuffer& framebuffer = rasterizer.framebuffer();
    stats_.tiles_touched += framebuffer.tiles_touched();
    const std::uint32_t far = config_.depth_max();
    return finish(rasterizer.hit_count().count(),
                  options.depth_picture
                      ? picture_of_depth(framebuffer.depth(), frame_.width, frame_.height, far)
                      : framebuffer.resolve());
  }

 private:
  Image finish(const std::vector<std::uint8_t>& hits, Image image) {
    const auto across = [this](int size) {
      return static_cast<std::uint64_t>((size + config_.grid() - 1) >> config_.grid_log2);
    };
    stats_.tiles_in_frame += across(frame_.width) * across(frame_.height);
    stats_.crc = crc32_of(hits, stats_.crc);
    ++stats_.cases;
    return image;
  }
  void draw(LevelRun& run) {
    scene_.draw(index_, frame_, config_, stats_,
                [&run](const ShadedTriangle& triangle) { run.draw(triangle); });
    run.finish();
  }

  const Scene& scene_;
  std::size_t index_;
  FrameState frame_;
  const Config& config_;
  RunStats& stats_;
};

void check_trace(const std::string& path, Fidelity level) {
  if (level != Fidelity::kCycle && level != Fidelity::kRtl) {
    throw Error(ErrorCode::kLevel, "--trace", "traces need level cycle or rtl");
  }
  if (!is_trace_file(path)) {
    throw Error(ErrorCode::kUsage, "--trace",
                fmt::format("'{}' does not end in .json or .kanata.gz", path));
  }
  check_writable(path);
}

// The handshakes of the frame, in a run of their own.
TraceLog level_trace(Fidelity level, const Scene& scene, Cull cull, const Config& config) {
  if (scene.frames() > 1) {
    throw Error(ErrorCode::kUsage, "--trace",
                fmt::format("the file has {} cases: choose one with --case", scene.frames()));
  }
  FrameState frame = scene.frame(0, config);
  frame.cull = cull;
  RunStats unused;
  std::vector<Triangle> triangles;
  scene.draw(0, frame, config, unused,
             [&](const ShadedTriangle& triangle) { triangles.push_back(triangle.triangle); });
  return level == Fidelity::kRtl ? trace_rtl_level(triangles, frame, config)
                                 : trace_model(triangles, frame, config, Stalls());
}

int run_render(const RenderOptions& options, const MethodDrawing* gallery) {
  const WallClock::time_point start = WallClock::now();
  const bool by_method = !options.method.empty();
  if (by_method && gallery == nullptr) {
    throw Error(ErrorCode::kNoLab, "--method", "this program was built without the gallery");
  }
  if (by_method) gallery->require(options.method, options.shade);
  const std::optional<Fidelity> chosen_level = parse_level(options.level);
  const bool automatic = !chosen_level;
  const Fidelity level = chosen_level.value_or(Fidelity::kCoverage);
  // A method has shades of its own; of --shade only the light matters here.
  const Shade shade = !by_method                ? parse_shade(options, level)
                      : options.shade == "flat" ? Shade::kFlat
                                                : Shade::kGouraud;
  if (!by_method) say_without_effect(options, level, shade);
  require_png_name(options.out, "--out");
  const Cull cull = parse_cull(options.cull);
  const Config config = options.config.load();
  BitFrameOptions bit{options.depth.load(config), kBackground,     shade == Shade::kDepth,
                      !options.stats.empty(),     options.threads, {}};
  if (!options.scissor.empty() && (shade == Shade::kCoverage || shade == Shade::kTiles)) {
    throw Error(ErrorCode::kUsage, "--scissor",
                "coverage is counted before it: --shade without it");
  }
  require_level(level, config);
  note_input(options.scene.path);
  if (!options.trace.empty()) check_trace(options.trace, level);
  check_distinct({options.out, options.stats, options.trace});
  check_writable(options.out);
  if (!options.stats.empty()) check_writable(options.stats);
  const std::unique_ptr<Scene> scene = options.scene.open(
      config, shade == Shade::kFlat ? Lighting::kFlat : Lighting::kGouraud, options.simplify);

  RunStats stats;
  stats.command = "render";
  stats.level = by_method ? options.method : options.level;
  stats.left_out = scene->left_out();
  std::vector<Image> images;
  for (std::size_t i = 0; i < scene->frames(); ++i) {
    FrameState frame = scene->frame(i, config);
    frame.cull = cull;
    if (!options.scissor.empty()) bit.scissor = parse_scissor(options.scissor, frame);
    if (by_method) {
      images.push_back(gallery->draw(*scene, i, frame, options.method, options.shade, stats));
      continue;
    }
    if (automatic) add_prediction(*scene, i, frame, config, stats);
    FrameRun run(*scene, i, frame, config, stats);
    switch (shade) {
      case Shade::kCoverage: images.push_back(run.coverage(level)); break;
      case Shade::kTiles: images.push_back(run.tiles()); break;
      default:
        images.push_back(level == Fidelity::kBit ? run.bit(bit) : run.full(level, bit));
        break;
    }
  }
  const std::string why =
      by_method || images.size() != 1 ? "" : why_nothing_is_drawn(*scene, 0, stats);
  if (!why.empty()) fmt::print(stderr, "halfspace: note: nothing is drawn: {}\n", why);
  if (images.empty()) throw Error(ErrorCode::kScene, options.scene.path, "has no cases");
  OutputGroup outputs;
  write_png(outputs.open(options.out), contact_sheet(images));
  stats.wall_seconds = std::chrono::duration<double>(WallClock::now() - start).count();
  if (!options.stats.empty()) write_stats(outputs.open(options.stats), stats, config);
  if (!options.trace.empty()) {
    write_trace(outputs.open(options.trace), level_trace(level, *scene, cull, config));
  }
  outputs.commit();
  return exit_status(stats);
}

}  // namespace

Action add_render_command(Command& program, const MethodDrawing* gallery) {
  Command* command = program.add_subcommand("render", "Draw a scene and write a PNG");
  auto o = std::make_shared<RenderOptions>();
  o->scene.add_to(*command);
  command->add_option("--out", o->out, "PNG file to write; -: standard output")->required();
  add_level_option(*command, o->level);
  o->config.add_to(*command);
  command->add_option("--stats", o->stats, "JSON statistics to write");
  command->add_option("--trace", o->trace, "Trace to write (levels cycle and rtl)");
  command->add_option("--shade", o->shade, "coverage: hits per pixel; tiles: nodes tested")
      ->type_name(type_name_of(std::span(kShadeNames)));
  add_cull_option(*command, o->cull);
  command
      ->add_option("--simplify", o->simplify,
                   "Leave out triangles as long as the surface moves by at most this many pixels")
      ->check(not_negative())
      ->type_name("PX");
  o->depth.add_to(*command);
  command->add_option("--scissor", o->scissor, "Draw inside this rectangle alone, pixels")
      ->type_name("X,Y,WxH");
  command
      ->add_option("--threads", o->threads,
                   "Threads of level bit, 0: as many as the machine has; the picture is the same")
      ->check(whole_between(0, 256))
      ->capture_default_str();
  command->get_option("--threads")->note(o->threads_given);
  command->get_option("--depth-test")->note(o->depth_test_given);
  Option* method = command->add_option(
      "--method", o->method, "Draw with a method of the gallery (halfspace methods lists them)");
  for (const char* other : {"--level", "--trace", "--depth-test", "--depth-clear", "--scissor",
                            "--cull", "--samples", "--threads"}) {
    method->excludes(command->get_option(other));  // the method has its own way
  }
  command->footer(
      "Without --eye the camera frames the scene by itself.\n"
      "Example: halfspace render tests/scenes/teapot.obj --size 640x480 --out out/teapot.png");
  return [o, gallery] { return run_render(*o, gallery); };
}

}  // namespace halfspace
