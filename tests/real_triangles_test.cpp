// SPDX-License-Identifier: Apache-2.0
#include "scene/real_triangles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "oracle/metrics.hpp"

namespace halfspace {
namespace {

constexpr FrameState kFrame{64, 32, Cull::kNone};
using Corners = std::array<glm::dvec4, 3>;

// A clip-space position that the window has at (x, y) px, in the middle of the depths.
glm::dvec4 at_px(double x, double y, double w = 1) {
  return {(2 * x / kFrame.width - 1) * w, (1 - 2 * y / kFrame.height) * w, 0.0, w};
}

std::vector<RealTriangle> real_of(const Corners& positions, int guard_bits) {
  std::array<ClipVertex, 3> triangle;
  for (std::size_t i = 0; i < 3; ++i) triangle[i].position = positions[i];
  std::vector<RealTriangle> out;
  real_triangles(triangle, 7, kFrame, guard_bits, [&](const RealTriangle& t) { out.push_back(t); });
  return out;
}

std::vector<std::uint32_t> hits(const std::vector<RealTriangle>& triangles) {
  std::vector<oracle::Corners> corners;
  for (const RealTriangle& t : triangles) {
    corners.push_back({{{t.vertex[0].x, t.vertex[0].y},
                        {t.vertex[1].x, t.vertex[1].y},
                        {t.vertex[2].x, t.vertex[2].y}}});
  }
  return oracle::exact_hits(corners, {kFrame.width, kFrame.height});
}

double farthest(const std::vector<RealTriangle>& triangles) {
  double most = 0;
  for (const RealTriangle& t : triangles) {
    for (const RealVertex& v : t.vertex) most = std::max({most, std::abs(v.x), std::abs(v.y)});
  }
  return most;
}

TEST(RealTriangles, TriangleInViewIsWholeWhateverTheGuardBand) {
  for (const int guard_bits : {0, 13}) {
    const auto found = real_of({at_px(1, 2), at_px(40.25, 3, 2), at_px(5, 30)}, guard_bits);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].whole);
    EXPECT_EQ(found[0].index, 7u);
    EXPECT_EQ(found[0].vertex[1].x, 40.25);
    EXPECT_EQ(found[0].vertex[1].y, 3.0);
    EXPECT_EQ(found[0].vertex[1].inverse_w, 0.5);
  }
}

TEST(RealTriangles, TriangleBeyondOneSideIsDropped) {
  for (const int guard_bits : {0, 13}) {
    EXPECT_TRUE(real_of({at_px(65, 2), at_px(90, 3), at_px(70, 30)}, guard_bits).empty());
    EXPECT_TRUE(real_of({at_px(1, -2), at_px(40, -3), at_px(5, -30)}, guard_bits).empty());
    EXPECT_FALSE(real_of({at_px(-9, 2), at_px(90, 3), at_px(70, 90)}, guard_bits).empty());
  }
}

TEST(RealTriangles, GuardBandCutsWithoutChangingThePicture) {
  const Corners far{at_px(-90000, 10), at_px(90000, 20), at_px(100, 70000)};
  const auto uncut = real_of(far, 0);
  const auto cut = real_of(far, 13);
  ASSERT_EQ(uncut.size(), 1u);
  EXPECT_EQ(farthest(uncut), 90000.0);
  ASSERT_GT(cut.size(), 1u);
  EXPECT_FALSE(cut[0].whole);
  EXPECT_LE(farthest(cut), 8192.0);
  EXPECT_GT(farthest(cut), 8191.0);
  const auto want = hits(uncut);
  EXPECT_EQ(hits(cut), want);
  EXPECT_GT(std::count(want.begin(), want.end(), 1u), 100);
  EXPECT_GT(std::count(want.begin(), want.end(), 0u), 100);
}

TEST(RealTriangles, NearAndFarAlwaysCut) {
  Corners through{at_px(1, 2), at_px(40, 3), at_px(5, 30)};
  through[2].z = 3;
  for (const int guard_bits : {0, 13}) {
    const auto found = real_of(through, guard_bits);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_FALSE(found[0].whole);
    EXPECT_LT(farthest(found), 41.0);
  }
  through[0].x = std::nan("");
  EXPECT_TRUE(real_of(through, 0).empty());
}

}  // namespace
}  // namespace halfspace
