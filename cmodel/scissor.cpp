// SPDX-License-Identifier: Apache-2.0
#include "scissor.hpp"

#include <algorithm>

namespace halfspace {
namespace {

// Bits first..last of a grid's row or column, cut to 0..grid - 1.
std::uint64_t span(std::int32_t first, std::int32_t last, int grid) {
  first = std::max(first, 0);
  last = std::min(last, grid - 1);
  if (first > last) return 0;
  return ((std::uint64_t{2} << last) - 1) & ~((std::uint64_t{1} << first) - 1);
}

}  // namespace

GridMask scissor_lanes(const Box& box, std::int32_t x, std::int32_t y, int grid_log2) {
  const int grid = 1 << grid_log2;
  const std::uint64_t columns = span(box.x_first - x, box.x_last - x, grid);
  const std::uint64_t rows = span(box.y_first - y, box.y_last - y, grid);
  GridMask out = 0;
  for (int j = 0; j < grid; ++j) {
    if ((rows >> j & 1) != 0) out |= columns << (j * grid);
  }
  return out;
}

std::optional<CoverageTile> scissor(const CoverageTile& tile, const Box& box,
                                    const Config& config) {
  const GridMask open = scissor_lanes(box, tile.x, tile.y, config.grid_log2);
  CoverageTile out = tile;
  GridMask any = 0;
  for (GridMask& mask : out.mask) {
    mask &= open;
    any |= mask;
  }
  if (any == 0) return std::nullopt;
  return out;
}

}  // namespace halfspace
