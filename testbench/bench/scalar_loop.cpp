// SPDX-License-Identifier: Apache-2.0
#include "scalar_loop.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <utility>

namespace halfspace {

std::uint64_t scalar_cover(const Triangle& triangle, const FrameState& frame, const Config& config,
                           std::vector<ScalarRecord>& records) {
  const int s = config.subpixel_bits;
  const std::int64_t half = std::int64_t{1} << (s - 1);
  std::array<Point, 3> v = triangle.vertex;
  const auto d = [](std::int32_t to, std::int32_t from) { return std::int64_t{to} - from; };
  const std::int64_t area =
      d(v[1].x, v[0].x) * d(v[2].y, v[0].y) - d(v[1].y, v[0].y) * d(v[2].x, v[0].x);
  if (area == 0) return 0;
  if (area < 0) std::swap(v[1], v[2]);
  const auto pixel = [s, half](std::int64_t p) { return static_cast<int>((p + half - 1) >> s); };
  const auto [x_min, x_max] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y_min, y_max] = std::minmax({v[0].y, v[1].y, v[2].y});
  const int x0 = std::max(pixel(x_min), 0);
  const int y0 = std::max(pixel(y_min), 0);
  const int x1 = std::min(pixel(x_max) - 1, frame.width - 1);
  const int y1 = std::min(pixel(y_max) - 1, frame.height - 1);
  std::array<std::int64_t, 3> a{}, b{}, e{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    a[i] = d(v[i].y, v[j].y);
    b[i] = d(v[j].x, v[i].x);
    e[i] = a[i] * (half - v[i].x) + b[i] * (half - v[i].y) -
           (a[i] > 0 || (a[i] == 0 && b[i] > 0) ? 0 : 1);
    a[i] <<= s;
    b[i] <<= s;
  }
  std::uint64_t covered = 0;
  for (int tile_y = y0 & ~7; tile_y <= y1; tile_y += 8) {
    for (int tile_x = x0 & ~7; tile_x <= x1; tile_x += 8) {
      const int left = std::max(tile_x, x0);
      const int right = std::min(tile_x + 7, x1);
      const int top = std::max(tile_y, y0);
      const int bottom = std::min(tile_y + 7, y1);
      std::uint64_t mask = 0;
      std::int64_t row0 = e[0] + a[0] * left + b[0] * top;
      std::int64_t row1 = e[1] + a[1] * left + b[1] * top;
      std::int64_t row2 = e[2] + a[2] * left + b[2] * top;
      for (int y = top; y <= bottom; ++y) {
        std::int64_t e0 = row0, e1 = row1, e2 = row2;
        for (int x = left; x <= right; ++x) {
          mask |= std::uint64_t{(e0 | e1 | e2) >= 0} << ((y & 7) * 8 + (x & 7));
          e0 += a[0];
          e1 += a[1];
          e2 += a[2];
        }
        row0 += b[0];
        row1 += b[1];
        row2 += b[2];
      }
      if (mask == 0) continue;
      covered += static_cast<std::uint64_t>(std::popcount(mask));
      records.push_back({mask, static_cast<std::uint32_t>(tile_y << 13 | tile_x >> 3)});
    }
  }
  return covered;
}

}  // namespace halfspace
