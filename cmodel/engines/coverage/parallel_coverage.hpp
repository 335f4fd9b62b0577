// SPDX-License-Identifier: Apache-2.0
//
// Level coverage on several threads (TBB). Its own library: the core needs no threads.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "coverage_engine.hpp"
#include "hit_plane.hpp"

namespace halfspace {

struct ParallelOptions {
  int threads = 0;       // 0: as many as the machine has
  std::string_view isa;  // as CoverageEngine
};

// CoverageEngine::cover() on several threads. sink is called by one thread at a time, with the
// chunks in triangle order: the same chunks, byte for byte, for any number of threads.
simd::KernelCounts cover_parallel(std::span<const Triangle> triangles, const FrameState& frame,
                                  const Config& config, const ParallelOptions& options,
                                  const std::function<void(const CoverageChunk&)>& sink);

// The hit counts of all triangles; the same for any number of threads. stats: added to, as
// count_records() and count_triangles().
HitPlane hits_parallel(std::span<const Triangle> triangles, const FrameState& frame,
                       const Config& config, const ParallelOptions& options, RasterStats& stats);

}  // namespace halfspace
