// SPDX-License-Identifier: Apache-2.0
//
// Snapping, packing and what happens to whole triangles. Clipping: geometry_clip_test.cpp.
#include "geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace halfspace {
namespace {

constexpr FrameState kFrame{.width = 256, .height = 128};

ClipVertex vertex(double x, double y, double z, double w) { return {{x, y, z, w}, {}}; }

std::vector<ShadedTriangle> run(const std::array<ClipVertex, 3>& triangle, const Config& config,
                                GeometryStats* stats = nullptr, const FrameState& frame = kFrame,
                                std::uint32_t tag = 0) {
  GeometryStage stage(frame, config);
  std::vector<ShadedTriangle> out;
  stage.process(triangle, tag, out);
  if (stats != nullptr) *stats = stage.stats();
  return out;
}

Config with_snap(SnapMode mode) {
  Config config;
  config.snap = mode;
  return config;
}

TEST(Snap, HalfTiesGoToEven) {
  const Config config = with_snap(SnapMode::kNearestEven);
  for (int i = -2000; i <= 2000; ++i) {
    const std::int64_t even = i % 2 == 0 ? i : i + 1;
    EXPECT_EQ(snap((i + 0.5) / 256.0, config), even) << i;
    EXPECT_EQ(snap(std::nextafter((i + 0.5) / 256.0, -1e9), config), i) << i;
    EXPECT_EQ(snap(std::nextafter((i + 0.5) / 256.0, 1e9), config), i + 1) << i;
  }
}

TEST(Snap, HalfAwayGoesAwayFromZero) {
  const Config config = with_snap(SnapMode::kHalfAway);
  for (int i = 0; i <= 2000; ++i) {
    EXPECT_EQ(snap((i + 0.5) / 256.0, config), i + 1);
    EXPECT_EQ(snap(-(i + 0.5) / 256.0, config), -(i + 1));
    EXPECT_EQ(snap(std::nextafter((i + 0.5) / 256.0, 0.0), config), i);
    EXPECT_EQ(snap(-std::nextafter((i + 0.5) / 256.0, 0.0), config), -i);
  }
}

TEST(Snap, TruncateGoesTowardsZero) {
  const Config config = with_snap(SnapMode::kTruncate);
  for (int i = 0; i <= 2000; ++i) {
    for (const double part : {0.0, 0.25, 0.5, 0.999}) {
      EXPECT_EQ(snap((i + part) / 256.0, config), i);
      EXPECT_EQ(snap(-(i + part) / 256.0, config), -i);
    }
  }
}

TEST(Snap, NearestIsNearestByAnotherRoute) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> px(-70000.0, 70000.0);
  for (int bits = 0; bits <= 12; ++bits) {
    Config config;
    config.subpixel_bits = bits;
    for (int i = 0; i < 2000; ++i) {
      const double x = px(random);
      // rint() in the default rounding mode is half to even.
      EXPECT_EQ(snap(x, config), static_cast<std::int64_t>(std::rint(std::ldexp(x, bits))));
    }
  }
}

TEST(Snap, HugeValuesDoNotOverflow) {
  for (const SnapMode mode : {SnapMode::kNearestEven, SnapMode::kHalfAway, SnapMode::kTruncate}) {
    Config config = with_snap(mode);
    config.subpixel_bits = 12;
    for (const double huge : {2e12, 1e30, 1e308, std::numeric_limits<double>::infinity()}) {
      EXPECT_EQ(snap(huge, config), snap(std::ldexp(1.0, 40), config));
      EXPECT_EQ(snap(-huge, config), -snap(huge, config));
      EXPECT_GT(snap(huge, config), config.coordinate_max());
    }
  }
}

TEST(Viewport, YPointsDownAndTheOriginIsTheTopLeftCorner) {
  const auto out =
      run({vertex(-1, 1, 0, 1), vertex(1, -1, 0, 1), vertex(0, 0, 0, 1)}, kFull, nullptr);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].triangle.vertex[0], (Point{0, 0}));
  EXPECT_EQ(out[0].triangle.vertex[1], (Point{256 * 256, 128 * 256}));
  EXPECT_EQ(out[0].triangle.vertex[2], (Point{128 * 256, 64 * 256}));
}

TEST(Viewport, DividesByW) {
  const auto out =
      run({vertex(1, 1, 0, 2), vertex(-2, 2, 0, 4), vertex(0, -4, 0, 8)}, kFull, nullptr);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].triangle.vertex[0], (Point{192 * 256, 32 * 256}));
  EXPECT_EQ(out[0].triangle.vertex[1], (Point{64 * 256, 32 * 256}));
  EXPECT_EQ(out[0].triangle.vertex[2], (Point{128 * 256, 96 * 256}));
}

TEST(Geometry, TagIsTruncatedAndSharedByTheCutPieces) {
  Config config;
  config.tag_bits = 5;
  const auto whole = run({vertex(0, 0, 0, 1), vertex(1, 0, 0, 1), vertex(0, 1, 0, 1)}, config,
                         nullptr, kFrame, 37);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].triangle.tag, 5U);
  const auto pieces = run({vertex(0, 0, -2, 1), vertex(1, 0, 0, 1), vertex(0, 1, 0, 1)}, config,
                          nullptr, kFrame, 37);
  ASSERT_EQ(pieces.size(), 2U);
  for (const ShadedTriangle& piece : pieces) EXPECT_EQ(piece.triangle.tag, 5U);
  config.tag_bits = 32;
  const auto wide = run({vertex(0, 0, 0, 1), vertex(1, 0, 0, 1), vertex(0, 1, 0, 1)}, config,
                        nullptr, kFrame, 0xdeadbeefU);
  EXPECT_EQ(wide.at(0).triangle.tag, 0xdeadbeefU);
}

TEST(Geometry, ACoordinateThatIsNotFiniteDropsTheTriangle) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity(), 1e200, -1e300}) {
    for (std::size_t v = 0; v < 3; ++v) {
      for (int axis = 0; axis < 4; ++axis) {
        std::array<ClipVertex, 3> triangle{vertex(0, 0, 0, 1), vertex(1, 0, 0, 1),
                                           vertex(0, 1, 0, 1)};
        triangle[v].position[axis] = bad;
        GeometryStats stats;
        EXPECT_TRUE(run(triangle, kFull, &stats).empty());
        EXPECT_EQ(stats, (GeometryStats{.triangles_in = 1, .dropped_not_finite = 1}));
      }
    }
  }
}

TEST(Geometry, HugeFiniteCoordinatesStayInRange) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> exponent(-330.0, 330.0), sign(-1.0, 1.0);
  for (const Preset& preset : kPresets) {
    GeometryStage stage({.width = 400, .height = 300}, preset.config);
    std::vector<ShadedTriangle> out;
    for (int i = 0; i < 40000; ++i) {
      std::array<ClipVertex, 3> triangle;
      for (ClipVertex& v : triangle) {
        for (int axis = 0; axis < 4; ++axis) {
          // Mostly moderate, sometimes near the ends of what is accepted.
          const double power = i % 2 == 0 ? exponent(random) : exponent(random) / 20.0;
          v.position[axis] = std::copysign(std::exp2(power), sign(random));
        }
      }
      stage.process(triangle, 0, out);  // HS_CHECK inside stops the test if a coordinate escapes
    }
    EXPECT_GT(stage.stats().clipped, 1000U) << preset.name;
    EXPECT_EQ(stage.stats().dropped_not_finite, 0U);
    EXPECT_EQ(stage.stats().triangles_out, out.size());
  }
}

TEST(Geometry, WhollyOutsideOnePlaneYieldsNothing) {
  for (const Preset& preset : kPresets) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        std::array<ClipVertex, 3> triangle{vertex(0, 0, 0, 1), vertex(.5, 0, 0, 2),
                                           vertex(0, .5, 0, 1)};
        for (ClipVertex& v : triangle) v.position[axis] = side * 1.01 * v.position.w;
        GeometryStats stats;
        EXPECT_TRUE(run(triangle, preset.config, &stats).empty());
        EXPECT_EQ(stats, (GeometryStats{.triangles_in = 1, .outside = 1}));
      }
    }
    const std::array<ClipVertex, 3> behind{vertex(0, 0, 0, -1), vertex(1, 0, 0, -2),
                                           vertex(0, 1, 0, 0)};
    EXPECT_TRUE(run(behind, preset.config).empty());
  }
}

// A vertex without a direction: the triangle degenerates to the opposite edge.
TEST(Geometry, AVertexOfAllZerosDrawsNothing) {
  EXPECT_TRUE(run({vertex(0, 0, 0, 0), vertex(1, 0, 0, 2), vertex(0, 1, 0, 2)}, kFull).empty());
}

// Beyond the frame by up to `reach` frames on every side of it.
std::array<ClipVertex, 3> beyond(double reach) {
  return {vertex(-reach, -reach, 0, 1), vertex(reach, -reach, 0, 1), vertex(0, reach, 0, 1)};
}

TEST(GuardBand, InsideTheBandNothingIsCutAndBeyondItIs) {
  const FrameState frame{.width = 1024, .height = 1024};
  const double band = 2.0 * 8191.0 / 1024 - 1.0;  // ndc at window x = 8191, kFull
  GeometryStats stats;
  const auto whole = run(beyond(band), kFull, &stats, frame);
  EXPECT_EQ(stats, (GeometryStats{.triangles_in = 1, .triangles_out = 1}));
  EXPECT_EQ(whole.at(0).triangle.vertex[1].x, 8191 * 256);
  const auto pieces = run(beyond(band + 0.01), kFull, &stats, frame);
  EXPECT_EQ(stats.clipped, 1U);
  EXPECT_GT(pieces.size(), 1U);
}

TEST(GuardBand, WithoutOneTheFrameIsTheLimit) {
  const FrameState frame{.width = 500, .height = 300};
  GeometryStats stats;
  run(beyond(1.0), kTiny, &stats, frame);
  EXPECT_EQ(stats.clipped, 0U);
  const auto pieces = run(beyond(1.001), kTiny, &stats, frame);
  EXPECT_EQ(stats.clipped, 1U);
  for (const ShadedTriangle& piece : pieces) {
    for (const Point& p : piece.triangle.vertex) {
      EXPECT_TRUE(p.x >= 0 && p.x <= 500 * 16 && p.y >= 0 && p.y <= 300 * 16);
    }
  }
}

TEST(Attributes, DepthRunsFromNearZeroToFarAllOnes) {
  for (const int bits : {16, 24}) {
    Config config;
    config.depth_bits = bits;
    const auto out =
        run({vertex(0, 0, -1, 1), vertex(1, 0, 3, 3), vertex(0, 1, 0, 1)}, config, nullptr);
    ASSERT_EQ(out.size(), 1U);
    const std::int32_t all_ones = (1 << kPlaneBits) - (1 << (kPlaneBits - bits));
    EXPECT_EQ(out[0].attributes[0].depth, 0);
    EXPECT_EQ(out[0].attributes[1].depth, all_ones);
    EXPECT_EQ(out[0].attributes[2].depth, all_ones / 2);
  }
}

TEST(Attributes, ValuesRoundAndClampAndUnusedOnesAreZero) {
  std::array<ClipVertex, 3> triangle{vertex(0, 0, 0, 1), vertex(1, 0, 0, 1), vertex(0, 1, 0, 1)};
  triangle[0].attribute = {255.0, 300.0, -1.0, 77.0};
  triangle[1].attribute = {127.5, 1.0 / 512.0, std::nan(""), 77.0};
  triangle[2].attribute = {1.0 / 513.0, 255.0 - 1.0 / 511.0, 254.999, 77.0};
  const auto out = run(triangle, kFull, nullptr);
  ASSERT_EQ(out.size(), 1U);
  using Values = std::array<std::int32_t, kMaxAttributes>;
  EXPECT_EQ(out[0].attributes[0].value, (Values{65280, 65280, 0}));
  EXPECT_EQ(out[0].attributes[1].value, (Values{32640, 1, 0}));
  EXPECT_EQ(out[0].attributes[2].value, (Values{0, 65279, 65280}));
}

TEST(Attributes, InverseWKeepsItsRatiosWithTheTopBitSetInTheGreatest) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> power(-60.0, 60.0), spread(0.0, 10.0);
  for (const int bits : {12, 25, 30}) {
    Config config;
    config.inverse_w_bits = bits;
    for (int i = 0; i < 5000; ++i) {
      const double base = power(random);
      std::array<ClipVertex, 3> triangle;
      for (ClipVertex& v : triangle) {
        const double w = std::exp2(base + spread(random));
        v = vertex(0.3 * w, 0.4 * w, 0.0, w);
      }
      const auto out = run(triangle, config);
      ASSERT_EQ(out.size(), 1U);
      std::size_t first = 0;
      for (std::size_t j = 1; j < 3; ++j) {
        if (triangle[j].position.w < triangle[first].position.w) first = j;
      }
      const double greatest = out[0].attributes[first].inverse_w;
      EXPECT_GE(greatest, std::exp2(bits - 1));
      EXPECT_LE(greatest, std::exp2(bits) - 1);
      for (std::size_t j = 0; j < 3; ++j) {
        const double expected = greatest * triangle[first].position.w / triangle[j].position.w;
        EXPECT_NEAR(out[0].attributes[j].inverse_w, expected, 1.01);
      }
    }
  }
}

TEST(Attributes, InverseWIsNeverZeroNorAboveItsBits) {
  const double almost_two = std::nextafter(1.0, 0.0) * 0.5;  // 1/w just rounds up to 2
  const auto out = run({vertex(0, 0, 0, std::nextafter(0.5, 1.0)), vertex(0, 0, 0, 1e30),
                        vertex(0, 0, 0, almost_two * 1e20)},
                       kFull);
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].attributes[0].inverse_w, (1U << kFull.inverse_w_bits) - 1U);
  EXPECT_EQ(out[0].attributes[1].inverse_w, 1U);
  EXPECT_EQ(out[0].attributes[2].inverse_w, 1U);
}

TEST(Attributes, EqualWGivesEqualInverseW) {
  const auto out = run({vertex(0, 0, 0, 1), vertex(1, 0, 0, 1), vertex(0, 1, 0, 1)}, kFull);
  ASSERT_EQ(out.size(), 1U);
  for (const VertexAttributes& a : out[0].attributes)
    EXPECT_EQ(a.inverse_w, 1U << (kFull.inverse_w_bits - 1));
}

}  // namespace
}  // namespace halfspace
