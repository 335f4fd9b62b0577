// SPDX-License-Identifier: Apache-2.0
#include "fit_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "../triangle_setup.hpp"
#include "error.hpp"

namespace halfspace {

void require_extent(const Triangle& triangle, std::uint64_t index, const Config& config,
                    const std::string& place) {
  if (config.extent_bits == 0 || within_extent(triangle, config)) return;
  const auto& v = triangle.vertex;
  const auto [x_min, x_max] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y_min, y_max] = std::minmax({v[0].y, v[1].y, v[2].y});
  const auto px = [&config](std::int32_t to, std::int32_t from) {
    return std::ldexp(static_cast<double>(std::int64_t{to} - from), -config.subpixel_bits);
  };
  throw Error(ErrorCode::kFitRange, place,
              fmt::format("triangle {} spans {} x {} px: the configuration was fitted to less than "
                          "{} px (extent_bits = {})",
                          index, px(x_max, x_min), px(y_max, y_min), 1 << config.extent_bits,
                          config.extent_bits));
}

void refuse_cut(std::uint64_t index, const Config& config, const std::string& place) {
  const std::string range = config.has_guard_band()
                                ? fmt::format("the guard band of {} px (guard_bits = {})",
                                              1 << config.guard_bits, config.guard_bits)
                                : std::string("the frame (guard_bits = 0)");
  throw Error(
      ErrorCode::kFitRange, place,
      fmt::format("triangle {} leaves {} that the configuration was fitted to", index, range));
}

}  // namespace halfspace
