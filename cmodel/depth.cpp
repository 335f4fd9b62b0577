// SPDX-License-Identifier: Apache-2.0
#include "depth.hpp"

#include <algorithm>
#include <bit>

#include "fixed.hpp"

namespace halfspace {

std::uint32_t depth_value(std::int32_t units, const Config& config) {
  const int down = kPlaneBits - config.depth_bits;
  const std::int64_t half = down > 0 ? std::int64_t{1} << (down - 1) : 0;
  const std::int64_t rounded =
      down > 0 ? floor_shift(units + half, down) : std::int64_t{units} * (std::int64_t{1} << -down);
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(rounded, 0, config.depth_max()));
}

GridMask depth_test(GridMask covered, const TilePlane& plane, DepthFunction function,
                    DepthTile& stored, const Config& config) {
  const unsigned lets = passing(function);
  GridMask passed = 0;
  for (GridMask rest = covered; rest != 0; rest &= rest - 1) {
    const int lane = std::countr_zero(rest);
    const std::uint32_t depth =
        depth_value(plane.at(lane & (config.grid() - 1), lane >> config.grid_log2), config);
    std::uint32_t& old = stored[static_cast<std::size_t>(lane)];
    const int compared = depth < old ? 0 : depth == old ? 1 : 2;
    if ((lets >> compared & 1) == 0) continue;
    old = depth;
    passed |= GridMask{1} << lane;
  }
  return passed;
}

}  // namespace halfspace
