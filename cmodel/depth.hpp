// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// When a fragment replaces what is stored: its depth compared with the stored one. Nearer is
// smaller, unless the projection is reversed.
enum class DepthFunction : std::uint8_t {
  kLess,
  kLessEqual,
  kAlways,
  kNever,
  kEqual,
  kGreater,
  kGreaterEqual,
  kNotEqual
};
inline constexpr int kDepthFunctions = 8;

// What of `less`, `equal` and `greater` a function lets pass, in bits 0, 1 and 2.
constexpr unsigned passing(DepthFunction function) {
  switch (function) {
    case DepthFunction::kLess: return 1;
    case DepthFunction::kLessEqual: return 3;
    case DepthFunction::kAlways: return 7;
    case DepthFunction::kNever: return 0;
    case DepthFunction::kEqual: return 2;
    case DepthFunction::kGreater: return 4;
    case DepthFunction::kGreaterEqual: return 6;
    case DepthFunction::kNotEqual: return 5;
  }
  return 0;
}

// How a frame's depths begin and are compared.
struct DepthState {
  DepthFunction function = DepthFunction::kLess;
  std::optional<std::uint32_t> clear;  // of a new tile, 0..depth_max(); nothing: depth_max(), far

  DepthState() = default;
  // A function alone is a state.
  DepthState(DepthFunction compare, std::optional<std::uint32_t> cleared = {})
      : function(compare), clear(cleared) {}

  std::uint32_t cleared(const Config& config) const { return clear.value_or(config.depth_max()); }
};

// Units to a depth-buffer value: rounded to nearest, clamped to 0..depth_max(). With more than 30
// depth bits the low ones are 0, but for the far plane's.
std::uint32_t depth_value(std::int32_t units, const Config& config);

// One sample plane of one tile: compare, and store where the fragment wins. Early: runs before any
// attribute is evaluated, on the same coverage bits.
//
//   covered  lanes to test
//   plane    depth over the tile, moved to the sample (TilePlane::base + sample_delta)
//   stored   the tile's depth buffer; replaced where the test passes
//   return   lanes that passed, a subset of `covered`
//
// Cost: one add, one compare per lane. Twin: rtl/hs_depth_test.sv.
GridMask depth_test(GridMask covered, const TilePlane& plane, DepthFunction function,
                    DepthTile& stored, const Config& config);

}  // namespace halfspace
