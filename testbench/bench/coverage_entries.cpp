// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <span>

#include "engines/coverage/coverage_engine.hpp"
#include "engines/coverage/parallel_coverage.hpp"
#include "engines/cycle/cycle_engine.hpp"
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

BenchOutput output(const MaskSum& masks) { return {masks.samples, masks, {}, {}, {}}; }

// Calls flush(records) now and then, and at the end.
template <class Flush>
void run_scalar(const Workload& work, const Flush& flush) {
  std::vector<ScalarRecord> records;
  for (const Triangle& t : work.triangles) {
    scalar_cover(t, work.frame, kBenchConfig, records);
    if (records.size() < CoverageEngine::kChunkRecords) continue;
    flush(records);
    records.clear();
  }
  flush(records);
}

// Its counts are part of the work: without someone who keeps them the compiler drops some.
template <class Tile>
RasterStats run_bit(const Workload& work, const Tile& tile) {
  RasterStats stats;
  for (const Triangle& t : work.triangles) rasterize(t, work.frame, kBenchConfig, stats, tile);
  return stats;
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

void add_tile(MaskSum& masks, const CoverageTile& tile) {
  masks.add(static_cast<std::uint32_t>(tile.x) / 8, static_cast<std::uint32_t>(tile.y) / 8,
            tile.mask[0]);
}

BenchOutput count_coverage(const Workload& work, const std::string& isa, int threads) {
  MaskSum masks;
  cover(work, isa, threads, [&](const CoverageChunk& chunk) {
    for (std::size_t i = 0; i < chunk.triangle.size(); ++i) {
      for_each_tile(chunk, i, 0, [&](const CoverageTile& tile) { add_tile(masks, tile); });
    }
  });
  BenchOutput out = output(masks);
  RasterStats unused;
  out.hits =
      hits_parallel(work.triangles, work.frame, kBenchConfig, {threads, isa}, unused).count();
  return out;
}

// Instruction set "scalar" is CycleModel, the readable one that the others are held to.
template <class Sink>
std::uint64_t run_cycle(const Workload& work, const std::string& isa, const Sink& sink) {
  CycleEngine engine(work.frame, kBenchConfig, Stalls(), isa);
  engine.run(work.triangles, sink);
  return engine.clocks();
}

BenchOutput count_cycle(const Workload& work, const std::string& isa) {
  MaskSum masks;
  const std::uint64_t clocks = run_cycle(work, isa, [&](const CycleChunk& chunk) {
    for (std::size_t i = 0; i < chunk.place.size(); ++i) {
      masks.add(chunk.place[i] & 0xffff, chunk.place[i] >> 16, chunk.plane[0][i]);
    }
  });
  BenchOutput out = output(masks);
  out.clocks = clocks;
  return out;
}

}  // namespace

MaskSum scalar_masks(const Workload& work) {
  MaskSum masks;
  run_scalar(work, [&](const std::vector<ScalarRecord>& records) {
    for (const ScalarRecord& r : records) masks.add(r.place & 0xffff, r.place >> 16, r.mask);
  });
  return masks;
}

std::vector<BenchEntry> coverage_entries(const Workload& work, const BenchOptions& options) {
  std::vector<BenchEntry> entries;
  entries.push_back({coverage_row("scalar"), [&work] { run_scalar(work, [](const auto&) {}); },
                     [&work] { return output(scalar_masks(work)); }});
  if (!work.mesh) {
    const auto kept = std::make_shared<RasterStats>();
    entries.push_back({coverage_row("bit"),
                       [&work, kept] { *kept = run_bit(work, [](const CoverageTile&) {}); },
                       [&work] {
                         MaskSum masks;
                         run_bit(work, [&](const CoverageTile& tile) { add_tile(masks, tile); });
                         return output(masks);
                       }});
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
    entries.push_back({coverage_row("cycle", isa),
                       [&work, isa] { run_cycle(work, isa, [](const CycleChunk&) {}); },
                       [&work, isa] { return count_cycle(work, isa); }});
  }
  return entries;
}

}  // namespace halfspace
