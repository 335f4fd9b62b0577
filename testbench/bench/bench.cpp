// SPDX-License-Identifier: Apache-2.0
#include "bench.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <ctime>

#include "agreement.hpp"
#include "engines/coverage/coverage_engine.hpp"
#include "entry.hpp"
#include "io/error.hpp"
#include "scene/progress.hpp"

namespace halfspace {
namespace {

#ifdef HALFSPACE_HAS_OSMESA
constexpr bool kHasOsmesa = true;
#else
constexpr bool kHasOsmesa = false;
#endif

// Empty when llvmpipe can be timed, else why not.
std::string no_llvmpipe() {
  if constexpr (kHasOsmesa) {
    return llvmpipe_absent();
  } else {
    return "this build has no llvmpipe (install libosmesa6-dev and configure again)";
  }
}

bool has(const std::vector<std::string>& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

bool wanted(const BenchOptions& options, std::string_view engine) {
  return options.engines.empty() || has(options.engines, engine);
}

// ns, from any start.
double now(const std::string& time) {
  if (time == "thread") {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
  }
  const auto wall = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<double>(std::chrono::duration_cast<std::chrono::nanoseconds>(wall).count());
}

void check_names(const BenchOptions& options) {
  std::vector<std::string> workloads = bench_workloads();
  for (const std::string& more : more_bench_workloads()) workloads.push_back(more);
  for (const std::string& name : options.workloads) {
    if (has(workloads, name)) continue;
    throw Error(ErrorCode::kUsage, "--workload",
                fmt::format("'{:.40}' is not one of {}", name, fmt::join(workloads, ", ")));
  }
  const std::vector<std::string> engines = bench_engines();
  for (const std::string& name : options.engines) {
    if (!has(engines, name)) {
      throw Error(ErrorCode::kUsage, "--engine",
                  fmt::format("'{:.40}' is not one of {}", name, fmt::join(engines, ", ")));
    }
    if (name == "rtl") build_bench_rtl();
    if (name == "llvmpipe" && !no_llvmpipe().empty()) {
      throw Error(ErrorCode::kEngine, "--engine llvmpipe", no_llvmpipe());
    }
  }
}

void check_isas(const BenchOptions& options) {
  const std::vector<std::string_view> there_are = coverage_isas();
  for (const std::string& isa : options.isas) {
    if (std::find(there_are.begin(), there_are.end(), isa) != there_are.end()) continue;
    throw Error(ErrorCode::kIsa, "--isa",
                fmt::format("'{:.40}' is not an instruction set of this machine and build ({})",
                            isa, fmt::join(there_are, ", ")));
  }
}

std::vector<BenchEntry> entries_of(const Workload& work, const BenchOptions& options) {
  std::vector<BenchEntry> out;
  const auto add = [&](std::vector<BenchEntry> more) {
    for (BenchEntry& entry : more) {
      if (wanted(options, entry.row.engine)) out.push_back(std::move(entry));
    }
  };
  add(coverage_entries(work, options));
  if (wanted(options, "rtl")) add(rtl_entries(work));
  if (work.mesh) add(frame_entries(work, options));
  if constexpr (kHasOsmesa) {
    if (wanted(options, "llvmpipe")) {
      add(work.mesh ? llvmpipe_frame_entries(work) : llvmpipe_coverage_entries(work));
    }
  }
  return out;
}

void finish(BenchRow& row, std::vector<double>& times, const Agreement& found) {
  std::sort(times.begin(), times.end());
  row.repetitions = static_cast<int>(times.size());
  row.min = times.front();
  row.median = row.ns_per_triangle = times[times.size() / 2];
  row.max = times.back();
  const double total = row.median * static_cast<double>(row.triangles);  // ns
  row.mpixels_per_s = 1e3 * static_cast<double>(row.covered_samples) / total;
  row.tiles_per_s = 1e9 * found.tiles() / total;
}

void bench_workload(const Workload& work, const BenchOptions& options,
                    std::vector<BenchRow>& rows) {
  std::vector<BenchEntry> entries = entries_of(work, options);
  const auto runs = static_cast<std::uint64_t>(options.repetitions) + 1;
  Progress progress(fmt::format("timing {} {}x{}", work.name, work.frame.width, work.frame.height),
                    entries.size() * runs);
  Agreement found(work.name, scalar_masks(work));
  for (BenchEntry& entry : entries) {
    entry.row.workload = work.name;
    entry.row.size = fmt::format("{}x{}", work.frame.width, work.frame.height);
    entry.row.time = entry.row.threads > 1 ? "wall" : "thread";
    entry.row.triangles = work.mesh ? work.mesh->triangles.size() : work.triangles.size();
    found.check(entry.row, entry.count());
    progress.step();
  }
  std::vector<std::vector<double>> times(entries.size());
  for (int repetition = 0; repetition < options.repetitions; ++repetition) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const double start = now(entries[i].row.time);
      entries[i].run();
      const double took = now(entries[i].row.time) - start;
      times[i].push_back(took / static_cast<double>(entries[i].row.triangles));
      progress.step();
    }
  }
  for (std::size_t i = 0; i < entries.size(); ++i) {
    finish(entries[i].row, times[i], found);
    rows.push_back(entries[i].row);
  }
}

bool is_scene(std::string_view name) {
  return name == "teapot" || name == "bunny" || name == "million";
}

}  // namespace

std::vector<std::string> bench_workloads() {
  return {"small", "medium", "large", "fullscreen", "sliver", "teapot", "bunny", "million"};
}

std::vector<std::string> more_bench_workloads() { return {"quad", "px32", "px16", "tile"}; }

std::vector<std::string> bench_engines() {
  return {"scalar", "bit", "coverage", "cycle", "rtl", "llvmpipe"};
}

std::vector<std::string> wanted_isas(const BenchOptions& options,
                                     const std::vector<std::string_view>& there_are) {
  std::vector<std::string> out;
  for (const std::string_view isa : there_are) {
    if (options.isas.empty() || has(options.isas, isa)) out.emplace_back(isa);
  }
  return out;
}

std::vector<BenchRow> run_bench(const BenchOptions& options) {
  check_names(options);
  check_isas(options);
  std::vector<BenchRow> rows;
  for (const std::string& name :
       options.workloads.empty() ? bench_workloads() : options.workloads) {
    if (!is_scene(name)) {
      bench_workload(make_workload(name, options.scale), options, rows);
      continue;
    }
    for (const auto& [width, height] : {std::pair{640, 480}, std::pair{1920, 1080}}) {
      bench_workload(make_scene_workload(name, width, height, options.scenes, options.scale),
                     options, rows);
    }
  }
  if (rows.empty()) throw BenchMismatch("nothing was compared: no engine of those runs on that");
  return rows;
}

}  // namespace halfspace
