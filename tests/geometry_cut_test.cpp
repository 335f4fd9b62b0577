// SPDX-License-Identifier: Apache-2.0
//
// The cut points themselves, before projection: on their plane, on their edge, and the same bits
// from both triangles at an edge.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <random>
#include <tuple>

#include "geometry.hpp"

namespace halfspace {
namespace {

using Clips = std::array<ClipVertex, 3>;

ClipVertex vertex(double x, double y, double z, double w) { return {{x, y, z, w}, {}}; }

// Attribute i of vertex j is 255 where i == j: after interpolation, barycentric coordinates.
Clips with_barycentrics(Clips triangle) {
  for (std::size_t i = 0; i < 3; ++i) {
    triangle[i].attribute = {};
    triangle[i].attribute[i] = 255.0;
  }
  return triangle;
}

// One vertex beyond each plane in turn: the cut lies on it, on its edges, and cuts the right part.
TEST(Clip, CutVerticesLieOnThePlaneAndOnTheirEdges) {
  const ClipVolume volume = clip_volume({.width = 64, .height = 64}, kTiny);
  for (int plane = 1; plane < kClipPlanes; ++plane) {
    const ClipPlane& p = volume[static_cast<std::size_t>(plane)];
    for (int out = 1; out <= 2; ++out) {
      Clips triangle{vertex(0.1, 0.2, -0.1, 1.5), vertex(0.4, -0.3, 0.2, 1.0),
                     vertex(-0.2, 0.1, 0.3, 2.0)};
      for (int i = 0; i < out; ++i) {
        ClipVertex& v = triangle[static_cast<std::size_t>(i)];
        v.position[p.axis] = p.sign * (2.0 + i) * v.position.w;
      }
      const ClipPolygon polygon = clip(with_barycentrics(triangle), volume);
      ASSERT_EQ(polygon.count, out == 1 ? 4 : 3);
      int on_plane = 0;
      for (int i = 0; i < polygon.count; ++i) {
        const ClipVertex& v = polygon.vertex[static_cast<std::size_t>(i)];
        EXPECT_GE(p.sign * (p.limit * v.position.w - v.position[p.axis]), 0.0);
        glm::dvec4 rebuilt{0.0};
        int touched = 0;
        for (std::size_t j = 0; j < 3; ++j) {
          rebuilt += v.attribute[j] / 255.0 * triangle[j].position;
          touched += v.attribute[j] != 0.0 ? 1 : 0;
        }
        EXPECT_LT(glm::length(rebuilt - v.position), 1e-14);
        EXPECT_LE(touched, 2) << "not on an edge";
        if (touched == 2) {
          EXPECT_EQ(v.position[p.axis], p.limit * v.position.w);
          ++on_plane;
        }
      }
      EXPECT_EQ(on_plane, 2);
    }
  }
}

// The points of a polygon on the edge opposite vertex `opposite` of with_barycentrics().
std::vector<glm::dvec4> points_on_edge(const ClipPolygon& polygon, std::size_t opposite) {
  std::vector<glm::dvec4> points;
  for (int i = 0; i < polygon.count; ++i) {
    const ClipVertex& v = polygon.vertex[static_cast<std::size_t>(i)];
    if (v.attribute[opposite] == 0.0) points.push_back(v.position);
  }
  std::sort(points.begin(), points.end(), [](const glm::dvec4& a, const glm::dvec4& b) {
    return std::tie(a.x, a.y, a.z, a.w) < std::tie(b.x, b.y, b.z, b.w);
  });
  return points;
}

TEST(Clip, BothTrianglesAtAnEdgeCutItAtTheSameBits) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const std::array<std::array<std::size_t, 3>, 6> orders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  int cut_edges = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto draw = [&] {
      const double w = any(random) + 0.3, z = 2 * any(random);
      const double y = 40 * any(random), x = 40 * any(random);
      return vertex(x, y, z, w);
    };
    const ClipVertex a = draw(), b = draw(), c = draw(), d = draw();
    const ClipVolume volume =
        clip_volume({.width = 400, .height = 300}, i % 2 == 0 ? kTiny : kFull);
    const auto reference = points_on_edge(clip(with_barycentrics({a, b, c}), volume), 2);
    const auto is_inside = [&](const ClipVertex& v) {
      return !reference.empty() && (v.position == reference[0] || v.position == reference.back());
    };
    cut_edges += !reference.empty() && !(is_inside(a) && is_inside(b)) ? 1 : 0;
    for (const auto& order : orders) {
      // A third vertex of its own, every winding and rotation.
      const Clips named = with_barycentrics({a, b, d});
      const auto polygon = clip({named[order[0]], named[order[1]], named[order[2]]}, volume);
      const auto points = points_on_edge(polygon, 2);
      // Zero or one common point: the other triangle may have lost even that; two must agree.
      if (reference.size() >= 2 || points.size() >= 2) {
        ASSERT_EQ(points, reference) << i;
      }
    }
  }
  EXPECT_GT(cut_edges, 3000);
}

}  // namespace
}  // namespace halfspace
