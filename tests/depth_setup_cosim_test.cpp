// SPDX-License-Identifier: Apache-2.0
//
// hs_depth_setup by itself against area_reciprocal() and the plane of interpolation_setup().
#include "interpolation.hpp"
#include "pipeline_cosim.hpp"
#include "triangle_setup.hpp"
#include "vectors/back_end_layout.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t kSeed = 85;

struct Setups {
  std::vector<PipelinePacket> planes;
  std::vector<PipelinePacket> areas;
};

void add(const Triangle& triangle, const SetupTriangle& setup, Random& random, const Config& config,
         Setups& setups) {
  std::array<VertexAttributes, 3> vertices;
  for (VertexAttributes& vertex : vertices) {
    vertex.depth = static_cast<std::int32_t>(random.in(kDepthLeast, kDepthMost));
  }
  const std::int64_t index = random.in(0, 127);
  const std::int64_t area = doubled_area(setup);
  const EdgeSlope a = setup.slope[0], c = setup.slope[2];
  Values in{area, a.a, a.b, c.a, c.b};
  for (const Point& point : triangle.vertex) in.insert(in.end(), {point.x, point.y});
  for (const VertexAttributes& vertex : vertices) in.push_back(vertex.depth);
  in.push_back(index);

  const InterpolationSetup planes = interpolation_setup(setup, triangle, vertices, 0, config);
  Values plane = values_of(corner_plane(planes.depth, planes.origin, config));
  plane.push_back(index);
  setups.planes.push_back({in, plane});

  const AreaReciprocal reciprocal = area_reciprocal(area);
  const int f = config.position_bits();
  const auto centre = [&](std::int32_t vertex) {
    return (1 << (f - 1)) - vertex * (1 << (f - config.subpixel_bits));
  };
  setups.areas.push_back({in,
                          {static_cast<std::int64_t>(reciprocal.factor >> 1), reciprocal.shift - 32,
                           static_cast<std::int64_t>(first_vertex(triangle.vertex)),
                           centre(planes.origin.x), centre(planes.origin.y), index}});
}

TEST(DepthSetupCosim, EveryTriangleHasTheModelsReciprocalAndPlane) {
  for (std::size_t v = 0; v < depth_setup_stages().size(); ++v) {
    const PipelineVariant& planes = depth_setup_stages()[v];
    const PipelineVariant& areas = depth_setup_area_stages()[v];
    const Config& config = planes.config;
    const FrameState frame{config.max_size(), config.max_size(), Cull::kNone};
    Random random(kSeed);
    Setups setups;
    const auto draw = [&](const Triangle& triangle) {
      if (const auto setup = triangle_setup(triangle, frame, config)) {
        add(triangle, *setup, random, config, setups);
      }
    };
    for (std::size_t n = 0; n < 10'000; ++n) {
      draw(random_triangle(random, kShapes[n % kShapes.size()], frame, config));
    }
    for (const Triangle& triangle : widest_triangles(config)) draw(triangle);
    EXPECT_GT(setups.planes.size(), 5000u);
    const Layout in = depth_setup_layout(config);
    ASSERT_NO_FATAL_FAILURE(expect_pipeline(planes, in, triangle_depth_layout(config),
                                            setups.planes, planes.parameter, true, kSeed));
    ASSERT_NO_FATAL_FAILURE(expect_pipeline(areas, in, triangle_area_layout(config), setups.areas,
                                            areas.parameter, true, kSeed));
  }
}

}  // namespace
}  // namespace halfspace
