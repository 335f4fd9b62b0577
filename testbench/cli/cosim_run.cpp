// SPDX-License-Identifier: Apache-2.0
//
// halfspace cosim.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "io/config_json.hpp"
#include "io/error.hpp"
#include "io/output_file.hpp"
#include "io/trace_formats.hpp"
#include "manners.hpp"
#include "rtl/cosim.hpp"
#include "rtl/link.hpp"
#include "rtl/rtl_trace.hpp"
#include "rtl_link.hpp"
#include "scene/progress.hpp"
#include "scene/scene.hpp"
#include "scene_options.hpp"
#include "wave_file.hpp"

namespace halfspace {
namespace {

// Clocks of waves before and after the first difference.
constexpr std::uint64_t kWavesBefore = 64;
constexpr std::uint64_t kWavesAfter = 16;

struct Frame {
  std::size_t index = 0;
  FrameState state;
  std::vector<Triangle> triangles;
};

struct Totals {
  std::uint64_t frames = 0;
  std::uint64_t skipped = 0;
  std::uint64_t packets = 0;
  std::uint64_t tiles = 0;
  std::uint64_t clocks = 0;
  RasterStats stats;
  GeometryStats geometry;
  std::vector<std::uint64_t> busy;
  double model_seconds = 0;
  double rtl_seconds = 0;

  void add(const CosimResult& result) {
    ++frames;
    packets += result.packets_compared;
    tiles += result.tiles_compared;
    clocks += result.clocks;
    stats += result.stats;
    busy.resize(result.busy.size());
    for (std::size_t i = 0; i < busy.size(); ++i) busy[i] += result.busy[i];
    model_seconds += result.model_seconds;
    rtl_seconds += result.rtl_seconds;
  }
};

double ratio(std::uint64_t a, std::uint64_t b) {
  return b == 0 ? 0.0 : static_cast<double>(a) / static_cast<double>(b);
}

nlohmann::ordered_json report(const CosimRequest& request, const Config& config, const Totals& t,
                              const std::optional<Mismatch>& mismatch, double wall) {
  nlohmann::ordered_json json;
  json["command"] = "cosim";
  json["identical"] = !mismatch.has_value();
  if (mismatch) json["mismatch"] = mismatch->line();
  json["stall"] = request.stall;
  json["seed"] = request.seed;
  json["cases"] = t.frames;
  json["cases_skipped"] = t.skipped;
  json["triangles"] = t.stats.triangles;
  json["triangles_culled"] =
      t.stats.triangles_zero_area + t.stats.triangles_culled + t.stats.triangles_no_sample;
  json["tiles_visited"] = t.stats.tiles_visited;
  json["tiles_covered"] = t.stats.tiles_covered;
  json["samples_tested"] = t.stats.samples_tested;
  json["samples_covered"] = t.stats.samples_covered;
  json["fragments"] = t.stats.fragments;
  json["cycles"] = t.clocks;
  json["packets_compared"] = t.packets;
  json["tiles_compared"] = t.tiles;
  json["pixels_per_clock"] = ratio(t.stats.fragments, t.clocks);
  json["clocks_per_covered_tile"] = ratio(t.clocks, t.stats.tiles_covered);
  json["sample_test_efficiency"] = ratio(t.stats.samples_covered, t.stats.samples_tested);
  nlohmann::ordered_json use;
  const std::vector<Link> all = links(config);
  for (std::size_t i = 0; i < t.busy.size(); ++i)
    use[stage_of(all[i])] = ratio(t.busy[i], t.clocks);
  json["utilisation"] = use;
  json["model_clocks_per_second"] = static_cast<double>(t.clocks) / std::max(t.model_seconds, 1e-9);
  json["rtl_clocks_per_second"] = static_cast<double>(t.clocks) / std::max(t.rtl_seconds, 1e-9);
  json["wall_seconds"] = wall;
  json["simulate_seconds"] = t.model_seconds + t.rtl_seconds;
  json["config"] = config_json(config);
  return json;
}

// Runs the frame again with waves around the difference; the name of the file.
std::string write_waves(const Frame& frame, const Config& config, const CosimOptions& options,
                        const Mismatch& mismatch) {
  const bool has_out = std::filesystem::is_directory("out");
  const std::string path = has_out ? "out/mismatch.fst" : "mismatch.fst";
  CosimOptions traced = options;
  WaveFile waves(path);
  traced.trace = waves.temporary();
  traced.trace_from = mismatch.clock > kWavesBefore ? mismatch.clock - kWavesBefore : 0;
  traced.trace_to = mismatch.clock + kWavesAfter;
  RtlRasterizer rtl(config, true, "cosim");
  cosim(rtl, frame.triangles, frame.state, config, traced);
  waves.commit();
  write_save_file(path, config, mismatch.clock > kWavesBefore ? mismatch.clock - kWavesBefore : 0);
  return path;
}

std::string replay_command(const CosimRequest& request, const Scene& scene, std::size_t index) {
  std::string command =
      fmt::format("halfspace cosim {} --config {}", request.in, request.config.name);
  if (!request.format.empty()) command += " --format " + request.format;
  if (request.stall > 0) {
    command += fmt::format(" --stall {} --seed {}", request.stall, request.seed);
  }
  if (request.config.samples != 0) command += fmt::format(" --samples {}", request.config.samples);
  if (!request.size.empty()) command += " --size " + request.size;
  if (request.cull != "none") command += " --cull " + request.cull;
  command += request.camera.text();
  if (request.views != 1) command += fmt::format(" --orbit {}", request.views);
  const int id = scene.case_id(index);
  if (id >= 0) command += fmt::format(" --case {}", id);
  return command + " --trace waves.fst";
}

// Waves are cosim()'s own to write; traces of handshakes take a run of each side.
bool is_wave_file(const std::string& path) { return path.ends_with(".fst"); }

void check_trace(const std::string& path, std::size_t frames) {
  if (path.empty()) return;
  if (!is_wave_file(path) && !is_trace_file(path)) {
    throw Error(ErrorCode::kUsage, "--trace",
                fmt::format("'{}' does not end in .json, .kanata.gz or .fst", path));
  }
  if (frames > 1) {
    throw Error(ErrorCode::kUsage, "--trace",
                fmt::format("the file has {} cases: choose one with --case", frames));
  }
  check_writable(path);
}

void write_traces(OutputGroup& outputs, const std::string& path, RtlRasterizer& rtl,
                  const Frame& frame, const Config& config, const Stalls& stalls) {
  write_trace(outputs.open(model_trace_path(path)),
              trace_model(frame.triangles, frame.state, config, stalls));
  try {
    const TraceLog log = trace_rtl(rtl, frame.triangles, frame.state, stalls);
    write_trace(outputs.open(path), log);
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& error) {  // an RTL that differs from the model may do anything
    fmt::print(stderr, "halfspace: note: no trace of the RTL: {}\n", error.what());
  }
}

// The frame's triangles; false when a TCOV case does not fit the configuration.
bool load_frame(const Scene& scene, const CosimRequest& request, const Config& config, Frame& frame,
                Totals& totals) {
  RunStats stats;
  try {
    frame.state = scene.frame(frame.index, config);
    frame.state.cull = parse_cull(request.cull);
    scene.draw(frame.index, frame.state, config, stats, [&](const ShadedTriangle& triangle) {
      frame.triangles.push_back(triangle.triangle);
    });
  } catch (const Error& error) {
    const bool misfit = error.code() == ErrorCode::kTcovRange || error.code() == ErrorCode::kSize ||
                        error.code() == ErrorCode::kFitRange;
    if (!misfit || scene.frames() == 1) throw;
    ++totals.skipped;
    return false;
  }
  return true;
}

std::unique_ptr<Scene> open_checked(const CosimRequest& request, const Config& config) {
  std::vector<std::string> outputs{request.stats, request.trace};
  if (is_trace_file(request.trace)) outputs.push_back(model_trace_path(request.trace));
  const std::string in = scene_file(request.in, request.format);
  check_distinct(outputs);
  if (!request.stats.empty()) check_writable(request.stats);
  if (request.seed_given && request.stall == 0) {
    say_no_effect("--seed", "it is that of the stalls, and --stall is 0");
  }
  if (is_tcov(in)) say_no_camera(request.size, request.camera, request.views);
  std::unique_ptr<Scene> scene =
      noted(open_scene(in, request.case_id, frame_size(request.size, config),
                       request.camera.options(), Lighting::kGouraud, request.views),
            request.in);
  check_trace(request.trace, scene->frames());
  return scene;
}

// What there is to say; the exit status.
int say_result(const CosimRequest& request, const Totals& totals,
               const std::optional<Mismatch>& mismatch) {
  if (mismatch) return 1;
  if (totals.packets == 0) {
    fmt::print(stderr, "halfspace: nothing was compared: no triangle reached the rasterizer\n");
    return 1;
  }
  fmt::print(talk({request.stats}),
             "identical in bits and clocks: {} triangles, {} tiles, {} packets in {} clocks\n",
             totals.stats.triangles, totals.tiles, totals.packets, totals.clocks);
  return 0;
}

}  // namespace

int run_cosim(const CosimRequest& request) {
  const auto start = std::chrono::steady_clock::now();
  if (!(request.stall >= 0 && request.stall <= 0.95)) {
    throw Error(ErrorCode::kUsage, "--stall",
                fmt::format("{} is out of range (0..0.95)", request.stall));
  }
  const Config config = request.config.load();
  const std::unique_ptr<Scene> scene = open_checked(request, config);
  const bool has_waves = is_wave_file(request.trace);
  std::unique_ptr<RtlRasterizer> rtl;
  try {
    rtl = std::make_unique<RtlRasterizer>(config, has_waves, "cosim");
  } catch (const RtlDrift& drift) {
    fmt::print(stderr, "halfspace: mismatch: {}\n", drift.line());
    return 1;
  }

  Totals totals;
  OutputGroup outputs;
  std::optional<WaveFile> waves;
  if (has_waves) waves.emplace(request.trace);
  std::optional<Mismatch> mismatch;
  for (std::size_t i = 0; i < scene->frames() && !mismatch; ++i) {
    Frame frame{.index = i, .state = {}, .triangles = {}};
    if (!load_frame(*scene, request, config, frame, totals)) continue;
    Progress progress("comparing triangles", frame.triangles.size());
    std::uint64_t shown = 0;
    CosimOptions options{.stalls = Stalls(request.stall, request.seed + i),
                         .trace = waves ? waves->temporary() : std::string(),
                         .progress = [&](std::uint64_t done) {
                           progress.advance(done - shown);
                           shown = done;
                         }};
    const CosimResult result = cosim(*rtl, frame.triangles, frame.state, config, options);
    totals.add(result);
    if (is_trace_file(request.trace)) {
      write_traces(outputs, request.trace, *rtl, frame, config, options.stalls);
    }
    if (!result.mismatch) continue;
    mismatch = result.mismatch;
    options.progress = nullptr;
    const std::string around = write_waves(frame, config, options, *mismatch);
    fmt::print(stderr, "halfspace: {}; replay: {}; waves: {}\n", mismatch->line(),
               replay_command(request, *scene, i), around);
  }
  if (totals.skipped != 0) {
    fmt::print(stderr, "halfspace: note: {} cases do not fit the configuration: skipped\n",
               totals.skipped);
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  if (!request.stats.empty()) {
    outputs.open(request.stats)
        .write(report(request, config, totals, mismatch, wall.count()).dump(2) + "\n");
  }
  const int status = say_result(request, totals, mismatch);
  if (waves) waves->finish();
  const InterruptsHeld held;  // all or none
  outputs.commit();
  if (waves) waves->commit();
  return status;
}

}  // namespace halfspace
