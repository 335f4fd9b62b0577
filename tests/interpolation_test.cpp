// SPDX-License-Identifier: Apache-2.0
//
// Depth and attributes against real-valued interpolation, at covered samples of triangles of every
// extent, shape and perspective. The reference is written from the definition (weights are ratios
// of areas) in long double, whose 64-bit mantissa is well beyond the bounds tested.
#include "interpolation.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "rasterizer.hpp"
#include "samples.hpp"

namespace halfspace {
namespace {

using Real = long double;

// A triangle with real-valued depth 0..1, w > 0 and one attribute 0..255 at its vertices.
struct RealTriangle {
  Triangle triangle;
  std::array<double, 3> depth;
  std::array<double, 3> w;
  std::array<double, 3> attribute;
};

// The packing that geometry.md describes, from its text.
std::array<VertexAttributes, 3> pack(const RealTriangle& t, const Config& config) {
  double greatest = 0;
  for (const double w : t.w) greatest = std::max(greatest, 1 / w);
  int exponent = 0;
  std::frexp(greatest, &exponent);
  const double one = std::ldexp(1.0, config.inverse_w_bits);
  std::array<VertexAttributes, 3> out;
  for (std::size_t i = 0; i < 3; ++i) {
    const double depth_scale = std::ldexp(1.0, 30) - std::ldexp(1.0, 30 - config.depth_bits);
    out[i].depth = static_cast<std::int32_t>(std::nearbyint(t.depth[i] * depth_scale));
    const double inverse_w = std::nearbyint(std::ldexp(1 / t.w[i], -exponent) * one);
    out[i].inverse_w = static_cast<std::uint32_t>(std::clamp(inverse_w, 1.0, one - 1));
    out[i].value[0] = static_cast<std::int32_t>(std::nearbyint(t.attribute[i] * 256));
  }
  return out;
}

// True values at the sample (x, y), S.f px: depth in 0..1, attribute in 0..255.
struct Truth {
  Real depth;
  Real attribute;
};
Truth truth(const RealTriangle& t, std::int64_t x, std::int64_t y, const Config& config) {
  const int up = config.position_bits() - config.subpixel_bits;
  std::array<Real, 3> weight{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point p = t.triangle.vertex[(i + 1) % 3];
    const Point q = t.triangle.vertex[(i + 2) % 3];
    const __int128 px = (std::int64_t{p.x} << up) - x;
    const __int128 py = (std::int64_t{p.y} << up) - y;
    const __int128 qx = (std::int64_t{q.x} << up) - x;
    const __int128 qy = (std::int64_t{q.y} << up) - y;
    weight[i] = static_cast<Real>(px * qy - py * qx);
  }
  const Real sum = weight[0] + weight[1] + weight[2];
  Truth out{0, 0};
  Real over_w = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Real share = weight[i] / sum;
    out.depth += share * t.depth[i];
    over_w += share / t.w[i];
    out.attribute += share * t.attribute[i] / t.w[i];
  }
  out.attribute /= over_w;
  return out;
}

struct Errors {
  double depth = 0;      // LSB of the depth buffer
  double attribute = 0;  // levels of 255
  long samples = 0;
};

// Greatest errors over covered samples of one triangle; every `stride`th covered tile is looked at.
void measure(const RealTriangle& t, const FrameState& frame, const Config& config, int stride,
             Errors& errors) {
  const std::array<VertexAttributes, 3> packed = pack(t, config);
  InterpolationSetup planes;
  RasterStats stats;
  long seen = 0;
  const auto on_tile = [&](const CoverageTile& tile) {
    if (seen++ % stride != 0) return;
    const TilePlane depth = tile_plane(planes.depth, planes.origin, tile.x, tile.y, config);
    const TilePlane u = tile_plane(planes.inverse_w, planes.origin, tile.x, tile.y, config);
    const TilePlane a = tile_plane(planes.attribute[0], planes.origin, tile.x, tile.y, config);
    for (int m = 0; m < config.samples; ++m) {
      const SamplePosition p = sample_positions(config.samples)[static_cast<std::size_t>(m)];
      const auto at = [&](const TilePlane& plane, const Plane& whole, int i, int j) {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(plane.at(i, j)) +
                                         sample_delta(whole, m, config));
      };
      for (GridMask rest = tile.mask[static_cast<std::size_t>(m)]; rest != 0; rest &= rest - 1) {
        const int lane = std::countr_zero(rest);
        const int i = lane & (config.grid() - 1);
        const int j = lane >> config.grid_log2;
        const int f = config.position_bits();
        const Truth real =
            truth(t, (std::int64_t{tile.x + i} << f) + ((std::int64_t{p.x} << f) >> 4),
                  (std::int64_t{tile.y + j} << f) + ((std::int64_t{p.y} << f) >> 4), config);
        const double full = std::ldexp(1.0, config.depth_bits) - 1;
        const double got = depth_value(at(depth, planes.depth, i, j), config);
        errors.depth =
            std::max(errors.depth, std::abs(static_cast<double>(real.depth * full - got)));
        const double level = perspective(at(a, planes.attribute[0], i, j),
                                         at(u, planes.inverse_w, i, j), planes.level[0], config);
        errors.attribute =
            std::max(errors.attribute, std::abs(static_cast<double>(real.attribute - level)));
        ++errors.samples;
      }
    }
  };
  rasterize(
      t.triangle, frame, config, stats,
      [&](const SetupTriangle& setup) {
        planes = interpolation_setup(setup, t.triangle, packed, 1, config);
      },
      [](const Node&, int, bool) {}, on_tile);
}

// Shapes by turn: anything, slivers a subpixel wide, and triangles that touch a corner of the
// frame.
RealTriangle random_triangle(std::mt19937_64& random, int extent, double w_ratio, int index,
                             const Config& config) {
  const auto side = static_cast<std::int64_t>(extent) << config.subpixel_bits;
  const auto coordinate = [&] {
    return static_cast<std::int32_t>(random() % static_cast<std::uint64_t>(side + 1));
  };
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  RealTriangle t{};
  for (Point& p : t.triangle.vertex) p = {coordinate(), coordinate()};
  if (index % 3 == 1) {  // a sliver along an edge
    const Point p = t.triangle.vertex[0];
    const Point q = t.triangle.vertex[1];
    t.triangle.vertex[2] = {(p.x + q.x) / 2 + static_cast<std::int32_t>(random() % 3),
                            std::min((p.y + q.y) / 2 + static_cast<std::int32_t>(random() % 200),
                                     static_cast<std::int32_t>(side))};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    t.depth[i] = index % 5 == 0 ? (i == 1 ? 1.0 : 0.0) : unit();
    t.w[i] = 0.37 * std::pow(w_ratio, index % 4 == 0 ? (i == 2 ? 1.0 : 0.0) : unit());
    t.attribute[i] = index % 7 == 0 ? (i == 0 ? 255.0 : 0.0) : 255 * unit();
  }
  return t;
}

Errors measure_many(const Config& config, int extent, double w_ratio, int count, int stride,
                    std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Errors errors;
  const int size = std::min(extent, config.max_size());
  for (int i = 0; i < count; ++i) {
    measure(random_triangle(random, extent, w_ratio, i, config), {size, size}, config, stride,
            errors);
  }
  return errors;
}

constexpr std::uint64_t kSeed = 20261122;

// Bounds of docs/03_design/interpolation.md.
constexpr double kDepthBound = 0.66;
double attribute_bound(double w_ratio) { return 0.53 + w_ratio * 0x1p-16; }

TEST(Interpolation, StaysWithinItsBoundAtEveryExtent) {
  for (const int extent : {3, 16, 64, 300, 1000, 4096}) {
    const Errors e =
        measure_many(kFull, extent, 8, extent < 300 ? 3000 : 150, extent < 300 ? 1 : 97, kSeed);
    EXPECT_GT(e.samples, 1000) << "extent " << extent;
    EXPECT_LE(e.depth, kDepthBound) << "extent " << extent << " seed " << kSeed;
    EXPECT_LE(e.attribute, attribute_bound(8)) << "extent " << extent << " seed " << kSeed;
  }
}

TEST(Interpolation, IsWithinOneLevelForWRatiosUpTo16384) {
  for (const double ratio : {1.0, 2.0, 100.0, 1000.0, 16384.0}) {
    const Errors e = measure_many(kFull, 400, ratio, 300, 7, kSeed + 1);
    EXPECT_LE(e.attribute, attribute_bound(ratio)) << "ratio " << ratio << " seed " << kSeed + 1;
    EXPECT_LT(e.attribute, 1.0) << "ratio " << ratio;
  }
}

TEST(Interpolation, StaysWithinItsBoundForEverySampleCountAndGrid) {
  for (const int samples : {1, 2, 4, 8, 16}) {
    for (const int s : {0, 4, 8, 12}) {
      Config config = kFull;
      config.samples = samples;
      config.subpixel_bits = s;
      config.grid_log2 = samples == 4 ? 2 : 3;
      const Errors e = measure_many(config, 200, 8, 200, 5, kSeed + 2);
      EXPECT_LE(e.depth, kDepthBound) << "samples " << samples << " s " << s;
      EXPECT_LE(e.attribute, attribute_bound(8)) << "samples " << samples << " s " << s;
    }
  }
}

TEST(Interpolation, StaysWithinItsBoundWithFewerDepthBits) {
  Config config = kTiny;
  config.depth_bits = 16;
  const Errors e = measure_many(config, 400, 4, 300, 3, kSeed + 3);
  EXPECT_LE(e.depth, 0.51);
}

// Fewer bits cost what the table says they do: the bound is about these widths, not about luck.
TEST(Interpolation, LosesPrecisionWithFewerGradientOrReciprocalBits) {
  Config coarse = kFull;
  coarse.gradient_bits = 2;
  EXPECT_GT(measure_many(coarse, 4000, 1, 60, 211, kSeed).depth, 2.0);
  Config rough = kFull;
  rough.reciprocal_bits = 8;
  const Errors e = measure_many(rough, 300, 8, 200, 7, kSeed);
  EXPECT_GT(e.attribute, 0.7);
  EXPECT_LT(e.attribute, 0.5 + 1.0 + 2.0 + 0.1);  // centred mantissa, floored reciprocal
}

// Equal attributes stay what they are over the whole triangle, whatever the perspective.
TEST(Interpolation, ConstantAttributeIsConstant) {
  std::mt19937_64 random(kSeed + 4);
  for (int i = 0; i < 500; ++i) {
    RealTriangle t = random_triangle(random, 200, 1000, i, kFull);
    for (double& a : t.attribute) a = i % 256;
    const std::array<VertexAttributes, 3> packed = pack(t, kFull);
    InterpolationSetup planes;
    RasterStats stats;
    rasterize(
        t.triangle, {200, 200}, kFull, stats,
        [&](const SetupTriangle& setup) {
          planes = interpolation_setup(setup, t.triangle, packed, 1, kFull);
        },
        [](const Node&, int, bool) {},
        [&](const CoverageTile& tile) {
          const TilePlane u = tile_plane(planes.inverse_w, planes.origin, tile.x, tile.y, kFull);
          const TilePlane a = tile_plane(planes.attribute[0], planes.origin, tile.x, tile.y, kFull);
          for (GridMask rest = tile.mask[0]; rest != 0; rest &= rest - 1) {
            const int lane = std::countr_zero(rest);
            ASSERT_EQ(perspective(a.at(lane & 7, lane >> 3), u.at(lane & 7, lane >> 3),
                                  planes.level[0], kFull),
                      i % 256);
          }
        });
  }
}

}  // namespace
}  // namespace halfspace
