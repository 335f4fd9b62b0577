// SPDX-License-Identifier: Apache-2.0
//
// The free values of a design, and every width derived from them. Formulas and proofs:
// docs/03_design/config.md. Twin: rtl/config/<preset>/hs_config_pkg.sv (free values) and
// rtl/hs_pkg.sv (derived widths).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

// How a real coordinate becomes a multiple of 2^-subpixel_bits.
enum class SnapMode {
  kNearestEven,  // round half to even: D3D 11.3, Vulkan drivers
  kHalfAway,     // round half away from zero
  kTruncate,     // towards zero, as at least one real GPU does
};

// One design point. A plain value: copy it, change a field, call validate().
struct Config {
  int subpixel_bits = 8;   // s: fraction bits of a vertex coordinate, 0..12
  int viewport_bits = 12;  // n: frames up to 2^n x 2^n pixels, 3..15
  int guard_bits = 13;     // k: |x|, |y| < 2^k px, n..16; 0: no guard band, 0 <= x, y <= 2^n px
  int extent_bits = 0;  // x: no edge reaches 2^x px in x or in y, 1..k+1 (no guard band: 1..n+1);
                        // 0: no limit but the coordinates' own
  int samples = 1;      // samples per pixel: 1, 2, 4, 8, 16, standard positions
  int grid_log2 = 3;    // g: a grid is 2^g x 2^g lanes; 2 or 3
  // Clocks between triangles in triangle_setup: 1, or 3 (multipliers shared).
  int setup_interval = 1;
  int tag_bits = 16;         // width of the triangle tag that travels with every packet, 1..32
  int depth_bits = 24;       // depth buffer: U0.depth_bits, 16..32
  int attributes = 3;        // 8-bit attributes per vertex (red, green, blue first), 0..8
  int inverse_w_bits = 30;   // precision of 1/w within a triangle, 12..30
  int gradient_bits = 16;    // F: fraction bits of a plane's gradient, 0..20
  int reciprocal_bits = 16;  // mantissa bits of the perspective reciprocal, 6..16
  SnapMode snap = SnapMode::kNearestEven;

  bool operator==(const Config&) const = default;

  // --- Derived. Widths in bits, signed unless said. ------------------------------------------

  constexpr bool has_guard_band() const { return guard_bits > 0; }
  // True when extent_bits says more about an edge than the coordinates do.
  constexpr bool narrow_extent() const {
    return extent_bits > 0 && extent_bits <= (has_guard_band() ? guard_bits : viewport_bits);
  }
  // X: |A| + |B| <= 2^(X+1) px, whatever limits them.
  constexpr int extent_log2() const {
    return narrow_extent() ? extent_bits : has_guard_band() ? guard_bits + 1 : viewport_bits;
  }

  // Fraction bits of a sample position within a pixel: 1/2 px for one sample, up to 1/16 px.
  constexpr int sample_position_bits() const {
    return samples == 1 ? 1 : samples == 2 ? 2 : samples == 4 ? 3 : 4;
  }
  // q: sample-position bits that stay in the edge values after setup. One sample needs none (the
  // pixel centre is folded into C).
  constexpr int sample_bits() const { return samples == 1 ? 0 : sample_position_bits(); }
  // f: fraction bits of positions at which setup evaluates C; E there has s + f fraction bits.
  constexpr int position_bits() const { return std::max(subpixel_bits, sample_position_bits()); }
  // Bits of C dropped by setup, exactly: f - q.
  constexpr int dropped_bits() const { return position_bits() - sample_bits(); }

  constexpr int grid() const { return 1 << grid_log2; }
  constexpr int lanes() const { return 1 << (2 * grid_log2); }
  // Grids in the pyramid, the leaf included: the least L with 2^(g L) >= 2^n.
  constexpr int levels() const { return (viewport_bits + grid_log2 - 1) / grid_log2; }
  // log2 of the side, in pixels, of a node at `level` (0 = root, levels() - 1 = leaf tile).
  constexpr int node_log2(int level) const { return grid_log2 * (levels() - level); }
  // Whether register 1 of `level` (levels() - 1 = coverage) is a FIFO of two: hs_pkg::buffered().
  constexpr bool buffered(int level) const { return (levels() - 1 - level) % 2 == 0; }
  // The greatest depth: that of the far plane.
  constexpr std::uint32_t depth_max() const { return 0xffffffffu >> (32 - depth_bits); }
  constexpr int max_size() const { return 1 << viewport_bits; }

  // Vertex coordinate, S.s px.
  constexpr int vertex_bits() const {
    return has_guard_band() ? guard_bits + subpixel_bits + 1 : viewport_bits + subpixel_bits + 2;
  }
  // Whether two coordinates may differ by 2^extent_log2() px itself: hs_pkg::EXTENT_REACHED.
  constexpr bool extent_reached() const { return !narrow_extent() && !has_guard_band(); }
  // A and B, S.s px.
  constexpr int delta_bits() const {
    return extent_log2() + subpixel_bits + (extent_reached() ? 2 : 1);
  }
  // The doubled area, S.2s px^2.
  constexpr int area_bits() const {
    return 2 * extent_log2() + 2 * subpixel_bits + (extent_reached() ? 2 : 1);
  }
  // C at the frame's corner, S.2s px^2.
  constexpr int constant_bits() const {
    return (has_guard_band() ? guard_bits : viewport_bits) + extent_log2() + 2 * subpixel_bits + 2;
  }
  // Biased E at any sample of the frame before bits are dropped, S.(s+f) px^2.
  constexpr int edge_full_bits() const {
    const int fraction = subpixel_bits + position_bits();
    if (narrow_extent()) {
      return (has_guard_band() ? guard_bits + 1 : viewport_bits) + extent_log2() + fraction + 2;
    }
    return 2 * (has_guard_band() ? guard_bits + 1 : viewport_bits) + fraction + 1;
  }
  // The same after dropping: S.(s+q) px^2.
  constexpr int edge_bits() const { return edge_full_bits() - dropped_bits(); }
  // Edge value at the origin of a node of side 2^node_log2 px, saturated: S.(s+q) px^2.
  constexpr int node_bits(int node_log2) const {
    return extent_log2() + subpixel_bits + sample_bits() + node_log2 + 2;
  }
  // One lane of half_plane_grid, the same at every level: S.s px^2 / child side.
  constexpr int lane_bits() const { return extent_log2() + subpixel_bits + grid_log2 + 3; }

  // Greatest |difference| of two vertices in x or in y, in subpixels.
  constexpr std::int64_t extent_max() const {
    if (extent_bits == 0) return coordinate_max() - coordinate_min();
    return (std::int64_t{1} << (extent_bits + subpixel_bits)) - 1;
  }
  // Greatest and least legal vertex coordinate, in subpixels.
  constexpr std::int64_t coordinate_max() const {
    return has_guard_band() ? (std::int64_t{1} << (guard_bits + subpixel_bits)) - 1
                            : std::int64_t{1} << (viewport_bits + subpixel_bits);
  }
  constexpr std::int64_t coordinate_min() const { return has_guard_band() ? -coordinate_max() : 0; }
};

// Which of its fields that are numbers.
using ConfigField = int Config::*;

// The named presets.
inline constexpr Config kFull{};
inline constexpr Config kTiny{
    .subpixel_bits = 4, .viewport_bits = 9, .guard_bits = 0, .grid_log2 = 2};
inline constexpr Config kD3d{.viewport_bits = 14, .guard_bits = 15};
inline constexpr Config kMsaa4{.samples = 4};

struct Preset {
  std::string_view name;
  Config config;
};
inline constexpr std::array<Preset, 4> kPresets{
    {{"tiny", kTiny}, {"full", kFull}, {"d3d", kD3d}, {"msaa4", kMsaa4}}};

// The preset of that name, or nothing.
std::optional<Config> find_preset(std::string_view name);

// What is wrong with a configuration: the field's name, its value and its range; empty when it is
// legal. Every stage assumes a legal configuration.
std::string validate(const Config& config);

}  // namespace halfspace
