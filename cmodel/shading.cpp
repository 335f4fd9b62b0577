// SPDX-License-Identifier: Apache-2.0
#include "shading.hpp"

#include <algorithm>
#include <bit>

#include "fixed.hpp"

namespace halfspace {
namespace {

// Width of the perspective divider's operands after normalisation.
constexpr int kQuotientBits = 16;

// Where a pixel's colour is evaluated; -1 is the centre.
int shading_sample(const SampleMasks& covered, int lane, int samples) {
  int first = -1;
  bool all = true;
  for (int m = samples - 1; m >= 0; --m) {
    const bool here = (covered[static_cast<std::size_t>(m)] >> lane & 1) != 0;
    if (here) first = m;
    all = all && here;
  }
  return all ? -1 : first;
}

}  // namespace

GridMask any_sample(const SampleMasks& passed) {
  GridMask any = 0;
  for (const GridMask mask : passed) any |= mask;
  return any;
}

ColorTile shading(const CoverageTile& tile, const SampleMasks& passed, const ShadingPlanes& planes,
                  int colors, const Config& config) {
  ColorTile out{};
  for (GridMask rest = any_sample(passed); rest != 0; rest &= rest - 1) {
    const int lane = std::countr_zero(rest);
    const int i = lane & (config.grid() - 1);
    const int j = lane >> config.grid_log2;
    const int sample = shading_sample(tile.mask, lane, config.samples);
    const std::int32_t inverse_w = planes.inverse_w.at(i, j, sample);
    for (std::size_t c = 0; c < static_cast<std::size_t>(colors); ++c) {
      out[static_cast<std::size_t>(lane)][c] =
          perspective(planes.color[c].at(i, j, sample), inverse_w, planes.level[c], config);
    }
  }
  return out;
}

std::uint32_t reciprocal(std::uint32_t mantissa, const Config& config) {
  const int R = config.reciprocal_bits;
  HS_CHECK(mantissa >> (R - 1) == 1);
  return static_cast<std::uint32_t>((std::uint64_t{1} << (2 * R)) / (2 * mantissa + 1));
}

std::uint8_t perspective(std::int32_t attribute, std::int32_t inverse_w, std::uint8_t level,
                         const Config& config) {
  const int R = config.reciprocal_bits;
  const auto u = static_cast<std::uint32_t>(std::max(inverse_w, 1));
  const auto p = static_cast<std::uint32_t>(std::clamp(attribute, 0, static_cast<std::int32_t>(u)));
  // Both shifted alike, so that 1/w has its top bit at 2^31: then cut to 16 and to R bits.
  const int up = std::countl_zero(u);
  const std::uint32_t numerator = (p << up) >> (32 - kQuotientBits);
  const std::uint32_t r = reciprocal((u << up) >> (32 - R), config);
  const int shift = R + kQuotientBits - 1 - 8;
  const std::uint64_t product = std::uint64_t{numerator} * r + (std::uint64_t{1} << (shift - 1));
  return static_cast<std::uint8_t>(std::min<std::uint64_t>(level + (product >> shift), 255));
}

}  // namespace halfspace
