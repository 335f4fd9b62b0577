// SPDX-License-Identifier: Apache-2.0
//
// Clipping against an independent reference: the homogeneous barycentric coordinates of a point of
// the screen, found from the uncut triangle by Cramer's rule, say whether it is inside and at
// which depth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>

#include "geometry.hpp"

namespace halfspace {
namespace {

using Clips = std::array<ClipVertex, 3>;

ClipVertex vertex(double x, double y, double z, double w) { return {{x, y, z, w}, {}}; }

std::vector<ShadedTriangle> run(const Clips& triangle, const FrameState& frame,
                                const Config& config, GeometryStats* stats = nullptr) {
  GeometryStage stage(frame, config);
  std::vector<ShadedTriangle> out;
  stage.process(triangle, 0, out);
  if (stats != nullptr) *stats = stage.stats();
  return out;
}

// Snapped to whole pixels: the most ties and the worst dents.
constexpr Config kCoarse{.subpixel_bits = 0, .viewport_bits = 9, .guard_bits = 0, .grid_log2 = 2};

// Twice the edge function of (from, to) at (x, y) in half subpixels, inside positive.
std::int64_t edge(const Point& from, const Point& to, std::int64_t x, std::int64_t y) {
  return (std::int64_t{from.y} - to.y) * (x - 2 * std::int64_t{from.x}) +
         (std::int64_t{to.x} - from.x) * (y - 2 * std::int64_t{from.y});
}

// 1, 0 or -1: the way a triangle faces.
int facing(const ShadedTriangle& triangle) {
  const auto& p = triangle.triangle.vertex;
  const std::int64_t area = edge(p[0], p[1], 2 * p[2].x, 2 * p[2].y);
  return static_cast<int>(area > 0) - static_cast<int>(area < 0);
}

// Snapping may make edges of a thin polygon cross: its pieces are then not quite the polygon, whose
// area counts what is folded over as negative.
bool crosses(const Clips& triangle, const FrameState& frame, const Config& config) {
  const ClipPolygon polygon = clip(triangle, clip_volume(frame, config));
  std::vector<Point> ring;
  for (int i = 0; i < polygon.count; ++i) {
    const glm::dvec4& p = polygon.vertex[static_cast<std::size_t>(i)].position;
    const glm::dvec2 at = window_position(p, frame.width / 2.0, frame.height / 2.0);
    ring.push_back({static_cast<std::int32_t>(snap(at.x, config)),
                    static_cast<std::int32_t>(snap(at.y, config))});
  }
  const auto doubled_area = [](const Point& a, const Point& b, const Point& c) {
    return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
           (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
  };
  std::int64_t area = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    area += doubled_area(ring[0], ring[i], ring[i + 1]);
  }
  for (const ShadedTriangle& piece : run(triangle, frame, config)) {
    const auto& v = piece.triangle.vertex;
    area -= doubled_area(v[0], v[1], v[2]);
  }
  return area != 0;
}

// Snapping may turn one of two thin shapes over.
bool folds(const std::vector<ShadedTriangle>& triangles) {
  const auto faces = [&](int way) {
    return std::any_of(triangles.begin(), triangles.end(),
                       [way](const ShadedTriangle& t) { return facing(t) == way; });
  };
  return faces(1) && faces(-1);
}

// How many of the triangles own the sample (x, y), both in half subpixels: top-left rule, exact.
int hits(const std::vector<ShadedTriangle>& triangles, std::int64_t x, std::int64_t y) {
  int count = 0;
  for (const ShadedTriangle& t : triangles) {
    auto p = t.triangle.vertex;
    if (facing(t) < 0) std::swap(p[1], p[2]);
    bool inside = facing(t) != 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point &from = p[i], &to = p[(i + 1) % 3];
      const std::int64_t e = edge(from, to, x, y);
      const bool top_left = from.y > to.y || (from.y == to.y && to.x > from.x);
      inside = inside && (e > 0 || (e == 0 && top_left));
    }
    count += inside ? 1 : 0;
  }
  return count;
}

// The least of everything that must be positive for the triangle to be seen at this point of the
// screen: its barycentric coordinates, scaled to sum to 1, and the distances to near and far.
double reference_margin(const Clips& t, double ndc_x, double ndc_y) {
  const auto column = [&t](std::size_t i) {
    const glm::dvec4& p = t[i].position;
    return glm::dvec3{p.x, p.y, p.w};
  };
  const glm::dvec3 a = column(0), b = column(1), c = column(2), p{ndc_x, ndc_y, 1.0};
  const double det = glm::dot(a, glm::cross(b, c));
  // Coefficients of p = l0 a + l1 b + l2 c; p has w = 1, so positive ones mean in front of the eye.
  const glm::dvec3 l = glm::dvec3{glm::dot(p, glm::cross(b, c)), glm::dot(a, glm::cross(p, c)),
                                  glm::dot(a, glm::cross(b, p))} /
                       det;
  const double z = l.x * t[0].position.z + l.y * t[1].position.z + l.z * t[2].position.z;
  const double sum = std::abs(l.x) + std::abs(l.y) + std::abs(l.z);
  return std::min({l.x / sum, l.y / sum, l.z / sum, z + 1.0, 1.0 - z});
}

// True when the reference has the same answer, in or out, over a square around the point.
bool clear_cut(const Clips& t, double x, double y, double radius, bool& inside) {
  inside = reference_margin(t, x, y) > 0.0;
  for (const double dx : {-radius, radius}) {
    for (const double dy : {-radius, radius}) {
      if ((reference_margin(t, x + dx, y + dy) > 0.0) != inside) return false;
    }
  }
  return true;
}

// Compares every pixel of a frame that is not within two subpixels of a border.
int compare_frame(const Clips& triangle, const FrameState& frame, const Config& config) {
  const auto out = run(triangle, frame, config);
  const std::int64_t unit = std::int64_t{1} << config.subpixel_bits;
  const double radius = 2.0 * 2.0 / static_cast<double>(unit * std::min(frame.width, frame.height));
  int compared = 0;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      bool inside = false;
      const double ndc_x = (x + 0.5) * 2.0 / frame.width - 1.0;
      const double ndc_y = 1.0 - (y + 0.5) * 2.0 / frame.height;
      if (!clear_cut(triangle, ndc_x, ndc_y, radius, inside)) continue;
      ++compared;
      const int count = hits(out, (2 * x + 1) * unit, (2 * y + 1) * unit);
      EXPECT_EQ(count, inside ? 1 : 0) << "pixel " << x << ", " << y;
    }
  }
  return compared;
}

TEST(Clip, FloorThroughTheEyePlaneCoversWhatTheReferenceCovers) {
  const Clips floor{vertex(-4, -1, 0, 4), vertex(4, -1, 0, 4), vertex(0, -1, 0, -0.5)};
  const FrameState frame{.width = 256, .height = 256};
  for (const Preset& preset : kPresets) {
    EXPECT_GT(compare_frame(floor, frame, preset.config), 60000) << preset.name;
  }
  GeometryStats stats;
  run(floor, frame, kFull, &stats);
  EXPECT_EQ(stats.clipped, 1U);
}

// Divided without clipping, the vertex behind the eye lands in the picture's wrong half.
TEST(Clip, DividingTheFloorUnclippedIsWrongAlmostEverywhere) {
  const Clips floor{vertex(-4, -1, 0, 4), vertex(4, -1, 0, 4), vertex(0, -1, 0, -0.5)};
  Clips divided = floor;
  for (ClipVertex& v : divided) v.position /= v.position.w;
  const FrameState frame{.width = 256, .height = 256};
  const auto right = run(floor, frame, kFull), wrong = run(divided, frame, kFull);
  int different = 0;
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) {
      const std::int64_t sx = 512 * x + 256, sy = 512 * y + 256;
      different += (hits(right, sx, sy) != hits(wrong, sx, sy)) ? 1 : 0;
    }
  }
  EXPECT_GT(different, 256 * 256 / 2);
}

TEST(Clip, RandomTrianglesCoverWhatTheReferenceCovers) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const FrameState frame{.width = 24, .height = 17};
  std::int64_t compared = 0;
  for (int i = 0; i < 4000; ++i) {
    Clips triangle;
    const double reach = i % 3 == 0 ? 1.5 : i % 3 == 1 ? 20.0 : 3000.0;
    for (ClipVertex& v : triangle) {
      const double w = any(random) + 0.4, z = 2.0 * any(random);
      const double y = reach * any(random), x = reach * any(random);
      v = vertex(x, y, z, w);
    }
    const Config& config = kPresets[static_cast<std::size_t>(i) % kPresets.size()].config;
    compared += compare_frame(triangle, frame, config);
    if (HasFailure()) FAIL() << "triangle " << i;
  }
  EXPECT_GT(compared, 4000 * 24 * 17 * 8 / 10);
}

// Dented or not, at whole pixels too.
TEST(Clip, PiecesOfACutTriangleFaceTheSameWay) {
  std::mt19937_64 random(23);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int crossing_coarse = 0, crossing_tiny = 0;
  for (int i = 0; i < 20000; ++i) {
    Clips triangle;
    for (ClipVertex& v : triangle) {
      const double z = any(random), y = 3 * any(random), x = 3 * any(random);
      v = vertex(x, y, z, 1.0);
    }
    const FrameState frame{.width = 16, .height = 16};
    ASSERT_FALSE(folds(run(triangle, frame, kCoarse))) << i;
    ASSERT_FALSE(folds(run(triangle, frame, kTiny))) << i;
    crossing_coarse += crosses(triangle, frame, kCoarse) ? 1 : 0;
    crossing_tiny += crosses(triangle, frame, kTiny) ? 1 : 0;
  }
  EXPECT_GT(crossing_coarse, 0);
  EXPECT_LE(crossing_coarse, 20);
  EXPECT_EQ(crossing_tiny, 0);
}

// Slivers along a diagonal, cut at its ends: many are folded over.
TEST(Clip, NoSampleIsOwnedTwiceByOneTriangle) {
  std::mt19937_64 random(24);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const FrameState frame{.width = 32, .height = 24};
  int crossing = 0, covered = 0;
  for (int i = 0; i < 6000; ++i) {
    const Config& config = i % 3 == 0 ? kCoarse : i % 3 == 1 ? kTiny : kFull;
    const double thin = std::pow(10.0, -1.5 - any(random) - 2.0 * (i % 3));
    const double dx = any(random), dy = any(random);
    Clips triangle;
    for (ClipVertex& v : triangle) {
      const double along = 1.5 * any(random);
      v = vertex(along * dx + thin * any(random), along * dy + thin * any(random),
                 1.1 * any(random), 1.0);
    }
    crossing += crosses(triangle, frame, config) ? 1 : 0;
    const auto out = run(triangle, frame, config);
    const std::int64_t unit = std::int64_t{1} << config.subpixel_bits;
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const int count = hits(out, (2 * x + 1) * unit, (2 * y + 1) * unit);
        ASSERT_LE(count, 1) << "triangle " << i << " pixel " << x << ", " << y;
        covered += count;
      }
    }
  }
  EXPECT_GT(crossing, 10);
  EXPECT_GT(covered, 1000);
}

// A convex flat quad, cut in every way, as two triangles: no sample twice, none missing.
TEST(Clip, TheTwoHalvesOfACutQuadOwnEachSampleOnce) {
  std::mt19937_64 random(22);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const FrameState frame{.width = 32, .height = 32};
  std::int64_t covered = 0;
  int folded = 0;
  for (int i = 0; i < 3000; ++i) {
    const Config& config = i % 3 == 0 ? kCoarse : i % 3 == 1 ? kTiny : kFull;
    const glm::dvec4 centre{any(random), any(random), any(random), 1.0 + any(random)};
    const glm::dvec4 u{3 * any(random), 3 * any(random), any(random), any(random)};
    const glm::dvec4 v{3 * any(random), 3 * any(random), any(random), any(random)};
    const std::array<ClipVertex, 4> p{
        ClipVertex{centre + u + v, {}}, ClipVertex{centre - u + v, {}},
        ClipVertex{centre - u - v, {}}, ClipVertex{centre + u - v, {}}};
    auto out = run({p[0], p[1], p[2]}, frame, config);
    const auto other = run({p[2], p[3], p[0]}, frame, config);
    out.insert(out.end(), other.begin(), other.end());
    const bool is_folded = folds(out) || crosses({p[0], p[1], p[2]}, frame, config) ||
                           crosses({p[2], p[3], p[0]}, frame, config);
    folded += is_folded ? 1 : 0;
    const std::int64_t unit = std::int64_t{1} << config.subpixel_bits;
    for (int y = 0; y < 32 && !is_folded; ++y) {
      for (int x = 0; x < 32; ++x) {
        const int count = hits(out, (2 * x + 1) * unit, (2 * y + 1) * unit);
        ASSERT_LE(count, 1) << "quad " << i << " pixel " << x << ", " << y;
        covered += count;
        bool inside[2] = {false, false};
        const double nx = (x + 0.5) / 16.0 - 1.0, ny = 1.0 - (y + 0.5) / 16.0;
        const double radius = 4.0 / static_cast<double>(unit * 32);
        // Whole-pixel snapping moves a border too far for the reference.
        const bool clear = unit > 1 && clear_cut({p[0], p[1], p[2]}, nx, ny, radius, inside[0]) &&
                           clear_cut({p[2], p[3], p[0]}, nx, ny, radius, inside[1]);
        if (clear) {
          ASSERT_EQ(count, inside[0] || inside[1] ? 1 : 0) << "quad " << i;
        }
      }
    }
  }
  EXPECT_GT(covered, 100000);
  EXPECT_LT(folded, 50);
}

}  // namespace
}  // namespace halfspace
