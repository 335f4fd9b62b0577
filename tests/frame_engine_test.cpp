// SPDX-License-Identifier: Apache-2.0
//
// The frame engine against the plain stages: the same framebuffer, byte for byte, and the same
// counts, on every instruction set of the machine.
#include "engines/frame/frame_engine.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "engines/coverage/coverage_engine.hpp"
#include "frame_compare.hpp"
#include "rasterizer.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

struct Case {
  const char* name;
  Config config;
  FrameState frame;
  DepthState depth = {};
  int triangles = 6000;
  std::optional<Box> scissor = {};
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

Config odd(int s, int n, int k, int samples, int grid_log2, int F, int R, int B, int depth) {
  Config config;
  config.subpixel_bits = s;
  config.viewport_bits = n;
  config.guard_bits = k;
  config.samples = samples;
  config.grid_log2 = grid_log2;
  config.gradient_bits = F;
  config.reciprocal_bits = R;
  config.inverse_w_bits = B;
  config.depth_bits = depth;
  return config;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"full", kFull, {200, 120, Cull::kNone}},
      {"full_less_equal", kFull, {131, 67, Cull::kBack}, DepthFunction::kLessEqual},
      {"full_always", kFull, {64, 64, Cull::kNone}, DepthFunction::kAlways},
      {"tiny", kTiny, {123, 75, Cull::kNone}},
      {"d3d", kD3d, {127, 65, Cull::kFront}},
      {"msaa4", kMsaa4, {100, 90, Cull::kNone}},
      {"msaa4_equal", kMsaa4, {61, 33, Cull::kNone}, DepthFunction::kLessEqual},
      {"coarse_16", odd(1, 6, 0, 16, 2, 5, 9, 20, 17), {64, 61, Cull::kNone}},
      {"no_fraction", odd(0, 7, 8, 1, 3, 0, 6, 12, 16), {128, 100, Cull::kNone}},
      {"two_samples", odd(10, 7, 12, 2, 3, 20, 16, 30, 24), {99, 100, Cull::kNone}},
      {"finest", odd(12, 15, 16, 1, 3, 20, 16, 30, 24), {96, 96, Cull::kNone}},
      {"finest_16",
       odd(12, 15, 16, 16, 3, 20, 15, 29, 23),
       {40, 56, Cull::kNone},
       DepthFunction::kLess,
       1500},
      {"finest_small_grid", odd(12, 15, 16, 1, 2, 19, 7, 13, 20), {77, 50, Cull::kNone}},
      {"never", kFull, {64, 40, Cull::kNone}, DepthFunction::kNever, 500},
      {"equal", kFull, {64, 40, Cull::kNone}, {DepthFunction::kEqual, 0}},
      {"greater", kTiny, {61, 40, Cull::kNone}, {DepthFunction::kGreater, 0}},
      {"greater_msaa4", kMsaa4, {64, 40, Cull::kNone}, {DepthFunction::kGreaterEqual, 1u << 23}},
      {"not_equal", kFull, {64, 40, Cull::kNone}, {DepthFunction::kNotEqual, 0xffffff}},
      {"cleared", kFull, {64, 40, Cull::kNone}, {DepthFunction::kLess, 1u << 23}},
      {"depth_25", odd(8, 8, 9, 1, 3, 16, 16, 30, 25), {99, 40, Cull::kNone}},
      {"depth_30", odd(8, 8, 9, 1, 2, 16, 16, 30, 30), {99, 40, Cull::kNone}},
      {"depth_31", odd(8, 8, 9, 2, 3, 16, 16, 30, 31), {99, 40, Cull::kNone}},
      {"depth_32", odd(8, 8, 9, 1, 3, 16, 16, 30, 32), {99, 40, Cull::kNone}},
      {"depth_32_greater",
       odd(8, 8, 9, 1, 3, 16, 16, 30, 32),
       {99, 40, Cull::kNone},
       {DepthFunction::kGreater, 0xfffffff3u}},
      {"scissor", kFull, {99, 80, Cull::kNone}, {}, 6000, Box{9, 17, 70, 55}},
      {"scissor_tile", kTiny, {99, 80, Cull::kNone}, {}, 6000, Box{8, 8, 15, 15}},
      {"scissor_pixel", kMsaa4, {99, 80, Cull::kNone}, {}, 6000, Box{40, 33, 40, 33}},
      {"one_pixel", odd(4, 3, 5, 8, 2, 16, 12, 24, 16), {1, 1, Cull::kNone}},
  };
  return all;
}

// Attributes of every magnitude: depths and colours alike or apart, 1/w alike or far apart.
VertexAttributes random_attributes(Random& random, const Config& config) {
  VertexAttributes out;
  const std::int64_t depth_most = (std::int64_t{1} << kPlaneBits) - 1;
  switch (random.in(0, 4)) {
    case 0: out.depth = static_cast<std::int32_t>(random.in(0, depth_most)); break;
    case 1: out.depth = static_cast<std::int32_t>(depth_most / 2 + random.in(-200, 200)); break;
    case 2: out.depth = random.in(0, 1) != 0 ? static_cast<std::int32_t>(depth_most) : 0; break;
    case 3: out.depth = random.in(0, 1) != 0 ? kDepthLeast : kDepthMost; break;
    default: out.depth = static_cast<std::int32_t>(random.in(0, 3) * (depth_most / 3)); break;
  }
  const auto bits = static_cast<int>(random.in(1, config.inverse_w_bits));
  const std::int64_t most = (std::int64_t{1} << bits) - 1;
  out.inverse_w = static_cast<std::uint32_t>(random.in(most / 2 + 1, most));
  for (std::int32_t& value : out.value) {
    switch (random.in(0, 5)) {
      case 0:
      case 1: value = random.in(0, 1) != 0 ? 255 * 256 : 0; break;
      case 2: value = static_cast<std::int32_t>(random.in(kValueLeast, kValueMost)); break;
      case 3: value = random.in(0, 1) != 0 ? kValueLeast : kValueMost; break;
      default: value = static_cast<std::int32_t>(random.in(0, 255 * 256)); break;
    }
  }
  return out;
}

std::vector<ShadedTriangle> random_triangles(const Case& c, std::uint64_t seed) {
  Random random(seed);
  std::vector<ShadedTriangle> out;
  const std::vector<Triangle> widest = widest_triangles(c.config);
  for (int i = 0; i < c.triangles; ++i) {
    ShadedTriangle& t = out.emplace_back();
    const Shape shape = kShapes[static_cast<std::size_t>(i) % kShapes.size()];
    t.triangle = i % 64 == 63 ? widest[static_cast<std::size_t>(i) % widest.size()]
                              : random_triangle(random, shape, c.frame, c.config);
    for (VertexAttributes& vertex : t.attributes) vertex = random_attributes(random, c.config);
    if (i % 5 == 0) t.attributes[1].depth = t.attributes[2].depth = t.attributes[0].depth;
  }
  return out;
}

class FrameEngineCases : public testing::TestWithParam<Case> {};

TEST_P(FrameEngineCases, DrawsWhatTheStagesDrawOnEveryInstructionSet) {
  const Case& c = GetParam();
  const std::uint64_t seed = 20250;
  const std::vector<ShadedTriangle> triangles = random_triangles(c, seed);
  const Rgb background{9, 80, 200};
  Rasterizer plain(c.frame, c.config, c.depth, background, c.scissor);
  for (const ShadedTriangle& triangle : triangles) plain.draw(triangle);
  ASSERT_EQ(plain.stats().fragments_shaded > 0, c.depth.function != DepthFunction::kNever);
  const std::size_t touched = plain.framebuffer().tiles_touched();
  for (const std::string_view isa : coverage_isas()) {
    SCOPED_TRACE(std::string(isa) + ", seed " + std::to_string(seed));
    FrameOptions options;
    options.depth = c.depth;
    options.scissor = c.scissor;
    options.background = background;
    options.isa = isa;
    options.count_hits = true;
    FrameEngine fast(c.frame, c.config, options);
    fast.draw(triangles);
    expect_equal(plain.stats(), fast.stats());
    EXPECT_EQ(plain.hit_count().count(), fast.hits());
    EXPECT_EQ(touched, fast.framebuffer().tiles_touched());
    expect_equal(plain.framebuffer(), fast.framebuffer(), c.frame, c.config);
    if (testing::Test::HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, FrameEngineCases, testing::ValuesIn(cases()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace halfspace
