// SPDX-License-Identifier: Apache-2.0
//
// The whole rasterizer, model against RTL: every packet at every handshake, bits and clock.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/mat4x4.hpp>

#include "camera.hpp"
#include "cycle_model.hpp"
#include "geometry.hpp"
#include "io/tcov.hpp"
#include "meshes/mesh.hpp"
#include "rtl/cosim.hpp"
#include "rtl/rtl_configs.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

struct Named {
  const char* name;
  Config config;
};
void PrintTo(const Named& named, std::ostream* out) { *out << named.name; }

class Cosim : public testing::TestWithParam<Named> {
 protected:
  void SetUp() override { rtl_ = std::make_unique<RtlRasterizer>(config(), false, "rtl"); }
  const Config& config() const { return GetParam().config; }

  // Identical, and something was compared.
  void expect_identical(const std::vector<Triangle>& triangles, const FrameState& frame,
                        double stall, std::uint64_t seed, int resets = 0) {
    CosimOptions options;
    options.stalls = Stalls(stall, seed);
    const CosimResult result =
        cosim_with_resets(*rtl_, triangles, frame, config(), options, resets);
    ASSERT_FALSE(result.mismatch) << "stall " << stall << " seed " << seed << " "
                                  << result.mismatch->line();
    EXPECT_GE(result.packets_compared, triangles.size());
    packets_ += result.packets_compared;
  }

  FrameState whole_frame(Cull cull = Cull::kNone) const {
    const int side = std::min(config().max_size(), 512);
    return {side, side, cull};
  }

  std::unique_ptr<RtlRasterizer> rtl_;
  std::uint64_t packets_ = 0;
};

TEST_P(Cosim, RandomTrianglesOfEveryShapeWithAndWithoutStalls) {
  std::uint64_t seed = 100;
  for (const double stall : {0.0, 0.3, 0.8}) {
    Random random(++seed);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 400; ++i) {
      triangles.push_back(random_triangle(
          random, kShapes[static_cast<std::size_t>(i) % kShapes.size()], whole_frame(), config()));
    }
    expect_identical(triangles, whole_frame(), stall, seed);
  }
  EXPECT_GT(packets_, 2000u);
}

TEST_P(Cosim, WidestTriangles) {
  std::vector<Triangle> triangles = widest_triangles(config());
  if (triangles.size() > 60) triangles.resize(60);
  expect_identical(
      triangles,
      {std::min(config().max_size(), 200), std::min(config().max_size(), 120), Cull::kNone}, 0.2,
      1);
}

TEST_P(Cosim, EveryCullModeAndOddFrameSizes) {
  for (const Cull cull : {Cull::kNone, Cull::kBack, Cull::kFront}) {
    Random random(7);
    std::vector<Triangle> triangles;
    const int side = std::min(config().max_size(), 300);
    const FrameState frame{std::max(1, side - 3), std::max(1, side / 2 - 1), cull};
    for (int i = 0; i < 60; ++i) {
      triangles.push_back(random_triangle(
          random, kShapes[static_cast<std::size_t>(i) % kShapes.size()], frame, config()));
    }
    expect_identical(triangles, frame, 0.3, 8);
  }
}

TEST_P(Cosim, ResetInTheMiddleLeavesNothingBehind) {
  Random random(11);
  std::vector<Triangle> triangles;
  for (int i = 0; i < 120; ++i) {
    triangles.push_back(random_triangle(
        random, kShapes[static_cast<std::size_t>(i) % kShapes.size()], whole_frame(), config()));
  }
  expect_identical(triangles, whole_frame(), 0.4, 12, 12);
}

TEST_P(Cosim, DriverCasesThatFit) {
  std::size_t fitting = 0;
  for (const TcovCase& tcov : read_tcov(std::string(HALFSPACE_TEST_DIR) + "/data/public.tcov")) {
    if (tcov.width > config().max_size() || tcov.height > config().max_size()) continue;
    std::vector<Triangle> triangles;
    try {
      triangles = tcov_triangles(tcov, config(), "").triangles;
    } catch (const std::exception&) {
      continue;  // beyond the configuration's range
    }
    ++fitting;
    expect_identical(triangles, {tcov.width, tcov.height, Cull::kNone}, 0.1, fitting);
  }
  EXPECT_GT(fitting, config().viewport_bits >= 8 ? 150u : 0u);
  if (config().guard_bits >= 13) {
    EXPECT_EQ(fitting, 320u);
  }
}

TEST_P(Cosim, TheTeapot) {
  const Mesh mesh = load_mesh(std::string(HALFSPACE_TEST_DIR) + "/scenes/teapot.obj");
  const FrameState frame = whole_frame();
  const glm::dmat4 matrix = world_to_clip(frame_camera(mesh.positions, 1.0), 1.0);
  GeometryStage stage(frame, config());
  std::vector<ShadedTriangle> shaded;
  std::uint32_t tag = 0;
  for (const auto& index : mesh.triangles) {
    std::array<ClipVertex, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle[i].position = matrix * glm::dvec4(glm::dvec3(mesh.positions[index[i]]), 1.0);
    }
    stage.process(triangle, tag++, shaded);
  }
  std::vector<Triangle> triangles;
  for (const ShadedTriangle& t : shaded) {
    // The host refuses the others.
    if (within_extent(t.triangle, config())) triangles.push_back(t.triangle);
  }
  EXPECT_GT(triangles.size(), shaded.size() / 2);
  expect_identical(triangles, frame, 0.3, 7);
}

INSTANTIATE_TEST_SUITE_P(
    All, Cosim,
    testing::Values(Named{"tiny", kTiny}, Named{"full", kFull}, Named{"d3d", kD3d},
                    Named{"msaa4", kMsaa4}, Named{"interval3", kTestInterval3},
                    Named{"samples16", kTestSamples16}, Named{"one_level", kTestOneLevel},
                    Named{"fitted", kTestFitted}, Named{"fitted_band", kTestFittedBand}),
    [](const auto& info) { return std::string(info.param.name); });

// A second model for the waves around a difference lives beside the first and ends before it.
TEST(RtlModel, TwoModelsLiveAndEndIndependently) {
  RtlRasterizer first(kTiny, false, "rtl");
  const std::vector<Triangle> one{{{{{0, 0}, {0, 200}, {200, 0}}}, 0}};
  const auto run = [&one](RtlRasterizer& rtl) {
    return cosim(rtl, one, {64, 64, Cull::kNone}, kTiny, {}).mismatch.has_value();
  };
  {
    RtlRasterizer second(kTiny, false, "rtl");
    EXPECT_FALSE(run(second));
    EXPECT_FALSE(run(first));
  }
  EXPECT_FALSE(run(first));
}

// The host refuses such a triangle; an RTL that gets it all the same says so.
TEST(RtlModel, AnEdgeBeyondTheFittedRangeFailsAnAssertion) {
  for (const Config& config : {kTestFitted, kTestFittedBand}) {
    const auto limit = static_cast<std::int32_t>(config.extent_max());
    for (const std::int32_t span : {limit, limit + 1}) {
      for (const bool in_x : {false, true}) {
        Triangle t{{{{0, 0}, {1, 2}, {2, 1}}}, 0};
        (in_x ? t.vertex[1].x : t.vertex[1].y) = span;
        RtlRasterizer rtl(config, false, "rtl");
        rtl.set_frame({16, 16, Cull::kNone});
        const auto offer = [&] {
          rtl.drive(&t, true);
          rtl.clock();
        };
        if (span == limit) {
          EXPECT_NO_THROW(offer());
        } else {
          EXPECT_THROW(offer(), std::runtime_error) << in_x;
        }
      }
    }
  }
}

// --- Throughput: facts in clocks, of the RTL. The table is in docs/03_design/throughput.md.
// --------

std::uint64_t rtl_clocks(const std::vector<Triangle>& triangles, const FrameState& frame,
                         std::uint64_t& tiles) {
  RtlRasterizer rtl(kFull, false, "rtl");
  tiles = 0;
  return run_rtl(rtl, triangles, frame, {}, [&](const CoverageTile&) { ++tiles; }).clocks;
}

// n triangles with a bounding box of about `extent` px, anywhere in the frame.
std::vector<Triangle> of_extent(int n, int extent, int frame) {
  Random random(static_cast<std::uint64_t>(extent));
  std::vector<Triangle> out;
  for (int i = 0; i < n; ++i) {
    const std::int64_t x = random.in(0, (frame - extent) * 256);
    const std::int64_t y = random.in(0, (frame - extent) * 256);
    Triangle t;
    for (Point& p : t.vertex) {
      p = {static_cast<std::int32_t>(x + random.in(0, extent * 256)),
           static_cast<std::int32_t>(y + random.in(0, extent * 256))};
    }
    out.push_back(t);
  }
  return out;
}

constexpr double kLatency = 25;

TEST(Throughput, OneTriangleAClockInsideOneTile) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < 2000; ++i) {
    const std::int32_t x = (i % 64) * 8 * 256;
    const std::int32_t y = (i / 64) * 8 * 256;
    triangles.push_back({{{{x, y}, {x + 2047, y}, {x, y + 2047}}}, 0});
  }
  std::uint64_t tiles = 0;
  EXPECT_LE(rtl_clocks(triangles, {4096, 4096, Cull::kNone}, tiles), 2000 + kLatency);
  EXPECT_EQ(tiles, 2000u);
}

TEST(Throughput, SixtyFourPixelsEveryClockOnALargeTriangle) {
  std::uint64_t tiles = 0;
  const std::vector<Triangle> quad{
      {{{{-262144, -262144}, {1048576, -262144}, {-262144, 1048576}}}, 0}};
  const std::uint64_t clocks = rtl_clocks(quad, {1024, 1024, Cull::kNone}, tiles);
  EXPECT_EQ(tiles, 128u * 128u);
  EXPECT_LE(static_cast<double>(clocks), static_cast<double>(tiles) + kLatency);
}

TEST(Throughput, ClocksPerCoveredTileAtSmallExtents) {
  for (const auto& [extent, most] : {std::pair{32, 1.08}, {16, 1.17}, {8, 1.30}}) {
    std::uint64_t tiles = 0;
    const std::uint64_t clocks =
        rtl_clocks(of_extent(4000, extent, 2048), {2048, 2048, Cull::kNone}, tiles);
    EXPECT_LE((static_cast<double>(clocks) - kLatency) / static_cast<double>(tiles), most)
        << "extent " << extent;
  }
}

TEST(Throughput, DiagonalSliver) {
  std::uint64_t tiles = 0;
  const std::vector<Triangle> sliver{
      {{{{0, 0}, {640 * 256, 638 * 256}, {640 * 256, 640 * 256}}}, 0}};
  const std::uint64_t clocks = rtl_clocks(sliver, {640, 640, Cull::kNone}, tiles);
  EXPECT_LE(static_cast<double>(clocks), 1.2 * static_cast<double>(tiles) + kLatency);
}

TEST(Throughput, FirstTileWithin25Clocks) {
  const std::vector<Triangle> one{{{{{0, 0}, {2048, 0}, {0, 2048}}}, 0}};
  std::uint64_t tiles = 0;
  EXPECT_LE(rtl_clocks(one, {4096, 4096, Cull::kNone}, tiles), 25u);
}

}  // namespace
}  // namespace halfspace
