// SPDX-License-Identifier: Apache-2.0
//
// Every triangle of a frame, and which one shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "explain_support.hpp"

namespace halfspace {
namespace {

constexpr Rgb kBlack{0, 0, 0};

// A triangle of one depth (0..1) and, as its colour, its number.
ShadedTriangle numbered(const Triangle& triangle, std::uint32_t number, double depth,
                        const Config& config) {
  VertexAttributes vertex;
  const double scale =
      std::ldexp(1.0, kPlaneBits) - std::ldexp(1.0, kPlaneBits - config.depth_bits);
  vertex.depth = static_cast<std::int32_t>(depth * scale);
  vertex.inverse_w = 1u << (config.inverse_w_bits - 1);
  // Five bits a channel, in the middle of eight levels: rounding cannot reach the next number.
  for (unsigned c = 0; c < 3; ++c) {
    const unsigned level = (number >> (5 * c) & 31u) * 8 + 4;
    vertex.value[c] = static_cast<std::int32_t>(level << kAttributeFractionBits);
  }
  ShadedTriangle out{triangle, {vertex, vertex, vertex}};
  out.triangle.tag = number;
  return out;
}

unsigned number_of(const Rgb& color) {
  return color[0] / 8u | color[1] / 8u << 5 | color[2] / 8u << 10;
}

std::vector<ShadedTriangle> random_scene(std::uint64_t seed, int count, const FrameState& frame,
                                         const Config& config) {
  Random random(seed);
  std::vector<ShadedTriangle> scene;
  for (int i = 0; i < count; ++i) {
    const Shape shape = kShapes[static_cast<std::size_t>(i) % kShapes.size()];
    const double depth = static_cast<double>(random.in(1, 90)) / 100.0;
    scene.push_back(numbered(random_triangle(random, shape, frame, config),
                             static_cast<std::uint32_t>(i), depth, config));
  }
  return scene;
}

Explainer explain(const std::vector<ShadedTriangle>& scene, const FrameState& frame,
                  const Config& config, const SamplePoint& at, bool keep_all = true,
                  DepthFunction function = DepthFunction::kLess) {
  Explainer explainer(frame, config, function, kBlack, at, keep_all);
  for (const ShadedTriangle& triangle : scene) explainer.add(triangle);
  explainer.finish(scene.size());
  return explainer;
}

std::uint64_t count(const Explainer& explainer, Fate fate) {
  return explainer.counts()[static_cast<std::size_t>(fate)];
}

TEST(Explain, AccountsForEveryTriangleOnce) {
  constexpr std::uint64_t kSeed = 802;
  for (const int samples : {1, 4}) {
    const Config config = with_index_tags(samples == 1 ? kFull : kMsaa4);
    const FrameState frame{60, 40, Cull::kBack};
    const auto scene = random_scene(kSeed, 500, frame, config);
    Random random(kSeed);
    for (int n = 0; n < 50; ++n) {
      const Explainer e = explain(scene, frame, config, random_point(random, frame, config));
      ASSERT_EQ(std::accumulate(e.counts().begin(), e.counts().end(), std::uint64_t{0}),
                scene.size());
      ASSERT_EQ(e.accounts().size(), scene.size());
      for (std::size_t i = 0; i < scene.size(); ++i) ASSERT_EQ(e.accounts()[i].index, i);
      ASSERT_FALSE(e.disagreement().has_value());
    }
  }
}

TEST(Explain, WinnerIsTheFramebuffersAtRandomPixels) {
  constexpr std::uint64_t kSeed = 803;
  for (const DepthFunction function : {DepthFunction::kLess, DepthFunction::kLessEqual}) {
    for (const FrameState frame : {FrameState{60, 40, Cull::kNone}, {200, 150, Cull::kFront}}) {
      const Config config = with_index_tags(kFull);
      const auto scene = random_scene(kSeed, 400, frame, config);
      Rasterizer rasterizer(frame, config, function, kBlack);
      for (const ShadedTriangle& triangle : scene) rasterizer.draw(triangle);
      Image picture = rasterizer.framebuffer().resolve();
      Random random(kSeed);
      for (int n = 0; n < 120; ++n) {
        const SamplePoint at = random_point(random, frame, config);
        const Explainer e = explain(scene, frame, config, at, false, function);
        const Rgb color = picture.at(at.x, at.y);
        ASSERT_EQ(e.color(), color);
        ASSERT_EQ(e.winner() < 0, color == kBlack) << at.x << "," << at.y << ", seed " << kSeed;
        ASSERT_EQ(count(e, Fate::kCovers), color == kBlack ? 0u : 1u);
        if (color != kBlack) {
          ASSERT_EQ(e.winner(), number_of(color));
        }
        ASSERT_EQ(
            e.depth(),
            rasterizer.framebuffer().depth()[static_cast<std::size_t>(at.y * frame.width + at.x)]);
      }
    }
  }
}

// The winner of each sample by brute force over the tiles that the model draws.
TEST(Explain, WinnerOfEachOfFourSamplesIsTheDepthTests) {
  constexpr std::uint64_t kSeed = 804;
  const Config config = with_index_tags(kMsaa4);
  const FrameState frame{50, 50, Cull::kNone};
  const auto scene = random_scene(kSeed, 300, frame, config);
  std::vector<std::int64_t> winner(4 * 50 * 50, -1);
  std::vector<std::int32_t> nearest(winner.size(), std::numeric_limits<std::int32_t>::max());
  for (const ShadedTriangle& t : scene) {
    RasterStats stats;
    rasterize(t.triangle, frame, config, stats, [&](const CoverageTile& tile) {
      for (std::size_t m = 0; m < 4; ++m) {
        for (GridMask left = tile.mask[m]; left != 0; left &= left - 1) {
          const int bit = std::countr_zero(left);
          const auto at =
              m + 4 * static_cast<std::size_t>((tile.y + bit / 8) * 50 + tile.x + bit % 8);
          if (t.attributes[0].depth >= nearest[at]) continue;
          nearest[at] = t.attributes[0].depth;
          winner[at] = t.triangle.tag;
        }
      }
    });
  }
  Random random(kSeed);
  for (int n = 0; n < 300; ++n) {
    const SamplePoint at = random_point(random, frame, config);
    const Explainer e = explain(scene, frame, config, at, false);
    ASSERT_EQ(e.winner(), winner[static_cast<std::size_t>(at.sample + 4 * (at.y * 50 + at.x))])
        << at.x << "," << at.y << " sample " << at.sample << ", seed " << kSeed;
  }
}

// Depths that slope: sample 0 of four is not at the centre.
TEST(Explain, DepthIsThatOfTheSampleAndNotOfTheCentre) {
  const Config config = with_index_tags(kMsaa4);
  const FrameState frame{40, 40, Cull::kNone};
  ShadedTriangle t = numbered({{{{0, 0}, {10000, 0}, {0, 10000}}}, 0}, 0, 0.1, config);
  t.attributes[1].depth *= 5;
  t.attributes[2].depth *= 8;
  Rasterizer rasterizer(frame, config, DepthFunction::kLess, kBlack);
  rasterizer.draw(t);
  for (const int x : {3, 11, 17}) {
    const Explainer e = explain({t}, frame, config, {x, 5, 0});
    EXPECT_EQ(e.depth(), rasterizer.framebuffer().depth()[static_cast<std::size_t>(5 * 40 + x)]);
    EXPECT_NE(e.depth(), explain({t}, frame, config, {x, 5, 1}).depth());
  }
}

// Vertices on pixel centres: shared edges run through samples everywhere.
TEST(Explain, ASharedEdgeSampleHasOneOwner) {
  const Config config = with_index_tags(kFull);
  const FrameState frame{64, 64, Cull::kNone};
  std::vector<ShadedTriangle> scene;
  for (const Triangle& t : jittered_mesh(805, 64, 8, 128, config)) {
    scene.push_back(numbered(t, static_cast<std::uint32_t>(scene.size()), 0.5, config));
  }
  std::uint64_t lost = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const Explainer e = explain(scene, frame, config, {x, y, 0}, false);
      ASSERT_EQ(count(e, Fate::kCovers), 1u) << x << "," << y;
      ASSERT_EQ(count(e, Fate::kBehind), 0u) << x << "," << y;
      lost += count(e, Fate::kTieLost);
    }
  }
  EXPECT_GT(lost, 50u) << "the mesh has no samples on edges";
}

TEST(Explain, SkippedIndicesWereClipped) {
  Explainer e(kFrame, kPlain, DepthFunction::kLess, kBlack, {3, 3, 0}, true);
  const Triangle covers{{{{0, 0}, {2560, 0}, {0, 2560}}}, 0};
  e.add(numbered(covers, 2, 0.5, kPlain));
  e.add(numbered(covers, 5, 0.25, kPlain));
  e.add(numbered(covers, 5, 0.75, kPlain));  // a second piece of 5, and one that is elsewhere
  e.add(numbered({{{{8000, 8000}, {9000, 8000}, {8000, 9000}}}, 0}, 5, 0.5, kPlain));
  e.finish(9);
  EXPECT_EQ(count(e, Fate::kClipped), 7u);
  EXPECT_EQ(count(e, Fate::kBehind), 1u);
  EXPECT_EQ(count(e, Fate::kOutsideBox), 0u);
  EXPECT_EQ(e.winner(), 5);
  ASSERT_EQ(e.accounts().size(), 9u);
  EXPECT_EQ(e.accounts()[2].fate, Fate::kBehind);
  EXPECT_TRUE(e.accounts()[2].pieces[0].passed);
  EXPECT_EQ(e.accounts()[2].pieces[0].behind, 5);
  EXPECT_EQ(e.accounts()[5].fate, Fate::kCovers);
  EXPECT_EQ(e.accounts()[5].pieces[1].fate, Fate::kBehind);
  EXPECT_EQ(e.accounts()[8].fate, Fate::kClipped);
}

TEST(Explain, BehindNamesTheTriangleInFrontAtTheTime) {
  Explainer e(kFrame, kPlain, DepthFunction::kLess, kBlack, {3, 3, 0}, false);
  const Triangle covers{{{{0, 0}, {2560, 0}, {0, 2560}}}, 0};
  const std::array<double, 5> depth{0.9, 0.5, 0.7, 0.2, 0.3};
  for (std::uint32_t i = 0; i < 5; ++i) e.add(numbered(covers, i, depth[i], kPlain));
  e.finish(5);
  const std::array<std::int64_t, 5> behind{1, 3, 1, -1, 3};
  const std::array<bool, 5> passed{true, true, false, true, false};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(e.accounts()[i].pieces[0].behind, behind[i]) << i;
    EXPECT_EQ(e.accounts()[i].pieces[0].passed, passed[i]) << i;
  }
  EXPECT_EQ(e.winner(), 3);
}

}  // namespace
}  // namespace halfspace
