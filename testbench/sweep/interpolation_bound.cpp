// SPDX-License-Identifier: Apache-2.0
#include "interpolation_bound.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "depth.hpp"
#include "interpolation.hpp"
#include "rasterizer.hpp"
#include "samples.hpp"
#include "shading.hpp"

namespace halfspace {
namespace {

__extension__ using Wide = __int128;

// Twice the signed areas that weigh the vertices at a position, in units of 2^-2f px^2.
struct Weights {
  std::array<Wide, 3> of{};
  Wide sum = 0;
};
Weights weights_at(const Triangle& triangle, std::int64_t x, std::int64_t y, const Config& config) {
  const int up = config.position_bits() - config.subpixel_bits;
  Weights out;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point p = triangle.vertex[(i + 1) % 3];
    const Point q = triangle.vertex[(i + 2) % 3];
    const Wide px = (std::int64_t{p.x} << up) - x, py = (std::int64_t{p.y} << up) - y;
    const Wide qx = (std::int64_t{q.x} << up) - x, qy = (std::int64_t{q.y} << up) - y;
    out.of[i] = px * qy - py * qx;
    out.sum += out.of[i];
  }
  return out;
}

// One triangle, sample by sample.
class Judge {
 public:
  Judge(const ShadedTriangle& shaded, const SetupTriangle& setup, const Config& config)
      : shaded_(shaded),
        config_(config),
        planes_(interpolation_setup(setup, shaded.triangle, shaded.attributes, config.attributes,
                                    config)) {}

  std::string tile(const CoverageTile& tile) {
    for (int m = 0; m < config_.samples; ++m) {
      for (GridMask rest = tile.mask[static_cast<std::size_t>(m)]; rest != 0; rest &= rest - 1) {
        const std::string text = sample(tile, m, std::countr_zero(rest));
        if (!text.empty()) return text;
      }
    }
    return {};
  }

 private:
  // Units that a plane may be off at a sample of the tile: the table of interpolation.md.
  double units_off(const CoverageTile& tile) const {
    const double step = std::ldexp(1.0, -config_.gradient_bits);
    const double side = config_.grid() - 1;
    const Point v = planes_.origin;
    const double ex = std::abs(tile.x - std::ldexp(v.x, -config_.subpixel_bits)) + 1;
    const double ey = std::abs(tile.y - std::ldexp(v.y, -config_.subpixel_bits)) + 1;
    const double reciprocal = 0.75;
    return (ex + ey) * step + reciprocal + step + 1 + side + 2 * side * step +
           (config_.samples > 1 ? 1 : 0);
  }

  std::int32_t value(const Plane& plane, const CoverageTile& tile, int m, int lane) const {
    const TilePlane at = tile_plane(plane, planes_.origin, tile.x, tile.y, config_);
    const int i = lane & (config_.grid() - 1);
    const int j = lane >> config_.grid_log2;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(at.at(i, j)) +
                                     sample_delta(plane, m, config_));
  }

  std::string sample(const CoverageTile& tile, int m, int lane) const {
    const SamplePosition p = sample_positions(config_.samples)[static_cast<std::size_t>(m)];
    const int f = config_.position_bits();
    const std::int64_t x = tile.x + (lane & (config_.grid() - 1));
    const std::int64_t y = tile.y + (lane >> config_.grid_log2);
    const Weights weights = weights_at(shaded_.triangle, (x << f) + ((std::int64_t{p.x} << f) >> 4),
                                       (y << f) + ((std::int64_t{p.y} << f) >> 4), config_);
    const double off = units_off(tile);
    const std::string place = fmt::format("pixel ({}, {}) sample {}: ", x, y, m);

    Wide depth = 0, over_w = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      depth += weights.of[i] * shaded_.attributes[i].depth;
      over_w += weights.of[i] * shaded_.attributes[i].inverse_w;
    }
    const std::uint32_t got = depth_value(value(planes_.depth, tile, m, lane), config_);
    const int down = kPlaneBits - config_.depth_bits;  // an LSB of depth in units of the plane
    const double wrong = down >= 0
                             ? ratio((Wide{got} << down) * weights.sum - depth, weights.sum << down)
                             : ratio(got * weights.sum - (depth << -down), weights.sum);
    const double allowed = off * std::ldexp(1.0, -down) + 0.5;
    if (wrong > allowed) {
      return place + fmt::format("depth {} is {} LSB off, allowed {}", got, wrong, allowed);
    }
    // In the units of the plane.
    const double u = ratio(over_w, weights.sum) * std::ldexp(1.0, 30 - config_.inverse_w_bits);
    if (u <= 4 * (off + 1)) return {};
    return attributes(tile, m, lane, weights, over_w, allowed_attribute(off + 0.5, u), place);
  }

  // Levels of 255 for planes that are `off` units off, 1/w being u.
  double allowed_attribute(double off, double u) const {
    // 1/w cut to R bits and centred, the reciprocal floored, a/w cut to 16 bits, the result
    // rounded.
    const double reciprocal = 3 * std::ldexp(256.0, -config_.reciprocal_bits);
    return 512 * off / (u - off) + reciprocal + 0x1p-7 + 0.5;
  }

  std::string attributes(const CoverageTile& tile, int m, int lane, const Weights& weights,
                         Wide over_w, double allowed, const std::string& place) const {
    const std::int32_t inverse_w = value(planes_.inverse_w, tile, m, lane);
    for (std::size_t n = 0; n < static_cast<std::size_t>(config_.attributes); ++n) {
      Wide sum = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexAttributes& vertex = shaded_.attributes[i];
        sum += weights.of[i] * vertex.inverse_w * vertex.value[n];
      }
      const int got = perspective(value(planes_.attribute[n], tile, m, lane), inverse_w,
                                  planes_.level[n], config_);
      const double wrong =
          ratio(((over_w * got) << kAttributeFractionBits) - sum, over_w << kAttributeFractionBits);
      if (wrong > allowed) {
        return place +
               fmt::format("attribute {} is {}, {} levels off, allowed {}", n, got, wrong, allowed);
      }
    }
    return {};
  }

  // |a / b|: exact until here.
  static double ratio(Wide a, Wide b) {
    return static_cast<double>(std::abs(static_cast<long double>(a) / static_cast<long double>(b)));
  }

  const ShadedTriangle& shaded_;
  const Config& config_;
  InterpolationSetup planes_;
};

}  // namespace

std::string interpolation_fault(const ShadedTriangle& shaded, const FrameState& frame,
                                const Config& config) {
  std::optional<Judge> judge;
  std::string text;
  RasterStats unused;
  rasterize(
      shaded.triangle, frame, config, unused,
      [&](const SetupTriangle& setup) { judge.emplace(shaded, setup, config); },
      [](const Node&, int, bool) {},
      [&](const CoverageTile& tile) {
        if (text.empty()) text = judge->tile(tile);
      });
  return text;
}

}  // namespace halfspace
