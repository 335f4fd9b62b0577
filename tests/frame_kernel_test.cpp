// SPDX-License-Identifier: Apache-2.0
//
// The frame engine's exact parts alone: reciprocals at every mantissa, divisions at every shift,
// planes of the widest and the thinnest triangles.
#include "engines/frame/frame_kernel.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engines/frame/frame_planes.hpp"
#include "fixed.hpp"
#include "interpolation.hpp"
#include "shading.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

using simd::Division;

FrameConstants constants_of(const Config& config) {
  FrameConstants out;
  out.config = config;
  out.f = config.position_bits();
  out.gradient_bits = config.gradient_bits;
  out.samples = config.samples;
  out.packed = true;
  return out;
}

// Runs the divisions on every instruction set and compares with the definitions.
void expect_exact(std::vector<Division> work, const Config& config) {
  for (const simd::FrameKernels& kernels : simd::frame_kernels()) {
    kernels.divide(constants_of(config), work.data(), work.size());
    for (const Division& d : work) {
      const auto u = static_cast<std::uint32_t>(std::max(d.inverse_w, 1));
      const std::uint32_t mantissa = (u << std::countl_zero(u)) >> (32 - config.reciprocal_bits);
      ASSERT_EQ(d.reciprocal, reciprocal(mantissa, config))
          << kernels.isa << ", mantissa " << mantissa << ", R = " << config.reciprocal_bits;
      ASSERT_EQ(d.value, perspective(d.attribute, d.inverse_w, 0, config))
          << kernels.isa << ", " << d.attribute << " over " << d.inverse_w
          << ", R = " << config.reciprocal_bits;
    }
  }
}

TEST(FrameKernel, DividesAtEveryMantissa) {
  for (int R = 6; R <= 16; ++R) {
    Config config;
    config.reciprocal_bits = R;
    std::vector<Division> work;
    for (std::int32_t m = 1 << (R - 1); m < 1 << R; ++m) {
      const std::int32_t u = m << (31 - R);
      const std::int32_t low = (1 << (31 - R)) - 1;
      for (const std::int32_t w : {u, u + low}) {
        for (const std::int32_t a : {w, w - 1, w / 3, w / 510, 0}) work.push_back({a, w, 0, 0});
      }
    }
    expect_exact(work, config);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(FrameKernel, DividesAtEveryShift) {
  Random random(31);
  for (const int R : {6, 11, 16}) {
    Config config;
    config.reciprocal_bits = R;
    std::vector<Division> work;
    for (int bit = 0; bit < 31; ++bit) {
      for (int i = 0; i < 3000; ++i) {
        const std::int64_t low = std::int64_t{1} << bit;
        auto w = static_cast<std::int32_t>(random.in(low, 2 * low - 1));
        if (i < 3) w = static_cast<std::int32_t>(low);  // a power of two
        if (i >= 3 && i < 6) w = static_cast<std::int32_t>(2 * low - 1);
        auto a = static_cast<std::int32_t>(random.in(-2, std::int64_t{w} + 2));
        if (i % 3 == 0) a = w;
        work.push_back({std::min(a, INT32_MAX - 1), w, 0, 0});
      }
    }
    // Values that only rounding errors make: below 0, above 1/w, 1/w of 0.
    for (const std::int32_t w : {0, -1, -5, INT32_MIN, 1, INT32_MAX}) {
      for (const std::int32_t a : {0, -1, INT32_MIN, 1, INT32_MAX}) work.push_back({a, w, 0, 0});
    }
    expect_exact(work, config);
  }
}

struct Input {
  std::vector<VertexRecord> records;
  std::vector<FrameTriangle> triangles;
};

// Triangles with an area, with values that make gradients whole, tiny, huge and wider than 64 bits.
Input random_input(Random& random, int count, const Config& config) {
  Input out;
  const FrameState frame{config.max_size(), config.max_size(), Cull::kNone};
  const std::int64_t w_most = (std::int64_t{1} << config.inverse_w_bits) - 1;
  while (out.records.size() < 3 * static_cast<std::size_t>(count)) {
    const Shape shape = kShapes[static_cast<std::size_t>(random.in(0, 9))];
    const Triangle t = random_triangle(random, shape, frame, config);
    const std::array<Point, 3>& v = t.vertex;
    if ((std::int64_t{v[1].x} - v[0].x) * (std::int64_t{v[2].y} - v[0].y) ==
        (std::int64_t{v[1].y} - v[0].y) * (std::int64_t{v[2].x} - v[0].x)) {
      continue;
    }
    const auto kind = random.in(0, 4);
    for (const Point p : v) {
      VertexRecord& r = out.records.emplace_back();
      r.point = p;
      r.depth = static_cast<std::int32_t>(kind == 0   ? 1 << 29
                                          : kind == 1 ? random.in(0, 1) * kDepthMost
                                                      : random.in(kDepthLeast, kDepthMost));
      r.inverse_w =
          static_cast<double>(kind == 2 ? w_most : random.in(kind == 3 ? 1 : w_most / 2, w_most));
      for (std::size_t n = 0; n < 3; ++n) {
        r.set_value(n, static_cast<std::int32_t>(kind == 1 ? random.in(0, 1) * 65280
                                                           : random.in(kValueLeast, kValueMost)));
      }
    }
  }
  for (std::size_t i = 0; i < out.records.size(); i += 3) {
    out.triangles.push_back(
        frame_triangle(&out.records[i], &out.records[i + 1], &out.records[i + 2]));
  }
  return out;
}

TEST(FrameKernel, PlanesAreThoseOfTheStages) {
  Config widest;
  widest.subpixel_bits = 12;
  widest.viewport_bits = 15;
  widest.guard_bits = 16;
  widest.gradient_bits = 20;
  Config coarse = kFull;
  coarse.subpixel_bits = 0;
  coarse.gradient_bits = 0;
  coarse.inverse_w_bits = 12;
  coarse.depth_bits = 16;
  for (const Config& config : {kFull, kD3d, kTiny, widest, coarse}) {
    const std::uint64_t seed = 4711;
    Random random(seed);
    const Input input = random_input(random, 20000, config);
    const FrameConstants constants = constants_of(config);
    const std::size_t count = input.triangles.size();
    std::vector<FramePlane> depth(count), want_depth(count);
    std::vector<ShadePlanes> shade(count), want_shade(count);
    simd::planes_scalar(constants, input.triangles.data(), count, want_depth.data());
    simd::shade_planes_scalar(constants, input.triangles.data(), count, want_shade.data());
    for (const simd::FrameKernels& kernels : simd::frame_kernels()) {
      kernels.planes(constants, input.triangles.data(), count, depth.data());
      kernels.shade_planes(constants, input.triangles.data(), count, shade.data());
      for (std::size_t i = 0; i < count; ++i) {
        SCOPED_TRACE(std::string(kernels.isa) + ", triangle " + std::to_string(i) + ", seed " +
                     std::to_string(seed));
        ASSERT_EQ(depth[i].origin, want_depth[i].origin);
        ASSERT_EQ(depth[i].dx, want_depth[i].dx);
        ASSERT_EQ(depth[i].dy, want_depth[i].dy);
        ASSERT_EQ(depth[i].lane_dx, want_depth[i].lane_dx);
        ASSERT_EQ(depth[i].lane_dy, want_depth[i].lane_dy);
        ASSERT_EQ(shade[i].origin, want_shade[i].origin);
        ASSERT_EQ(shade[i].dx, want_shade[i].dx);
        ASSERT_EQ(shade[i].dy, want_shade[i].dy);
        ASSERT_EQ(shade[i].level, want_shade[i].level);
        for (std::size_t n = 0; n < kShades; ++n) {  // the low halves count
          ASSERT_EQ(static_cast<std::uint32_t>(shade[i].lane_dx[n]),
                    static_cast<std::uint32_t>(want_shade[i].lane_dx[n]));
          ASSERT_EQ(static_cast<std::uint32_t>(shade[i].lane_dy[n]),
                    static_cast<std::uint32_t>(want_shade[i].lane_dy[n]));
        }
      }
    }
  }
}

}  // namespace
}  // namespace halfspace
