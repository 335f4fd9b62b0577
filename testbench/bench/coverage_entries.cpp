// SPDX-License-Identifier: Apache-2.0
#include <span>

#include "batch/coverage_engine.hpp"
#include "batch/cycle_engine.hpp"
#include "batch/parallel_coverage.hpp"
#include "entry.hpp"
#include "scalar_loop.hpp"

namespace halfspace {
namespace {

BenchRow coverage_row(const char* engine, std::string isa = "-", int threads = 1) {
  BenchRow row;
  row.work = "coverage";
  row.engine = engine;
  row.isa = std::move(isa);
  row.threads = threads;
  return row;
}

// An entry whose timed run counts as it goes.
BenchEntry counting(BenchRow row, std::function<BenchOutput()> cover) {
  return {std::move(row), [cover] { cover(); }, cover};
}

BenchOutput run_scalar(const Workload& work) {
  std::vector<ScalarRecord> records;
  BenchOutput out;
  std::uint64_t tiles = 0;
  for (const Triangle& t : work.triangles) {
    out.samples += scalar_cover(t, work.frame, kBenchConfig, records);
    if (records.size() < CoverageEngine::kChunkRecords) continue;
    tiles += records.size();
    records.clear();
  }
  out.tiles = tiles + records.size();
  return out;
}

BenchOutput run_bit(const Workload& work) {
  RasterStats stats;
  for (const Triangle& t : work.triangles) {
    rasterize(t, work.frame, kBenchConfig, stats, [](const CoverageTile&) {});
  }
  return {stats.samples_covered, stats.tiles_covered, {}, {}, {}};
}

template <class Sink>
void cover(const Workload& work, const std::string& isa, int threads, const Sink& sink) {
  if (threads > 1) {
    cover_parallel(work.triangles, work.frame, kBenchConfig, {threads, isa}, sink);
  } else {
    CoverageEngine engine(work.frame, kBenchConfig, isa);
    engine.cover(work.triangles, sink);
  }
}

BenchOutput count_coverage(const Workload& work, const std::string& isa, int threads) {
  RasterStats stats;
  cover(work, isa, threads, [&](const CoverageChunk& chunk) { count_records(chunk, stats); });
  RasterStats unused;
  const HitPlane hits =
      hits_parallel(work.triangles, work.frame, kBenchConfig, {threads, isa}, unused);
  return {stats.samples_covered, stats.tiles_covered, {}, {}, hits.count()};
}

// Instruction set "scalar" is CycleModel, the readable one that the others are held to.
BenchOutput run_cycle(const Workload& work, const std::string& isa) {
  CycleEngine engine(work.frame, kBenchConfig, Stalls(), isa);
  engine.run(work.triangles, [](const CycleChunk&) {});
  return {engine.stats().samples_covered, engine.stats().tiles_covered, engine.clocks(), {}, {}};
}

}  // namespace

std::uint64_t scalar_samples(const Workload& work) { return run_scalar(work).samples; }

std::vector<BenchEntry> coverage_entries(const Workload& work, const BenchOptions& options) {
  std::vector<BenchEntry> entries;
  entries.push_back(counting(coverage_row("scalar"), [&work] { return run_scalar(work); }));
  if (!work.mesh) {
    entries.push_back(counting(coverage_row("bit"), [&work] { return run_bit(work); }));
  }
  for (const std::string& isa : wanted_isas(options, coverage_isas())) {
    for (const int threads : options.threads) {
      entries.push_back(
          {coverage_row("coverage", isa, threads),
           [&work, isa, threads] { cover(work, isa, threads, [](const CoverageChunk&) {}); },
           [&work, isa, threads] { return count_coverage(work, isa, threads); }});
    }
  }
  for (const std::string& isa : wanted_isas(options, cycle_isas())) {
    entries.push_back(
        counting(coverage_row("cycle", isa), [&work, isa] { return run_cycle(work, isa); }));
  }
  return entries;
}

}  // namespace halfspace
