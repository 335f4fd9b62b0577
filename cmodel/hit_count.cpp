// SPDX-License-Identifier: Apache-2.0
#include "hit_count.hpp"

#include <bit>

namespace halfspace {

void HitCount::add(const CoverageTile& tile, const Config& config) {
  GridMask any = 0;
  for (const GridMask mask : tile.mask) any |= mask;
  for (; any != 0; any &= any - 1) {
    const int bit = std::countr_zero(any);
    const int x = tile.x + (bit & (config.grid() - 1));
    const int y = tile.y + (bit >> config.grid_log2);
    std::uint8_t& count = count_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                 static_cast<std::size_t>(x)];
    if (count != 255) ++count;
  }
}

}  // namespace halfspace
