// SPDX-License-Identifier: Apache-2.0
#include "half_plane_grid.hpp"

#include <algorithm>

#include "fixed.hpp"

namespace halfspace {
namespace {

// Lanes one after the other, in the narrowest type that holds lane_bits(). Grid is a constant so
// that the compiler unrolls a row.
template <int Grid, class Lane>
GridMask signs(Lane base, Lane a, Lane b) {
  GridMask mask = 0;
  for (int j = 0; j < Grid; ++j) {
    Lane e = static_cast<Lane>(base + b * static_cast<Lane>(j));
    unsigned row = 0;
    for (int i = 0; i < Grid; ++i) {
      row |= static_cast<unsigned>(e >= 0) << i;
      e = static_cast<Lane>(e + a);
    }
    mask |= GridMask{row} << (j * Grid);
  }
  return mask;
}

// Bits first..last of a row or column of the grid, cut to it; empty when they are outside.
constexpr unsigned range_bits(int first, int last, int grid) {
  first = std::max(first, 0);
  last = std::min(last, grid - 1);
  return first > last ? 0u : ((2u << last) - (1u << first));
}

}  // namespace

GridMask half_plane_grid(std::int64_t base, EdgeSlope slope, const Config& config) {
  HS_CHECK(fits(base, config.lane_bits()));
  // Lanes change monotonically along rows and columns, so the corners bound them all.
  const std::int64_t last = config.grid() - 1;
  HS_CHECK(fits(base + slope.a * last, config.lane_bits()));
  HS_CHECK(fits(base + slope.b * last, config.lane_bits()));
  HS_CHECK(fits(base + slope.a * last + slope.b * last, config.lane_bits()));
  if (config.lane_bits() > 31) {  // one past the last lane is computed too
    return config.grid_log2 == 3 ? signs<8, std::int64_t>(base, slope.a, slope.b)
                                 : signs<4, std::int64_t>(base, slope.a, slope.b);
  }
  const auto narrow = static_cast<std::int32_t>(base);
  return config.grid_log2 == 3 ? signs<8, std::int32_t>(narrow, slope.a, slope.b)
                               : signs<4, std::int32_t>(narrow, slope.a, slope.b);
}

GridMask box_mask(std::int32_t x, std::int32_t y, int child_log2, const Box& box,
                  const Config& config) {
  const int grid = config.grid();
  const auto lane = [child_log2](std::int32_t pixel, std::int32_t origin) {
    return static_cast<int>(floor_shift(pixel - origin, child_log2));
  };
  const unsigned columns = range_bits(lane(box.x_first, x), lane(box.x_last, x), grid);
  const unsigned rows = range_bits(lane(box.y_first, y), lane(box.y_last, y), grid);
  GridMask mask = 0;
  for (int j = 0; j < grid; ++j) {
    if ((rows >> j & 1u) != 0) mask |= GridMask{columns} << (j * grid);
  }
  return mask;
}

}  // namespace halfspace
