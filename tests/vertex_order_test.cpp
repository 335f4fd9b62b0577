// SPDX-License-Identifier: Apache-2.0
//
// Depth and colour are functions of the triangle: the six orders of its vertices, so both ways of
// winding, give the same fragments, and a second pass meets exactly the depths of the first.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry.hpp"
#include "rasterizer.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

constexpr std::array<std::array<std::size_t, 3>, 6> kOrders{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}, {1, 0, 2}, {0, 2, 1}}};

struct Seen {
  std::int32_t x, y;
  std::uint16_t covered, passed;
  Rgb color;
  std::array<std::uint32_t, kMaxSamples> depth;
  bool operator==(const Seen&) const = default;
};

// The fragments in the order drawn.
std::vector<Seen> fragments(const std::vector<ShadedTriangle>& pieces, const FrameState& frame,
                            const Config& config) {
  std::vector<Seen> out;
  Rasterizer rasterizer(frame, config, DepthFunction::kAlways, {});
  const auto keep = [&out](const Fragment& f) {
    out.push_back({f.x, f.y, f.covered, f.passed, f.color, f.depth});
  };
  rasterizer.on_fragment(keep);
  for (const ShadedTriangle& piece : pieces) rasterizer.draw(piece);
  return out;
}

// Draws the pieces of the first order, then those of each other with less or equal: all pass.
void expect_second_pass(const std::vector<std::vector<ShadedTriangle>>& orders,
                        const FrameState& frame, const Config& config) {
  for (std::size_t i = 1; i < orders.size(); ++i) {
    Rasterizer rasterizer(frame, config, DepthFunction::kLessEqual, {});
    for (const ShadedTriangle& piece : orders[0]) rasterizer.draw(piece);
    const std::uint64_t first = rasterizer.stats().fragments_shaded;
    for (const ShadedTriangle& piece : orders[i]) rasterizer.draw(piece);
    ASSERT_EQ(rasterizer.stats().fragments_shaded, 2 * first) << "order " << i;
  }
}

void expect_alike(const std::vector<std::vector<ShadedTriangle>>& orders, const FrameState& frame,
                  const Config& config) {
  const std::vector<Seen> first = fragments(orders[0], frame, config);
  for (std::size_t i = 1; i < orders.size(); ++i) {
    ASSERT_EQ(first, fragments(orders[i], frame, config)) << "order " << i;
  }
  expect_second_pass(orders, frame, config);
}

const std::vector<Config>& configs() {
  static const std::vector<Config> all = [] {
    Config coarse = kFull;
    coarse.depth_bits = 16;
    coarse.gradient_bits = 4;
    return std::vector<Config>{kFull, kTiny, kD3d, kMsaa4, coarse};
  }();
  return all;
}

TEST(VertexOrder, MakesNoDifferenceToSnappedTriangles) {
  const FrameState frame{.width = 64, .height = 48};
  for (const Config& config : configs()) {
    Random random(7);
    const std::vector<Triangle> widest = widest_triangles(config);
    for (int n = 0; n < 300; ++n) {
      const Shape shape = kShapes[static_cast<std::size_t>(n) % kShapes.size()];
      ShadedTriangle base;
      base.triangle = n % 8 == 7 ? widest[static_cast<std::size_t>(n) % widest.size()]
                                 : random_triangle(random, shape, frame, config);
      for (VertexAttributes& v : base.attributes) {
        v.depth = static_cast<std::int32_t>(random.in(0, (1 << 30) - 1));
        v.inverse_w = static_cast<std::uint32_t>(random.in(1 << 26, (1 << 30) - 1));
        for (std::size_t c = 0; c < 3; ++c) {
          v.value[c] = static_cast<std::int32_t>(random.in(0, 255 * 256));
        }
      }
      base.attributes[0].inverse_w |= 1u << 29;
      std::vector<std::vector<ShadedTriangle>> orders;
      for (const auto& order : kOrders) {
        ShadedTriangle& t = orders.emplace_back(1).front();
        for (std::size_t i = 0; i < 3; ++i) {
          t.triangle.vertex[i] = base.triangle.vertex[order[i]];
          t.attributes[i] = base.attributes[order[i]];
        }
      }
      SCOPED_TRACE("triangle " + std::to_string(n));
      expect_alike(orders, frame, config);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(VertexOrder, MakesNoDifferenceToClippedTriangles) {
  const FrameState frame{.width = 64, .height = 48};
  for (const Config& config : configs()) {
    std::mt19937_64 random(11);
    const auto in = [&random](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    int cut = 0, turned = 0;
    for (int n = 0; n < 400; ++n) {
      std::array<ClipVertex, 3> base;
      for (ClipVertex& v : base) {
        const double w = in(-2, 6), wide = n % 3 == 0 ? 1e4 : 1.0;
        v.position = {in(-3, 3) * wide, in(-3, 3) * wide, 1.002 * w - 0.2002, w};
        for (double& a : v.attribute) a = in(-10, 300);
      }
      if (n % 4 == 0) {  // a sliver
        base[2].position = 0.3 * base[0].position + 0.7 * base[1].position;
        base[2].position.x += in(-0.01, 0.01);
      }
      std::vector<std::vector<ShadedTriangle>> orders;
      for (const auto& order : kOrders) {
        GeometryStage geometry(frame, config);
        orders.emplace_back();
        geometry.process({base[order[0]], base[order[1]], base[order[2]]}, 0, orders.back());
        cut += static_cast<int>(geometry.stats().clipped);
        turned += orders.back().size() > 1 ? 1 : 0;
      }
      SCOPED_TRACE("triangle " + std::to_string(n));
      expect_alike(orders, frame, config);
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(cut, 500);
    EXPECT_GT(turned, 100);
  }
}

}  // namespace
}  // namespace halfspace
