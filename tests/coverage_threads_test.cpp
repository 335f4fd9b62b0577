// SPDX-License-Identifier: Apache-2.0
//
// Level coverage on several threads, and on the triangles that a real driver drew.
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <vector>

#include "engines/coverage/parallel_coverage.hpp"
#include "io/tcov.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

constexpr std::array<int, 4> kThreads{1, 2, 3, 8};

std::vector<Triangle> scene(const FrameState& frame, const Config& config) {
  Random random(7);
  std::vector<Triangle> triangles;
  for (int i = 0; i < 20000; ++i) {
    const Shape shape = i % 50 == 0 ? Shape::kAnywhere : i % 3 == 0 ? Shape::kTiny : Shape::kSmall;
    triangles.push_back(random_triangle(random, shape, frame, config));
  }
  return triangles;
}

// Everything a sink sees, as words.
std::vector<std::uint64_t> stream(const std::vector<Triangle>& triangles, const FrameState& frame,
                                  const Config& config, int threads) {
  std::vector<std::uint64_t> words;
  const auto add = [&](const CoverageChunk& chunk) {
    words.push_back(chunk.records());
    words.insert(words.end(), chunk.triangle.begin(), chunk.triangle.end());
    words.insert(words.end(), chunk.end.begin(), chunk.end.end());
    words.insert(words.end(), chunk.place.begin(), chunk.place.end());
    for (std::size_t m = 0; m < static_cast<std::size_t>(chunk.samples); ++m) {
      words.insert(words.end(), chunk.plane[m], chunk.plane[m] + chunk.records());
    }
  };
  const simd::KernelCounts counts = cover_parallel(triangles, frame, config, {threads, {}}, add);
  words.push_back(counts.triangles);
  words.push_back(counts.zero_area);
  words.push_back(counts.no_sample);
  return words;
}

TEST(CoverageThreads, SameBytesForAnyNumberOfThreads) {
  const FrameState frame{300, 200, Cull::kNone};
  for (const Config& config : {kFull, kMsaa4}) {
    const std::vector<Triangle> triangles = scene(frame, config);
    const std::vector<std::uint64_t> one = stream(triangles, frame, config, 1);
    for (const int threads : kThreads) {
      EXPECT_TRUE(stream(triangles, frame, config, threads) == one) << threads;
    }
  }
}

TEST(CoverageThreads, SameRecordsAsOneEngine) {
  const FrameState frame{300, 200, Cull::kNone};
  const std::vector<Triangle> triangles = scene(frame, kFull);
  std::vector<std::uint64_t> one, many;
  CoverageEngine engine(frame, kFull);
  const auto add = [](std::vector<std::uint64_t>& to, const CoverageChunk& chunk) {
    for (std::size_t i = 0; i < chunk.triangle.size(); ++i) {
      to.push_back(chunk.triangle[i]);
      for (std::size_t r = chunk.begin_of(i); r < chunk.end[i]; ++r) {
        to.push_back(chunk.place[r]);
        to.push_back(chunk.plane[0][r]);
      }
    }
  };
  engine.cover(triangles, [&](const CoverageChunk& chunk) { add(one, chunk); });
  cover_parallel(triangles, frame, kFull, {3, {}},
                 [&](const CoverageChunk& chunk) { add(many, chunk); });
  EXPECT_TRUE(one == many);
}

TEST(CoverageThreads, SameHitsForAnyNumberOfThreads) {
  const FrameState frame{300, 200, Cull::kNone};
  for (const Config& config : {kFull, kTiny, kMsaa4}) {
    const std::vector<Triangle> triangles = scene(frame, config);
    HitCount want(frame.width, frame.height);
    RasterStats want_stats;
    for (const Triangle& t : triangles) {
      rasterize(t, frame, config, want_stats,
                [&](const CoverageTile& tile) { want.add(tile, config); });
    }
    for (const int threads : kThreads) {
      RasterStats stats;
      EXPECT_EQ(hits_parallel(triangles, frame, config, {threads, {}}, stats).count(),
                want.count());
      EXPECT_EQ(stats.samples_covered, want_stats.samples_covered);
      EXPECT_EQ(stats.triangles_no_sample, want_stats.triangles_no_sample);
    }
  }
}

TEST(CoverageThreads, NothingComesOfNothing) {
  RasterStats stats;
  const HitPlane plane = hits_parallel({}, {8, 8, Cull::kNone}, kFull, {2, {}}, stats);
  EXPECT_EQ(plane.count(), std::vector<std::uint8_t>(64, 0));
  int chunks = 0;
  cover_parallel({}, {8, 8, Cull::kNone}, kFull, {2, {}}, [&](const CoverageChunk&) { ++chunks; });
  EXPECT_EQ(chunks, 0);
}

// A sink that throws stops all threads, and the caller hears of it.
TEST(CoverageThreads, WhatTheSinkThrowsReachesTheCaller) {
  const FrameState frame{300, 200, Cull::kNone};
  const std::vector<Triangle> triangles = scene(frame, kFull);
  for (const int threads : kThreads) {
    int chunks = 0;
    EXPECT_THROW(cover_parallel(triangles, frame, kFull, {threads, {}},
                                [&](const CoverageChunk&) {
                                  if (++chunks == 5) throw std::runtime_error("full");
                                }),
                 std::runtime_error);
    EXPECT_EQ(chunks, 5);
  }
}

TEST(CoverageDriver, EveryPixelEqualOnEveryInstructionSet) {
  const std::vector<TcovCase> cases =
      read_tcov(std::string(HALFSPACE_TEST_DIR) + "/data/public.tcov");
  ASSERT_EQ(cases.size(), 320u);
  Config small = kFull;
  small.grid_log2 = 2;
  Config fine = kD3d;
  fine.subpixel_bits = 12;
  for (const TcovCase& tcov : cases) {
    for (const Config& config : {kFull, kD3d, small, fine}) {
      const std::vector<Triangle> triangles = tcov_triangles(tcov, config, "").triangles;
      for (const std::string_view isa : coverage_isas()) {
        RasterStats stats;
        const FrameState frame{tcov.width, tcov.height, Cull::kNone};
        EXPECT_TRUE(hits_parallel(triangles, frame, config, {1, isa}, stats).count() == tcov.hits)
            << tcov.id << " " << isa;
      }
    }
  }
}

}  // namespace
}  // namespace halfspace
