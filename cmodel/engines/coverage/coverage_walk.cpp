// SPDX-License-Identifier: Apache-2.0
#include "coverage_walk.hpp"

#include "../../half_plane_grid.hpp"
#include "../../samples.hpp"

namespace halfspace {

CoverageWalk::CoverageWalk(const Triangle& triangle, const SetupTriangle& setup,
                           const Config& config)
    : config_(config), box_(setup.box), tag_(setup.tag), edge_{} {
  const int f = config.position_bits();
  const int up = f - config.subpixel_bits;
  const std::int64_t one = std::int64_t{1} << f;
  for (std::size_t i = 0; i < 3; ++i) {
    Edge& edge = edge_[i];
    const std::int64_t a = setup.slope[i].a;
    const std::int64_t b = setup.slope[i].b;
    const std::int64_t bias = a > 0 || (a == 0 && b > 0) ? 0 : -1;
    edge.a = a * one;
    edge.b = b * one;
    const Point from = triangle.vertex[i];
    std::int64_t low = INT64_MAX;
    std::int64_t high = INT64_MIN;
    for (std::size_t m = 0; m < static_cast<std::size_t>(config.samples); ++m) {
      // Samples lie on multiples of 2^-sample_position_bits(), so the shift is exact.
      const SamplePosition p = sample_positions(config.samples)[m];
      const std::int64_t u = (std::int64_t{p.x} << f) >> 4;
      const std::int64_t v = (std::int64_t{p.y} << f) >> 4;
      edge.at_sample[m] =
          a * (u - (std::int64_t{from.x} << up)) + b * (v - (std::int64_t{from.y} << up)) + bias;
      low = std::min(low, edge.at_sample[m]);
      high = std::max(high, edge.at_sample[m]);
    }
    const std::int64_t last = config.grid() - 1;
    edge.low = low + last * (std::min<std::int64_t>(edge.a, 0) + std::min<std::int64_t>(edge.b, 0));
    edge.high =
        high + last * (std::max<std::int64_t>(edge.a, 0) + std::max<std::int64_t>(edge.b, 0));
  }
}

GridMask CoverageWalk::mask(std::int32_t x, std::int32_t y, std::size_t sample) const {
  GridMask mask = 0;
  const int grid = config_.grid();
  std::array<std::int64_t, 3> row{};
  for (std::size_t i = 0; i < 3; ++i) {
    row[i] = edge_[i].at_sample[sample] + edge_[i].a * x + edge_[i].b * y;
  }
  for (int j = 0; j < grid; ++j) {
    std::array<std::int64_t, 3> e = row;
    for (int i = 0; i < grid; ++i) {
      const bool inside = (e[0] | e[1] | e[2]) >= 0;  // no sign bit set
      mask |= GridMask{inside} << (j * grid + i);
      for (std::size_t k = 0; k < 3; ++k) e[k] += edge_[k].a;
    }
    for (std::size_t k = 0; k < 3; ++k) row[k] += edge_[k].b;
  }
  return mask;
}

std::optional<CoverageTile> CoverageWalk::tile(std::int32_t x, std::int32_t y) const {
  bool full = true;
  for (const Edge& edge : edge_) {
    const std::int64_t origin = edge.a * x + edge.b * y;
    if (origin + edge.high < 0) return std::nullopt;
    full = full && origin + edge.low >= 0;
  }
  CoverageTile out{x, y, {}, tag_};
  const GridMask box = box_mask(x, y, 0, box_, config_);
  GridMask any = 0;
  for (std::size_t m = 0; m < static_cast<std::size_t>(config_.samples); ++m) {
    out.mask[m] = full ? box : box & mask(x, y, m);
    any |= out.mask[m];
  }
  if (any == 0) return std::nullopt;
  return out;
}

}  // namespace halfspace
