// SPDX-License-Identifier: Apache-2.0
#include "depth.hpp"

#include <algorithm>
#include <bit>

#include "fixed.hpp"

namespace halfspace {

std::uint32_t depth_value(std::int32_t units, const Config& config) {
  const int shift = kPlaneBits - config.depth_bits;
  const std::int64_t rounded =
      floor_shift(std::int64_t{units} + (std::int64_t{1} << (shift - 1)), shift);
  const std::int64_t greatest = (std::int64_t{1} << config.depth_bits) - 1;
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(rounded, 0, greatest));
}

GridMask depth_test(GridMask covered, const TilePlane& plane, DepthFunction function,
                    DepthTile& stored, const Config& config) {
  GridMask passed = 0;
  for (GridMask rest = covered; rest != 0; rest &= rest - 1) {
    const int lane = std::countr_zero(rest);
    const std::uint32_t depth =
        depth_value(plane.at(lane & (config.grid() - 1), lane >> config.grid_log2), config);
    std::uint32_t& old = stored[static_cast<std::size_t>(lane)];
    const bool wins = function == DepthFunction::kAlways || depth < old ||
                      (function == DepthFunction::kLessEqual && depth == old);
    if (!wins) continue;
    old = depth;
    passed |= GridMask{1} << lane;
  }
  return passed;
}

}  // namespace halfspace
