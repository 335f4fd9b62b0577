// SPDX-License-Identifier: Apache-2.0
//
// hs_triangle_setup by itself against triangle_setup() and the rules of timing.md.
#include "triangle_setup.hpp"

#include "stage_cosim.hpp"

namespace halfspace {
namespace {

std::vector<StagePacket> packets_of(std::vector<Triangle> triangles, const FrameState& frame,
                                    const Config& config) {
  std::vector<StagePacket> packets;
  for (Triangle& triangle : triangles) {
    triangle.tag = static_cast<std::uint32_t>(packets.size());
    StagePacket packet{values_of(triangle, config), {}};
    if (const auto setup = triangle_setup(triangle, frame, config)) {
      packet.out.push_back(values_of(*setup, config));
    }
    packets.push_back(std::move(packet));
  }
  return packets;
}

std::size_t dropped(const std::vector<StagePacket>& packets) {
  std::size_t count = 0;
  for (const StagePacket& packet : packets) count += packet.out.empty() ? 1 : 0;
  return count;
}

void expect_same_setup(const StageVariant& variant, const std::vector<StagePacket>& packets,
                       const FrameState& frame, std::uint64_t seed) {
  const StageRun run{triangle_setup_clocks, triangle_layout(variant.config),
                     setup_layout(variant.config)};
  expect_same("triangle_setup", variant, run, packets, frame, seed);
}

TEST(TriangleSetupCosim, TrianglesOfEveryShapeAgreeInBitsAndClocks) {
  constexpr std::uint64_t kSeed = 71;
  for (const StageVariant& variant : triangle_setup_stages()) {
    const Config& config = variant.config;
    for (const Cull cull : {Cull::kNone, Cull::kBack, Cull::kFront}) {
      const int size = cull == Cull::kNone ? config.max_size() : config.max_size() / 2 + 37;
      const FrameState frame{size, size - 5, cull};
      Random random(kSeed);
      std::vector<Triangle> triangles;
      for (int i = 0; i < 5500; ++i) {
        const Shape shape = kShapes[static_cast<std::size_t>(i) % kShapes.size()];
        triangles.push_back(random_triangle(random, shape, frame, config));
      }
      const std::vector<StagePacket> packets = packets_of(triangles, frame, config);
      EXPECT_GT(dropped(packets), 100u);
      EXPECT_LT(dropped(packets), 5000u);
      ASSERT_NO_FATAL_FAILURE(expect_same_setup(variant, packets, frame, kSeed));
    }
  }
}

TEST(TriangleSetupCosim, WidestTrianglesAgreeInBitsAndClocks) {
  for (const StageVariant& variant : triangle_setup_stages()) {
    const int size = variant.config.max_size();
    const FrameState frame{size, size, Cull::kNone};
    std::vector<Triangle> triangles = widest_triangles(variant.config);
    if (triangles.size() > 2000) triangles.resize(2000);
    ASSERT_NO_FATAL_FAILURE(
        expect_same_setup(variant, packets_of(triangles, frame, variant.config), frame, 0));
  }
}

// The throughput of the header: one triangle every SETUP_INTERVAL clocks, whatever they are.
TEST(TriangleSetupCosim, TakesATriangleEveryInterval) {
  for (const StageVariant& variant : triangle_setup_stages()) {
    const Config& config = variant.config;
    const FrameState frame{200, 200, Cull::kNone};
    Random random(72);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 100; ++i) {
      triangles.push_back(random_triangle(random, Shape::kTiny, frame, config));
    }
    const std::vector<StagePacket> packets = packets_of(triangles, frame, config);
    const StageClocks clocks = triangle_setup_clocks(packets, variant, Stalls());
    EXPECT_EQ(clocks.accepted.back(), 99u * static_cast<std::uint64_t>(config.setup_interval));
    ASSERT_NO_FATAL_FAILURE(expect_same_setup(variant, packets, frame, 72));
  }
}

}  // namespace
}  // namespace halfspace
