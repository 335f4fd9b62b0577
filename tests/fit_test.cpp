// SPDX-License-Identifier: Apache-2.0
//
// fit: the ranges are those of the scene and no wider, the error is the oracle's, the area that of
// the measured configurations.
#include "fit/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "hit_count.hpp"
#include "io/error.hpp"
#include "io/output_file.hpp"
#include "oracle/oracle.hpp"

namespace halfspace {
namespace {

const std::string kScenes = std::string(HALFSPACE_TEST_DIR) + "/scenes/";

std::vector<FitView> views_of(const std::string& file, int width, int height,
                              const CameraOptions& camera = {}, int views = 1) {
  const std::string path = kScenes + file;
  return fit_views(open_scene(path, -1, {width, height}, camera, Lighting::kGouraud, views), path,
                   Cull::kNone);
}

// The error that drawing with this configuration throws, as text; empty when there is none.
std::string refusal(const std::vector<FitView>& views, const Config& config) {
  try {
    for (const FitView& view : views) {
      RunStats stats;
      view.scene->draw(view.index, view.frame, config, stats, [](const ShadedTriangle&) {});
    }
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kFitRange) << error.what();
    return error.what();
  }
  return "";
}

TEST(FitRanges, EachIsTheLeastThatDoesNotRefuseTheScene) {
  for (const auto& views : {views_of("teapot.obj", 320, 240), views_of("bunny.obj", 500, 513),
                            views_of("teapot.obj", 200, 150, {}, 5)}) {
    const FitRanges ranges = fit_ranges(views, kFull);
    ASSERT_FALSE(ranges.cut_anyway);
    EXPECT_EQ(ranges.guard_bits, 0);
    Config config = with_ranges(kFull, ranges);
    ASSERT_EQ(validate(config), "");
    EXPECT_EQ(refusal(views, config), "");
    EXPECT_LE(views[0].frame.height, config.max_size());
    EXPECT_GT(std::max(views[0].frame.width, views[0].frame.height), config.max_size() / 2);
    --config.extent_bits;
    const std::string text = refusal(views, config);
    EXPECT_NE(text.find("triangle "), std::string::npos) << text;
    EXPECT_NE(text.find("fitted to less than"), std::string::npos) << text;
  }
}

TEST(FitRanges, TheWidestTriangleIsNamedAndAttained) {
  const auto views = views_of("cube.gltf", 300, 200);
  const FitRanges ranges = fit_ranges(views, kFull);
  Config config = with_ranges(kFull, ranges);
  std::int64_t widest = 0;
  std::uint32_t tag = 0;
  RunStats stats;
  views[0].scene->draw(0, views[0].frame, config, stats, [&](const ShadedTriangle& shaded) {
    const auto& v = shaded.triangle.vertex;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t d =
          std::max(std::abs(v[i].x - v[(i + 1) % 3].x), std::abs(v[i].y - v[(i + 1) % 3].y));
      if (d > widest) tag = shaded.triangle.tag;
      widest = std::max(widest, d);
    }
  });
  EXPECT_EQ(ranges.extent, widest);
  EXPECT_LE(widest, config.extent_max());
  EXPECT_GT(2 * widest, config.extent_max());
  EXPECT_NE(ranges.widest.find("triangle " + std::to_string(tag)), std::string::npos);
}

TEST(FitRanges, AGuardBandAppearsOnlyWhenTrianglesLeaveTheFrame) {
  CameraOptions close;
  close.eye = glm::dvec3{0.5, 0.4, 1.6};
  close.fov_y_degrees = 20;
  const auto views = views_of("torus.ply", 128, 128, close);
  const FitRanges ranges = fit_ranges(views, kFull);
  ASSERT_FALSE(ranges.cut_anyway);
  ASSERT_GT(ranges.guard_bits, 0);
  Config config = with_ranges(kFull, ranges);
  EXPECT_EQ(refusal(views, config), "");
  config.guard_bits = 0;
  config.extent_bits = config.viewport_bits;
  EXPECT_NE(refusal(views, config).find("leaves the frame"), std::string::npos);
}

TEST(FitRanges, TrianglesThroughTheEyesPlaneAreLeftToTheWidthsOfFull) {
  CameraOptions inside;
  inside.eye = glm::dvec3{0.0, 0.0, 0.0};
  inside.target = glm::dvec3{0.3, 0.2, 1.0};
  inside.fov_y_degrees = 60;
  const auto views = views_of("cube.gltf", 128, 128, inside);
  const FitRanges ranges = fit_ranges(views, kFull);
  ASSERT_TRUE(ranges.cut_anyway);
  EXPECT_EQ(ranges.extent_bits, 0);
  EXPECT_EQ(ranges.guard_bits, kFull.guard_bits);
  EXPECT_EQ(refusal(views, with_ranges(kFull, ranges)), "");
}

// What coverage_curve() finds near the outlines, found by asking about every pixel.
TEST(FitCoverage, CurveEqualsTheOracleAskedAboutEveryPixel) {
  const auto views = views_of("teapot.obj", 60, 44);
  for (const int samples : {1, 4}) {
    const Config base{.viewport_bits = 6, .samples = samples};
    const CoverageCurve curve = coverage_curve(views, base, 1'000'000);
    EXPECT_EQ(curve.triangles, curve.of);
    for (const int s : {0, 2, 8}) {
      Config config = base;
      config.subpixel_bits = s;
      config.tag_bits = 32;
      std::vector<Triangle> snapped(curve.of);
      RunStats stats;
      views[0].scene->draw(0, views[0].frame, config, stats,
                           [&](const ShadedTriangle& t) { snapped[t.triangle.tag] = t.triangle; });
      CoverageError expected;
      views[0].scene->real(0, [&](const RealTriangle& real) {
        const auto& v = real.vertex;
        const oracle::Corners truth{{{v[0].x, v[0].y}, {v[1].x, v[1].y}, {v[2].x, v[2].y}}};
        oracle::Corners moved;
        for (std::size_t i = 0; i < 3; ++i) {
          const Point p = snapped[real.index].vertex[i];
          moved[i] = {std::ldexp(p.x, -s), std::ldexp(p.y, -s)};
        }
        for (int y = 0; y < 44; ++y) {
          for (int x = 0; x < 60; ++x) {
            const auto at = oracle::standard_samples(samples);
            const std::uint32_t want = oracle::pixel_mask(truth, x, y, at);
            const std::uint32_t got = oracle::pixel_mask(moved, x, y, at);
            expected.covered += static_cast<std::uint64_t>(std::popcount(want));
            expected.missing += static_cast<std::uint64_t>(std::popcount(want & ~got));
            expected.extra += static_cast<std::uint64_t>(std::popcount(got & ~want));
          }
        }
      });
      const CoverageError& found = curve.error[static_cast<std::size_t>(s)];
      EXPECT_EQ(found.covered, expected.covered) << "samples " << samples << " s " << s;
      EXPECT_EQ(found.missing, expected.missing) << "samples " << samples << " s " << s;
      EXPECT_EQ(found.extra, expected.extra) << "samples " << samples << " s " << s;
    }
  }
}

TEST(Fit, TheFewestSubpixelBitsKeepTheLimitAndDrawWhatFullDraws) {
  const auto views = views_of("teapot.obj", 320, 240);
  FitOptions options;
  options.max_error = 1000;
  options.max_attribute_error = 1.0;
  const FitResult result = fit(views, options);
  const auto s = static_cast<std::size_t>(result.config.subpixel_bits);
  EXPECT_LE(result.coverage->error[s].ppm(), 1000);
  EXPECT_GT(result.coverage->error[s - 1].ppm(), 1000);
  EXPECT_LE(result.attribute_error, 1.0);
  EXPECT_LT(result.config.reciprocal_bits, kFull.reciprocal_bits);
  EXPECT_EQ(result.samples_different, 0u);
  EXPECT_GT(result.samples_covered, 10'000u);
  EXPECT_LT(area_estimate(result.config).luts(), area_estimate(kFull).luts() / 2);
}

TEST(Fit, OppositeScenesGetOppositeShapes) {
  FitOptions options;
  options.max_error = 1000;
  options.target = parse_target("20px/clk");
  const FitResult large = fit(views_of("cube.gltf", 640, 480), options);
  EXPECT_EQ(large.config.grid_log2, 3);
  EXPECT_LE(large.config.subpixel_bits, 5);
  options.target.reset();
  const FitResult small = fit(views_of("bunny.obj", 320, 240), options);
  EXPECT_EQ(small.config.grid_log2, 2);
  EXPECT_GE(small.config.subpixel_bits, 8);
  EXPECT_LT(small.config.extent_bits + 3, large.config.extent_bits);
}

TEST(Fit, LimitsOutOfReachAreRefused) {
  const auto views = views_of("cube.gltf", 100, 100);
  FitOptions options;
  options.max_error = 0;
  const auto code = [&] {
    try {
      fit(views, options);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  if (fit(views, {}).samples_covered > 0 &&
      coverage_curve(views, kFull, 1'000'000).error[12].ppm() > 0) {
    EXPECT_EQ(code(), ErrorCode::kFitLimit);
  }
  options = {};
  options.target = parse_target("65px/clk");
  EXPECT_EQ(code(), ErrorCode::kFitLimit);
  options = {};
  options.max_attribute_error = 0.1;
  EXPECT_EQ(code(), ErrorCode::kFitLimit);
}

TEST(FitTarget, ReadsTwoFormsAndRefusesOthers) {
  EXPECT_EQ(parse_target("2.5px/clk").pixels_per_clock, 2.5);
  EXPECT_EQ(parse_target("60fps@100MHz").frames_per_second, 60);
  EXPECT_EQ(parse_target("60fps@100MHz").megahertz, 100);
  for (const char* text : {"", "px/clk", "0px/clk", "-1px/clk", "3px", "60fps", "60fps@",
                           "60fps@MHz", "60fps@-5MHz", "60fps@100GHz", "2px/clkx", "nanpx/clk"}) {
    EXPECT_THROW(parse_target(text), Error) << text;
  }
}

TEST(AreaModel, IsWithinTheStatedErrorOfEveryMeasuredConfiguration) {
  const auto data = nlohmann::json::parse(
      read_file(std::string(HALFSPACE_TEST_DIR) + "/../docs/charts/fit_area.json"));
  ASSERT_GE(data["configurations"].size(), 10u);
  for (const auto& entry : data["configurations"]) {
    Config c;
    const auto& from = entry["config"];
    c.subpixel_bits = from["subpixel_bits"];
    c.viewport_bits = from["viewport_bits"];
    c.guard_bits = from["guard_bits"];
    c.extent_bits = from["extent_bits"];
    c.samples = from["samples"];
    c.grid_log2 = from["grid_log2"];
    c.setup_interval = from["setup_interval"];
    c.tag_bits = from["tag_bits"];
    ASSERT_EQ(validate(c), "");
    const AreaEstimate estimate = area_estimate(c);
    const double luts = entry["measured"]["luts"];
    const double flip_flops = entry["measured"]["ff"];
    EXPECT_NEAR(estimate.luts(), luts, luts * kAreaErrorPercent / 100) << from;
    EXPECT_NEAR(estimate.flip_flops, flip_flops, flip_flops * kFlipFlopErrorPercent / 100) << from;
    EXPECT_EQ(estimate.multipliers, entry["measured"]["mult18"].get<double>()) << from;
  }
}

}  // namespace
}  // namespace halfspace
