// SPDX-License-Identifier: Apache-2.0
//
// Hits per pixel summed over batches.
#include "engines/coverage/hit_plane.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "engines/coverage/coverage_engine.hpp"

namespace halfspace {
namespace {

// 300 triangles on every pixel: counts stop at 255, before and after planes are added.
TEST(HitPlane, StopsAt255) {
  const Triangle all{{{{-4096, -4096}, {65536, -4096}, {-4096, 65536}}}, 0};
  CoverageEngine engine({30, 20, Cull::kNone}, kFull);
  HitPlane plane(30, 20);
  const std::vector<Triangle> many(300, all);
  engine.cover(many, [&](const CoverageChunk& chunk) { plane.add(chunk); });
  EXPECT_EQ(plane.count(), std::vector<std::uint8_t>(600, 255));
  plane.add(plane);
  EXPECT_EQ(plane.count(), std::vector<std::uint8_t>(600, 255));
}

}  // namespace
}  // namespace halfspace
