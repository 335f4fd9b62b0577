// SPDX-License-Identifier: Apache-2.0
#include "coverage_kernel.hpp"
#include "coverage_walk.hpp"

namespace halfspace::simd {
namespace {

// Appends one tile.
void append(const CoverageTile& tile, RecordBuffer& buffer) {
  buffer.reserve(buffer.count + 1);
  for (std::size_t m = 0; m < static_cast<std::size_t>(buffer.samples); ++m) {
    buffer.mask(m)[buffer.count] = tile.mask[m];
  }
  buffer.place[buffer.count] =
      static_cast<std::uint32_t>(tile.y) << 13 | static_cast<std::uint32_t>(tile.x) >> 3;
  ++buffer.count;
}

}  // namespace

std::size_t cover_scalar(const KernelFrame& frame, std::span<const Triangle> triangles,
                         std::uint32_t first, std::size_t enough, RecordBuffer& buffer,
                         KernelCounts& counts) {
  std::size_t done = 0;
  RasterStats stats;
  for (; done < triangles.size() && buffer.count < enough; ++done) {
    const std::uint64_t drawn_before = stats.triangles - stats.triangles_zero_area -
                                       stats.triangles_culled - stats.triangles_no_sample;
    cover(triangles[done], frame.state, frame.config, stats,
          [&buffer](const CoverageTile& tile) { append(tile, buffer); });
    const std::uint64_t drawn = stats.triangles - stats.triangles_zero_area -
                                stats.triangles_culled - stats.triangles_no_sample;
    buffer.reserve_triangles(buffer.triangle_count + 1);
    buffer.triangle[buffer.triangle_count] = first + static_cast<std::uint32_t>(done);
    buffer.end[buffer.triangle_count] = static_cast<std::uint32_t>(buffer.count);
    buffer.triangle_count += drawn != drawn_before;
  }
  counts.triangles += stats.triangles;
  counts.zero_area += stats.triangles_zero_area;
  counts.culled += stats.triangles_culled;
  counts.no_sample += stats.triangles_no_sample;
  return done;
}

}  // namespace halfspace::simd
