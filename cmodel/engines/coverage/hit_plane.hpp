// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "coverage_chunk.hpp"

namespace halfspace {

// How many triangles cover each pixel, from records: the counts of HitCount, faster. With several
// samples a triangle counts once for a pixel when it covers any of them; counts stop at 255.
class HitPlane {
 public:
  // 1..2^15 a side.
  HitPlane(int width, int height);

  // Adds every record of a chunk. They must come from an engine for a frame of this size.
  void add(const CoverageChunk& chunk);

  // Adds another plane of the same size. The order of additions does not matter: every count is
  // the least of 255 and the true number.
  void add(const HitPlane& other);

  // Row by row from the top, as HitCount::count().
  std::vector<std::uint8_t> count() const;

 private:
  void add_row(std::size_t at, std::uint64_t hits);

  std::size_t width_;
  std::size_t height_;
  std::size_t stride_;               // width in whole tiles, and eight bytes
  std::vector<std::uint8_t> count_;  // height in whole tiles
};

}  // namespace halfspace
