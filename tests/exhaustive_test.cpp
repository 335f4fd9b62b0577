// SPDX-License-Identifier: Apache-2.0
//
// Every triangle of an 8x8 lattice against the oracle, at every sample, wherever it lies.
#include <gtest/gtest.h>

#include <bitset>
#include <cstdint>
#include <string>
#include <tuple>

#include "lattice.hpp"

namespace halfspace {
namespace {

// All 2^18 triangles; stops at the first that is wrong.
void expect_every_triangle_exact(const Placement& where) {
  ASSERT_EQ(validate(where.config), "");
  const LatticeOracle truth(where);
  std::uint64_t owned = 0;
  for (int code = 0; code < kLatticeTriangles; ++code) {
    bool outside = false;
    const WindowMask model = model_window(where, code, outside);
    const WindowMask expected = truth.covered(code);
    ASSERT_FALSE(outside) << "pixels far outside: " << describe(where, code);
    for (std::size_t m = 0; m < model.size(); ++m) {
      ASSERT_EQ(model[m], expected[m])
          << std::hex << "sample " << m << ", model " << model[m] << ", oracle " << expected[m]
          << ": " << std::dec << describe(where, code);
      owned += static_cast<std::uint64_t>(std::popcount(expected[m]));
    }
  }
  EXPECT_GT(owned, 0u) << "nothing was compared";
}

class Lattice : public ::testing::TestWithParam<std::tuple<int, int>> {
 protected:
  int subpixel_bits() const { return std::get<0>(GetParam()); }
  int samples() const { return std::get<1>(GetParam()); }
  int window() const { return 8 >> subpixel_bits(); }
};

TEST_P(Lattice, EveryTriangleAtTheOriginIsExact) {
  const Config config{.subpixel_bits = subpixel_bits(),
                      .viewport_bits = 3,
                      .guard_bits = 0,
                      .samples = samples(),
                      .grid_log2 = 3};
  expect_every_triangle_exact({config, 0, {window(), window()}});
}

TEST_P(Lattice, EveryTriangleAcrossTheFramesCornerIsExact) {
  const Config config{.subpixel_bits = subpixel_bits(),
                      .viewport_bits = 3,
                      .guard_bits = 4,
                      .samples = samples(),
                      .grid_log2 = 2};
  expect_every_triangle_exact({config, -window() / 2, {8, 7}});
}

INSTANTIATE_TEST_SUITE_P(Exhaustive, Lattice,
                         ::testing::Combine(::testing::Values(0, 1, 2, 3),
                                            ::testing::Values(1, 2, 4, 8, 16)),
                         [](const auto& param) {
                           return "SubpixelBits" + std::to_string(std::get<0>(param.param)) +
                                  "Samples" + std::to_string(std::get<1>(param.param));
                         });

// Deep in a pyramid, where every level above the leaf is saturated or nearly so. The lattice
// straddles a corner of four leaf tiles, or the frame's last row and column.
TEST(Exhaustive, EveryTriangleDeepInAPyramidIsExact) {
  const Config narrow{.subpixel_bits = 1, .viewport_bits = 9, .guard_bits = 0, .grid_log2 = 2};
  expect_every_triangle_exact({narrow, 508, {511, 512}});
  expect_every_triangle_exact({narrow, 254, {512, 512}});
  const Config wide{.subpixel_bits = 1, .viewport_bits = 12, .guard_bits = 16, .samples = 4};
  expect_every_triangle_exact({wide, 2046, {4096, 4096}});
}

// The frame cuts the lattice at every column and row.
TEST(Exhaustive, EveryTriangleInEveryFrameIsExact) {
  for (int width = 1; width <= 4; ++width) {
    const Config config{.subpixel_bits = 1, .viewport_bits = 3, .guard_bits = 3, .grid_log2 = 2};
    expect_every_triangle_exact({config, 0, {width, 5 - width}});
  }
}

// What the fill rule can see of a sample: for every edge its direction (one of eight, from the
// signs of dx and dy) and the side the sample is on. Nothing for two equal vertices.
using Cases = std::bitset<24 * 24 * 24>;

void see(const oracle::Corners& t, oracle::Vec sample, Cases& cases) {
  std::size_t index = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const oracle::Vec from = t[i];
    const oracle::Vec to = t[(i + 1) % 3];
    const int dx = (to.x > from.x) - (to.x < from.x);
    const int dy = (to.y > from.y) - (to.y < from.y);
    if (dx == 0 && dy == 0) return;
    const int direction = (dx + 1) * 3 + dy + 1;  // 0..8 without 4
    const int side = oracle::turn(from, to, sample) + 1;
    index = index * 24 + static_cast<std::size_t>((direction - direction / 5) * 3 + side);
  }
  cases.set(index);
}

Cases cases_of_lattice(int size) {
  Cases cases;
  const auto at = [size](int code) {
    return oracle::Vec{static_cast<double>(code % size), static_cast<double>(code / size)};
  };
  const int points = size * size;
  for (int code = 0; code < points * points * points; ++code) {
    const oracle::Corners t{at(code % points), at(code / points % points),
                            at(code / points / points)};
    for (int y = 1; y < size; y += 2) {  // samples at odd points: half a pixel is one subpixel
      for (int x = 1; x < size; x += 2) {
        see(t, {static_cast<double>(x), static_cast<double>(y)}, cases);
      }
    }
  }
  return cases;
}

// Why a lattice of 3-bit coordinates is enough: one of 6x6 points attains every case that the fill
// rule can tell apart, so does 8x8, and no triangle of a larger lattice adds one.
TEST(Exhaustive, LatticeAttainsEveryCaseOfSidesAndDirections) {
  constexpr std::uint64_t kSeed = 91;
  const Cases cases = cases_of_lattice(8);
  EXPECT_EQ(cases.count(), 2640u);
  EXPECT_EQ(cases_of_lattice(6), cases);
  EXPECT_LT(cases_of_lattice(5).count(), cases.count());
  Random random(kSeed);
  Cases larger;
  for (const int size : {10, 16, 1000}) {
    const auto draw = [&] {
      const auto x = static_cast<double>(random.in(0, size));
      return oracle::Vec{x, static_cast<double>(random.in(0, size))};
    };
    for (int n = 0; n < 1'000'000; ++n) {
      const oracle::Vec sample = draw();
      see({draw(), draw(), draw()}, sample, larger);
    }
  }
  EXPECT_GT(larger.count(), 2000u);
  EXPECT_EQ((larger & ~cases).count(), 0u) << "seed " << kSeed;
}

}  // namespace
}  // namespace halfspace
