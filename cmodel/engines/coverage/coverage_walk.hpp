// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

#include "../../config.hpp"
#include "../../packets.hpp"
#include "../../rasterizer.hpp"

namespace halfspace {

// Level coverage: the masks of level bit and nothing else. Walks the tiles of the sample box row by
// row with unsaturated 64-bit edge values; no pyramid, no packets, so the order of tiles differs.
//
//   setup   what triangle_setup() returned; its e values are not used
//   tile    called with every CoverageTile
//
// Same set of (tile, mask) as rasterize(), always. stats: tiles_visited and samples_tested count
// the tiles this walk tests, which are not those of the pyramid.
class CoverageWalk {
 public:
  CoverageWalk(const Triangle& triangle, const SetupTriangle& setup, const Config& config);

  // The masks of the tile whose first pixel is (x, y); nothing when the triangle misses it.
  std::optional<CoverageTile> tile(std::int32_t x, std::int32_t y) const;

  // Tiles first..last that the sample box touches, pixel coordinates of their first pixels.
  std::int32_t x_first() const { return box_.x_first & ~(config_.grid() - 1); }
  std::int32_t y_first() const { return box_.y_first & ~(config_.grid() - 1); }
  std::int32_t x_last() const { return box_.x_last; }
  std::int32_t y_last() const { return box_.y_last; }

 private:
  struct Edge {
    std::int64_t a;  // per pixel
    std::int64_t b;
    std::int64_t low;  // least and greatest change of E from a tile's first pixel to its samples
    std::int64_t high;
    std::array<std::int64_t, kMaxSamples> at_sample;  // biased E at sample m of pixel (0, 0)
  };
  GridMask mask(std::int32_t x, std::int32_t y, std::size_t sample) const;

  Config config_;
  Box box_;
  std::uint32_t tag_;
  std::array<Edge, 3> edge_;
};

// One triangle at level coverage; arguments as rasterize().
template <class Tile>
void cover(const Triangle& triangle, const FrameState& frame, const Config& config,
           RasterStats& stats, Tile&& tile) {
  ++stats.triangles;
  SetupOutcome outcome = SetupOutcome::kDrawn;
  const std::optional<SetupTriangle> ready = triangle_setup(triangle, frame, config, &outcome);
  if (!ready) {
    count_drop(outcome, stats);
    return;
  }
  const CoverageWalk walk(triangle, *ready, config);
  for (std::int32_t y = walk.y_first(); y <= walk.y_last(); y += config.grid()) {
    for (std::int32_t x = walk.x_first(); x <= walk.x_last(); x += config.grid()) {
      ++stats.tiles_visited;
      stats.samples_tested += static_cast<std::uint64_t>(config.lanes() * config.samples);
      if (const std::optional<CoverageTile> covered = walk.tile(x, y)) {
        count_tile(*covered, stats);
        tile(*covered);
      }
    }
  }
}

}  // namespace halfspace
