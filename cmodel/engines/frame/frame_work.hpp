// SPDX-License-Identifier: Apache-2.0
//
// Inside FrameEngine: the order of the steps, for one thread and for several.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "frame_engine.hpp"
#include "frame_piece.hpp"

namespace halfspace {

class FrameEngine::Work {
 public:
  Work(const FrameState& frame, const Config& config, const FrameOptions& options);

  void clear();
  void draw(std::span<const ShadedTriangle> triangles);
  void draw(const VertexSource& source, std::span<const TriangleIndices> triangles);

  PictureView picture();
  const FrameStore& store() const { return store_; }
  const RasterStats& stats() const { return stats_; }
  const GeometryStats& geometry() const { return geometry_sum_; }
  std::vector<std::uint8_t> hits() const;

 private:
  // Pieces of a round for each of several threads.
  static constexpr std::size_t kPiecesPerThread = 2;

  // What a draw consists of.
  struct Feed {
    std::size_t triangles = 0;
    // Fills a piece's assembly with the triangles first .. first + count - 1.
    std::function<void(std::size_t piece, std::size_t first, std::size_t count)> assemble;
    // How many of the source's vertices these triangles need, from the first on; checks indices.
    std::function<std::size_t(std::size_t first, std::size_t count)> vertices;
    const VertexSource* source = nullptr;  // null: no vertices
  };
  struct Round;  // frame_shared.cpp
  class Shared;  // frame_shared.cpp

  void check(std::span<const ShadedTriangle> triangles) const;
  void run(const Feed& feed);
  void draw_alone(const Feed& feed);
  void draw_shared(const Feed& feed);
  void assemble(const Feed& feed, std::size_t piece, std::size_t first, std::size_t count);
  void tell(FramePiece& piece) const;
  void draw_tiles(const FramePiece& piece, std::uint32_t band, std::size_t thread);
  void finish_shared();
  void add_counts();
  void add_geometry();

  FrameOptions options_;
  FrameConstants constants_;
  ProjectConstants project_;
  const simd::FrameKernels& kernels_;
  FrameStore store_;
  FrameBuckets::Grid grid_;  // bands: rows of tiles that one thread draws at a time
  RasterStats stats_;
  RasterStats setup_;  // already in stats_, of the engines' own counts
  GeometryStats geometry_sum_;
  bool drawing_ = false;  // also after a draw that threw
  std::vector<VertexRecord> records_;
  std::vector<FramePiece> pieces_;              // two rounds of them, or one piece for one thread
  std::vector<GeometryStage> plain_;            // one per piece
  std::vector<GeometryStats> geometry_;         // of what plain_ did not see
  std::vector<HitPlane> hits_;                  // one per thread
  std::vector<PassedTiles> passed_;             // one per thread
  std::vector<FrameCounts> counts_;             // one per thread
  std::vector<FrameBuckets::Scratch> scratch_;  // one per thread
};

}  // namespace halfspace
