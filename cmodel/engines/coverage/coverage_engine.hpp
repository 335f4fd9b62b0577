// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "../../config.hpp"
#include "../../packets.hpp"
#include "../../rasterizer.hpp"
#include "coverage_chunk.hpp"
#include "coverage_kernel.hpp"
#include "coverage_path.hpp"

namespace halfspace {

// Instruction sets this machine can run, the best first, by the names CoverageEngine takes.
std::vector<std::string_view> coverage_isas();

// Level coverage for many triangles: the masks of level bit, by SIMD.
//
//   frame   as triangle_setup()
//   config  any legal configuration
//   isa     one of coverage_isas(); empty: the best
//
// Same set of (x, y, masks) per triangle as rasterize(), always, on every instruction set and in
// the same order of triangles. Runs of full tiles are one record. Keeps buffers, no other state:
// one engine per thread. Method and proofs: docs/03_design/coverage_engine.md.
class CoverageEngine {
 public:
  CoverageEngine(const FrameState& frame, const Config& config, std::string_view isa = {});

  // Calls sink(const CoverageChunk&) with the records of all triangles, in order. Vertices must be
  // legal (checked, as in triangle_setup()).
  template <class Sink>
  void cover(std::span<const Triangle> triangles, Sink&& sink) {
    for (std::size_t done = 0; done < triangles.size();) {
      done += fill(triangles, done);
      sink(chunk());
    }
  }

  // Records after which a chunk is handed out: small enough to stay in the second-level cache.
  static constexpr std::size_t kChunkRecords = 1 << 13;

  // The same in steps: covers triangles from `first` on until the chunk has `enough` records or
  // none are left, and returns how many. chunk() is theirs until the next call.
  std::size_t fill(std::span<const Triangle> triangles, std::size_t first,
                   std::size_t enough = kChunkRecords);
  CoverageChunk chunk() const;

  // Sums over everything covered: triangles and why they were dropped.
  const simd::KernelCounts& counts() const { return counts_; }
  std::string_view isa() const { return kernel_.isa; }

 private:
  void split_tiles();

  Config config_;
  simd::KernelFrame frame_;
  simd::CoverageKernels kernel_;
  simd::KernelCounts counts_;
  RecordBuffer buffer_;
  RecordBuffer small_;  // the same in 4x4 tiles, when the grid is 4
};

// Adds a chunk's covered tiles and samples to the counts that rasterize() keeps. tiles_covered
// counts every tile of a run.
void count_records(const CoverageChunk& chunk, RasterStats& stats);

// Adds setup's counts.
void count_triangles(const simd::KernelCounts& counts, RasterStats& stats);

}  // namespace halfspace
