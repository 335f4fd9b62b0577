// SPDX-License-Identifier: Apache-2.0
//
// Google Benchmark at the micro level: ns per setup (triangles that cover nothing), per window (one
// 32 px window each, setup included), per strip of eight rows, per tile of triangles of 200 px
// (setup included), per record added to hit counts.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "engines/coverage/coverage_engine.hpp"
#include "engines/coverage/hit_plane.hpp"
#include "vectors/generators.hpp"
#include "workload.hpp"

namespace halfspace {
namespace {

constexpr FrameState kFrame{1024, 1024, Cull::kNone};

// n copies of a triangle given in pixels.
std::vector<Triangle> copies(std::size_t n, std::array<double, 6> px) {
  Triangle t;
  for (std::size_t i = 0; i < 3; ++i) {
    t.vertex[i] = snap_px(px[2 * i], px[2 * i + 1], kBenchConfig);
  }
  return std::vector<Triangle>(n, t);
}

// The time of one item, for an iteration that does `items` of them.
void report(benchmark::State& state, std::size_t items) {
  using benchmark::Counter;
  state.counters["one"] =
      Counter(static_cast<double>(items), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void cover(benchmark::State& state, std::string_view isa, const std::vector<Triangle>& triangles,
           std::size_t items) {
  CoverageEngine engine(kFrame, kBenchConfig, isa);
  for (auto _ : state) {
    engine.cover(triangles,
                 [](const CoverageChunk& chunk) { benchmark::DoNotOptimize(chunk.place.data()); });
  }
  report(state, items);
}

void setup(benchmark::State& state, std::string_view isa) {
  cover(state, isa, copies(4096, {-30, 10, -10, 15, -20, 30}), 4096);  // left of the frame
}

void window(benchmark::State& state, std::string_view isa) {
  cover(state, isa, copies(4096, {8.3, 8.2, 15.7, 9.1, 10.2, 15.6}), 4096);  // one tile
}

void strip(benchmark::State& state, std::string_view isa) {
  cover(state, isa, copies(64, {10, 0, 1000, 0, 500, 1024}), 64 * 128);
}

void tile(benchmark::State& state, std::string_view isa) {
  const std::vector<Triangle> triangles = bench_triangles("medium", 0.01);
  RasterStats stats;
  CoverageEngine(kFrame, kBenchConfig, isa).cover(triangles, [&](const CoverageChunk& chunk) {
    count_records(chunk, stats);
  });
  cover(state, isa, triangles, stats.tiles_covered);
}

void hits(benchmark::State& state, std::string_view isa) {
  CoverageEngine engine(kFrame, kBenchConfig, isa);
  const std::vector<Triangle> triangles = bench_triangles("medium", 0.005);
  engine.fill(triangles, 0);
  const CoverageChunk chunk = engine.chunk();
  HitPlane plane(kFrame.width, kFrame.height);
  for (auto _ : state) plane.add(chunk);
  report(state, chunk.records());
}

}  // namespace
}  // namespace halfspace

int main(int argc, char** argv) {
  for (const std::string_view isa : halfspace::coverage_isas()) {
    const std::string name(isa);
    benchmark::RegisterBenchmark(("setup/" + name).c_str(), halfspace::setup, isa);
    benchmark::RegisterBenchmark(("window/" + name).c_str(), halfspace::window, isa);
    benchmark::RegisterBenchmark(("tile/" + name).c_str(), halfspace::tile, isa);
    benchmark::RegisterBenchmark(("strip/" + name).c_str(), halfspace::strip, isa);
  }
  benchmark::RegisterBenchmark("hit_plane", halfspace::hits, halfspace::coverage_isas().front());
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
