// SPDX-License-Identifier: Apache-2.0
//
// Depth and colour of triangles that clipping cuts, against the exact plane of the triangle as it
// was before: cut by the near plane with vertices behind the eye, by the sides, at the widest, and
// slivers.
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "exact_plane.hpp"
#include "rasterizer.hpp"
#include "samples.hpp"

namespace halfspace {
namespace {

using Clips = std::array<ClipVertex, 3>;
enum class Shape { kNear, kFar, kSides, kWidest, kSliver };

struct Case {
  const char* name;
  Config config;
  FrameState frame;
  Shape shape;
  int triangles;
  long stride;  // of fragments that are looked at
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Maker {
 public:
  Maker(const Case& c, std::uint64_t seed) : c_(c), random_(seed) {}

  Clips next() {
    Clips out;
    for (ClipVertex& v : out) v.position = position();
    if (c_.shape == Shape::kSliver) {  // the third near a line through the others, behind or not
      const double at = in(-0.5, 1.5);
      glm::dvec4& p = out[2].position;
      p = out[0].position + (out[1].position - out[0].position) * at;
      p += glm::dvec4(in(-1, 1), in(-1, 1), in(-1, 1), in(-1, 1)) * 0.02;
    }
    for (ClipVertex& v : out) {
      for (int axis = 0; axis < 4; ++axis) v.position[axis] = exactly(v.position[axis]);
      for (std::size_t n = 0; n < 3; ++n) v.attribute[n] = std::floor(in(0, 256));
    }
    return out;
  }

 private:
  double in(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  // A camera of near 0.1 and far 100, or a window position and w.
  glm::dvec4 position() {
    const double spread = 3;
    switch (c_.shape) {
      case Shape::kNear:
      case Shape::kSliver: return seen(in(-spread, spread), in(-spread, spread), in(-2, 6));
      case Shape::kFar: return seen(in(-60, 60), in(-60, 60), in(20, 300));
      case Shape::kSides: return windowed(0.05 * in(10, 1000), 3.0);
      case Shape::kWidest: break;
    }
    return windowed(1.0, 1e4);
  }
  static glm::dvec4 seen(double x, double y, double z) {
    constexpr double kNear = 0.1, kFar = 100;
    return {x, y, (kFar + kNear) / (kFar - kNear) * z - 2 * kFar * kNear / (kFar - kNear), z};
  }
  glm::dvec4 windowed(double w, double beyond) {
    const double reach = c_.config.has_guard_band()
                             ? std::ldexp(beyond, c_.config.guard_bits) / c_.frame.width
                             : beyond;
    const double far = std::min(reach, 2.0 * (1 << c_.config.guard_bits));
    return {in(-far, far) * w, in(-far, far) * w, in(-1, 1) * w, w};
  }

  Case c_;
  std::mt19937_64 random_;
};

struct Worst {
  double depth = 0;      // LSB
  double attribute = 0;  // levels, less what the ratio of w excuses
  long samples = 0;
  long cut = 0;   // triangles with a fragment that were cut
  long thin = 0;  // of them, those whose plane leaves its range within a subpixel
};

// True when the exact plane at the vertices of all pieces is what a vertex can hold.
bool fits(const std::vector<ShadedTriangle>& pieces, const ExactPlane& plane,
          const Config& config) {
  for (const ShadedTriangle& piece : pieces) {
    for (const Point p : piece.triangle.vertex) {
      const ExactPlane::Values v =
          plane.at(std::int64_t{p.x} << (config.position_bits() - config.subpixel_bits),
                   std::int64_t{p.y} << (config.position_bits() - config.subpixel_bits));
      if (v.scale == 0 || v.weight == 0 || (v.scale > 0) != (v.weight > 0)) return false;
      const double depth = ratio(v.depth, v.scale) / 2;
      if (depth < -0.499 || depth > 1.499) return false;
      for (const Exact& attribute : v.attribute) {
        const double value = ratio(attribute, v.weight);
        if (value < -127.9 || value > 383.9) return false;
      }
    }
  }
  return true;
}

double w_ratio(const std::vector<ShadedTriangle>& pieces) {
  double greatest = 1;
  for (const ShadedTriangle& piece : pieces) {
    std::uint32_t least = ~0u;
    for (const VertexAttributes& v : piece.attributes) least = std::min(least, v.inverse_w);
    greatest = std::max(greatest, std::ldexp(1.0, kFull.inverse_w_bits) / least);
  }
  return greatest;
}

void measure(const Clips& triangle, const Case& c, Worst& worst) {
  GeometryStage geometry(c.frame, c.config);
  std::vector<ShadedTriangle> pieces;
  geometry.process(triangle, 0, pieces);
  if (geometry.stats().clipped == 0) return;
  const int f = c.config.position_bits();
  const ExactPlane plane(triangle, c.frame, f);
  ++worst.cut;
  if (!fits(pieces, plane, c.config)) {
    ++worst.thin;
    return;
  }
  const double excused = w_ratio(pieces) * 0x1p-16;
  Rasterizer rasterizer(c.frame, c.config, DepthFunction::kAlways, {});
  long seen = 0;
  rasterizer.on_fragment([&](const Fragment& fragment) {
    if (seen++ % c.stride != 0) return;
    const auto at = [&](SamplePosition p) {
      return plane.at((std::int64_t{fragment.x} << f) + ((std::int64_t{p.x} << f) >> 4),
                      (std::int64_t{fragment.y} << f) + ((std::int64_t{p.y} << f) >> 4));
    };
    for (unsigned rest = fragment.passed; rest != 0; rest &= rest - 1) {
      const auto m = static_cast<std::size_t>(std::countr_zero(rest));
      const ExactPlane::Values v = at(sample_positions(c.config.samples)[m]);
      const std::int64_t most = (std::int64_t{1} << c.config.depth_bits) - 1;
      worst.depth =
          std::max(worst.depth, error_of(fragment.depth[m], v.depth * most, 2 * v.scale, most));
      ++worst.samples;
    }
    const bool all = fragment.covered == (1u << c.config.samples) - 1;
    const ExactPlane::Values v = at(
        all ? SamplePosition{8, 8}
            : sample_positions(
                  c.config.samples)[static_cast<std::size_t>(std::countr_zero(fragment.covered))]);
    for (std::size_t n = 0; n < 3; ++n) {
      worst.attribute = std::max(
          worst.attribute, error_of(fragment.color[n], v.attribute[n], v.weight, 255) - excused);
    }
  });
  for (const ShadedTriangle& piece : pieces) rasterizer.draw(piece);
}

class CutPlanes : public testing::TestWithParam<Case> {};

TEST_P(CutPlanes, KeepTheBoundsOfUncutTriangles) {
  const Case& c = GetParam();
  const std::uint64_t seed = 20261130;
  Maker maker(c, seed);
  Worst worst;
  for (int i = 0; i < c.triangles; ++i) measure(maker.next(), c, worst);
  EXPECT_GT(worst.samples, 2000);
  EXPECT_GT(worst.cut, 40);
  EXPECT_LT(worst.thin, worst.cut / (c.shape == Shape::kSliver ? 2 : 20) + 1);
  EXPECT_LE(worst.depth, 0.66) << "seed " << seed;
  EXPECT_LE(worst.attribute, 0.53) << "seed " << seed;
  RecordProperty("depth_lsb", std::to_string(worst.depth));
  RecordProperty("levels", std::to_string(worst.attribute));
  RecordProperty("samples", std::to_string(worst.samples));
}

std::vector<Case> cases() {
  std::vector<Case> out;
  const auto add = [&out](const char* name, const Config& config, Shape shape, int triangles,
                          long stride = 7) {
    out.push_back({name, config, {.width = 320, .height = 240}, shape, triangles, stride});
  };
  add("full_near", kFull, Shape::kNear, 200);
  add("full_far", kFull, Shape::kFar, 200);
  add("full_sides", kFull, Shape::kSides, 600, 211);
  add("full_widest", kFull, Shape::kWidest, 600, 211);
  add("full_sliver", kFull, Shape::kSliver, 4000);
  add("tiny_near", kTiny, Shape::kNear, 200);
  add("tiny_sides", kTiny, Shape::kSides, 200);
  add("tiny_sliver", kTiny, Shape::kSliver, 4000);
  add("d3d_near", kD3d, Shape::kNear, 200);
  add("d3d_widest", kD3d, Shape::kWidest, 600, 211);
  add("msaa4_near", kMsaa4, Shape::kNear, 200);
  add("msaa4_sliver", kMsaa4, Shape::kSliver, 4000);
  return out;
}

INSTANTIATE_TEST_SUITE_P(Cases, CutPlanes, testing::ValuesIn(cases()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace halfspace
