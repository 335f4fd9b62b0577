// SPDX-License-Identifier: Apache-2.0
//
// halfspace bench: the engines side by side, as a table and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "bench/bench.hpp"
#include "bench/bumpy_torus.hpp"
#include "command.hpp"
#include "io/error.hpp"
#include "io/output_file.hpp"
#include "manners.hpp"

namespace halfspace {
namespace {

struct BenchRequest {
  BenchOptions options;
  std::string out;
  std::string mesh_out;
};

void check(const BenchRequest& request) {
  const BenchOptions& o = request.options;
  if (o.repetitions < 1 || o.repetitions > 1000) {
    throw Error(ErrorCode::kUsage, "--repetitions",
                fmt::format("{} is out of range (1..1000)", o.repetitions));
  }
  if (!(o.scale >= 1e-5 && o.scale <= 100)) {
    throw Error(ErrorCode::kUsage, "--scale",
                fmt::format("{} is out of range (0.00001..100)", o.scale));
  }
  for (const int threads : o.threads) {
    if (threads >= 1 && threads <= 1024) continue;
    throw Error(ErrorCode::kUsage, "--threads",
                fmt::format("{} is out of range (1..1024)", threads));
  }
}

int run(const BenchRequest& request) {
  check(request);
  if (!request.mesh_out.empty()) {
    write_bumpy_torus(request.mesh_out, kMillion * request.options.scale);
    return 0;
  }
  if (!request.out.empty()) check_writable(request.out);
  try {
    const Machine machine = this_machine();  // its load before there is ours
    const std::vector<BenchRow> rows = run_bench(request.options);
    fmt::print(talk({request.out}), "{}", bench_table(machine, rows));
    if (!request.out.empty()) {
      write_text(request.out, bench_json(machine, rows));
    }
  } catch (const BenchMismatch& mismatch) {
    fmt::print(stderr, "halfspace: bench: {}\n", mismatch.what());
    return 1;
  }
  return 0;
}

}  // namespace

Action add_bench_command(Command& program) {
  Command* command =
      program.add_subcommand("bench", "Time the engines on the same triangles, side by side");
  auto request = std::make_shared<BenchRequest>();
  BenchOptions& o = request->options;
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  if (cores > 1) o.threads.push_back(cores);
  command->add_option("--out", request->out, "JSON list of rows to write, each with the machine");
  command->add_option("--workload", o.workloads, "Workloads (default: all but the last four)")
      ->type_name("small|medium|large|fullscreen|sliver|teapot|bunny|million|quad|px32|px16|tile");
  command->add_option("--engine", o.engines, "Engines (default: all there are)")
      ->type_name("scalar|bit|coverage|cycle|rtl|llvmpipe");
  command->add_option("--isa", o.isas, "Instruction sets (default: all of the machine)");
  command->add_option("--threads", o.threads, "Thread counts of engines that use several")
      ->capture_default_str();
  command->add_option("--repetitions", o.repetitions, "Timed runs of each engine, in turn")
      ->capture_default_str();
  command->add_option("--scale", o.scale, "Of the triangles of every generated workload")
      ->capture_default_str();
  command->add_option("--scenes", o.scenes, "Folder of teapot.obj and bunny.obj")
      ->take_last()
      ->capture_default_str();
  Option* mesh_out = command->add_option("--mesh-out", request->mesh_out,
                                         "Write workload million's mesh as a PLY file and stop");
  command->stands_alone(mesh_out, {"--scale", "--scenes"});
  command->footer(
      "Times are in ns per triangle: CPU time of the thread, or wall time for several threads.\n"
      "Example: halfspace bench --workload small medium --engine scalar coverage --out bench.json");
  return [request] { return run(*request); };
}

}  // namespace halfspace
