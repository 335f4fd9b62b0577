// SPDX-License-Identifier: Apache-2.0
#include "coverage_bench.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "batch/coverage_engine.hpp"
#include "batch/parallel_coverage.hpp"
#include "generators.hpp"
#include "scalar_loop.hpp"

namespace halfspace {
namespace {

// CPU time of this thread, ns.
double thread_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

double wall_time() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<double>(std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
}

// What one run over a workload found.
struct Output {
  std::uint64_t samples = 0;
  std::uint64_t tiles = 0;
};

// One engine on one workload: a timed run, and an untimed one that counts its output.
struct Entry {
  BenchRow row;
  std::function<void()> run;
  std::function<Output()> count;
  std::vector<double> times;
};

double uniform(Random& random, double low, double high) {
  return low + (high - low) * std::ldexp(static_cast<double>(random.next() >> 11), -53);
}

// Vertices anywhere in a square of `side` px, itself anywhere in the frame.
Triangle in_square(Random& random, double side) {
  const double x = uniform(random, 0, kBenchFrame.width - side);
  const double y = uniform(random, 0, kBenchFrame.height - side);
  Triangle t;
  for (Point& p : t.vertex) {
    const double px = uniform(random, x, x + side);
    p = snap_px(px, uniform(random, y, y + side), kBenchConfig);
  }
  return t;
}

// Nearly equilateral, radius about 430 px, turned at random, whole in the frame.
Triangle large(Random& random) {
  const double turn = uniform(random, 0, 2 * std::numbers::pi);
  const double radius = uniform(random, 415, 445);
  const double x = uniform(random, 462, 562);
  const double y = uniform(random, 462, 562);
  Triangle t;
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = turn + 2 * std::numbers::pi / 3 * static_cast<double>(i);
    t.vertex[i] = snap_px(x + radius * std::cos(angle), y + radius * std::sin(angle), kBenchConfig);
  }
  return t;
}

Triangle full_screen(Random& random) {
  Triangle t;
  const double out = -uniform(random, 0, 1);
  t.vertex = {snap_px(out, out, kBenchConfig),
              snap_px(2100 + uniform(random, 0, 1), out, kBenchConfig),
              snap_px(out, 2100 + uniform(random, 0, 1), kBenchConfig)};
  return t;
}

// 330 px long and 1.6 px wide at the middle, in any direction.
Triangle sliver(Random& random) {
  const double turn = uniform(random, 0, 2 * std::numbers::pi);
  const double x = uniform(random, 332, 692);
  const double y = uniform(random, 332, 692);
  const double dx = std::cos(turn);
  const double dy = std::sin(turn);
  Triangle t;
  t.vertex = {snap_px(x, y, kBenchConfig), snap_px(x + 330 * dx, y + 330 * dy, kBenchConfig),
              snap_px(x + 165 * dx - 1.6 * dy, y + 165 * dy + 1.6 * dx, kBenchConfig)};
  return t;
}

Output count_output(const CoverageChunk& chunk) {
  RasterStats stats;
  count_records(chunk, stats);
  return {stats.samples_covered, stats.tiles_covered};
}

Entry scalar_entry(std::span<const Triangle> triangles) {
  const auto cover = [triangles] {
    std::vector<ScalarRecord> records;
    Output out;
    for (const Triangle& t : triangles) {
      out.samples += scalar_cover(t, kBenchFrame, kBenchConfig, records);
      if (records.size() < CoverageEngine::kChunkRecords) continue;
      out.tiles += records.size();
      records.clear();
    }
    out.tiles += records.size();
    return out;
  };
  Entry entry;
  entry.row.engine = "scalar";
  entry.row.isa = "-";
  entry.run = [cover] { cover(); };
  entry.count = cover;
  return entry;
}

Entry bit_entry(std::span<const Triangle> triangles) {
  const auto cover = [triangles] {
    RasterStats stats;
    for (const Triangle& t : triangles) {
      rasterize(t, kBenchFrame, kBenchConfig, stats, [](const CoverageTile&) {});
    }
    return Output{stats.samples_covered, stats.tiles_covered};
  };
  Entry entry;
  entry.row.engine = "bit";
  entry.row.isa = "-";
  entry.run = [cover] { cover(); };
  entry.count = cover;
  return entry;
}

Entry coverage_entry(std::span<const Triangle> triangles, const std::string& isa, int threads) {
  const auto cover = [triangles, isa, threads](const auto& sink) {
    if (threads > 1) {
      cover_parallel(triangles, kBenchFrame, kBenchConfig, {threads, isa}, sink);
    } else {
      CoverageEngine engine(kBenchFrame, kBenchConfig, isa);
      engine.cover(triangles, sink);
    }
  };
  Entry entry;
  entry.row.engine = "coverage";
  entry.row.isa = isa;
  entry.row.threads = threads;
  entry.run = [cover] { cover([](const CoverageChunk&) {}); };
  entry.count = [cover] {
    Output sum;
    cover([&sum](const CoverageChunk& chunk) {
      const Output out = count_output(chunk);
      sum.samples += out.samples;
      sum.tiles += out.tiles;
    });
    return sum;
  };
  return entry;
}

std::vector<BenchRow> bench_workload(const std::string& workload, const BenchOptions& options,
                                     const std::vector<std::string>& isas) {
  const std::vector<Triangle> triangles = bench_triangles(workload, options.scale);
  std::vector<Entry> entries;
  entries.push_back(scalar_entry(triangles));
  if (options.bit) entries.push_back(bit_entry(triangles));
  for (const std::string& isa : isas) {
    for (const int threads : options.threads) {
      entries.push_back(coverage_entry(triangles, isa, threads));
    }
  }
  for (int repetition = 0; repetition < options.repetitions; ++repetition) {
    for (Entry& entry : entries) {
      const auto clock = entry.row.threads > 1 ? wall_time : thread_time;
      const double start = clock();
      entry.run();
      entry.times.push_back((clock() - start) / static_cast<double>(triangles.size()));
    }
  }
  std::vector<BenchRow> rows;
  for (Entry& entry : entries) {
    const Output out = entry.count();
    BenchRow row = entry.row;
    std::sort(entry.times.begin(), entry.times.end());
    row.workload = workload;
    row.repetitions = options.repetitions;
    row.min = entry.times.front();
    row.median = row.ns_per_triangle = entry.times[entry.times.size() / 2];
    row.max = entry.times.back();
    const double total = row.median * static_cast<double>(triangles.size());  // ns
    row.mpixels_per_s = 1e3 * static_cast<double>(out.samples) / total;
    row.tiles_per_s = 1e9 * static_cast<double>(out.tiles) / total;
    row.covered_samples = out.samples;
    if (!rows.empty() && rows.front().covered_samples != out.samples) {
      throw std::runtime_error("engine " + row.engine + " " + row.isa + " covers " +
                               std::to_string(out.samples) + " samples of " + workload +
                               ", scalar " + std::to_string(rows.front().covered_samples));
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::vector<std::string> bench_workloads() {
  return {"small", "medium", "large", "fullscreen", "sliver"};
}

std::vector<Triangle> bench_triangles(std::string_view workload, double scale) {
  struct Kind {
    double count;
    std::function<Triangle(Random&)> make;
  };
  // The mean area of a triangle in a unit square is 11/144.
  const std::map<std::string_view, Kind> kinds{
      {"small", {1e6, [](Random& r) { return in_square(r, std::sqrt(10 * 144.0 / 11)); }}},
      {"medium", {1e5, [](Random& r) { return in_square(r, std::sqrt(200 * 144.0 / 11)); }}},
      {"large", {500, large}},
      {"fullscreen", {200, full_screen}},
      {"sliver", {10000, sliver}}};
  const auto kind = kinds.find(workload);
  if (kind == kinds.end()) {
    throw std::runtime_error("no such workload: " + std::string(workload));
  }
  Random random(0x5eed);
  std::vector<Triangle> triangles;
  const auto count = static_cast<std::size_t>(std::max(1.0, kind->second.count * scale));
  while (triangles.size() < count) triangles.push_back(kind->second.make(random));
  return triangles;
}

std::vector<BenchRow> run_coverage_bench(const BenchOptions& options) {
  std::vector<std::string> isas = options.isas;
  if (isas.empty()) {
    for (const std::string_view isa : coverage_isas()) isas.emplace_back(isa);
  }
  std::vector<BenchRow> rows;
  for (const std::string& workload :
       options.workloads.empty() ? bench_workloads() : options.workloads) {
    const std::vector<BenchRow> more = bench_workload(workload, options, isas);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

std::string bench_table(const std::vector<BenchRow>& rows) {
  std::map<std::string, double> scalar;
  for (const BenchRow& row : rows) {
    if (row.engine == "scalar") scalar[row.workload] = row.median;
  }
  std::string table =
      "workload    engine    isa      threads   ns/triangle        min        max     Mpx/s"
      "    Mtiles/s  x scalar\n";
  for (const BenchRow& row : rows) {
    char line[160];
    std::snprintf(
        line, sizeof line, "%-11s %-9s %-8s %7d %13.2f %10.2f %10.2f %9.0f %11.2f %9.1f\n",
        row.workload.c_str(), row.engine.c_str(), row.isa.c_str(), row.threads, row.median, row.min,
        row.max, row.mpixels_per_s, row.tiles_per_s / 1e6, scalar[row.workload] / row.median);
    table += line;
  }
  return table;
}

}  // namespace halfspace
