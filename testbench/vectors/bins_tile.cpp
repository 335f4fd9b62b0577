// SPDX-License-Identifier: Apache-2.0
//
// Part of bins.hpp: what the pyramid, the tiles and the ties of a triangle hit.
#include <bit>

#include "bins_sampler.hpp"
#include "coverage.hpp"
#include "fixed.hpp"
#include "half_plane_grid.hpp"
#include "tile_traversal.hpp"

namespace halfspace {
namespace {

std::size_t index(std::int64_t value) { return static_cast<std::size_t>(value); }

}  // namespace

bool TriangleSampler::follow(const Node& node, int level, std::optional<int>& split) {
  if (level == config_.levels() - 1) return sample_tile(node);
  const GridMask live = live_children(node, level, *setup_, config_);
  if (live == 0) hits_.add(g_.dead + index(level));
  if (!split && std::popcount(live) > 1) split = level;
  if (level == config_.levels() - 2 && std::popcount(live) == config_.lanes()) hits_.add(g_.all);
  const int child_log2 = config_.node_log2(level + 1);
  const std::int64_t greatest = (std::int64_t{1} << (config_.node_bits(child_log2) - 1)) - 1;
  const GridMask box = box_mask(node.x, node.y, child_log2, setup_->box, config_);
  for (GridMask rest = box & ~live; rest != 0; rest &= rest - 1) {
    hits_.add(g_.reject + index(level * config_.lanes() + std::countr_zero(rest)));
  }
  bool covered = false;
  for (GridMask rest = live; rest != 0; rest &= rest - 1) {
    const int bit = std::countr_zero(rest);
    const Node child = child_node(node, level, bit, *setup_, config_);
    if (!follow(child, level + 1, split)) continue;
    covered = true;
    hits_.add(g_.child + index(level * config_.lanes() + bit));
    for (std::size_t i = 0; i < 3; ++i) {
      const EdgeSlope slope = setup_->slope[i];
      const std::int64_t step = (std::int64_t{slope.a} * (bit & (config_.grid() - 1)) +
                                 std::int64_t{slope.b} * (bit >> config_.grid_log2))
                                << (child_log2 + config_.sample_bits());
      if (node.e[i] + step > greatest) hits_.add(g_.saturate + 3 * index(level + 1) + i);
    }
  }
  return covered;
}

bool TriangleSampler::sample_tile(const Node& node) {
  sample_edge_ties(node);
  const auto tile = coverage(node, *setup_, config_);
  if (!tile) {
    hits_.add(g_.mask_empty);
    return false;
  }
  for (int m = 0; m < config_.samples; ++m) sample_mask(tile->mask[index(m)], m);
  if (config_.samples > 1) sample_pixels(*tile);
  sample_cut(node, tile->mask[0]);
  return true;
}

void TriangleSampler::sample_mask(GridMask mask, int sample) {
  const int grid = config_.grid(), lanes = config_.lanes();
  const GridMask full = lanes == 64 ? ~GridMask{0} : (GridMask{1} << lanes) - 1;
  const std::size_t group = g_.mask + index(sample * (lanes + 2 * grid + 1));
  if (std::popcount(mask) == 1) hits_.add(group + index(std::countr_zero(mask)));
  const GridMask row = (GridMask{1} << grid) - 1;
  GridMask column = 0;
  for (int j = 0; j < grid; ++j) column |= GridMask{1} << (j * grid);
  for (int j = 0; j < grid; ++j) {
    if (mask == row << (j * grid)) hits_.add(group + index(lanes + j));
    if (mask == column << j) hits_.add(group + index(lanes + grid + j));
  }
  if (mask == full) hits_.add(group + index(lanes + 2 * grid));
  if (std::popcount(full & ~mask) == 1) {
    hits_.add(g_.mask_lacks + index(std::countr_zero(full & ~mask)));
  }
}

void TriangleSampler::sample_pixels(const CoverageTile& tile) {
  for (int lane = 0; lane < config_.lanes(); ++lane) {
    unsigned samples = 0;
    for (int m = 0; m < config_.samples; ++m) {
      samples |= static_cast<unsigned>(tile.mask[index(m)] >> lane & 1u) << m;
    }
    if (samples == 0) continue;
    hits_.add(g_.pixel_count + index(std::popcount(samples) - 1));
    if (std::popcount(samples) == 1) hits_.add(g_.pixel_alone + index(std::countr_zero(samples)));
  }
}

void TriangleSampler::sample_cut(const Node& node, GridMask mask) {
  const GridMask full = config_.lanes() == 64 ? ~GridMask{0} : (GridMask{1} << config_.lanes()) - 1;
  if (mask == full || mask == 0 || box_mask(node.x, node.y, 0, setup_->box, config_) != full) {
    return;
  }
  const SamplePosition offset = sample_offset(config_, 0);
  std::optional<std::size_t> cut;
  for (std::size_t i = 0; i < 3; ++i) {
    const EdgeSlope slope = setup_->slope[i];
    const std::int64_t e =
        node.e[i] + std::int64_t{slope.a} * offset.x + std::int64_t{slope.b} * offset.y;
    if (half_plane_grid(floor_shift(e, config_.sample_bits()), slope, config_) == full) continue;
    if (cut) return;
    cut = i;
  }
  if (cut) hits_.add(g_.cut + 16 * *cut + index(wind_of(setup_->slope[*cut])));
}

std::int64_t TriangleSampler::edge_at(std::size_t i, std::int64_t x, std::int64_t y,
                                      SamplePosition at) const {
  const int f = config_.position_bits();
  const std::int64_t px = (x << f) + ((std::int64_t{at.x} << f) >> 4);
  const std::int64_t py = (y << f) + ((std::int64_t{at.y} << f) >> 4);
  return setup_->slope[i].a * (px - std::int64_t{v_[i].x} * (std::int64_t{1} << up_)) +
         setup_->slope[i].b * (py - std::int64_t{v_[i].y} * (std::int64_t{1} << up_));
}

void TriangleSampler::sample_edge_ties(const Node& node) {
  const int grid = config_.grid();
  for (int lane = 0; lane < config_.lanes(); ++lane) {
    const std::int64_t x = node.x + (lane & (grid - 1)), y = node.y + lane / grid;
    if (x >= frame_.width || y >= frame_.height) continue;
    for (const SamplePosition at : sample_positions(config_.samples)) {
      std::optional<std::size_t> tied;
      bool inside = true;
      for (std::size_t i = 0; i < 3 && inside; ++i) {
        const std::int64_t e = edge_at(i, x, y, at);
        inside = e > 0 || (e == 0 && !tied);
        if (e == 0) tied = i;
      }
      if (!inside || !tied) continue;
      tied_ |= 1u << *tied;
      hits_.add(g_.tie_edge + index(wind_of(setup_->slope[*tied])));
    }
  }
}

void TriangleSampler::sample_vertex_ties() {
  const int f = config_.position_bits();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int64_t px = std::int64_t{v_[k].x} * (std::int64_t{1} << up_);
    const std::int64_t py = std::int64_t{v_[k].y} * (std::int64_t{1} << up_);
    const std::int64_t x = px >> f, y = py >> f;
    if (x < 0 || y < 0 || x >= frame_.width || y >= frame_.height) continue;
    for (const SamplePosition at : sample_positions(config_.samples)) {
      if ((x << f) + ((std::int64_t{at.x} << f) >> 4) != px ||
          (y << f) + ((std::int64_t{at.y} << f) >> 4) != py) {
        continue;
      }
      bool owned = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const EdgeSlope slope = setup_->slope[i];
        const bool top_left = slope.a > 0 || (slope.a == 0 && slope.b > 0);
        owned = owned && edge_at(i, x, y, at) >= (top_left ? 0 : 1);
      }
      hits_.add(g_.tie_vertex + 2 * k + (owned ? 0u : 1u));
    }
  }
}

}  // namespace halfspace
