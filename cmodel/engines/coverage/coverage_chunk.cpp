// SPDX-License-Identifier: Apache-2.0
#include "coverage_chunk.hpp"

#include <algorithm>

namespace halfspace {

void RecordBuffer::reserve(std::size_t records) {
  if (!place.empty() && records <= capacity()) return;
  const std::size_t size = std::max(records, 2 * place.size()) + kSlack;
  std::vector<std::uint64_t> moved(static_cast<std::size_t>(samples) * size);
  for (std::size_t m = 0; m < static_cast<std::size_t>(samples); ++m) {
    std::copy_n(mask(m), count, moved.data() + m * size);
  }
  masks.swap(moved);
  place.resize(size);
}

void RecordBuffer::reserve_triangles(std::size_t triangles) {
  if (triangles + kSlack <= triangle.size()) return;
  const std::size_t size = std::max(triangles, 2 * triangle.size()) + kSlack;
  triangle.resize(size);
  end.resize(size);
}

CoverageChunk RecordBuffer::chunk(int grid_log2) const {
  CoverageChunk out;
  out.triangle = {triangle.data(), triangle_count};
  out.end = {end.data(), triangle_count};
  out.place = {place.data(), count};
  for (std::size_t m = 0; m < static_cast<std::size_t>(samples); ++m) {
    out.plane[m] = mask(m);
  }
  out.samples = samples;
  out.grid_log2 = grid_log2;
  return out;
}

}  // namespace halfspace
