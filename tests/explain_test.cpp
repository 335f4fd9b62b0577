// SPDX-License-Identifier: Apache-2.0
//
// One triangle at one sample.
#include <gtest/gtest.h>

#include "explain_support.hpp"

namespace halfspace {
namespace {

PieceAccount at_pixel(std::array<Point, 3> px, int x, int y, Cull cull = Cull::kNone) {
  for (Point& p : px) p = {p.x * 256, p.y * 256};
  return explain_triangle({px, 0}, {64, 64, cull}, kPlain, {x, y, 0});
}

TEST(Explain, EveryReasonHasItsTriangle) {
  EXPECT_EQ(at_pixel({{{1, 1}, {5, 5}, {9, 9}}}, 3, 3).fate, Fate::kZeroArea);
  EXPECT_EQ(at_pixel({{{0, 0}, {9, 0}, {0, 9}}}, 3, 3, Cull::kBack).fate, Fate::kCulled);
  EXPECT_EQ(at_pixel({{{0, 0}, {0, 9}, {9, 0}}}, 3, 3, Cull::kFront).fate, Fate::kCulled);
  EXPECT_EQ(at_pixel({{{70, 0}, {90, 0}, {80, 9}}}, 3, 3).fate, Fate::kNoSample);
  EXPECT_EQ(at_pixel({{{4, 0}, {9, 0}, {6, 9}}}, 3, 3).fate, Fate::kOutsideBox);
  EXPECT_EQ(at_pixel({{{0, 0}, {9, 0}, {0, 9}}}, 6, 6).fate, Fate::kOutsideEdge);
  EXPECT_EQ(at_pixel({{{0, 0}, {9, 0}, {0, 9}}}, 3, 3).fate, Fate::kCovers);
}

// (4, 4)'s centre is on the hypotenuse of both halves of a square.
TEST(Explain, ATieNamesTheEdgeThatDecidedIt) {
  const PieceAccount loser = at_pixel({{{0, 0}, {9, 0}, {0, 9}}}, 4, 4);
  EXPECT_EQ(loser.fate, Fate::kTieLost);
  EXPECT_EQ(loser.failed, 0b010u);
  EXPECT_EQ(loser.edge[1].raw, 0);
  EXPECT_EQ(loser.edge[1].biased, -1);
  EXPECT_EQ(loser.edge[1].kind, EdgeKind::kOther);
  const PieceAccount owner = at_pixel({{{9, 0}, {9, 9}, {0, 9}}}, 4, 4);
  EXPECT_EQ(owner.fate, Fate::kCovers);
  EXPECT_EQ(owner.ties_won, 0b100u);
  EXPECT_EQ(owner.edge[2].raw, 0);
  EXPECT_EQ(owner.edge[2].biased, 0);
  EXPECT_EQ(owner.edge[2].kind, EdgeKind::kLeft);
}

TEST(Explain, OutsideNamesEveryFailingEdge) {
  const PieceAccount beyond = at_pixel({{{0, 0}, {20, 10}, {0, 20}}}, 18, 1);
  EXPECT_EQ(beyond.fate, Fate::kOutsideEdge);
  EXPECT_EQ(beyond.failed, 0b001u);
  // Beyond the blunt corner of vertex 2, within the box: outside both edges that meet there.
  const PieceAccount corner = at_pixel({{{0, 0}, {20, 12}, {12, 10}}}, 12, 11);
  EXPECT_EQ(corner.fate, Fate::kOutsideEdge);
  EXPECT_EQ(corner.failed, 0b110u);
}

// E is (to - from) x (sample - from), in units of 2^-16 px^2.
TEST(Explain, EdgeValuesAreTheCrossProducts) {
  const PieceAccount p = at_pixel({{{2, 1}, {7, 5}, {1, 9}}}, 3, 4);
  EXPECT_EQ(p.doubled_area, (5 * 8 - 4 * -1) * 65536);
  EXPECT_EQ(p.edge[0].raw, static_cast<std::int64_t>((5 * 3.5 - 4 * 1.5) * 65536));
  EXPECT_EQ(p.edge[1].raw, static_cast<std::int64_t>((-6 * -0.5 - 4 * -3.5) * 65536));
  EXPECT_EQ(p.edge[2].raw, static_cast<std::int64_t>((1 * -4.5 - -8 * 2.5) * 65536));
}

// The sample is one unit, 2^-16 px^2, outside edge 0 and well inside the others.
TEST(Explain, OneUnitOutsideIsOutside) {
  const Triangle t{{{{129, 129}, {-870, -871}, {2560, 129}}}, 0};
  const PieceAccount piece = explain_triangle(t, kFrame, kPlain, {0, 0, 0});
  EXPECT_EQ(piece.edge[0].raw, -1);
  EXPECT_EQ(piece.fate, Fate::kOutsideEdge);
  EXPECT_EQ(piece.failed, 0b001u);
  EXPECT_TRUE(piece.model_agrees);
}

TEST(Explain, VerdictIsTheOraclesOnEveryShape) {
  constexpr std::uint64_t kSeed = 801;
  for (const Preset& preset : kPresets) {
    for (const int samples : {1, 4, 16}) {
      Config config = with_index_tags(preset.config);
      config.samples = samples;
      const FrameState frame{57, 43, Cull::kNone};
      Random random(kSeed);
      for (int n = 0; n < 4000; ++n) {
        const Shape shape = kShapes[static_cast<std::size_t>(n) % kShapes.size()];
        const Triangle t = random_triangle(random, shape, frame, config);
        const SamplePoint at = random_point(random, frame, config);
        const PieceAccount piece = explain_triangle(t, frame, config, at);
        const oracle::Vec offset =
            oracle::standard_samples(samples)[static_cast<std::size_t>(at.sample)];
        const bool owned =
            oracle::covered(corners_px(t, config), {at.x + offset.x, at.y + offset.y});
        ASSERT_TRUE(piece.model_agrees) << describe(t, frame, config) << ", seed " << kSeed;
        ASSERT_EQ(piece.fate == Fate::kCovers, owned)
            << fate_name(piece.fate) << " at (" << at.x << "," << at.y << ") sample " << at.sample
            << ": " << describe(t, frame, config) << ", seed " << kSeed;
      }
    }
  }
}

}  // namespace
}  // namespace halfspace
