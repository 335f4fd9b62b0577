// SPDX-License-Identifier: Apache-2.0
#include "back_end_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace halfspace {
namespace {

constexpr int kUnitBits = 32;
constexpr int kSlotBits = 9;
constexpr int kIndexBits = 7;

// From a vertex to the centre of pixel (0, 0): hs_pkg::CENTRE_BITS.
int centre_bits(const Config& config) {
  return config.position_bits() + 2 +
         (config.has_guard_band() ? config.guard_bits : config.viewport_bits);
}

}  // namespace

Layout gradient_layout(const Config& config) {
  Layout layout;
  for (int i = 0; i < 3; ++i) layout.push_back({fmt::format("value{}", i), kUnitBits, true});
  layout.push_back({"first", 2, false});
  for (const char* name : {"slope0.a", "slope0.b", "slope2.a", "slope2.b"}) {
    layout.push_back({name, config.delta_bits(), true});
  }
  layout.push_back({"x", centre_bits(config), true});
  layout.push_back({"y", centre_bits(config), true});
  layout.push_back({"length", 6, false});
  layout.push_back({"reciprocal", 32, false});
  return layout;
}

Layout corner_plane_layout(const Config& config) {
  const int F = config.gradient_bits;
  const int slope_bits = kUnitBits + F + (config.samples == 1 ? 0 : 4);
  return {{"at_pixel0", kUnitBits + F + config.position_bits(), false},
          {"dx", slope_bits, false},
          {"dy", slope_bits, false}};
}

Layout tile_plane_in_layout(int planes, const Config& config) {
  const int tile_bits = std::max(config.viewport_bits - config.grid_log2, 1);
  Layout layout;
  for (int p = 0; p < planes; ++p) {
    for (PortField field : corner_plane_layout(config)) {
      field.name = fmt::format("plane{}.{}", p, field.name);
      layout.push_back(field);
    }
  }
  layout.push_back({"column", tile_bits, false});
  layout.push_back({"row", tile_bits, false});
  layout.push_back({"side", 8, false});
  return layout;
}

Layout tile_plane_out_layout(int planes) {
  Layout layout;
  for (int p = 0; p < planes; ++p) {
    for (const char* name : {"base", "dx", "dy"}) {
      layout.push_back({fmt::format("plane{}.{}", p, name), kUnitBits, false});
    }
  }
  layout.push_back({"side", 8, false});
  return layout;
}

Layout depth_setup_layout(const Config& config) {
  Layout layout{{"area", config.area_bits() - 1, false}};
  for (const char* name : {"slope0.a", "slope0.b", "slope2.a", "slope2.b"}) {
    layout.push_back({name, config.delta_bits(), true});
  }
  for (int i = 0; i < 3; ++i) {
    layout.push_back({fmt::format("vertex{}.x", i), config.vertex_bits(), true});
    layout.push_back({fmt::format("vertex{}.y", i), config.vertex_bits(), true});
  }
  for (int i = 0; i < 3; ++i) layout.push_back({fmt::format("depth{}", i), kUnitBits, true});
  layout.push_back({"index", kIndexBits, false});
  return layout;
}

Layout triangle_area_layout(const Config& config) {
  return {{"reciprocal", 32, false},
          {"length", 6, false},
          {"first", 2, false},
          {"x", centre_bits(config), true},
          {"y", centre_bits(config), true},
          {"index", kIndexBits, false}};
}

Layout triangle_depth_layout(const Config& config) {
  Layout layout = corner_plane_layout(config);
  layout.push_back({"index", kIndexBits, false});
  return layout;
}

Layout depth_state_layout(const Config& config) {
  return {{"less", 1, false},
          {"equal", 1, false},
          {"greater", 1, false},
          {"clear", config.depth_bits, false}};
}

Layout depth_tile_layout(const Config& config) {
  Layout layout;
  for (const char* name : {"plane.base", "plane.dx", "plane.dy"}) {
    layout.push_back({name, kUnitBits, false});
  }
  layout.push_back({"mask", config.lanes(), false});
  layout.push_back({"slot", kSlotBits, false});
  layout.push_back({"fresh", 1, false});
  layout.push_back({"index", kIndexBits, false});
  return layout;
}

Layout depth_passed_layout(const Config& config) {
  return {
      {"passed", config.lanes(), false}, {"slot", kSlotBits, false}, {"index", kIndexBits, false}};
}

Layout shade_tile_layout(const Config& config) {
  Layout layout{{"passed", config.lanes(), false}, {"slot", kSlotBits, false}};
  for (int c = 2; c >= 0; --c) layout.push_back({fmt::format("level{}", c), 8, false});
  for (int p = 3; p >= 0; --p) {
    for (const char* name : {"base", "dx", "dy"}) {
      layout.push_back({fmt::format("plane{}.{}", p, name), kUnitBits, false});
    }
  }
  return layout;
}

Layout shade_group_layout(int fragments, const Config& config) {
  const int groups = config.lanes() / fragments;
  Layout layout{{"slot", kSlotBits, false},
                {"group", std::countr_zero(static_cast<unsigned>(groups)), false},
                {"mask", fragments, false}};
  for (int k = fragments - 1; k >= 0; --k) {
    for (int c = 2; c >= 0; --c) layout.push_back({fmt::format("color{}.{}", k, c), 8, false});
  }
  return layout;
}

Values values_of(const GradientInput& input) {
  return {input.value[0], input.value[1], input.value[2], input.first,
          input.slope0.a, input.slope0.b, input.slope2.a, input.slope2.b,
          input.centre.x, input.centre.y, input.length,   input.reciprocal};
}

Values values_of(const CornerPlane& plane) {
  return {static_cast<std::int64_t>(plane.at_pixel0), static_cast<std::int64_t>(plane.dx),
          static_cast<std::int64_t>(plane.dy)};
}

Values values_of(const TilePlane& plane) { return {plane.base, plane.dx, plane.dy}; }

Values values_of(const DepthState& state, const Config& config) {
  const unsigned lets = passing(state.function);
  return {lets & 1, lets >> 1 & 1, lets >> 2, state.cleared(config)};
}

}  // namespace halfspace
