// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>

#include "soak.hpp"

namespace halfspace {
namespace {

using Axis = std::int32_t Point::*;  // x or y

using Triangles = std::vector<ShadedTriangle>;

// Legal input to triangle_setup.
bool legal(const Triangle& triangle, const Config& config) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Point a = triangle.vertex[i];
    const Point b = triangle.vertex[(i + 1) % 3];
    for (const std::int64_t value : {a.x, a.y}) {
      if (value < config.coordinate_min() || value > config.coordinate_max()) return false;
    }
    const auto apart = [](std::int64_t p, std::int64_t q) { return std::abs(p - q); };
    if (std::max(apart(a.x, b.x), apart(a.y, b.y)) > config.extent_max()) return false;
  }
  return true;
}

std::int64_t size_of(const Triangle& triangle) {
  std::int64_t sum = 0;
  for (const Point p : triangle.vertex) {
    sum += std::abs(std::int64_t{p.x}) + std::abs(std::int64_t{p.y});
  }
  return sum;
}

class Shrinker {
 public:
  Shrinker(Triangles triangles, const Config& config, const Fails& fails)
      : triangles_(std::move(triangles)), config_(config), fails_(fails) {}

  Triangles run() {
    drop();
    while (reduce()) {
    }
    return triangles_;
  }

 private:
  bool take(Triangles candidate) {
    if (candidate.empty() || !fails_(candidate)) return false;
    triangles_ = std::move(candidate);
    return true;
  }

  // Leaves parts of the list out, halves first, then smaller parts, down to single triangles.
  void drop() {
    for (std::size_t part = triangles_.size() / 2; part > 0; part /= 2) {
      for (std::size_t at = 0; at < triangles_.size();) {
        Triangles fewer = triangles_;
        const auto first = fewer.begin() + static_cast<std::ptrdiff_t>(at);
        const auto count = static_cast<std::ptrdiff_t>(std::min(part, fewer.size() - at));
        fewer.erase(first, first + count);
        if (!take(std::move(fewer))) at += part;
      }
    }
  }

  // One, two or three vertices of a triangle at a time towards zero; whether any moved.
  bool reduce() {
    bool changed = false;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (const unsigned vertices : {7u, 3u, 5u, 6u, 1u, 2u, 4u}) {
        for (const Axis axis : {&Point::x, &Point::y}) {
          while (reduce(t, vertices, axis)) changed = true;
        }
      }
    }
    return changed;
  }

  // By the greatest of a few steps with which it still fails.
  bool reduce(std::size_t t, unsigned vertices, Axis axis) {
    const std::int32_t pixel = 1 << config_.subpixel_bits;
    for (std::size_t v = 0; v < 3; ++v) {
      if ((vertices >> v & 1) == 0) continue;
      const std::int32_t old = triangles_[t].triangle.vertex[v].*axis;
      const std::int32_t sign = old > 0 ? 1 : -1;
      for (const std::int32_t step :
           {old, old / pixel * pixel, old / 2, old / 2 / pixel * pixel, sign * pixel, sign}) {
        Triangles other = triangles_;
        for (std::size_t i = 0; i < 3; ++i) {
          if ((vertices >> i & 1) != 0) other[t].triangle.vertex[i].*axis -= step;
        }
        if (size_of(other[t].triangle) >= size_of(triangles_[t].triangle)) continue;
        if (legal(other[t].triangle, config_) && take(std::move(other))) return true;
      }
    }
    return false;
  }

  Triangles triangles_;
  const Config& config_;
  const Fails& fails_;
};

}  // namespace

std::vector<ShadedTriangle> shrink(std::vector<ShadedTriangle> triangles, const Config& config,
                                   const Fails& fails) {
  return Shrinker(std::move(triangles), config, fails).run();
}

}  // namespace halfspace
