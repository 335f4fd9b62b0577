// SPDX-License-Identifier: Apache-2.0
#include "ladder_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "engines/frame/frame_engine.hpp"
#include "hit_count.hpp"
#include "io/error.hpp"
#include "io/tcov.hpp"
#include "level_run.hpp"

namespace halfspace {
namespace {

constexpr int kRepetitions = 5;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Measured {
  double seconds = INFINITY;
  RunStats stats;
  std::uint32_t crc = 0;
};

Measured measure(Fidelity level, const std::vector<ShadedTriangle>& triangles,
                 const FrameState& frame, const Config& config) {
  Measured best;
  for (int n = 0; n < kRepetitions; ++n) {
    RunStats stats;
    HitCount hits(frame.width, frame.height);
    const double start = cpu_seconds();
    LevelRun run(level, frame, config, stats, {},
                 [&](const CoverageTile& tile) { hits.add(tile, config); });
    for (const ShadedTriangle& triangle : triangles) run.draw(triangle);
    run.finish();
    best.seconds = std::min(best.seconds, cpu_seconds() - start);
    best.stats = stats;
    best.crc = crc32_of(hits.count());
  }
  return best;
}

// Level bit as `halfspace render` computes it, on one thread: depth, colours and the picture too.
Measured measure_frame(const std::vector<ShadedTriangle>& triangles, const FrameState& frame,
                       const Config& config) {
  FrameOptions options;
  options.count_hits = true;
  FrameEngine engine(frame, config, options);
  Measured best;
  for (int n = 0; n < kRepetitions; ++n) {
    const double start = cpu_seconds();
    engine.clear();
    engine.draw(triangles);
    engine.picture();
    best.seconds = std::min(best.seconds, cpu_seconds() - start);
  }
  best.stats.raster = engine.stats();
  best.crc = crc32_of(engine.hits());
  return best;
}

}  // namespace

nlohmann::ordered_json ladder_chart(const SceneOptions& options) {
  const Config config;
  const std::unique_ptr<Scene> scene = options.open_one(config, Lighting::kGouraud);
  const FrameState frame = scene->frame(0, config);
  std::vector<ShadedTriangle> triangles;
  RunStats unused;
  scene->draw(0, frame, config, unused,
              [&](const ShadedTriangle& triangle) { triangles.push_back(triangle); });

  nlohmann::ordered_json json{{"chart", "ladder"},
                              {"scene", options.path},
                              {"width", frame.width},
                              {"height", frame.height},
                              {"triangles", triangles.size()}};
  const Measured bit = measure(Fidelity::kBit, triangles, frame, config);
  const Measured cycle = measure(Fidelity::kCycle, triangles, frame, config);
  std::optional<Measured> rtl;
  try {
    require_level(Fidelity::kRtl, config);
    rtl = measure(Fidelity::kRtl, triangles, frame, config);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kLevel) throw;
  }
  const auto row = [&](const char* level, const char* engine, const Measured& m,
                       const char* packets, const std::string& clocks) {
    nlohmann::ordered_json one{
        {"level", level},
        {"engine", engine},
        {"coverage", m.crc == bit.crc ? "exact" : "WRONG"},
        {"packets", packets},
        {"clocks", clocks},
        {"cpu_seconds", m.seconds},
        {"mpixels_per_cpu_second",
         1e-6 * static_cast<double>(m.stats.raster.samples_covered) / m.seconds}};
    if (m.stats.cycles) {
      one["cycles"] = *m.stats.cycles;
      one["mclocks_per_cpu_second"] = 1e-6 * static_cast<double>(*m.stats.cycles) / m.seconds;
    }
    json["levels"].push_back(std::move(one));
  };
  std::string cycle_clocks = fmt::format("{}", *cycle.stats.cycles);
  if (rtl) {
    const auto off = static_cast<std::int64_t>(*cycle.stats.cycles - *rtl->stats.cycles);
    cycle_clocks += fmt::format(", {} off", off);
  }
  row("coverage", "coverage engine", measure(Fidelity::kCoverage, triangles, frame, config), "no",
      "no");
  row("bit", "frame engine", measure_frame(triangles, frame, config), "no", "no");
  row("bit", "plain stages", bit, "every one", "no");
  row("cycle", "cycle engine", cycle, "every one", cycle_clocks);
  if (rtl) {
    row("rtl", "Verilator", *rtl, "every one", fmt::format("{}", *rtl->stats.cycles));
  } else {
    json["levels"].push_back({{"level", "rtl"},
                              {"engine", "Verilator"},
                              {"coverage", "exact"},
                              {"packets", "every one"},
                              {"clocks", "by definition"}});
  }
  return json;
}

}  // namespace halfspace
