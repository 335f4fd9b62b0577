// SPDX-License-Identifier: Apache-2.0
//
// Times the engines on the same triangles, side by side. What each row means: docs/02_use/bench.md.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "machine.hpp"

namespace halfspace {

// One line of the result. Times are nanoseconds per triangle over `repetitions` runs; the rates and
// ns_per_triangle come from the median.
struct BenchRow {
  std::string workload;
  std::string size;       // of the frame, "1024x1024" px
  std::string work;       // "coverage": masks; "frame": a whole picture
  std::string engine;     // scalar, bit, coverage, cycle, rtl, llvmpipe
  std::string isa = "-";  // instruction set; "-" for an engine that has but one form
  int threads = 1;
  std::string time;  // "thread": CPU time of the thread; "wall"
  std::uint64_t triangles = 0;
  double ns_per_triangle = 0;
  double mpixels_per_s = 0;  // covered samples, millions
  double tiles_per_s = 0;    // 8x8 tiles with a covered sample
  std::uint64_t covered_samples = 0;
  std::optional<std::uint64_t> clocks;  // engines cycle and rtl: simulated
  // Whole pictures of llvmpipe against engine bit's: pixels with a channel that is more than one
  // level of 255 off, and the largest difference.
  std::optional<std::uint64_t> pixels_off;
  std::optional<int> largest_difference;
  int repetitions = 0;
  double min = 0;
  double median = 0;
  double max = 0;
};

struct BenchOptions {
  std::vector<std::string> workloads;   // empty: bench_workloads()
  std::vector<std::string> engines;     // empty: all that are there
  std::vector<std::string> isas;        // empty: all of the machine
  std::vector<int> threads = {1};       // of engines that use several
  int repetitions = 5;                  // interleaved: every engine runs once before any again
  double scale = 1;                     // of the number of triangles of every generated workload
  std::string scenes = "tests/scenes";  // folder of teapot.obj and bunny.obj
};

// Two engines that should agree do not: the figures would compare different work.
class BenchMismatch : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// small, medium, large, fullscreen, sliver, teapot, bunny, million: what runs when nothing is
// asked for; and further ones, for engines cycle and rtl.
std::vector<std::string> bench_workloads();
std::vector<std::string> more_bench_workloads();
std::vector<std::string> bench_engines();

// Throws Error for an unknown name (kUsage), an engine that this build or machine does not have
// (kLevel, kEngine), an instruction set that it does not have (kIsa), a scene that cannot be read;
// BenchMismatch when two engines found different samples, tiles, clocks or pictures.
std::vector<BenchRow> run_bench(const BenchOptions& options);

// The machine in a line, and the rows as an aligned table, each with its speed against the row that
// it is to be measured by: scalar for coverage, rtl for cycle, llvmpipe for frames; "-" where that
// was not run.
std::string bench_table(const Machine& machine, const std::vector<BenchRow>& rows);

// The rows as a JSON list; each names the machine.
std::string bench_json(const Machine& machine, const std::vector<BenchRow>& rows);

}  // namespace halfspace
