// SPDX-License-Identifier: Apache-2.0
#include "frame_piece.hpp"

#include <algorithm>

#include "frame_planes.hpp"

namespace halfspace {

FramePiece::FramePiece(const FrameState& frame, const Config& config,
                       const simd::FrameKernels& kernels)
    : kernels_(kernels), engine_(frame, config, kernels.isa) {}

void FramePiece::cover(const FrameConstants& constants, const std::vector<VertexRecord>& records,
                       std::size_t enough, const FrameBuckets::Grid& grid,
                       FrameBuckets::Scratch& scratch) {
  done_ += engine_.fill({assembly_.triangle.data(), assembly_.count}, done_, enough);
  const CoverageChunk chunk = engine_.chunk();
  list_triangles(chunk, records);
  list_records(chunk);
  make_planes(constants);
  tiles_.count = chunk.records();
  tiles_.place = chunk.place.data();
  tiles_.mask = chunk.plane;
  tiles_.triangle = record_triangle_.data();
  tiles_.depth = depth_.data();
  tiles_.depth_delta = depth_delta_.data();
  buckets_.clear();
  if (constants.samples == 1 && kernels_.buckets != nullptr &&
      buckets_.fill(tiles_, constants, grid, scratch)) {
    return;
  }
  sort_records(grid);
}

// Triangles with a record, as positions in the chunk.
void FramePiece::list_triangles(const CoverageChunk& chunk,
                                const std::vector<VertexRecord>& records) {
  const std::size_t most = chunk.triangle.size();
  if (visible_.size() < most) {
    visible_.resize(2 * most);
    triangle_.resize(2 * most);
    depth_.resize(2 * most);
  }
  count_ = 0;
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < most; ++i) {
    visible_[count_] = static_cast<std::uint32_t>(i);
    count_ += chunk.end[i] != begin;
    begin = chunk.end[i];
  }
  const auto record = [&](std::uint32_t corner) {
    return (corner & Assembly::kExtra) == 0 ? &records[corner]
                                            : &assembly_.extra[corner & ~Assembly::kExtra];
  };
  for (std::size_t k = 0; k < count_; ++k) {
    const TriangleIndices& corner = assembly_.corner[chunk.triangle[visible_[k]]];
    triangle_[k] = frame_triangle(record(corner[0]), record(corner[1]), record(corner[2]));
  }
}

void FramePiece::list_records(const CoverageChunk& chunk) {
  constexpr std::size_t kAtOnce = 4;  // most triangles have no more records: no loop
  if (record_triangle_.size() < chunk.records() + kAtOnce) {
    record_triangle_.resize(2 * chunk.records() + kAtOnce);
  }
  std::uint32_t* to = record_triangle_.data();
  for (std::uint32_t k = 0; k < count_; ++k) {
    std::size_t r = chunk.begin_of(visible_[k]);
    const std::size_t end = chunk.end[visible_[k]];
    for (std::size_t i = 0; i < kAtOnce; ++i) to[r + i] = k;
    for (r += kAtOnce; r < end; ++r) to[r] = k;
  }
}

void FramePiece::make_planes(const FrameConstants& constants) {
  kernels_.planes(constants, triangle_.data(), count_, depth_.data());
  const auto samples = static_cast<std::size_t>(constants.samples);
  if (samples == 1) return;
  if (depth_delta_.size() < count_ * samples) depth_delta_.resize(2 * count_ * samples);
  for (std::size_t k = 0; k < count_; ++k) {
    for (std::size_t m = 0; m < samples; ++m) {
      depth_delta_[k * samples + m] =
          frame_delta(depth_[k].dx, depth_[k].dy, static_cast<int>(m), constants);
    }
  }
}

void FramePiece::sort_records(const FrameBuckets::Grid& grid) {
  of_band_.resize(grid.bands());
  for (std::vector<std::uint32_t>& list : of_band_) list.clear();
  if (grid.bands() == 1) return;
  for (std::size_t r = 0; r < tiles_.count; ++r) {
    const std::uint32_t row = RecordPlace{tiles_.place[r]}.tile_y();
    of_band_[row / grid.band].push_back(static_cast<std::uint32_t>(r));
  }
}

simd::RecordOrder FramePiece::order(std::uint32_t band) const {
  if (of_band_.size() == 1) return {nullptr, tiles_.count};
  return {of_band_[band].data(), of_band_[band].size()};
}

simd::RecordOrder FramePiece::take(simd::RecordOrder& rest, std::size_t enough) const {
  simd::RecordOrder out = rest;
  std::size_t tiles = 0;
  for (out.count = 0; out.count < rest.count && tiles < enough; ++out.count) {
    const std::size_t record = rest.at(out.count);
    tiles += RecordPlace{tiles_.place[record]}.is_run() ? tiles_.mask[0][record] : 1;
  }
  if (rest.record != nullptr) rest.record += out.count;
  rest.first += out.count;
  rest.count -= out.count;
  return out;
}

}  // namespace halfspace
