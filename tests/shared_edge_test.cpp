// SPDX-License-Identifier: Apache-2.0
//
// Every way two or three triangles of an 8x8 lattice meet: each sample has exactly one owner.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <tuple>

#include "lattice.hpp"

namespace halfspace {
namespace {

class SharedEdge : public ::testing::TestWithParam<std::tuple<int, int>> {
 protected:
  SharedEdge()
      : where_{{.subpixel_bits = std::get<0>(GetParam()),
                .viewport_bits = 3,
                .guard_bits = 0,
                .samples = std::get<1>(GetParam()),
                .grid_log2 = 3},
               0,
               {8 >> std::get<0>(GetParam()), 8 >> std::get<0>(GetParam())}},
        truth_(where_),
        model_(where_),
        turn_(where_) {}

  // Do the segments ab and cd cross between their ends? c and d lie on opposite sides of ab.
  bool crosses(int a, int b, int c, int d) const { return turn_(c, d, a) * turn_(c, d, b) < 0; }

  std::string describe(std::array<int, 4> points) const {
    std::string text = halfspace::describe(where_.config) + ":";
    for (const int p : points) {
      text += " (" + std::to_string(p % 8) + "," + std::to_string(p / 8) + ")";
    }
    return text;
  }

  Placement where_;
  LatticeOracle truth_;
  LatticeModel model_;
  LatticeTurns turn_;
};

TEST_P(SharedEdge, MasksDoNotDependOnOrderOrWinding) {
  for (int code = 0; code < kLatticeTriangles; ++code) {
    std::array<int, 4> p{code & 63, code >> 6 & 63, code >> 12, 0};
    if (!std::is_sorted(p.begin(), p.begin() + 3)) continue;
    const WindowMask first = model_.covered(p[0], p[1], p[2]);
    while (std::next_permutation(p.begin(), p.begin() + 3)) {
      ASSERT_EQ(model_.covered(p[0], p[1], p[2]), first) << describe(p);
    }
  }
}

// abc and bad lie on opposite sides of ab.
TEST_P(SharedEdge, BothSidesOwnEachSampleOnce) {
  std::uint64_t pairs = 0;
  std::uint64_t tied = 0;  // pairs with a sample on the shared edge
  for (int a = 0; a < kLatticePoints; ++a) {
    for (int b = a + 1; b < kLatticePoints; ++b) {
      const WindowMask& on_edge = truth_.between(a, b);
      for (int c = 0; c < kLatticePoints; ++c) {
        if (turn_(a, b, c) <= 0) continue;
        const WindowMask& one = model_.covered(a, b, c);
        for (int d = 0; d < kLatticePoints; ++d) {
          if (turn_(a, b, d) >= 0) continue;
          const WindowMask& other = model_.covered(b, a, d);
          ASSERT_EQ(one & other, kNoSamples) << "owned twice: " << describe({a, b, c, d});
          ASSERT_EQ((one | other) & on_edge, on_edge) << "a hole: " << describe({a, b, c, d});
          ++pairs;
          tied += on_edge == kNoSamples ? 0u : 1u;
        }
      }
    }
  }
  EXPECT_GT(pairs, 1'000'000u);
  EXPECT_GT(tied, 1'000u);
}

// A convex quad a d b c cut along ab or along cd.
TEST_P(SharedEdge, EitherDiagonalGivesTheSameSamples) {
  std::uint64_t quads = 0;
  for (int a = 0; a < kLatticePoints; ++a) {
    for (int b = a + 1; b < kLatticePoints; ++b) {
      for (int c = 0; c < kLatticePoints; ++c) {
        if (turn_(a, b, c) <= 0) continue;
        for (int d = 0; d < kLatticePoints; ++d) {
          if (turn_(a, b, d) >= 0 || !crosses(a, b, c, d)) continue;
          ASSERT_EQ(model_.covered(a, b, c) | model_.covered(b, a, d),
                    model_.covered(c, d, a) | model_.covered(d, c, b))
              << describe({a, b, c, d});
          ++quads;
        }
      }
    }
  }
  EXPECT_GT(quads, 100'000u);
}

// o inside abc or on an edge: oab, obc and oca cut it in three, or in two and a degenerate one.
TEST_P(SharedEdge, SplittingATriangleAtAnyPointMovesNoSample) {
  std::uint64_t splits = 0;
  std::uint64_t at_a_sample = 0;  // splits at a point that is a sample
  const auto is_sample = [this](int p) {
    for (const oracle::Vec s : oracle::standard_samples(where_.config.samples)) {
      const oracle::Vec at = where_.px(p);
      if (at.x - std::floor(at.x) == s.x && at.y - std::floor(at.y) == s.y) return true;
    }
    return false;
  };
  for (int o = 0; o < kLatticePoints; ++o) {
    for (int a = 0; a < kLatticePoints; ++a) {
      for (int b = 0; b < kLatticePoints; ++b) {
        if (turn_(a, b, o) < 0) continue;
        for (int c = 0; c < kLatticePoints; ++c) {
          if (turn_(a, b, c) <= 0 || turn_(b, c, o) < 0 || turn_(c, a, o) < 0) continue;
          const WindowMask& ab = model_.covered(o, a, b);
          const WindowMask& bc = model_.covered(b, o, c);
          const WindowMask& ca = model_.covered(o, c, a);
          ASSERT_EQ(ab | bc | ca, model_.covered(a, b, c)) << describe({a, b, c, o});
          ASSERT_EQ((ab & bc) | (bc & ca) | (ca & ab), kNoSamples) << describe({a, b, c, o});
          ++splits;
          at_a_sample += is_sample(o) ? 1u : 0u;
        }
      }
    }
  }
  EXPECT_GT(splits, 100'000u);
  const bool centres = where_.config.samples == 1 && where_.config.subpixel_bits > 0;
  EXPECT_GE(at_a_sample, centres ? 10'000u : 0u);
}

INSTANTIATE_TEST_SUITE_P(Exhaustive, SharedEdge,
                         ::testing::Combine(::testing::Values(0, 1, 2, 3),
                                            ::testing::Values(1, 2, 4, 8, 16)),
                         [](const auto& param) {
                           return "SubpixelBits" + std::to_string(std::get<0>(param.param)) +
                                  "Samples" + std::to_string(std::get<1>(param.param));
                         });

}  // namespace
}  // namespace halfspace
