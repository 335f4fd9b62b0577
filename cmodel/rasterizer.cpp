// SPDX-License-Identifier: Apache-2.0
#include "rasterizer.hpp"

#include <algorithm>

#include "fixed.hpp"

namespace halfspace {

RasterStats& RasterStats::operator+=(const RasterStats& other) {
  triangles += other.triangles;
  triangles_zero_area += other.triangles_zero_area;
  triangles_culled += other.triangles_culled;
  triangles_no_sample += other.triangles_no_sample;
  upper_nodes_skipped += other.upper_nodes_skipped;
  for (std::size_t i = 0; i < traversal.nodes.size(); ++i) {
    traversal.nodes[i] += other.traversal.nodes[i];
  }
  tiles_visited += other.tiles_visited;
  tiles_covered += other.tiles_covered;
  samples_tested += other.samples_tested;
  samples_covered += other.samples_covered;
  fragments += other.fragments;
  fragments_shaded += other.fragments_shaded;
  return *this;
}

Rasterizer::Rasterizer(const FrameState& frame, const Config& config, const DepthState& depth,
                       Rgb background, const std::optional<Box>& scissor)
    : frame_(frame),
      config_(config),
      depth_function_(depth.function),
      scissor_(scissor),
      framebuffer_(frame, config, background, depth.cleared(config)),
      hit_count_(frame.width, frame.height),
      colors_(std::min(config.attributes, 3)) {
  HS_CHECK(depth.cleared(config) <= config.depth_max());
  if (scissor) HS_CHECK(inside(*scissor, frame));
}

void Rasterizer::draw(const ShadedTriangle& triangle) {
  rasterize(
      triangle.triangle, frame_, config_, stats_,
      [&](const SetupTriangle& setup) { begin(triangle, setup); }, [](const Node&, int, bool) {},
      [this](const CoverageTile& tile) { draw_tile(tile); });
}

void Rasterizer::begin(const ShadedTriangle& triangle, const SetupTriangle& setup) {
  triangle_ = &triangle;
  setup_ = setup;
  has_depth_ = false;
  has_attributes_ = false;
}

void Rasterizer::draw_tile(const CoverageTile& tile) {
  hit_count_.add(tile, config_);
  if (!scissor_) return draw_inside(tile);
  if (const auto left = scissor(tile, *scissor_, config_)) draw_inside(*left);
}

void Rasterizer::draw_inside(const CoverageTile& tile) {
  if (!has_depth_) {
    planes_ = interpolation_setup(setup_, triangle_->triangle, triangle_->attributes, 0, config_);
    has_depth_ = true;
  }
  FrameTile& stored = framebuffer_.tile(tile.x, tile.y);
  const SampleMasks passed = test_tile(tile, stored);
  if (any_sample(passed) == 0) return;
  if (!has_attributes_) {
    planes_ =
        interpolation_setup(setup_, triangle_->triangle, triangle_->attributes, colors_, config_);
    has_attributes_ = true;
  }
  shade_tile(tile, passed, stored);
}

SampleMasks Rasterizer::test_tile(const CoverageTile& tile, FrameTile& stored) {
  const TilePlane depth = tile_plane(planes_.depth, planes_.origin, tile.x, tile.y, config_);
  SampleMasks passed{};
  for (int m = 0; m < config_.samples; ++m) {
    const auto s = static_cast<std::size_t>(m);
    TilePlane at_sample = depth;
    at_sample.base += sample_delta(planes_.depth, m, config_);
    passed[s] = depth_test(tile.mask[s], at_sample, depth_function_, stored.depth[s], config_);
  }
  return passed;
}

void Rasterizer::shade_tile(const CoverageTile& tile, const SampleMasks& passed,
                            FrameTile& stored) {
  const ShadingPlanes planes = shading_planes(planes_, colors_, tile.x, tile.y, config_);
  const ColorTile color = shading(tile, passed, planes, colors_, config_);
  for (GridMask any = any_sample(passed); any != 0; any &= any - 1) {
    const int lane = std::countr_zero(any);
    const Rgb& fragment = color[static_cast<std::size_t>(lane)];
    ++stats_.fragments_shaded;
    for (std::size_t s = 0; s < static_cast<std::size_t>(config_.samples); ++s) {
      if ((passed[s] >> lane & 1) != 0) stored.color[s][static_cast<std::size_t>(lane)] = fragment;
    }
    if (fragment_) fragment_(fragment_at(lane, tile, passed, stored, fragment));
  }
}

Fragment Rasterizer::fragment_at(int lane, const CoverageTile& tile, const SampleMasks& passed,
                                 const FrameTile& stored, const Rgb& color) const {
  Fragment out;
  out.x = tile.x + (lane & (config_.grid() - 1));
  out.y = tile.y + (lane >> config_.grid_log2);
  out.tag = tile.tag;
  out.color = color;
  for (std::size_t s = 0; s < static_cast<std::size_t>(config_.samples); ++s) {
    out.covered |= static_cast<std::uint16_t>((tile.mask[s] >> lane & 1) << s);
    if ((passed[s] >> lane & 1) == 0) continue;
    out.passed |= static_cast<std::uint16_t>(1u << s);
    out.depth[s] = stored.depth[s][static_cast<std::size_t>(lane)];
  }
  return out;
}

}  // namespace halfspace
