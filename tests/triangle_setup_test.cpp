// SPDX-License-Identifier: Apache-2.0
#include "triangle_setup.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "compare.hpp"
#include "oracle/oracle.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

using Wide = __int128;

// Configurations with every relation of subpixel and sample-position bits, with and without a
// guard band, and the widest and narrowest numbers.
const std::vector<Config>& configs() {
  static const std::vector<Config> all = [] {
    std::vector<Config> list;
    for (const Preset& preset : kPresets) list.push_back(preset.config);
    for (const int samples : {1, 2, 4, 8, 16}) {
      for (const int s : {0, 1, 3, 4, 8, 12}) {
        list.push_back(
            {.subpixel_bits = s, .viewport_bits = 15, .guard_bits = 16, .samples = samples});
        // A small viewport in a wide guard band: most edges saturate.
        list.push_back(
            {.subpixel_bits = s, .viewport_bits = 4, .guard_bits = 16, .samples = samples});
        list.push_back({.subpixel_bits = s,
                        .viewport_bits = 3,
                        .guard_bits = 0,
                        .samples = samples,
                        .grid_log2 = 2});
      }
    }
    return list;
  }();
  return all;
}

FrameState random_frame(Random& random, const Config& config) {
  return {static_cast<int>(random.in(1, config.max_size())),
          static_cast<int>(random.in(1, config.max_size())), Cull::kNone};
}

Wide floor_of(Wide numerator, Wide denominator) {
  Wide quotient = numerator / denominator;
  while (quotient * denominator > numerator) --quotient;
  return quotient;
}

// Edge i at the sample grid's origin, biased, dropped, not saturated: the page's steps 1 to 6 in
// 128 bits. Orients by swapping the ends, and takes C as a cross product.
struct WideEdge {
  Wide a, b, c;
};

WideEdge wide_edge(const Triangle& t, std::size_t i, const Config& config) {
  const auto x = [&t](std::size_t v) { return Wide{t.vertex[v % 3].x}; };
  const auto y = [&t](std::size_t v) { return Wide{t.vertex[v % 3].y}; };
  const Wide area = x(0) * (y(1) - y(2)) + x(1) * (y(2) - y(0)) + x(2) * (y(0) - y(1));
  const std::size_t from = area > 0 ? i : i + 1;
  const std::size_t to = area > 0 ? i + 1 : i;
  WideEdge edge{y(from) - y(to), x(to) - x(from), x(from) * y(to) - x(to) * y(from)};
  const Wide unit = Wide{1} << config.position_bits();
  edge.c = edge.c * unit / (Wide{1} << config.subpixel_bits);
  if (config.samples == 1) edge.c += unit / 2 * (edge.a + edge.b);
  if (edge.a < 0 || (edge.a == 0 && edge.b <= 0)) edge.c -= 1;
  edge.c = floor_of(edge.c, Wide{1} << config.dropped_bits());
  return edge;
}

TEST(TriangleSetup, EdgesAreThePagesFormulasSaturated) {
  constexpr std::uint64_t kSeed = 11;
  Random random(kSeed);
  std::uint64_t drawn = 0;
  std::uint64_t saturated = 0;
  for (const Config& config : configs()) {
    const Wide limit = Wide{1} << (config.node_bits(config.node_log2(0)) - 1);
    for (int n = 0; n < 4000; ++n) {
      const FrameState frame = random_frame(random, config);
      const Triangle t = random_triangle(
          random, kShapes[static_cast<std::size_t>(n) % kShapes.size()], frame, config);
      const auto setup = triangle_setup(t, frame, config);
      if (!setup) continue;
      ++drawn;
      EXPECT_EQ(setup->tag, t.tag);
      for (std::size_t i = 0; i < 3; ++i) {
        const WideEdge edge = wide_edge(t, i, config);
        const Wide clamped = std::clamp(edge.c, -limit, limit - 1);
        saturated += clamped != edge.c ? 1u : 0u;
        ASSERT_TRUE(setup->slope[i].a == edge.a && setup->slope[i].b == edge.b)
            << "edge " << i << ", seed " << kSeed << ": " << describe(t, frame, config);
        ASSERT_EQ(setup->e[i], static_cast<std::int64_t>(clamped))
            << "edge " << i << ", seed " << kSeed << ": " << describe(t, frame, config);
      }
    }
  }
  EXPECT_GT(drawn, 50'000u);
  EXPECT_GT(saturated, 1'000u);
}

// The sign of a saturated edge value is the unsaturated one's at every sample of the frame.
TEST(TriangleSetup, SaturationKeepsEverySign) {
  for (const Config& config : configs()) {
    const int last = config.max_size() - 1;
    const FrameState frame{config.max_size(), config.max_size(), Cull::kNone};
    const auto samples = oracle::standard_samples(config.samples);
    for (const Triangle& t : widest_triangles(config)) {
      const auto setup = triangle_setup(t, frame, config);
      if (!setup) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const WideEdge edge = wide_edge(t, i, config);
        // A linear function's difference from the saturated one is constant: its corners suffice.
        for (const oracle::Vec s : samples) {
          for (const int corner : {0, 1, 2, 3}) {
            const bool one = config.samples == 1;  // the centre is in C
            const double unit = std::ldexp(1.0, config.sample_bits());
            const Wide u = static_cast<Wide>(((corner & 1) * last + (one ? 0 : s.x)) * unit);
            const Wide v = static_cast<Wide>(((corner >> 1) * last + (one ? 0 : s.y)) * unit);
            const Wide walk = edge.a * u + edge.b * v;
            ASSERT_EQ(walk + setup->e[i] >= 0, walk + edge.c >= 0)
                << "edge " << i << " corner " << corner << ": " << describe(t, frame, config);
          }
        }
      }
    }
  }
}

TEST(TriangleSetup, TopAndLeftEdgesAloneKeepTheirTies) {
  // Clockwise as seen: top edge, right edge, then the left diagonal.
  const Config config{.subpixel_bits = 8};
  const FrameState frame{16, 16, Cull::kNone};
  const Triangle t{{{{128, 128}, {2176, 128}, {2176, 2176}}}, 0};
  const auto setup = triangle_setup(t, frame, config);
  ASSERT_TRUE(setup);
  EXPECT_FALSE(setup->flipped);
  // Pixel (0, 0)'s centre is the first vertex: edges 0 and 2 pass through it.
  EXPECT_EQ(setup->e[0], 0);  // top: inclusive
  EXPECT_EQ(setup->e[2], 0);  // left: inclusive
  EXPECT_EQ(setup->slope[1], (EdgeSlope{-2048, 0}));
  EXPECT_EQ(setup->e[1], 2048 * 8 - 1);  // right: 8 px away, exclusive
}

TEST(TriangleSetup, EitherWindingGivesTheSameEdgesAndSaysWhich) {
  constexpr std::uint64_t kSeed = 12;
  Random random(kSeed);
  const FrameState frame{200, 200, Cull::kNone};
  for (int n = 0; n < 2000; ++n) {
    const Triangle t = random_triangle(random, Shape::kSmall, frame, kFull);
    const Triangle mirrored{{t.vertex[1], t.vertex[0], t.vertex[2]}, 0};
    const auto one = triangle_setup(t, frame, kFull);
    const auto other = triangle_setup(mirrored, frame, kFull);
    ASSERT_EQ(one.has_value(), other.has_value());
    if (!one) continue;
    const auto corners = corners_px(t, kFull);
    EXPECT_EQ(one->flipped, oracle::turn(corners[0], corners[1], corners[2]) < 0);
    EXPECT_NE(one->flipped, other->flipped);
    EXPECT_EQ(one->box, other->box);
    // Edge i runs from vertex i to i + 1: swapping 0 and 1 exchanges edges 1 and 2.
    for (const auto& [i, j] : {std::pair{0u, 0u}, {1u, 2u}, {2u, 1u}}) {
      ASSERT_EQ(one->slope[i], other->slope[j]) << "seed " << kSeed << ", " << n;
      ASSERT_EQ(one->e[i], other->e[j]) << "seed " << kSeed << ", " << n;
    }
  }
}

SetupOutcome outcome_of(const Triangle& t, FrameState frame, const Config& config) {
  SetupOutcome outcome{};
  const auto setup = triangle_setup(t, frame, config, &outcome);
  EXPECT_EQ(setup.has_value(), outcome == SetupOutcome::kDrawn);
  return outcome;
}

TEST(TriangleSetup, CullDropsTheFacesItNames) {
  // Counter-clockwise as seen: down, then right.
  const Triangle front{{{{0, 0}, {0, 2560}, {2560, 2560}}}, 0};
  const Triangle back{{{{0, 0}, {2560, 2560}, {0, 2560}}}, 0};
  const auto drawn = [](const Triangle& t, Cull cull) {
    return outcome_of(t, {16, 16, cull}, kFull) == SetupOutcome::kDrawn;
  };
  EXPECT_TRUE(drawn(front, Cull::kNone));
  EXPECT_TRUE(drawn(back, Cull::kNone));
  EXPECT_TRUE(drawn(front, Cull::kBack));
  EXPECT_FALSE(drawn(back, Cull::kBack));
  EXPECT_FALSE(drawn(front, Cull::kFront));
  EXPECT_TRUE(drawn(back, Cull::kFront));
}

TEST(TriangleSetup, ReasonsAreTriedInOrder) {
  const Triangle flat{{{{-300, -300}, {-200, -200}, {-100, -100}}}, 0};
  const Triangle back{{{{-300, -300}, {-100, -100}, {-300, -100}}}, 0};
  const Triangle between{{{{129, 129}, {383, 129}, {129, 383}}}, 0};  // no pixel centre
  EXPECT_EQ(outcome_of(flat, {16, 16, Cull::kBack}, kFull), SetupOutcome::kZeroArea);
  EXPECT_EQ(outcome_of(back, {16, 16, Cull::kBack}, kFull), SetupOutcome::kCulled);
  EXPECT_EQ(outcome_of(back, {16, 16, Cull::kNone}, kFull), SetupOutcome::kNoSample);
  EXPECT_EQ(outcome_of(between, {16, 16, Cull::kNone}, kFull), SetupOutcome::kNoSample);
}

TEST(TriangleSetup, EveryTriangleWithoutAreaIsDropped) {
  constexpr std::uint64_t kSeed = 13;
  Random random(kSeed);
  for (const Config& config : configs()) {
    const FrameState frame = random_frame(random, config);
    for (int n = 0; n < 300; ++n) {
      const Triangle t = random_triangle(random, Shape::kNoArea, frame, config);
      ASSERT_EQ(outcome_of(t, frame, config), SetupOutcome::kZeroArea)
          << "seed " << kSeed << ": " << describe(t, frame, config);
    }
  }
}

}  // namespace
}  // namespace halfspace
