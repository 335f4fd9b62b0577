// SPDX-License-Identifier: Apache-2.0
//
// The framebuffer alone, and the whole pipeline into it.
#include "framebuffer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "rasterizer.hpp"

namespace halfspace {
namespace {

constexpr Rgb kBlack{0, 0, 0};

// A triangle in pixels with one depth (0..1) and one colour.
ShadedTriangle flat_triangle(std::array<std::array<double, 2>, 3> px, double depth, Rgb color,
                             const Config& config) {
  ShadedTriangle t;
  for (std::size_t i = 0; i < 3; ++i) {
    const double one = 1 << config.subpixel_bits;
    t.triangle.vertex[i] = {static_cast<std::int32_t>(px[i][0] * one),
                            static_cast<std::int32_t>(px[i][1] * one)};
    t.attributes[i].depth = static_cast<std::int32_t>(depth * ((1 << config.depth_bits) - 1))
                            << (kPlaneBits - config.depth_bits);
    t.attributes[i].inverse_w = 1u << (config.inverse_w_bits - 1);
    for (std::size_t c = 0; c < 3; ++c) {
      t.attributes[i].value[c] = color[c] << kAttributeFractionBits;
    }
  }
  return t;
}

TEST(Framebuffer, AllocatesOnlyTouchedTiles) {
  Rasterizer r({4096, 4096, Cull::kNone}, kFull, DepthFunction::kLess, kBlack);
  EXPECT_EQ(r.framebuffer().tiles_touched(), 0u);
  r.draw(flat_triangle({{{9, 9}, {15, 9}, {9, 15}}}, 0.5, {1, 2, 3}, kFull));
  EXPECT_EQ(r.framebuffer().tiles_touched(), 1u);
  EXPECT_EQ(r.framebuffer().tiles_total(), 512u * 512u);
}

TEST(Framebuffer, ResolveAveragesSamplesToNearest) {
  Config config = kMsaa4;
  Framebuffer f({8, 8, Cull::kNone}, config, {10, 20, 30}, config.depth_max());
  FrameTile& tile = f.tile(0, 0);
  for (std::size_t m = 0; m < 3; ++m) tile.color[m][9] = {255, 0, 33};
  const Image image = f.resolve();
  // (3 * 255 + 10) / 4 = 193.75; 20 / 4 = 5; (3 * 33 + 30) / 4 = 32.25
  EXPECT_EQ(image.pixel[9], (Rgb{194, 5, 32}));
  EXPECT_EQ(image.pixel[10], (Rgb{10, 20, 30}));
}

TEST(Framebuffer, FrameNeedNotBeAMultipleOfTheTile) {
  Rasterizer r({13, 5, Cull::kNone}, kFull, DepthFunction::kLess, kBlack);
  r.draw(flat_triangle({{{-50, -50}, {100, -50}, {-50, 100}}}, 0.5, {9, 9, 9}, kFull));
  const Image image = r.framebuffer().resolve();
  ASSERT_EQ(image.pixel.size(), 65u);
  EXPECT_EQ(std::count(image.pixel.begin(), image.pixel.end(), Rgb({9, 9, 9})), 65);
  EXPECT_EQ(r.stats().samples_covered, 65u);
}

// Overlapping triangles, each at a depth of its own: any order gives the same picture.
TEST(Rasterizer, OrderDoesNotMatterForDistinctDepths) {
  for (const Config& config : {kFull, kTiny, kMsaa4}) {
    constexpr std::uint64_t kSeed = 7;
    std::mt19937_64 random(kSeed);
    std::vector<ShadedTriangle> triangles;
    for (int i = 0; i < 60; ++i) {
      std::array<std::array<double, 2>, 3> px{};
      for (auto& p : px)
        p = {static_cast<double>(random() % 128), static_cast<double>(random() % 96)};
      const Rgb color{static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                      static_cast<std::uint8_t>(random())};
      triangles.push_back(flat_triangle(px, 0.1 + i * 0.01, color, config));
    }
    std::vector<Rgb> first;
    for (int round = 0; round < 4; ++round) {
      Rasterizer r({128, 96, Cull::kNone}, config, DepthFunction::kLess, kBlack);
      for (const ShadedTriangle& t : triangles) r.draw(t);
      const Image image = r.framebuffer().resolve();
      if (round == 0) first = image.pixel;
      EXPECT_TRUE(image.pixel == first) << "seed " << kSeed << " round " << round;
      std::shuffle(triangles.begin(), triangles.end(), random);
    }
  }
}

// A nearer triangle drawn first leaves nothing to shade of one behind it.
TEST(Rasterizer, AttributesAreEvaluatedOnlyWhereDepthPassed) {
  Rasterizer r({64, 64, Cull::kNone}, kFull, DepthFunction::kLess, kBlack);
  const std::array<std::array<double, 2>, 3> px{{{0, 0}, {64, 0}, {0, 64}}};
  r.draw(flat_triangle(px, 0.2, {200, 0, 0}, kFull));
  const std::uint64_t shaded = r.stats().fragments_shaded;
  EXPECT_EQ(shaded, r.stats().fragments);
  r.draw(flat_triangle(px, 0.7, {0, 200, 0}, kFull));
  EXPECT_EQ(r.stats().fragments_shaded, shaded);
  EXPECT_EQ(r.stats().fragments, 2 * shaded);
}

// Two triangles that split a square, red and green, four samples: every sample of the square has a
// colour, and pixels on the diagonal blend both without the background showing through.
TEST(Rasterizer, SharedEdgeBlendsWithoutBackground) {
  Rasterizer r({32, 32, Cull::kNone}, kMsaa4, DepthFunction::kLess, {0, 0, 255});
  r.draw(flat_triangle({{{0, 0}, {32, 0}, {32, 32}}}, 0.5, {255, 0, 0}, kMsaa4));
  r.draw(flat_triangle({{{0, 0}, {32, 32}, {0, 32}}}, 0.5, {0, 255, 0}, kMsaa4));
  EXPECT_EQ(r.stats().samples_covered, 32u * 32u * 4u);
  bool blended = false;
  for (const Rgb& pixel : r.framebuffer().resolve().pixel) {
    EXPECT_EQ(pixel[2], 0);
    EXPECT_NEAR(pixel[0] + pixel[1], 255, 1);
    blended = blended || (pixel[0] > 0 && pixel[1] > 0);
  }
  EXPECT_TRUE(blended);
}

TEST(Rasterizer, CullDropsTheFaceItNames) {
  const std::array<std::array<double, 2>, 3> clockwise{{{0, 0}, {8, 0}, {0, 8}}};  // y is down
  const std::array<std::array<double, 2>, 3> counter{{{0, 0}, {0, 8}, {8, 0}}};
  const auto covered = [](const std::array<std::array<double, 2>, 3>& px, Cull cull) {
    Rasterizer r({8, 8, cull}, kFull, DepthFunction::kLess, kBlack);
    r.draw(flat_triangle(px, 0.5, {1, 1, 1}, kFull));
    return r.stats().samples_covered;
  };
  EXPECT_GT(covered(clockwise, Cull::kNone), 0u);
  EXPECT_EQ(covered(clockwise, Cull::kBack), 0u);
  EXPECT_GT(covered(clockwise, Cull::kFront), 0u);
  EXPECT_GT(covered(counter, Cull::kBack), 0u);
  EXPECT_EQ(covered(counter, Cull::kFront), 0u);
}

}  // namespace
}  // namespace halfspace
