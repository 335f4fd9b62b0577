// SPDX-License-Identifier: Apache-2.0
#include "interpolation.hpp"

#include <algorithm>
#include <bit>

#include "fixed.hpp"
#include "samples.hpp"

namespace halfspace {
namespace {

// numerator 2^fraction / area modulo 2^64. The quotient of a sliver may be far wider; its low bits
// are all that later sums use.
std::uint64_t gradient(std::int64_t numerator, int fraction, const AreaReciprocal& area) {
  return static_cast<std::uint64_t>(static_cast<__int128>(numerator) *
                                        static_cast<std::int64_t>(area.factor) >>
                                    (area.shift - fraction));
}

// The plane through three vertex values (units): vertex i is opposite edge (i + 1) mod 3, so its
// weight changes by A of that edge over the doubled area.
Plane make_plane(const std::array<std::int64_t, 3>& value, std::size_t origin,
                 const SetupTriangle& setup, const AreaReciprocal& area, const Config& config) {
  // The slopes of all edges sum to zero, so differences to any vertex give the same sum.
  const std::int64_t d1 = value[1] - value[0];
  const std::int64_t d2 = value[2] - value[0];
  const int fraction = config.subpixel_bits + config.gradient_bits;
  return {static_cast<std::uint64_t>(value[origin]) << config.gradient_bits,
          gradient(d1 * setup.slope[2].a + d2 * setup.slope[0].a, fraction, area),
          gradient(d1 * setup.slope[2].b + d2 * setup.slope[0].b, fraction, area)};
}

// The whole level that all three values reach, 0..255.
std::uint8_t level_of(std::int32_t a, std::int32_t b, std::int32_t c) {
  return static_cast<std::uint8_t>(
      std::clamp(std::min({a, b, c}) >> kAttributeFractionBits, 0, 255));
}

// a / 256 * inverse_w in units: S9.8 times U0.30, rounded to nearest.
std::int64_t over_w(std::int32_t value, std::int64_t inverse_w_units) {
  constexpr int kShift = 8 + kAttributeFractionBits;
  return (std::int64_t{value} * inverse_w_units + (std::int64_t{1} << (kShift - 1))) >> kShift;
}

constexpr int kUnitBits = 32;  // of a value at a sample

std::uint64_t low_bits(std::uint64_t value, int bits) {
  return value & (~std::uint64_t{0} >> (64 - bits));
}

std::uint64_t floor_mod(std::uint64_t value, int shift) {
  return static_cast<std::uint64_t>(floor_shift(static_cast<std::int64_t>(value), shift));
}

// A gradient rounded to nearest units, halves up.
std::uint32_t to_units(std::uint64_t gradient, int F) {
  const std::uint64_t half = F > 0 ? std::uint64_t{1} << (F - 1) : 0;
  return static_cast<std::uint32_t>(floor_mod(gradient + half, F));
}

// What a plane changes by from its origin to the centre of pixel (x, y), S.(F+f) units.
std::uint64_t slopes_to_centre(const Plane& plane, Point origin, std::int32_t x, std::int32_t y,
                               const Config& config) {
  const int f = config.position_bits();
  const auto distance = [&](std::int32_t pixel, std::int32_t vertex) {
    return static_cast<std::uint64_t>((std::int64_t{pixel} << f) + (std::int64_t{1} << (f - 1)) -
                                      (std::int64_t{vertex} << (f - config.subpixel_bits)));
  };
  return plane.dx * distance(x, origin.x) + plane.dy * distance(y, origin.y);
}

}  // namespace

std::int64_t doubled_area(const SetupTriangle& setup) {
  const std::int64_t cross = std::int64_t{setup.slope[0].a} * setup.slope[1].b -
                             std::int64_t{setup.slope[0].b} * setup.slope[1].a;
  // Negating both edges, as setup does, leaves its sign.
  return setup.flipped ? -cross : cross;
}

AreaReciprocal area_reciprocal(std::int64_t area) {
  HS_CHECK(area > 0 && fits(area, 63));
  const int zeros = std::countl_zero(static_cast<std::uint64_t>(area));
  const std::uint64_t mantissa = static_cast<std::uint64_t>(area) << zeros >> 32;
  // The divisor is odd, so 2^64 - 1 has the same quotient.
  return {2 * (~std::uint64_t{0} / (2 * mantissa + 1)) + 1, 96 - zeros};
}

InterpolationSetup interpolation_setup(const SetupTriangle& setup, const Triangle& triangle,
                                       const std::array<VertexAttributes, 3>& attributes, int count,
                                       const Config& config) {
  HS_CHECK(count >= 0 && count <= config.attributes);
  const AreaReciprocal area = area_reciprocal(doubled_area(setup));
  const int inverse_w_shift = kPlaneBits - config.inverse_w_bits;

  InterpolationSetup out;
  const std::size_t origin = first_vertex(triangle.vertex);
  out.origin = triangle.vertex[origin];
  std::array<std::int64_t, 3> depth{};
  std::array<std::int64_t, 3> inverse_w{};
  for (std::size_t i = 0; i < 3; ++i) {
    depth[i] = attributes[i].depth;
    HS_CHECK(depth[i] >= kDepthLeast && depth[i] <= kDepthMost);
    if (count == 0) continue;
    HS_CHECK(attributes[i].inverse_w >= 1 && attributes[i].inverse_w >> config.inverse_w_bits == 0);
    inverse_w[i] = std::int64_t{attributes[i].inverse_w} << inverse_w_shift;
  }
  out.depth = make_plane(depth, origin, setup, area, config);
  if (count == 0) return out;
  out.inverse_w = make_plane(inverse_w, origin, setup, area, config);
  for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n) {
    std::array<std::int64_t, 3> value{};
    out.level[n] = level_of(attributes[0].value[n], attributes[1].value[n], attributes[2].value[n]);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t at = attributes[i].value[n];
      HS_CHECK(at >= kValueLeast && at <= kValueMost);
      value[i] = over_w(at - (out.level[n] << kAttributeFractionBits), inverse_w[i]);
    }
    out.attribute[n] = make_plane(value, origin, setup, area, config);
  }
  return out;
}

TilePlane tile_plane(const Plane& plane, Point origin, std::int32_t x, std::int32_t y,
                     const Config& config) {
  const std::uint64_t sum = slopes_to_centre(plane, origin, x, y, config);
  const int F = config.gradient_bits;
  return {static_cast<std::uint32_t>(
              floor_mod(plane.at_origin + floor_mod(sum, config.position_bits()), F)),
          to_units(plane.dx, F), to_units(plane.dy, F)};
}

CornerPlane corner_plane(const Plane& plane, Point origin, const Config& config) {
  const int F = config.gradient_bits;
  const int f = config.position_bits();
  const std::uint64_t sum = slopes_to_centre(plane, origin, 0, 0, config);
  const int slope_bits = kUnitBits + F + (config.samples == 1 ? 0 : 4);
  return {low_bits((plane.at_origin << f) + sum, kUnitBits + F + f), low_bits(plane.dx, slope_bits),
          low_bits(plane.dy, slope_bits)};
}

TilePlane tile_plane(const CornerPlane& plane, std::int32_t x, std::int32_t y,
                     const Config& config) {
  const int F = config.gradient_bits;
  const int f = config.position_bits();
  const std::uint64_t sum =
      plane.dx * static_cast<std::uint64_t>(x) + plane.dy * static_cast<std::uint64_t>(y);
  return {static_cast<std::uint32_t>(floor_mod(plane.at_pixel0 + (sum << f), F + f)),
          to_units(plane.dx, F), to_units(plane.dy, F)};
}

std::uint32_t sample_delta(const Plane& plane, int sample, const Config& config) {
  if (config.samples == 1) return 0;
  const SamplePosition p = sample_positions(config.samples)[static_cast<std::size_t>(sample)];
  const std::uint64_t sum = plane.dx * static_cast<std::uint64_t>(std::int64_t{p.x} - 8) +
                            plane.dy * static_cast<std::uint64_t>(std::int64_t{p.y} - 8);
  return static_cast<std::uint32_t>(
      floor_shift(static_cast<std::int64_t>(sum), config.gradient_bits + 4));
}

ShadingPlanes shading_planes(const InterpolationSetup& setup, int colors, std::int32_t x,
                             std::int32_t y, const Config& config) {
  const auto sampled = [&](const Plane& plane) {
    SampledPlane out;
    out.center = tile_plane(plane, setup.origin, x, y, config);
    for (int m = 0; m < config.samples; ++m) {
      out.offset[static_cast<std::size_t>(m)] = sample_delta(plane, m, config);
    }
    return out;
  };
  ShadingPlanes out;
  out.inverse_w = sampled(setup.inverse_w);
  for (std::size_t c = 0; c < static_cast<std::size_t>(colors); ++c) {
    out.color[c] = sampled(setup.attribute[c]);
    out.level[c] = setup.level[c];
  }
  return out;
}

}  // namespace halfspace
