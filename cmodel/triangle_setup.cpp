// SPDX-License-Identifier: Apache-2.0
#include "triangle_setup.hpp"

#include <algorithm>

#include "fixed.hpp"
#include "samples.hpp"

namespace halfspace {
namespace {

struct Span {
  std::int32_t first;
  std::int32_t last;
};

// Pixels that may hold a covered sample, given the extreme coordinates of the vertices in one
// direction (S.s px) and those of the samples in a pixel (1/16 px), cut to 0..size-1.
Span sample_span(std::int64_t v_min, std::int64_t v_max, int sample_low, int sample_high, int size,
                 const Config& config) {
  const int f = config.position_bits();
  const int up = f - config.subpixel_bits;
  const std::int64_t one = std::int64_t{1} << f;
  const auto to_position = [f](int sixteenths) { return (std::int64_t{sixteenths} << f) >> 4; };
  const std::int64_t first = floor_shift((v_min << up) - to_position(sample_high) + one - 1, f);
  const std::int64_t last = floor_shift((v_max << up) - to_position(sample_low) + one - 1, f) - 1;
  return {static_cast<std::int32_t>(std::max<std::int64_t>(first, 0)),
          static_cast<std::int32_t>(std::min<std::int64_t>(last, size - 1))};
}

// The doubled area, S.2s px^2: positive when the winding is clockwise as seen (y down).
std::int64_t doubled_area(const std::array<Point, 3>& v) {
  const auto d = [](std::int32_t to, std::int32_t from) {
    return std::int64_t{to} - std::int64_t{from};
  };
  return d(v[1].x, v[0].x) * d(v[2].y, v[0].y) - d(v[1].y, v[0].y) * d(v[2].x, v[0].x);
}

}  // namespace

std::optional<SetupTriangle> triangle_setup(const Triangle& triangle, const FrameState& frame,
                                            const Config& config, SetupOutcome* outcome) {
  const auto drop = [outcome](SetupOutcome why) {
    if (outcome != nullptr) *outcome = why;
    return std::optional<SetupTriangle>{};
  };
  const std::array<Point, 3>& v = triangle.vertex;
  for (const Point p : v) {
    HS_CHECK(p.x >= config.coordinate_min() && p.x <= config.coordinate_max());
    HS_CHECK(p.y >= config.coordinate_min() && p.y <= config.coordinate_max());
  }
  HS_CHECK(frame.width >= 1 && frame.width <= config.max_size());
  HS_CHECK(frame.height >= 1 && frame.height <= config.max_size());
  HS_CHECK(within_extent(triangle, config));

  const std::int64_t area = doubled_area(v);
  HS_CHECK(fits(area, config.area_bits()));
  if (area == 0) return drop(SetupOutcome::kZeroArea);
  const bool flipped = area < 0;
  if ((frame.cull == Cull::kFront && flipped) || (frame.cull == Cull::kBack && !flipped)) {
    return drop(SetupOutcome::kCulled);
  }

  const SampleExtent extent = sample_extent(config.samples);
  const auto [x_min, x_max] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y_min, y_max] = std::minmax({v[0].y, v[1].y, v[2].y});
  const Span x = sample_span(x_min, x_max, extent.low.x, extent.high.x, frame.width, config);
  const Span y = sample_span(y_min, y_max, extent.low.y, extent.high.y, frame.height, config);
  if (x.first > x.last || y.first > y.last) return drop(SetupOutcome::kNoSample);

  SetupTriangle out;
  out.box = {x.first, y.first, x.last, y.last};
  out.flipped = flipped;
  out.tag = triangle.tag;
  const int f = config.position_bits();
  for (std::size_t i = 0; i < 3; ++i) {
    const Point from = v[i];
    const Point to = v[(i + 1) % 3];
    std::int64_t a = std::int64_t{from.y} - to.y;
    std::int64_t b = std::int64_t{to.x} - from.x;
    std::int64_t c = -((a * from.x + b * from.y) * (std::int64_t{1} << (f - config.subpixel_bits)));
    if (config.samples == 1) c += (a + b) * (std::int64_t{1} << (f - 1));
    if (flipped) {
      a = -a;
      b = -b;
      c = -c;
    }
    const bool top_left = a > 0 || (a == 0 && b > 0);
    if (!top_left) c -= 1;
    HS_CHECK(fits(a, config.delta_bits()) && fits(b, config.delta_bits()));
    out.slope[i] = {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)};
    out.e[i] =
        saturate(floor_shift(c, config.dropped_bits()), config.node_bits(config.node_log2(0)));
  }
  if (outcome != nullptr) *outcome = SetupOutcome::kDrawn;
  return out;
}

}  // namespace halfspace
