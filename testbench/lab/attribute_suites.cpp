// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "fixed.hpp"
#include "suite_shapes.hpp"

namespace halfspace::lab {
namespace {

using methods::Color;

Color random_color(Random& random) {
  return {static_cast<double>(random.in(0, 255)), static_cast<double>(random.in(0, 255)),
          static_cast<double>(random.in(0, 255))};
}

// Disjoint triangles, one in each cell of a frame, with random colours and w between 1 and ratio.
// The cells are `stretch` times as wide as high.
SuiteCase shaded_case(std::string name, std::uint64_t seed, int cell, int cells, double ratio,
                      int stretch = 1) {
  Random random(seed);
  std::vector<Facet> out;
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      const auto at = [&](double part_x, double part_y) {
        const double jitter = static_cast<double>(random.in(0, 64)) / 512;
        return Position{on_grid((x + part_x + jitter) * cell * stretch),
                        on_grid((y + part_y - jitter) * cell)};
      };
      const Position bottom = at(0.3, 0.95), right = at(0.8, 0.3), left = at(0.05, 0.2);
      Facet f = facet_of(left, right, bottom);
      for (std::size_t i = 0; i < 3; ++i) {
        f[i].color = random_color(random);
        const double part = static_cast<double>(random.in(0, 1000)) / 1000;
        f[i].w = i == 1 ? ratio : 1 + part * (ratio - 1);
      }
      f[0].w = 1;
      out.push_back(f);
    }
  }
  return area_case(std::move(name), out, {cell * cells * stretch, cell * cells});
}

std::vector<SuiteCase> perspective_cases() {
  return {shaded_case("w ratio 4", 881, 64, 4, 4), shaded_case("w ratio 100", 882, 64, 4, 100),
          shaded_case("w ratio 10000", 883, 64, 4, 10000)};
}

std::vector<SuiteCase> gradient_cases() {
  return {shaded_case("64 px", 884, 64, 4, 1), shaded_case("1536 px wide", 885, 64, 1, 1, 24),
          shaded_case("16 px", 886, 16, 12, 1)};
}

// Two squares that cross along x = 64.25, their depths `slope` apart at the frame's sides.
SuiteCase coplanar_case(int power) {
  const double slope = std::ldexp(1.0, -power);
  std::vector<Facet> out;
  const auto square = [&](double tilt, double level) {
    const auto v = [&](double x, double y) {
      return Vertex{x, y, 0.5 + tilt * (x - 64.25) / 128, 1, {level, level, level}};
    };
    out.push_back({v(0, 0), v(128.5, 0), v(128.5, 96)});
    out.push_back({v(0, 0), v(128.5, 96), v(0, 96)});
  };
  square(slope, 64);
  square(0, 192);
  return area_case("2^-" + std::to_string(power) + " of the depth range apart", out, {128, 96});
}

std::vector<SuiteCase> coplanar_cases() {
  return {coplanar_case(10), coplanar_case(16), coplanar_case(20), coplanar_case(23)};
}

std::vector<SuiteCase> order_cases() {
  auto facets = facets_of(jittered_mesh(887, 192, 16, 128, kShapeGrid));
  Random random(888);
  for (Facet& f : facets) {
    const Color color = random_color(random);
    for (Vertex& v : f) v.color = color;
  }
  SuiteCase one = area_case("mesh on half pixels, shuffled", facets, {192, 192});
  for (std::size_t n = facets.size() - 1; n > 0; --n) {
    const auto other = static_cast<std::size_t>(random.in(0, static_cast<std::int64_t>(n)));
    std::swap(facets[n], facets[other]);
  }
  one.shuffled = methods::drawing_of(facets, 192, 192);
  return {one};
}

// A triangle in clip space, in 1/16: x, y, z, w.
using Whole = std::array<std::array<std::int64_t, 4>, 3>;

// Owns the centre of pixel (x, y)? By homogeneous weights in integers: the point of the triangle
// with w > 0 that projects there, if it lies between near and far. No sample may be on an edge
// (checked), so no tie rule is needed.
bool owns(const Whole& t, int x, int y, int size) {
  using Wide = __int128;
  // The point (nx, ny, 1) times size: ndc of the centre.
  const Wide n[3] = {2 * x + 1 - size, size - 2 * y - 1, size};
  const auto cross = [&](const auto& a, const auto& b) {
    const Wide p[3] = {a[0], a[1], a[3]};
    const Wide q[3] = {b[0], b[1], b[3]};
    return n[0] * (p[1] * q[2] - p[2] * q[1]) + n[1] * (p[2] * q[0] - p[0] * q[2]) +
           n[2] * (p[0] * q[1] - p[1] * q[0]);
  };
  const Wide weight[3] = {cross(t[1], t[2]), cross(t[2], t[0]), cross(t[0], t[1])};
  Wide w = 0, z = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    HS_CHECK(weight[i] != 0);
    w += weight[i] * t[i][3];
    z += weight[i] * t[i][2];
  }
  // The weights up to a common factor, of which w > 0 decides the sign.
  const bool flip = w < 0;
  for (const Wide value : weight) {
    if ((value < 0) != flip) return false;
  }
  return flip ? (-z <= -w && -z >= w) : (z <= w && z >= -w);
}

SuiteCase clip_case(std::string name, const std::vector<Whole>& triangles) {
  constexpr int kSize = 128;
  SuiteCase one;
  one.name = std::move(name);
  one.kinds = kClipKinds;
  one.window = {kSize, kSize};
  one.drawing.view.width = kSize;
  one.drawing.view.height = kSize;
  for (const Whole& t : triangles) {
    methods::ClipFacet facet;
    for (std::size_t i = 0; i < 3; ++i) {
      for (int k = 0; k < 4; ++k) {
        facet[i].position[k] = static_cast<double>(t[i][static_cast<std::size_t>(k)]) / 16;
      }
      facet[i].color = {200, 200, 200};
    }
    one.drawing.clip.push_back(facet);
  }
  one.hits = [triangles] {
    std::vector<std::uint32_t> hits(kSize * kSize);
    for (const Whole& t : triangles) {
      for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
          hits[static_cast<std::size_t>(y * kSize + x)] += owns(t, x, y, kSize) ? 1u : 0u;
        }
      }
    }
    return hits;
  };
  return one;
}

// z = w - 1/2: the near plane is at w = 1/4, there is no far plane. In 1/16; odd numbers keep the
// edges off the centres.
std::vector<SuiteCase> w_to_zero() {
  const auto v = [](std::int64_t x, std::int64_t y, std::int64_t w) {
    return std::array<std::int64_t, 4>{x, y, w - 8, w};
  };
  return {
      clip_case("a floor that runs under the eye",
                {{v(-65, -17, 63), v(67, -17, 65), v(1, -17, -7)}}),
      clip_case("a vertex with w = 0", {{v(-65, -17, 63), v(67, -15, 65), v(3, -1, 0)}}),
      clip_case("two vertices behind the eye", {{v(3, 41, 63), v(-41, -1, -7), v(43, -1, -7)}}),
      clip_case("cut by the near plane in sight", {{v(-5, -1, 18), v(7, -1, 18), v(1, 1, -15)}})};
}

}  // namespace

void add_attribute_suites(std::vector<Suite>& list) {
  list.push_back({"order", "the same mesh, shuffled",
                  "a sample drawn twice shows whatever came first or last", Judge::kOrder, true,
                  order_cases});
  list.push_back({"w_to_zero", "triangles that reach w = 0",
                  "divided unclipped, a vertex behind the eye comes out on the other side",
                  Judge::kHits, false, w_to_zero});
  list.push_back({"coplanar", "two surfaces almost as deep",
                  "a depth of few bits cannot tell them apart", Judge::kDepth, false,
                  coplanar_cases});
  list.push_back({"gradient", "attributes without perspective",
                  "a gradient of F fraction bits drifts by its rounding at every pixel",
                  Judge::kAttribute, true, gradient_cases});
  list.push_back({"perspective", "attributes with w from 1 to 4, 100, 10,000",
                  "affine interpolation bends; a short reciprocal steps", Judge::kAttribute, true,
                  perspective_cases});
}

}  // namespace halfspace::lab
