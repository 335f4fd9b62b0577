// SPDX-License-Identifier: Apache-2.0
//
// The order of the stages, defined. Whatever else runs them in a row (cycle_model.hpp, explain.cpp,
// those of engines/) must give the same, and tests compare it with this.
// Twin: rtl/hs_rasterizer.sv (triangle_setup, tile_traversal, coverage).
#pragma once

#include <array>
#include <bit>
#include <functional>
#include <optional>
#include <utility>

#include "config.hpp"
#include "coverage.hpp"
#include "depth.hpp"
#include "framebuffer.hpp"
#include "hit_count.hpp"
#include "interpolation.hpp"
#include "packets.hpp"
#include "scissor.hpp"
#include "shading.hpp"
#include "tile_traversal.hpp"
#include "triangle_setup.hpp"

namespace halfspace {

// What the stages did; sums over everything drawn. `tiles_visited` are leaf tiles tested,
// `tiles_covered` those of them that hold a covered sample.
struct RasterStats {
  std::uint64_t triangles = 0;
  std::uint64_t triangles_zero_area = 0;
  std::uint64_t triangles_culled = 0;
  std::uint64_t triangles_no_sample = 0;  // the box holds no sample: dropped before traversal
  std::uint64_t upper_nodes_skipped = 0;  // above the leaves, not tested: the box lies in one child
  TraversalCount traversal;               // nodes tested per level, root first
  std::uint64_t tiles_visited = 0;
  std::uint64_t tiles_covered = 0;
  std::uint64_t samples_tested = 0;  // lanes x samples of every visited tile
  std::uint64_t samples_covered = 0;
  std::uint64_t fragments = 0;         // covered pixels of covered tiles, before the depth test
  std::uint64_t fragments_shaded = 0;  // of those, with a sample that passed: attributes evaluated

  RasterStats& operator+=(const RasterStats& other);
};

// Adds one triangle that triangle_setup dropped to the counts.
inline void count_drop(SetupOutcome outcome, RasterStats& stats) {
  stats.triangles_zero_area += outcome == SetupOutcome::kZeroArea ? 1u : 0u;
  stats.triangles_culled += outcome == SetupOutcome::kCulled ? 1u : 0u;
  stats.triangles_no_sample += outcome == SetupOutcome::kNoSample ? 1u : 0u;
}

// Adds one covered tile to the counts.
inline void count_tile(const CoverageTile& tile, RasterStats& stats) {
  ++stats.tiles_covered;
  GridMask any = 0;
  for (const GridMask mask : tile.mask) {
    any |= mask;
    stats.samples_covered += static_cast<std::uint64_t>(std::popcount(mask));
  }
  stats.fragments += static_cast<std::uint64_t>(std::popcount(any));
}

// One triangle through triangle_setup, tile_traversal and coverage.
//
//   triangle, frame, config  as triangle_setup()
//   stats                    added to
//   setup                    called with the SetupTriangle once, if it survives, before any tile
//   visit                    called with every Node tested, its level and, for a leaf tile,
//                            whether it was covered (true above the leaf level)
//   tile                     called with every CoverageTile, in the order of the RTL
template <class Setup, class Visit, class Tile>
void rasterize(const Triangle& triangle, const FrameState& frame, const Config& config,
               RasterStats& stats, Setup&& setup, Visit&& visit, Tile&& tile) {
  ++stats.triangles;
  SetupOutcome outcome = SetupOutcome::kDrawn;
  const std::optional<SetupTriangle> ready = triangle_setup(triangle, frame, config, &outcome);
  if (!ready) {
    count_drop(outcome, stats);
    return;
  }
  setup(*ready);
  const int leaf_level = config.levels() - 1;
  visit_nodes(root_node(*ready), 0, *ready, config, [&](const Node& node, int level) {
    ++stats.traversal.nodes[static_cast<std::size_t>(level)];
    if (level != leaf_level) {
      visit(node, level, true);
      return;
    }
    ++stats.tiles_visited;
    stats.samples_tested += static_cast<std::uint64_t>(config.lanes() * config.samples);
    const std::optional<CoverageTile> covered = coverage(node, *ready, config);
    visit(node, level, covered.has_value());
    if (!covered) return;
    count_tile(*covered, stats);
    tile(*covered);
  });
}

// The same for callers that want only the covered tiles.
template <class Tile>
void rasterize(const Triangle& triangle, const FrameState& frame, const Config& config,
               RasterStats& stats, Tile&& tile) {
  rasterize(
      triangle, frame, config, stats, [](const SetupTriangle&) {}, [](const Node&, int, bool) {},
      std::forward<Tile>(tile));
}

// One pixel of one triangle with a sample that passed the depth test.
struct Fragment {
  std::int32_t x = 0;  // pixel
  std::int32_t y = 0;
  std::uint32_t tag = 0;
  std::uint16_t covered = 0;  // bit m: sample m is inside the triangle
  std::uint16_t passed = 0;   // bit m: it passed
  Rgb color{};
  std::array<std::uint32_t, kMaxSamples> depth{};  // of the samples that passed; 0 elsewhere
};

// The whole pipeline at level bit: coverage, scissor, then depth, then, where depth passed,
// attributes into the framebuffer.
class Rasterizer {
 public:
  // config: legal. frame: 1..2^viewport_bits a side. background: colour where nothing is drawn.
  // scissor: nothing is drawn outside, though counted as coverage; inside the frame (checked).
  Rasterizer(const FrameState& frame, const Config& config, const DepthState& depth, Rgb background,
             const std::optional<Box>& scissor = {});

  // Draws one triangle: attributes 0..2 are red, green and blue (missing ones are 0). Coverage is
  // also added to hit_count().
  void draw(const ShadedTriangle& triangle);

  // The same for coverage that comes from elsewhere (level cycle, the RTL): begin() with what
  // triangle_setup() returned for the triangle, then each of its tiles. The triangle must stay
  // where it is until the last one.
  void begin(const ShadedTriangle& triangle, const SetupTriangle& setup);
  void draw_tile(const CoverageTile& tile);

  // Called with every fragment from now on: tiles in order, pixels of a tile by lane. Empty: none.
  void on_fragment(std::function<void(const Fragment&)> sink) { fragment_ = std::move(sink); }

  const Framebuffer& framebuffer() const { return framebuffer_; }
  const RasterStats& stats() const { return stats_; }
  const HitCount& hit_count() const { return hit_count_; }

 private:
  void draw_inside(const CoverageTile& tile);
  SampleMasks test_tile(const CoverageTile& tile, FrameTile& stored);
  void shade_tile(const CoverageTile& tile, const SampleMasks& passed, FrameTile& stored);
  Fragment fragment_at(int lane, const CoverageTile& tile, const SampleMasks& passed,
                       const FrameTile& stored, const Rgb& color) const;

  FrameState frame_;
  Config config_;
  DepthFunction depth_function_;
  std::optional<Box> scissor_;
  Framebuffer framebuffer_;
  HitCount hit_count_;
  RasterStats stats_;
  std::function<void(const Fragment&)> fragment_;

  // The triangle being drawn, and its planes: planes with attributes once a fragment passed,
  // without before.
  const ShadedTriangle* triangle_ = nullptr;
  SetupTriangle setup_;
  bool has_depth_ = false;
  bool has_attributes_ = false;
  InterpolationSetup planes_;
  int colors_;
};

}  // namespace halfspace
