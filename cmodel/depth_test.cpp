// SPDX-License-Identifier: Apache-2.0
#include "depth_test.hpp"

#include <bit>

namespace halfspace {

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
