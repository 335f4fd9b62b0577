// SPDX-License-Identifier: Apache-2.0
//
// halfspace coverage: triangles of a TCOV file in, hit counts of every pixel out.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>

#include "auto_level.hpp"
#include "command.hpp"
#include "io/error.hpp"
#include "io/input_files.hpp"
#include "io/output_file.hpp"
#include "io/stats_json.hpp"
#include "io/tcov.hpp"
#include "level_run.hpp"
#include "scene/progress.hpp"
#include "scene_file.hpp"

namespace halfspace {
namespace {

using WallClock = std::chrono::steady_clock;

struct CoverageOptions {
  std::string in;
  std::string format;  // of standard input, which needs none
  std::string out;
  std::string stats;
  std::string level = "bit";
  std::string cull = "none";
  ConfigOptions config;
};

// The case with its hit counts computed.
TcovCase run_case(const TcovCase& source, Fidelity level, Cull cull, const Config& config,
                  const std::string& place, RunStats& stats) {
  const TcovTriangles input = tcov_triangles(source, config, place);
  const FrameState frame{source.width, source.height, cull};
  HitCount hits(frame.width, frame.height);
  LevelRun run(level, frame, config, stats, {},
               [&](const CoverageTile& tile) { hits.add(tile, config); });
  const WallClock::time_point start = WallClock::now();
  for (const Triangle& triangle : input.triangles) run.draw({triangle, {}});
  stats.simulate_seconds += std::chrono::duration<double>(WallClock::now() - start).count();
  run.finish();
  stats.resnapped += input.resnapped;
  stats.geometry.triangles_in += input.triangles.size();
  stats.crc = crc32_of(hits.count(), stats.crc);
  ++stats.cases;
  TcovCase out = source;
  out.hits = hits.count();
  return out;
}

int run_coverage(const CoverageOptions& options) {
  const WallClock::time_point start = WallClock::now();
  const std::optional<Fidelity> chosen_level = parse_level(options.level);
  const bool automatic = !chosen_level;
  const Fidelity level = chosen_level.value_or(Fidelity::kCoverage);
  const Cull cull = parse_cull(options.cull);
  const Config config = options.config.load();
  require_level(level, config);
  if (!options.format.empty() && options.format != "tcov") {
    throw Error(ErrorCode::kUsage, "--format", "only TCOV files are read here");
  }
  const bool from_input = options.in == kStandardStream;
  const std::string in = scene_file(options.in, from_input ? "tcov" : options.format);
  check_distinct({options.out, options.stats});
  check_writable(options.out);
  if (!options.stats.empty()) check_writable(options.stats);
  const std::vector<TcovCase> cases = read_tcov(in, {.max_size = config.max_size(), .hits = true});
  if (cases.empty()) throw Error(ErrorCode::kScene, options.in, "has no cases");

  RunStats stats;
  stats.command = "coverage";
  stats.level = options.level;
  std::vector<TcovCase> results;
  {
    Progress progress("covering cases", cases.size());
    for (const TcovCase& source : cases) {
      if (automatic) {
        add_prediction(tcov_triangles(source, config, in).triangles,
                       {source.width, source.height, cull}, config, stats);
      }
      results.push_back(run_case(source, level, cull, config, in, stats));
      progress.advance();
    }
  }
  if (stats.resnapped != 0) {
    fmt::print(stderr,
               "halfspace: note: {} coordinates are finer than 1/{} px and were snapped again\n",
               stats.resnapped, 1 << config.subpixel_bits);
  }
  OutputGroup outputs;
  write_tcov(outputs.open(options.out), results);
  stats.wall_seconds = std::chrono::duration<double>(WallClock::now() - start).count();
  if (!options.stats.empty()) write_stats(outputs.open(options.stats), stats, config);
  outputs.commit();
  return exit_status(stats);
}

}  // namespace

Action add_coverage_command(Command& program) {
  Command* command =
      program.add_subcommand("coverage", "Compute the hit counts of a TCOV file's triangles");
  auto options = std::make_shared<CoverageOptions>();
  command->add_option("IN", options->in, "TCOV file (coordinates in 1/256 px); -: standard input")
      ->required();
  command->add_option("--format", options->format, "Format of standard input")->type_name("tcov");
  command->add_option("--out", options->out, "TCOV file to write; -: standard output")->required();
  command->add_option("--stats", options->stats, "JSON statistics to write");
  add_level_option(*command, options->level);
  add_cull_option(*command, options->cull);
  options->config.add_to(*command);
  command->footer("Example: halfspace coverage tests/data/public.tcov --out out/public.tcov");
  return [options] { return run_coverage(*options); };
}

}  // namespace halfspace
