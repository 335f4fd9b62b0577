// SPDX-License-Identifier: Apache-2.0
//
// Times the coverage engines on the same triangles, side by side.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// One line of the result. Times are nanoseconds per triangle over `repetitions` runs; rates and
// ns_per_triangle come from the median.
struct BenchRow {
  std::string workload;
  std::string engine;  // scalar, bit, coverage
  std::string isa;     // of engine coverage, else "-"
  int threads = 1;
  double ns_per_triangle = 0;
  double mpixels_per_s = 0;
  double tiles_per_s = 0;
  std::uint64_t covered_samples = 0;  // equal for every engine on a workload, or the run stops
  int repetitions = 0;
  double min = 0;
  double median = 0;
  double max = 0;
};

struct BenchOptions {
  std::vector<std::string> workloads;  // empty: all of bench_workloads()
  std::vector<std::string> isas;       // empty: all of coverage_isas()
  std::vector<int> threads = {1};      // of engine coverage
  int repetitions = 5;                 // interleaved: every engine runs once before any again
  double scale = 1;                    // of every workload's number of triangles
  bool bit = true;                     // also time level bit
};

// small (~10 px), medium (~200 px), large (~240,000 px), fullscreen, sliver (~260 px, 330 px long).
std::vector<std::string> bench_workloads();

// A workload's triangles: in a 1024 x 1024 frame, 8 subpixel bits, the same on every machine.
std::vector<Triangle> bench_triangles(std::string_view workload, double scale = 1);
inline constexpr FrameState kBenchFrame{1024, 1024, Cull::kNone};
inline constexpr Config kBenchConfig = kFull;

// One thread: CPU time of that thread. More: wall time, because the point is how soon it is done.
// Throws std::runtime_error when two engines cover different numbers of samples.
std::vector<BenchRow> run_coverage_bench(const BenchOptions& options);

// The rows as an aligned table, each with its speed against engine scalar on the same workload.
std::string bench_table(const std::vector<BenchRow>& rows);

}  // namespace halfspace
