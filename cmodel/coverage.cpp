// SPDX-License-Identifier: Apache-2.0
#include "coverage.hpp"

#include "fixed.hpp"
#include "half_plane_grid.hpp"
#include "samples.hpp"

namespace halfspace {

std::optional<CoverageTile> coverage(const Node& tile, const SetupTriangle& triangle,
                                     const Config& config) {
  for (const std::int64_t e : tile.e) HS_CHECK(fits(e, config.node_bits(config.grid_log2)));
  const GridMask box = box_mask(tile.x, tile.y, 0, triangle.box, config);
  CoverageTile out{tile.x, tile.y, {}, triangle.tag};
  GridMask any = 0;
  for (int m = 0; m < config.samples; ++m) {
    const SamplePosition offset = sample_offset(config, m);
    GridMask mask = box;
    for (std::size_t i = 0; i < 3; ++i) {
      const EdgeSlope slope = triangle.slope[i];
      const std::int64_t at_sample =
          tile.e[i] + std::int64_t{slope.a} * offset.x + std::int64_t{slope.b} * offset.y;
      mask &= half_plane_grid(floor_shift(at_sample, config.sample_bits()), slope, config);
    }
    out.mask[static_cast<std::size_t>(m)] = mask;
    any |= mask;
  }
  if (any == 0) return std::nullopt;
  return out;
}

}  // namespace halfspace
