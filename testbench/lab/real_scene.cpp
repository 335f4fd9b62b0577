// SPDX-License-Identifier: Apache-2.0
#include "real_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fixed.hpp"
#include "geometry.hpp"
#include "rasterizer.hpp"
#include "scene/scene.hpp"
#include "vectors/generators.hpp"

namespace halfspace::lab {
namespace {

constexpr int kGuardBits = 13;  // geometry beyond +-2^13 px is cut

// Pixels with a centre in a range of coordinates, cut to the frame.
std::pair<int, int> centres(double least, double greatest, int size) {
  const double first = std::clamp(std::floor(least - 0.5), 0.0, static_cast<double>(size));
  const double last = std::clamp(std::ceil(greatest - 0.5), -1.0, size - 1.0);
  return {static_cast<int>(first), static_cast<int>(last)};
}

}  // namespace

RealScene real_scene(const Scene& scene, const FrameState& frame, const std::string& name) {
  RealScene out{name, frame.width, frame.height, {}};
  scene.real(0, kGuardBits, [&](const RealTriangle& triangle) {
    const auto px = [&](std::size_t i) {
      return oracle::Vec{triangle.vertex[i].x, triangle.vertex[i].y};
    };
    out.triangles.push_back({px(0), px(1), px(2)});
  });
  return out;
}

RealScene random_scene(std::uint64_t seed, int count, double side, int width, int height) {
  Random random(seed);
  const auto unit = [&random] { return std::ldexp(static_cast<double>(random.next() >> 12), -52); };
  RealScene scene{fmt::format("{} px triangles", side), width, height, {}};
  for (int n = 0; n < count; ++n) {
    const double x = unit() * (width - side);
    const double y = unit() * (height - side);
    oracle::Corners t;
    for (oracle::Vec& v : t) {
      v.x = x + unit() * side;
      v.y = y + unit() * side;
    }
    scene.triangles.push_back(t);
  }
  return scene;
}

std::vector<Triangle> snapped(const RealScene& scene, const Config& config) {
  std::vector<Triangle> out;
  out.reserve(scene.triangles.size());
  for (const oracle::Corners& corners : scene.triangles) {
    Triangle t;
    t.tag = static_cast<std::uint32_t>(out.size()) & (0xffffffffu >> (32 - config.tag_bits));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t x = snap(corners[i].x, config);
      const std::int64_t y = snap(corners[i].y, config);
      HS_CHECK(x >= config.coordinate_min() && x <= config.coordinate_max());
      HS_CHECK(y >= config.coordinate_min() && y <= config.coordinate_max());
      t.vertex[i] = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
    }
    out.push_back(t);
  }
  return out;
}

std::vector<std::vector<std::uint32_t>> oracle_pixels(const RealScene& scene) {
  std::vector<std::vector<std::uint32_t>> out(scene.triangles.size());
  for (std::size_t n = 0; n < out.size(); ++n) {
    const oracle::Corners& t = scene.triangles[n];
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
    const auto [x0, x1] = centres(left, right, scene.width);
    const auto [y0, y1] = centres(top, bottom, scene.height);
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        if (!oracle::covered(t, {x + 0.5, y + 0.5})) continue;
        out[n].push_back(static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(scene.width) +
                         static_cast<std::uint32_t>(x));
      }
    }
  }
  return out;
}

std::vector<std::vector<std::uint32_t>> model_pixels(const std::vector<Triangle>& triangles,
                                                     const RealScene& scene, const Config& config) {
  HS_CHECK(config.samples == 1);
  const FrameState frame{scene.width, scene.height, Cull::kNone};
  std::vector<std::vector<std::uint32_t>> out(triangles.size());
  RasterStats stats;
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    rasterize(triangles[n], frame, config, stats, [&](const CoverageTile& tile) {
      for (GridMask left = tile.mask[0]; left != 0; left &= left - 1) {
        const int bit = std::countr_zero(left);
        const int x = tile.x + bit % config.grid();
        const int y = tile.y + bit / config.grid();
        out[n].push_back(static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(scene.width) +
                         static_cast<std::uint32_t>(x));
      }
    });
    std::sort(out[n].begin(), out[n].end());
  }
  return out;
}

Difference compare(const std::vector<std::vector<std::uint32_t>>& found,
                   const std::vector<std::vector<std::uint32_t>>& truth) {
  HS_CHECK(found.size() == truth.size());
  Difference difference;
  for (std::size_t n = 0; n < found.size(); ++n) {
    std::uint64_t both = 0;
    auto f = found[n].begin();
    for (const std::uint32_t pixel : truth[n]) {
      f = std::lower_bound(f, found[n].end(), pixel);
      both += f != found[n].end() && *f == pixel ? 1u : 0u;
    }
    difference.covered += truth[n].size();
    difference.missing += truth[n].size() - both;
    difference.extra += found[n].size() - both;
  }
  return difference;
}

}  // namespace halfspace::lab
