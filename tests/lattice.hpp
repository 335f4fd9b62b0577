// SPDX-License-Identifier: Apache-2.0
//
// The world of the exhaustive tests: the 64 points of an 8x8 lattice, one subpixel apart, and the
// pixels around them. A triangle is three of the points, 6 bits each: 2^18 in all, every order and
// winding included. Why so few points attain every case: docs/03_design/exactness.md.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "compare.hpp"

namespace halfspace {

inline constexpr int kLatticePoints = 64;
inline constexpr int kLatticeTriangles = 1 << 18;

// Bit 8 row + column of word m: sample m of that pixel of the window.
using WindowMask = std::array<std::uint64_t, kMaxSamples>;

inline WindowMask operator|(const WindowMask& a, const WindowMask& b) {
  WindowMask out;
  for (std::size_t m = 0; m < out.size(); ++m) out[m] = a[m] | b[m];
  return out;
}
inline WindowMask operator&(const WindowMask& a, const WindowMask& b) {
  WindowMask out;
  for (std::size_t m = 0; m < out.size(); ++m) out[m] = a[m] & b[m];
  return out;
}
inline constexpr WindowMask kNoSamples{};

// Where a lattice lies: its point (0, 0) at pixel (origin, origin), in a frame that may cut it.
struct Placement {
  Config config;
  int origin = 0;  // px
  FrameState frame;

  int window() const { return 8 >> config.subpixel_bits; }  // px the lattice spans, 8, 4, 2 or 1
  Point at(int point) const {
    const int corner = origin * (1 << config.subpixel_bits);
    return {corner + point % 8, corner + point / 8};
  }
  oracle::Vec px(int point) const {
    const Point p = at(point);
    return {std::ldexp(p.x, -config.subpixel_bits), std::ldexp(p.y, -config.subpixel_bits)};
  }
  Triangle triangle(int code) const {
    return {{at(code & 63), at(code >> 6 & 63), at(code >> 12)}, 0};
  }
};

inline std::string describe(const Placement& where, int code) {
  return describe(where.triangle(code), where.frame, where.config);
}

// What the oracle says of every directed pair of lattice points.
class LatticeOracle {
 public:
  explicit LatticeOracle(const Placement& where)
      : right_(kLatticePoints * kLatticePoints), left_(right_.size()), between_(right_.size()) {
    const auto samples = oracle::standard_samples(where.config.samples);
    for (int from = 0; from < kLatticePoints; ++from) {
      for (int to = 0; to < kLatticePoints; ++to) {
        for (int pixel = 0; pixel < where.window() * where.window(); ++pixel) {
          const int column = pixel % where.window();
          const int row = pixel / where.window();
          const int x = where.origin + column;
          const int y = where.origin + row;
          if (x < 0 || y < 0 || x >= where.frame.width || y >= where.frame.height) continue;
          for (std::size_t m = 0; m < samples.size(); ++m) {
            see(where.px(from), where.px(to), {x + samples[m].x, y + samples[m].y}, index(from, to),
                m, std::uint64_t{1} << (8 * row + column));
          }
        }
      }
    }
  }

  WindowMask covered(int a, int b, int c) const {
    return (right_[index(a, b)] & right_[index(b, c)] & right_[index(c, a)]) |
           (left_[index(a, b)] & left_[index(b, c)] & left_[index(c, a)]);
  }
  WindowMask covered(int code) const { return covered(code & 63, code >> 6 & 63, code >> 12); }
  // Samples on the open segment.
  const WindowMask& between(int a, int b) const { return between_[index(a, b)]; }

 private:
  static std::size_t index(int from, int to) { return static_cast<std::size_t>(from * 64 + to); }

  void see(oracle::Vec from, oracle::Vec to, oracle::Vec sample, std::size_t pair, std::size_t m,
           std::uint64_t bit) {
    const int side = oracle::side(from, to, sample);
    if (side > 0) right_[pair][m] |= bit;
    if (side < 0) left_[pair][m] |= bit;
    if (oracle::strictly_between(from, to, sample)) between_[pair][m] |= bit;
  }

  std::vector<WindowMask> right_, left_, between_;
};

// The model's masks of one triangle in the window; `outside` is set when it drew a pixel elsewhere.
inline WindowMask model_window(const Placement& where, int code, bool& outside) {
  WindowMask window{};
  RasterStats stats;
  const Config& config = where.config;
  rasterize(where.triangle(code), where.frame, config, stats, [&](const CoverageTile& tile) {
    for (std::size_t m = 0; m < window.size(); ++m) {
      for (GridMask left = tile.mask[m]; left != 0; left &= left - 1) {
        const int bit = std::countr_zero(left);
        const int column = tile.x + bit % config.grid() - where.origin;
        const int row = tile.y + bit / config.grid() - where.origin;
        if (column < 0 || row < 0 || column >= where.window() || row >= where.window()) {
          outside = true;
        } else {
          window[m] |= std::uint64_t{1} << (8 * row + column);
        }
      }
    }
  });
  return window;
}

// The model's masks of every triangle of the lattice, by code.
class LatticeModel {
 public:
  explicit LatticeModel(const Placement& where) : mask_(kLatticeTriangles) {
    bool outside = false;
    for (int code = 0; code < kLatticeTriangles; ++code) {
      mask_[static_cast<std::size_t>(code)] = model_window(where, code, outside);
    }
    EXPECT_FALSE(outside) << describe(where.config);
  }
  const WindowMask& covered(int a, int b, int c) const {
    return mask_[static_cast<std::size_t>(a | b << 6 | c << 12)];
  }

 private:
  std::vector<WindowMask> mask_;
};

// oracle::turn of every three lattice points.
class LatticeTurns {
 public:
  explicit LatticeTurns(const Placement& where) : turn_(kLatticeTriangles) {
    for (int code = 0; code < kLatticeTriangles; ++code) {
      turn_[static_cast<std::size_t>(code)] = static_cast<std::int8_t>(
          oracle::turn(where.px(code & 63), where.px(code >> 6 & 63), where.px(code >> 12)));
    }
  }
  int operator()(int a, int b, int c) const {
    return turn_[static_cast<std::size_t>(a | b << 6 | c << 12)];
  }

 private:
  std::vector<std::int8_t> turn_;
};

}  // namespace halfspace
