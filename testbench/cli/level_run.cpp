// SPDX-License-Identifier: Apache-2.0
#include "level_run.hpp"

#include <chrono>
#include <utility>

#include "rtl_link.hpp"

namespace halfspace {
namespace {

// Triangles that the batch engines take together.
constexpr std::size_t kBatchTriangles = 1024;

// What the cycle engine tells its listener, passed on to LevelRun's callbacks.
struct Forward {
  static constexpr bool kWantsSetup = true;
  static constexpr bool kWantsNodes = false;

  const std::vector<ShadedTriangle>& triangles;
  const LevelRun::Begin& begin;
  const LevelRun::Tile& to;
  std::size_t accepted_count = 0;

  void accepted(Timing::Clock) { ++accepted_count; }
  void setup(Timing::Clock, const SetupTriangle& packet) const {
    if (begin) begin(triangles[accepted_count - 1], packet);
  }
  void node(int, Timing::Clock, const Node&) const {}
  void tile(Timing::Clock, const CoverageTile& packet) const { to(packet); }
};

std::vector<Triangle> positions(const std::vector<ShadedTriangle>& shaded) {
  std::vector<Triangle> out;
  out.reserve(shaded.size());
  for (const ShadedTriangle& triangle : shaded) out.push_back(triangle.triangle);
  return out;
}

}  // namespace

LevelRun::LevelRun(Fidelity level, const FrameState& frame, const Config& config, RunStats& stats,
                   Begin begin, Tile tile)
    : level_(level),
      frame_(frame),
      config_(config),
      stats_(stats),
      begin_(std::move(begin)),
      tile_(std::move(tile)),
      coverage_(frame, config),
      cycle_(frame, config, Stalls()) {}

void LevelRun::draw(const ShadedTriangle& triangle) {
  switch (level_) {
    case Fidelity::kBit: draw_bit(triangle); break;
    case Fidelity::kCoverage:
    case Fidelity::kCycle:
      waiting_.push_back(triangle);
      if (waiting_.size() == kBatchTriangles) flush();
      break;
    case Fidelity::kRtl: waiting_.push_back(triangle); break;
  }
}

void LevelRun::draw_bit(const ShadedTriangle& triangle) {
  rasterize(
      triangle.triangle, frame_, config_, stats_.raster,
      [&](const SetupTriangle& setup) {
        if (begin_) begin_(triangle, setup);
      },
      [](const Node&, int, bool) {}, tile_);
}

void LevelRun::flush() {
  if (level_ == Fidelity::kCycle) {
    cycle_.draw(positions(waiting_), Forward{waiting_, begin_, tile_});
  } else {
    flush_coverage();
  }
  waiting_.clear();
}

void LevelRun::flush_coverage() {
  const std::vector<Triangle> triangles = positions(waiting_);
  coverage_.cover(triangles, [&](const CoverageChunk& chunk) {
    count_records(chunk, covered_);
    for (std::size_t i = 0; i < chunk.triangle.size(); ++i) {
      for_each_tile(chunk, i, triangles[chunk.triangle[i]].tag, tile_);
    }
  });
}

void LevelRun::finish() {
  const auto start = std::chrono::steady_clock::now();
  if (level_ == Fidelity::kCoverage) {
    flush();
    count_triangles(coverage_.counts(), covered_);
    // The engine computes crossings, not tests: what it looked at is what it found.
    covered_.tiles_visited = covered_.tiles_covered;
    covered_.samples_tested =
        covered_.tiles_covered * static_cast<std::uint64_t>(config_.lanes() * config_.samples);
    stats_.raster += covered_;
  }
  if (level_ == Fidelity::kCycle) {
    flush();
    stats_.raster += cycle_.stats();
    stats_.cycles = stats_.cycles.value_or(0) + cycle_.clocks();
  }
  if (level_ == Fidelity::kRtl) finish_rtl();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  stats_.simulate_seconds += took.count();
}

void LevelRun::finish_rtl() {
  const std::vector<Triangle> triangles = positions(waiting_);
  // Tiles come in the order of the triangles, so a tag that changes names a later triangle.
  const std::uint64_t mask = (std::uint64_t{1} << config_.tag_bits) - 1;
  std::uint64_t current = 0;
  bool begun = false;
  const auto tile = [&](const CoverageTile& covered) {
    std::uint64_t index = (current & ~mask) | covered.tag;
    if (index < current) index += mask + 1;
    if (begin_ && (!begun || index != current)) {
      begin_(waiting_[index], *triangle_setup(triangles[index], frame_, config_));
    }
    begun = true;
    current = index;
    count_tile(covered, stats_.raster);
    tile_(covered);
  };
  const std::uint64_t clocks = rasterize_rtl(triangles, frame_, config_, tile);
  stats_.cycles = stats_.cycles.value_or(0) + clocks;
  // The ports do not show what was tested and dropped: that is the model's to say.
  RasterStats counted;
  for (const Triangle& triangle : triangles) {
    rasterize(triangle, frame_, config_, counted, [](const CoverageTile&) {});
  }
  counted.tiles_covered = counted.samples_covered = counted.fragments = 0;  // counted above
  stats_.raster += counted;
}

}  // namespace halfspace
