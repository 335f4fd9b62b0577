// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cstdlib>

#include "bins_sampler.hpp"
#include "tile_traversal.hpp"
#include "triangle_setup.hpp"

namespace halfspace {
namespace {

std::size_t index(std::int64_t value) { return static_cast<std::size_t>(value); }

}  // namespace

TriangleSampler::TriangleSampler(const BinModel& model, const FrameState& frame,
                                 const Triangle& triangle, BinSet& hits)
    : config_(model.config()),
      g_(model.groups()),
      phases_(model.phases()),
      frame_(frame),
      v_(triangle.vertex),
      hits_(hits),
      up_(config_.position_bits() - config_.subpixel_bits) {
  SetupOutcome outcome = SetupOutcome::kDrawn;
  setup_ = triangle_setup(triangle, frame, config_, &outcome);
  area_ = (std::int64_t{v_[1].x} - v_[0].x) * (std::int64_t{v_[2].y} - v_[0].y) -
          (std::int64_t{v_[1].y} - v_[0].y) * (std::int64_t{v_[2].x} - v_[0].x);
  if (outcome == SetupOutcome::kZeroArea) sample_degenerate();
  if (outcome == SetupOutcome::kCulled) sample_cull();
  if (outcome == SetupOutcome::kNoSample) sample_dropped();
  if (!setup_) return;
  std::optional<int> split;
  const bool covered = follow(root_node(*setup_), 0, split);
  sample_vertex_ties();
  if (!covered) return;
  hits_.add(g_.split + index(split.value_or(config_.levels() - 1)));
  sample_setup();
  sample_box();
  sample_widths();
}

void TriangleSampler::sample_cull() {
  hits_.add(g_.cull + 2 * index(static_cast<int>(frame_.cull)) + (area_ < 0));
}

void TriangleSampler::sample_degenerate() {
  const bool e01 = v_[0] == v_[1], e12 = v_[1] == v_[2], e20 = v_[2] == v_[0];
  if (e01 || e12 || e20) {
    hits_.add(g_.degenerate + (e01 && e12 ? 0u : e01 ? 1u : e12 ? 2u : 3u));
    return;
  }
  // The line that all three lie on.
  const int wind = wind_of({v_[1].x - v_[0].x, v_[1].y - v_[0].y});
  hits_.add(g_.degenerate + (wind % 8 == 0 ? 4u : wind % 8 == 4 ? 5u : wind % 4 == 2 ? 6u : 7u));
}

void TriangleSampler::sample_dropped() {
  const auto [x_min, x_max] = std::minmax({v_[0].x, v_[1].x, v_[2].x});
  const auto [y_min, y_max] = std::minmax({v_[0].y, v_[1].y, v_[2].y});
  const int s = config_.subpixel_bits;
  const bool left = x_max<0, right = x_min> frame_.width << s;
  const bool top = y_max<0, bottom = y_min> frame_.height << s;
  for (const auto& [hit, bin] : {std::pair{left, 0u}, {right, 1u}, {top, 2u}, {bottom, 3u}}) {
    if (hit) hits_.add(g_.outside + bin);
  }
  if (left || right || top || bottom) return;
  if (x_max - x_min < 1 << s) hits_.add(g_.between);
  if (y_max - y_min < 1 << s) hits_.add(g_.between + 1);
}

void TriangleSampler::sample_setup() {
  sample_cull();
  if (area_ == 1 || area_ == -1) hits_.add(g_.area_one);
  for (std::size_t i = 0; i < 3; ++i) {
    hits_.add(g_.edge + 16 * i + index(wind_of(setup_->slope[i])));
  }
  const int one = 1 << config_.subpixel_bits;
  for (const Point p : v_) {
    const auto at = [&](std::int32_t value) {
      return std::find(phases_.begin(), phases_.end(), value & (one - 1)) - phases_.begin();
    };
    const auto x = index(at(p.x)), y = index(at(p.y));
    if (x < phases_.size() && y < phases_.size()) hits_.add(g_.phase + x * phases_.size() + y);
  }
}

void TriangleSampler::sample_box() {
  const Box& box = setup_->box;
  const int grid = config_.grid();
  std::size_t group = g_.box;
  for (const std::int32_t edge : {box.x_first, box.y_first, box.x_last, box.y_last}) {
    hits_.add(group + index(edge & (grid - 1)));
    group += index(grid);
  }
  const auto [x_min, x_max] = std::minmax({v_[0].x, v_[1].x, v_[2].x});
  const auto [y_min, y_max] = std::minmax({v_[0].y, v_[1].y, v_[2].y});
  const int s = config_.subpixel_bits;
  if (x_min < 0) hits_.add(g_.box_cut);
  if (x_max > frame_.width << s) hits_.add(g_.box_cut + 1);
  if (y_min < 0) hits_.add(g_.box_cut + 2);
  if (y_max > frame_.height << s) hits_.add(g_.box_cut + 3);
  if (box.x_first == box.x_last) hits_.add(g_.box_thin);
  if (box.y_first == box.y_last) hits_.add(g_.box_thin + 1);
  std::size_t at = g_.frame;
  for (const int size : {frame_.width, frame_.height}) {
    if (size == 1) hits_.add(at);
    if (size == config_.max_size()) hits_.add(at + 1);
    if (size % grid != 0) hits_.add(at + 2);
    at += 3;
  }
}

void TriangleSampler::sample_widths() {
  const std::int64_t low = config_.coordinate_min(), high = config_.coordinate_max();
  for (const EdgeSlope slope : setup_->slope) {
    if (slope.a == high - low) hits_.add(g_.slope);
    if (slope.a == low - high) hits_.add(g_.slope + 1);
    if (slope.b == high - low) hits_.add(g_.slope + 2);
    if (slope.b == low - high) hits_.add(g_.slope + 3);
  }
  // The top magnitude bit of the area.
  if (std::abs(area_) >= std::int64_t{1} << (config_.area_bits() - 2)) {
    hits_.add(g_.area + (area_ < 0));
  }
  // One bit of it alone: nothing else tells the area from 0.
  const auto twice = static_cast<std::uint64_t>(std::abs(area_));
  const int bit = std::countr_zero(twice);
  if (std::has_single_bit(twice) && bit >= first_area_bit(config_) &&
      bit <= last_area_bit(config_)) {
    hits_.add(g_.area_bit + index(bit - first_area_bit(config_)));
  }
  unsigned corners = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool west = v_[k].x == low, east = v_[k].x == high;
    const bool north = v_[k].y == low, south = v_[k].y == high;
    if (west) hits_.add(g_.vertex + 4 * k);
    if (east) hits_.add(g_.vertex + 4 * k + 1);
    if (north) hits_.add(g_.vertex + 4 * k + 2);
    if (south) hits_.add(g_.vertex + 4 * k + 3);
    if ((west || east) && (north || south)) corners |= 1u << (2 * south + east);
  }
  for (unsigned c = 0; c < 4; ++c) {
    if ((corners >> c & 1u) != 0) hits_.add(g_.corner + c);
    if (corners == (15u & ~(1u << c))) hits_.add(g_.corners + c);
  }
  sample_root_saturation();
}

void TriangleSampler::sample_root_saturation() {
  const SamplePosition origin = config_.samples == 1 ? SamplePosition{8, 8} : SamplePosition{0, 0};
  const std::int64_t greatest =
      (std::int64_t{1} << (config_.node_bits(config_.node_log2(0)) - 1)) - 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t e = edge_at(i, 0, 0, origin) >> config_.dropped_bits();
    if (e > greatest) hits_.add(g_.saturate + i);
  }
}

void BinModel::sample(const FrameState& frame, std::span<const Triangle> triangles,
                      BinSet& hits) const {
  unsigned tied_before = 0;
  std::array<Point, 3> before{};
  std::optional<SetupTriangle> setup_before;
  for (const Triangle& triangle : triangles) {
    const TriangleSampler sampler(*this, frame, triangle, hits);
    for (std::size_t i = 0; i < 3 && sampler.setup() && setup_before; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const Point a = triangle.vertex[i], b = triangle.vertex[(i + 1) % 3];
        const Point c = before[j], d = before[(j + 1) % 3];
        const bool same = (a == c && b == d) || (a == d && b == c);
        const int wind = wind_of(sampler.setup()->slope[i]);
        const bool opposite = wind == (wind_of(setup_before->slope[j]) + 8) % 16;
        const bool tied = (sampler.tied_edges() >> i & 1u) != 0 && (tied_before >> j & 1u) != 0;
        if (same && opposite && tied) hits.add(groups_.tie_shared + index(wind % 8));
      }
    }
    tied_before = sampler.tied_edges();
    before = triangle.vertex;
    setup_before = sampler.setup();
  }
}

}  // namespace halfspace
