// SPDX-License-Identifier: Apache-2.0
//
// coverage_bench: the coverage engines side by side, as a table and, with --out, as JSON.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>

#include "coverage_bench.hpp"
#include "io/error.hpp"
#include "io/output_file.hpp"

namespace {

void write_json(const std::string& path, const std::vector<halfspace::BenchRow>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const halfspace::BenchRow& row : rows) {
    list.push_back({{"workload", row.workload},
                    {"engine", row.engine},
                    {"isa", row.isa},
                    {"threads", row.threads},
                    {"ns_per_triangle", row.ns_per_triangle},
                    {"mpixels_per_s", row.mpixels_per_s},
                    {"tiles_per_s", row.tiles_per_s},
                    {"covered_samples", row.covered_samples},
                    {"repetitions", row.repetitions},
                    {"min", row.min},
                    {"median", row.median},
                    {"max", row.max}});
  }
  halfspace::OutputFile file(path);
  file.write(list.dump(1) + "\n");
  file.commit();
}

}  // namespace

int main(int argc, char** argv) {
  halfspace::BenchOptions options;
  std::string out;
  bool no_bit = false;
  CLI::App program{"Coverage engines on the same triangles: ns per triangle and ratios"};
  program.add_option("WORKLOAD", options.workloads, "small, medium, large, fullscreen, sliver");
  program.add_option("--out", out, "JSON list of rows to write");
  program.add_option("--isa", options.isas, "Instruction sets (default: all of the machine)");
  program.add_option("--threads", options.threads, "Thread counts of engine coverage")
      ->capture_default_str();
  program.add_option("--repetitions", options.repetitions, "Interleaved runs of each engine")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  program.add_option("--scale", options.scale, "Of every workload's number of triangles")
      ->check(CLI::Range(1e-4, 100.0))
      ->capture_default_str();
  program.add_flag("--no-bit", no_bit, "Leave level bit out");
  try {
    program.parse(argc, argv);
    options.bit = !no_bit;
    if (!out.empty()) halfspace::check_writable(out);
    const std::vector<halfspace::BenchRow> rows = halfspace::run_coverage_bench(options);
    std::fputs(halfspace::bench_table(rows).c_str(), stdout);
    if (!out.empty()) write_json(out, rows);
  } catch (const CLI::CallForHelp& help) {
    return program.exit(help);
  } catch (const halfspace::Error& error) {
    std::fprintf(stderr, "halfspace: error[HS%03d]: %s\n", static_cast<int>(error.code()),
                 error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "halfspace: error[HS001]: %s\n", error.what());
    return 2;
  }
  return 0;
}
