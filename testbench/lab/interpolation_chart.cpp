// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "charts.hpp"
#include "fixed.hpp"
#include "interpolation.hpp"
#include "rasterizer.hpp"
#include "vectors/generators.hpp"

namespace halfspace::lab {
namespace {

constexpr std::uint64_t kSeed = 850;
constexpr int kTriangles = 1500;
constexpr int kFrame = 1024;
constexpr double kGreatestRatio = 16.0;  // of w within a triangle

using Wide = __int128;

struct Errors {
  double greatest = 0;
  double squares = 0;
  std::uint64_t count = 0;
  void add(double error) {
    greatest = std::max(greatest, std::abs(error));
    squares += error * error;
    ++count;
  }
  double rms() const { return count == 0 ? 0.0 : std::sqrt(squares / static_cast<double>(count)); }
};

struct Measured {
  Errors attribute;  // 8-bit LSB
  Errors depth;      // LSB of depth_bits
};

// numerator / denominator as a double, from the exact quotient and remainder.
double ratio(Wide numerator, Wide denominator) {
  const Wide whole = floor_div(numerator, denominator);
  const Wide rest = numerator - whole * denominator;
  return static_cast<double>(whole) + static_cast<double>(rest) / static_cast<double>(denominator);
}

std::array<VertexAttributes, 3> invented_attributes(Random& random, const Config& config) {
  std::array<VertexAttributes, 3> out;
  const double most = std::ldexp(1.0, config.inverse_w_bits) - 1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = std::ldexp(static_cast<double>(random.in(0, 1 << 20)), -20);
    const double w = i == 0 ? 1.0 : 1.0 + part * (kGreatestRatio - 1.0);
    out[i].inverse_w = static_cast<std::uint32_t>(most / w);
    const int unit = kPlaneBits - config.depth_bits;  // log2 of an LSB
    out[i].depth =
        static_cast<std::int32_t>(random.in(0, (std::int64_t{1} << kPlaneBits) - (1 << unit)));
    out[i].value[0] = static_cast<std::int32_t>(random.in(0, 255 << kAttributeFractionBits));
  }
  return out;
}

// The exact values at a pixel centre: edge values are the weights of the vertices opposite.
struct Exact {
  double attribute;
  double depth;
};
Exact exact_at(const ShadedTriangle& t, int x, int y, const Config& config) {
  // Twice the subpixel scale, so that the half pixel is whole for every s.
  const Wide px = (2 * x + 1) * (Wide{1} << config.subpixel_bits);
  const Wide py = (2 * y + 1) * (Wide{1} << config.subpixel_bits);
  const auto& v = t.triangle.vertex;
  std::array<Wide, 3> weight{};
  Wide sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point from = v[(i + 1) % 3];
    const Point to = v[(i + 2) % 3];
    weight[i] = (Wide{from.y} - to.y) * (px - 2 * Wide{from.x}) +
                (Wide{to.x} - from.x) * (py - 2 * Wide{from.y});
    sum += weight[i];
  }
  Wide over_w = 0, inverse_w = 0, depth = 0;
  const int sign = sum < 0 ? -1 : 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexAttributes& a = t.attributes[i];
    over_w += sign * weight[i] * a.inverse_w * a.value[0];
    inverse_w += sign * weight[i] * a.inverse_w;
    depth += sign * weight[i] * a.depth;
  }
  return {ratio(over_w, inverse_w * (1 << kAttributeFractionBits)),
          ratio(depth, sign * sum * (Wide{1} << (kPlaneBits - config.depth_bits)))};
}

void measure(const ShadedTriangle& t, const FrameState& frame, const Config& config,
             Measured& out) {
  RasterStats stats;
  InterpolationSetup planes;
  rasterize(
      t.triangle, frame, config, stats,
      [&](const SetupTriangle& setup) {
        planes = interpolation_setup(setup, t.triangle, t.attributes, 1, config);
      },
      [](const Node&, int, bool) {},
      [&](const CoverageTile& tile) {
        const auto plane = [&](const Plane& p) {
          return tile_plane(p, planes.origin, tile.x, tile.y, config);
        };
        const TilePlane w = plane(planes.inverse_w);
        const TilePlane a = plane(planes.attribute[0]);
        const TilePlane d = plane(planes.depth);
        for (GridMask left = tile.mask[0]; left != 0; left &= left - 1) {
          const int bit = std::countr_zero(left);
          const int i = bit % config.grid();
          const int j = bit / config.grid();
          const Exact exact = exact_at(t, tile.x + i, tile.y + j, config);
          out.attribute.add(perspective(a.at(i, j), w.at(i, j), planes.level[0], config) -
                            exact.attribute);
          out.depth.add(depth_value(d.at(i, j), config) - exact.depth);
        }
      });
}

Json measured_json(const std::vector<ShadedTriangle>& triangles, const FrameState& frame,
                   const Config& config) {
  Measured m;
  for (const ShadedTriangle& t : triangles) measure(t, frame, config, m);
  return {{"reciprocal_bits", config.reciprocal_bits},
          {"gradient_bits", config.gradient_bits},
          {"samples", m.attribute.count},
          {"attribute_max_lsb", m.attribute.greatest},
          {"attribute_rms_lsb", m.attribute.rms()},
          {"depth_max_lsb", m.depth.greatest},
          {"depth_rms_lsb", m.depth.rms()}};
}

// Sides of 2 to 1024 px, fewer of the large ones: each class costs about the same.
RealScene mixed_sizes() {
  RealScene scene{"random triangles of 2 to 1024 px, w ratio up to 16", kFrame, kFrame, {}};
  for (int log2 = 1; log2 <= 10; ++log2) {
    const double side = std::ldexp(1.0, log2);
    const int count = std::clamp(static_cast<int>(2e5 / (side * side)), 3, kTriangles);
    const RealScene part =
        random_scene(kSeed + static_cast<std::uint64_t>(log2), count, side, kFrame, kFrame);
    scene.triangles.insert(scene.triangles.end(), part.triangles.begin(), part.triangles.end());
  }
  return scene;
}

}  // namespace

Json interpolation_chart(const RealScene* chosen) {
  const RealScene scene = chosen == nullptr ? mixed_sizes() : *chosen;
  Config config;
  config.guard_bits = 14;
  const FrameState frame{scene.width, scene.height, Cull::kNone};
  Random random(kSeed);
  std::vector<ShadedTriangle> triangles;
  for (const Triangle& t : snapped(scene, config)) {
    triangles.push_back({t, invented_attributes(random, config)});
  }
  Json data;
  data["chart"] = "interpolation";
  data["scene"] = scene.name;
  data["depth_bits"] = config.depth_bits;
  const Config best = config;
  for (config.reciprocal_bits = 6; config.reciprocal_bits <= 16; ++config.reciprocal_bits) {
    data["by_reciprocal_bits"].push_back(measured_json(triangles, frame, config));
  }
  config = best;
  for (config.gradient_bits = 0; config.gradient_bits <= 20; config.gradient_bits += 2) {
    data["by_gradient_bits"].push_back(measured_json(triangles, frame, config));
  }
  return data;
}

}  // namespace halfspace::lab
