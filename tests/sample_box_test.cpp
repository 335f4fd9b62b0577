// SPDX-License-Identifier: Apache-2.0
//
// The box of triangle_setup: the pixels that may hold a covered sample.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "compare.hpp"
#include "triangle_setup.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

// The pixels 0..size-1 of one direction that may hold a sample of low <= position < high px, by
// trying each: a pixel's samples lie in [pixel + least, pixel + greatest].
struct Pixels {
  int first = 0;
  int last = -1;
};

Pixels brute_force(double low, double high, double least, double greatest, int size) {
  Pixels pixels;
  for (int p = size - 1; p >= 0; --p) {
    if (p + greatest < low || p + least >= high) continue;
    if (pixels.last < 0) pixels.last = p;
    pixels.first = p;
  }
  return pixels;
}

std::optional<Box> brute_force_box(const Triangle& t, const FrameState& frame,
                                   const Config& config) {
  const auto c = corners_px(t, config);
  oracle::Vec least{1, 1};
  oracle::Vec greatest{0, 0};
  for (const oracle::Vec s : oracle::standard_samples(config.samples)) {
    least = {std::min(least.x, s.x), std::min(least.y, s.y)};
    greatest = {std::max(greatest.x, s.x), std::max(greatest.y, s.y)};
  }
  const auto [x_min, x_max] = std::minmax({c[0].x, c[1].x, c[2].x});
  const auto [y_min, y_max] = std::minmax({c[0].y, c[1].y, c[2].y});
  const Pixels x = brute_force(x_min, x_max, least.x, greatest.x, frame.width);
  const Pixels y = brute_force(y_min, y_max, least.y, greatest.y, frame.height);
  if (x.last < 0 || y.last < 0) return std::nullopt;
  return Box{x.first, y.first, x.last, y.last};
}

std::vector<Config> small_configs() {
  std::vector<Config> list;
  for (const int samples : {1, 2, 4, 8, 16}) {
    for (const int s : {0, 1, 2, 3, 4, 8}) {
      list.push_back({.subpixel_bits = s, .viewport_bits = 5, .guard_bits = 6, .samples = samples});
    }
  }
  return list;
}

TEST(SampleBox, IsTheClosedFormForEveryShapeAndSampleCount) {
  constexpr std::uint64_t kSeed = 21;
  Random random(kSeed);
  for (const Config& config : small_configs()) {
    for (int n = 0; n < 3000; ++n) {
      const FrameState frame{static_cast<int>(random.in(1, 32)), static_cast<int>(random.in(1, 32)),
                             Cull::kNone};
      const Triangle t = random_triangle(
          random, kShapes[static_cast<std::size_t>(n) % kShapes.size()], frame, config);
      SetupOutcome outcome{};
      const auto setup = triangle_setup(t, frame, config, &outcome);
      if (outcome == SetupOutcome::kZeroArea) continue;
      const auto box = brute_force_box(t, frame, config);
      ASSERT_EQ(setup.has_value(), box.has_value())
          << "seed " << kSeed << ": " << describe(t, frame, config);
      if (!box) continue;
      ASSERT_EQ(setup->box, *box) << "seed " << kSeed << ": " << describe(t, frame, config)
                                  << " box " << setup->box.x_first << "," << setup->box.y_first
                                  << " - " << setup->box.x_last << "," << setup->box.y_last;
    }
  }
}

// A right triangle whose legs lie along the box covers samples in its first and last column and
// row, unless none of its samples is there: for one sample no smaller box would do.
TEST(SampleBox, NoSmallerBoxHoldsAnAxisAlignedPairOfTriangles) {
  for (int s = 0; s <= 3; ++s) {
    const Config config{.subpixel_bits = s, .viewport_bits = 3, .guard_bits = 0};
    const FrameState frame{8, 8, Cull::kNone};
    const int high = 3 << s;
    for (int x0 = 0; x0 < high; ++x0) {
      for (int x1 = x0 + 1; x1 <= high; ++x1) {
        const Triangle upper{{{{x0, x0}, {x1, x0}, {x1, x1}}}, 0};
        const Triangle lower{{{{x0, x0}, {x1, x1}, {x0, x1}}}, 0};
        const auto hits = oracle_hits({upper, lower}, frame, config);
        const auto setup = triangle_setup(upper, frame, config);
        for (int y = 0; y < 8; ++y) {
          for (int x = 0; x < 8; ++x) {
            const bool in_box = setup && x >= setup->box.x_first && x <= setup->box.x_last &&
                                y >= setup->box.y_first && y <= setup->box.y_last;
            ASSERT_EQ(hits[static_cast<std::size_t>(8 * y + x)], in_box ? 1 : 0)
                << "square " << x0 << ".." << x1 << " subpixels, s=" << s << ", pixel " << x << ","
                << y;
          }
        }
      }
    }
  }
}

TEST(SampleBox, NeverCutsAnOwnedSample) {
  constexpr std::uint64_t kSeed = 22;
  Random random(kSeed);
  for (const Config& config : small_configs()) {
    const auto samples = oracle::standard_samples(config.samples);
    const FrameState frame{32, 32, Cull::kNone};
    for (int n = 0; n < 100; ++n) {
      const Triangle t = random_triangle(
          random, kShapes[static_cast<std::size_t>(n) % kShapes.size()], frame, config);
      const auto setup = triangle_setup(t, frame, config);
      const Box box = setup ? setup->box : Box{0, 0, -1, -1};
      const auto corners = corners_px(t, config);
      for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
          if (x >= box.x_first && x <= box.x_last && y >= box.y_first && y <= box.y_last) continue;
          ASSERT_EQ(oracle::pixel_mask(corners, x, y, samples), 0u)
              << "pixel " << x << "," << y << ", seed " << kSeed << ": "
              << describe(t, frame, config);
        }
      }
    }
  }
}

TEST(TriangleSetup, IllegalInputStopsTheProgram) {
  const Triangle legal{{{{0, 0}, {2560, 0}, {0, 2560}}}, 0};
  Triangle outside = legal;
  outside.vertex[1].x = static_cast<std::int32_t>(kFull.coordinate_max()) + 1;
  const FrameState frame{16, 16, Cull::kNone};
  EXPECT_DEATH(triangle_setup(outside, frame, kFull), "coordinate_max");
  EXPECT_DEATH(triangle_setup(legal, {4097, 16, Cull::kNone}, kFull), "frame.width");
  EXPECT_DEATH(triangle_setup(legal, {16, 0, Cull::kNone}, kFull), "frame.height");
}

}  // namespace
}  // namespace halfspace
