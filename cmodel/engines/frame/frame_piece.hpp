// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "../coverage/coverage_engine.hpp"
#include "../coverage/hit_plane.hpp"
#include "frame_buckets.hpp"
#include "frame_geometry.hpp"
#include "frame_kernel.hpp"
#include "frame_records.hpp"

namespace halfspace {

// Some triangles of a draw, up to the depth test: coverage and depth planes. Pieces know nothing of
// each other, so threads may prepare several at a time. Keeps its buffers between uses.
class FramePiece {
 public:
  FramePiece(const FrameState& frame, const Config& config, const simd::FrameKernels& kernels);

  // Triangles to cover: fill this, then call start().
  Assembly& assembly() { return assembly_; }
  void start() { done_ = 0; }
  bool finished() const { return done_ == assembly_.count; }

  // Covers the next triangles, until there are `enough` records or no more triangles.
  //
  //   records  of the mesh, for corners that are not the assembly's own
  //   grid     of the frame's tiles; what is found is sorted by its bands
  //   scratch  for the sorting
  void cover(const FrameConstants& constants, const std::vector<VertexRecord>& records,
             std::size_t enough, const FrameBuckets::Grid& grid, FrameBuckets::Scratch& scratch);

  // What the last cover() found.
  const FrameTiles& tiles() const { return tiles_; }
  const FrameTriangle* triangles() const { return triangle_.data(); }
  std::size_t triangle_count() const { return count_; }
  // Sorted by tile or, where that is not done, by band only.
  const FrameBuckets& buckets() const { return buckets_; }
  simd::RecordOrder order(std::uint32_t band) const;
  // The first of `rest`, until they are `enough` tiles, a run counted by its length; takes them
  // off.
  simd::RecordOrder take(simd::RecordOrder& rest, std::size_t enough) const;
  CoverageChunk chunk() const { return engine_.chunk(); }
  const simd::KernelCounts& counts() const { return engine_.counts(); }

 private:
  void list_triangles(const CoverageChunk& chunk, const std::vector<VertexRecord>& records);
  void list_records(const CoverageChunk& chunk);
  void make_planes(const FrameConstants& constants);
  void sort_records(const FrameBuckets::Grid& grid);

  const simd::FrameKernels& kernels_;
  CoverageEngine engine_;
  Assembly assembly_;
  std::size_t done_ = 0;
  FrameTiles tiles_;
  std::size_t count_ = 0;  // triangles with records
  std::vector<std::uint32_t> visible_;
  std::vector<FrameTriangle> triangle_;
  std::vector<FramePlane> depth_;
  std::vector<std::uint32_t> depth_delta_;
  std::vector<std::uint32_t> record_triangle_;
  FrameBuckets buckets_;
  std::vector<std::vector<std::uint32_t>> of_band_;  // records of each band, in order
};

}  // namespace halfspace
