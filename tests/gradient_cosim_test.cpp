// SPDX-License-Identifier: Apache-2.0
//
// hs_gradient by itself against the planes of interpolation_setup().
#include <bit>

#include "interpolation.hpp"
#include "pipeline_cosim.hpp"
#include "triangle_setup.hpp"
#include "vectors/back_end_layout.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t kSeed = 82;

// Depths of every kind: anything, the ends of the range, all alike.
std::array<VertexAttributes, 3> random_depths(Random& random) {
  std::array<VertexAttributes, 3> vertices;
  const auto kind = random.in(0, 3);
  for (VertexAttributes& vertex : vertices) {
    vertex.depth =
        static_cast<std::int32_t>(kind == 0 ? (random.in(0, 1) == 0 ? kDepthLeast : kDepthMost)
                                            : random.in(kDepthLeast, kDepthMost));
  }
  if (kind == 1) vertices[1].depth = vertices[2].depth = vertices[0].depth;
  return vertices;
}

PipelinePacket packet_of(const Triangle& triangle, const SetupTriangle& setup, Random& random,
                         const Config& config) {
  const std::array<VertexAttributes, 3> vertices = random_depths(random);
  const InterpolationSetup planes = interpolation_setup(setup, triangle, vertices, 0, config);
  const AreaReciprocal area = area_reciprocal(doubled_area(setup));
  GradientInput input;
  for (std::size_t i = 0; i < 3; ++i) input.value[i] = vertices[i].depth;
  input.first = static_cast<int>(first_vertex(triangle.vertex));
  input.slope0 = setup.slope[0];
  input.slope2 = setup.slope[2];
  const int f = config.position_bits();
  const auto centre = [&](std::int32_t vertex) {
    return (1 << (f - 1)) - vertex * (1 << (f - config.subpixel_bits));
  };
  input.centre = {centre(planes.origin.x), centre(planes.origin.y)};
  input.reciprocal = static_cast<std::uint32_t>(area.factor >> 1);
  input.length = area.shift - 32;
  return {values_of(input), values_of(corner_plane(planes.depth, planes.origin, config))};
}

TEST(GradientCosim, EveryTriangleHasTheModelsPlane) {
  for (const PipelineVariant& variant : gradient_stages()) {
    const Config& config = variant.config;
    const FrameState frame{config.max_size(), config.max_size(), Cull::kNone};
    Random random(kSeed);
    std::vector<PipelinePacket> packets;
    const auto add = [&](const Triangle& triangle) {
      if (const auto setup = triangle_setup(triangle, frame, config)) {
        packets.push_back(packet_of(triangle, *setup, random, config));
      }
    };
    for (std::size_t n = 0; n < 20'000; ++n) {
      add(random_triangle(random, kShapes[n % kShapes.size()], frame, config));
    }
    for (const Triangle& triangle : widest_triangles(config)) add(triangle);
    EXPECT_GT(packets.size(), 10'000u);
    ASSERT_NO_FATAL_FAILURE(expect_pipeline(variant, gradient_layout(config),
                                            corner_plane_layout(config), packets, variant.parameter,
                                            true, kSeed));
  }
}

}  // namespace
}  // namespace halfspace
