// SPDX-License-Identifier: Apache-2.0
//
// The judge is judged: by hand, by a moved point, and by pictures a real driver drew.
#include "oracle/oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "vectors/generators.hpp"

namespace halfspace::oracle {
namespace {

TEST(Oracle, SampleOnATopOrLeftEdgeIsInAndOnTheOthersOut) {
  const Corners upper{{{0, 0}, {4, 0}, {4, 4}}};  // top, right and a left diagonal
  const Corners lower{{{0, 0}, {4, 4}, {0, 4}}};  // a right diagonal, bottom and left
  EXPECT_TRUE(covered(upper, {2, 0}));
  EXPECT_FALSE(covered(upper, {4, 2}));
  EXPECT_TRUE(covered(upper, {2, 2}));
  EXPECT_FALSE(covered(lower, {2, 2}));
  EXPECT_FALSE(covered(lower, {2, 4}));
  EXPECT_TRUE(covered(lower, {0, 2}));
  EXPECT_TRUE(covered(upper, {0, 0}));   // where top and left edge meet
  EXPECT_FALSE(covered(upper, {4, 0}));  // top and right
  EXPECT_FALSE(covered(lower, {0, 4}));  // left and bottom
}

TEST(Oracle, TriangleWithoutAreaOwnsNothing) {
  for (const Corners& flat : {Corners{{{0, 0}, {2, 2}, {4, 4}}}, Corners{{{4, 4}, {0, 0}, {2, 2}}},
                              Corners{{{0, 1}, {4, 1}, {2, 1}}}, Corners{{{2, 2}, {2, 2}, {4, 0}}},
                              Corners{{{2, 2}, {2, 2}, {2, 2}}}}) {
    for (int i = 0; i < 64; ++i) EXPECT_FALSE(covered(flat, {i % 8 * 0.5, i / 8 * 0.5}));
  }
}

// On a lattice of sixteenths an eps of 2^-12 is small enough to move the sample for real.
TEST(Oracle, TiesAreThoseOfAReallyMovedSample) {
  constexpr std::uint64_t kSeed = 81;
  Random random(kSeed);
  const double eps = std::ldexp(1.0, -12);
  for (int n = 0; n < 100'000; ++n) {
    const auto lattice = [&random] {
      const auto x = static_cast<double>(random.in(0, 12)) / 2;
      return Vec{x, static_cast<double>(random.in(0, 12)) / 2};
    };
    const Corners t{lattice(), lattice(), lattice()};
    const Vec sample = lattice();
    const Vec moved{sample.x + eps, sample.y + eps * eps};
    const int first = turn(t[0], t[1], moved);
    const bool inside =
        first != 0 && turn(t[1], t[2], moved) == first && turn(t[2], t[0], moved) == first;
    ASSERT_EQ(covered(t, sample), inside) << "number " << n << ", seed " << kSeed;
  }
}

TEST(Oracle, VertexOffByTheLastBitOfADoubleDecides) {
  const double below = std::nextafter(0.5, 0.0);
  const double above = std::nextafter(0.5, 1.0);
  const auto left_edge_at = [](double x) { return Corners{{{x, 0}, {9, 5}, {x, 9}}}; };
  EXPECT_TRUE(covered(left_edge_at(below), {0.5, 4.5}));
  EXPECT_TRUE(covered(left_edge_at(0.5), {0.5, 4.5}));
  EXPECT_FALSE(covered(left_edge_at(above), {0.5, 4.5}));
  // A diagonal whose distance to the sample underflows any product of rounded differences.
  const Vec far{-3e8, -3e8};
  EXPECT_TRUE(covered({far, {1e9, -1}, {1e9, std::nextafter(1e9, 2e9)}}, {0.5, 0.5}));
  EXPECT_FALSE(covered({far, {1e9, -1}, {1e9, std::nextafter(1e9, 0.0)}}, {0.5, 0.5}));
}

TEST(Oracle, RealValuedTrianglesThatShareAnEdgeOwnEachSampleOnce) {
  constexpr std::uint64_t kSeed = 82;
  Random random(kSeed);
  const auto real = [&random] {
    const double x = std::ldexp(static_cast<double>(random.next() >> 11), -49);
    return Vec{x, std::ldexp(static_cast<double>(random.next() >> 11), -49)};
  };
  int pairs = 0;
  while (pairs < 2000) {
    const Vec a = real(), b = real(), c = real(), d = real();
    if (turn(a, b, c) * turn(a, b, d) >= 0 || turn(c, d, a) * turn(c, d, b) >= 0) continue;
    ++pairs;
    for (int i = 0; i < 256; ++i) {
      const Vec sample{i % 16 + 0.5, i / 16 + 0.5};
      const int cut = covered({a, b, c}, sample) + covered({a, b, d}, sample);
      const int other = covered({c, d, a}, sample) + covered({c, d, b}, sample);
      ASSERT_LE(cut, 1);
      ASSERT_EQ(cut, other) << "pair " << pairs << ", seed " << kSeed;
    }
  }
}

// One case of a TCOV file: its triangles and the driver's picture.
struct DriverCase {
  std::string name;
  int width = 0;
  int height = 0;
  std::vector<Corners> triangles;
  std::vector<std::uint8_t> picture;
};

DriverCase read_case(std::istream& file) {
  DriverCase c;
  std::string word, tag;
  std::size_t triangles = 0, spans = 0;
  file >> word >> word >> tag >> c.width >> c.height >> triangles >> spans >> word >> word;
  c.name = tag;
  c.triangles.resize(triangles);
  for (Corners& corners : c.triangles) {
    for (Vec& v : corners) {
      file >> v.x >> v.y;
      v = {v.x / 256, v.y / 256};
    }
  }
  c.picture.resize(static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.height));
  std::size_t at = 0;
  for (std::size_t i = 0; i < spans; ++i) {
    std::size_t gap = 0, length = 0;
    int value = 0;
    file >> gap >> length >> value;
    at += gap;
    for (; length > 0; --length) c.picture.at(at++) = static_cast<std::uint8_t>(value);
  }
  return c;
}

TEST(Oracle, DrawsWhatARealDriverDrew) {
  std::ifstream file(HALFSPACE_TEST_DIR "/data/public.tcov");
  std::string magic;
  int version = 0, cases = 0;
  file >> magic >> version >> cases;
  ASSERT_EQ(magic, "TCOV");
  ASSERT_EQ(version, 1);
  ASSERT_GT(cases, 0);
  for (int n = 0; n < cases; ++n) {
    const DriverCase c = read_case(file);
    ASSERT_TRUE(file) << "case " << n;
    EXPECT_EQ(hit_count(c.triangles, c.width, c.height, standard_samples(1)), c.picture)
        << "case " << n << " " << c.name;
  }
}

TEST(Oracle, StandardPositionsAreDistinctSixteenthsAndOnlyForStandardCounts) {
  for (const int samples : {1, 2, 4, 8, 16}) {
    const auto standard = standard_samples(samples);
    ASSERT_EQ(standard.size(), static_cast<std::size_t>(samples));
    for (const Vec v : standard) {  // multiples of 1/16 in the pixel, all different
      EXPECT_EQ(v.x * 16, std::floor(v.x * 16));
      EXPECT_EQ(v.y * 16, std::floor(v.y * 16));
      EXPECT_TRUE(v.x >= 0 && v.x < 1 && v.y >= 0 && v.y < 1);
      EXPECT_EQ(std::count(standard.begin(), standard.end(), v), 1);
    }
  }
  EXPECT_TRUE(standard_samples(0).empty());
  EXPECT_TRUE(standard_samples(3).empty());
}

}  // namespace
}  // namespace halfspace::oracle
