// SPDX-License-Identifier: Apache-2.0
#include "rasterizer.hpp"

#include <algorithm>

namespace halfspace {
namespace {

// A pixel's colour is evaluated once: at its centre when every sample is covered, else at the first
// covered sample. Both lie in the triangle, so no attribute is ever extrapolated. -1 is the centre.
int shading_sample(const CoverageTile& tile, int lane, int samples) {
  int first = -1;
  for (int m = samples - 1; m >= 0; --m) {
    if ((tile.mask[static_cast<std::size_t>(m)] >> lane & 1) != 0) first = m;
  }
  for (int m = 0; m < samples; ++m) {
    if ((tile.mask[static_cast<std::size_t>(m)] >> lane & 1) == 0) return first;
  }
  return -1;
}

}  // namespace

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

Rasterizer::Rasterizer(const FrameState& frame, const Config& config, DepthFunction depth_function,
                       Rgb background)
    : frame_(frame),
      config_(config),
      depth_function_(depth_function),
      framebuffer_(frame, config, background),
      hit_count_(frame.width, frame.height),
      colors_(std::min(config.attributes, 3)) {}

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
  if (!has_depth_) {
    planes_ = interpolation_setup(setup_, triangle_->triangle, triangle_->attributes, 0, config_);
    has_depth_ = true;
  }
  FrameTile& stored = framebuffer_.tile(tile.x, tile.y);
  const TilePlane depth = tile_plane(planes_.depth, planes_.origin, tile.x, tile.y, config_);
  std::array<GridMask, kMaxSamples> passed{};
  GridMask any = 0;
  for (int m = 0; m < config_.samples; ++m) {
    const auto s = static_cast<std::size_t>(m);
    TilePlane at_sample = depth;
    at_sample.base += sample_delta(planes_.depth, m, config_);
    passed[s] = depth_test(tile.mask[s], at_sample, depth_function_, stored.depth[s], config_);
    any |= passed[s];
  }
  if (any == 0) return;
  if (!has_attributes_) {
    planes_ =
        interpolation_setup(setup_, triangle_->triangle, triangle_->attributes, colors_, config_);
    has_attributes_ = true;
  }
  shade(tile, passed, stored);
}

void Rasterizer::shade(const CoverageTile& tile, const std::array<GridMask, kMaxSamples>& passed,
                       FrameTile& stored) {
  inverse_w_ = tile_plane(planes_.inverse_w, planes_.origin, tile.x, tile.y, config_);
  for (std::size_t c = 0; c < static_cast<std::size_t>(colors_); ++c) {
    attribute_[c] = tile_plane(planes_.attribute[c], planes_.origin, tile.x, tile.y, config_);
  }
  GridMask any = 0;
  for (const GridMask mask : passed) any |= mask;
  for (; any != 0; any &= any - 1) {
    const int lane = std::countr_zero(any);
    ++stats_.fragments_shaded;
    const Rgb color = color_at(lane, shading_sample(tile, lane, config_.samples));
    for (std::size_t s = 0; s < static_cast<std::size_t>(config_.samples); ++s) {
      if ((passed[s] >> lane & 1) != 0) stored.color[s][static_cast<std::size_t>(lane)] = color;
    }
    if (fragment_) fragment_(fragment_at(lane, tile, passed, stored, color));
  }
}

Fragment Rasterizer::fragment_at(int lane, const CoverageTile& tile,
                                 const std::array<GridMask, kMaxSamples>& passed,
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

Rgb Rasterizer::color_at(int lane, int sample) const {
  const int i = lane & (config_.grid() - 1);
  const int j = lane >> config_.grid_log2;
  const auto at = [&](const TilePlane& tile, const Plane& plane) {
    const std::uint32_t delta = sample < 0 ? 0 : sample_delta(plane, sample, config_);
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(tile.at(i, j)) + delta);
  };
  const std::int32_t inverse_w = at(inverse_w_, planes_.inverse_w);
  Rgb color{};
  for (std::size_t c = 0; c < static_cast<std::size_t>(colors_); ++c) {
    color[c] = perspective(at(attribute_[c], planes_.attribute[c]), inverse_w, config_);
  }
  return color;
}

}  // namespace halfspace
