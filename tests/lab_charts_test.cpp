// SPDX-License-Identifier: Apache-2.0
#include "lab/charts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "lab/real_scene.hpp"

namespace halfspace::lab {
namespace {

RealScene small_scene() { return random_scene(901, 3000, 16, 256, 256); }

TEST(LabCharts, EachSubpixelBitAboutHalvesTheError) {
  const RealScene scene = small_scene();
  const Json data = subpixel_chart(&scene);
  std::vector<double> ppm;
  for (const Json& row : data["scenes"][0]["rows"]) {
    if (row["snap"] == "nearest_even") ppm.push_back(row["wrong_ppm"]);
  }
  ASSERT_EQ(ppm.size(), 13u);
  for (std::size_t s = 1; s < 8; ++s) {
    EXPECT_GT(ppm[s - 1] / ppm[s], 1.5) << "s = " << s;
    EXPECT_LT(ppm[s - 1] / ppm[s], 2.6) << "s = " << s;
  }
  // Known for 16 px triangles: 15,428 at s = 4, 909 at s = 8; half and double at most.
  EXPECT_GT(ppm[4], 15428 / 2.0);
  EXPECT_LT(ppm[4], 15428 * 2.0);
  EXPECT_GT(ppm[8], 909 / 2.0);
  EXPECT_LT(ppm[8], 909 * 2.0);
}

TEST(LabCharts, TruncationIsWorseThanRounding) {
  const RealScene scene = small_scene();
  const Json data = subpixel_chart(&scene);
  const Json& rows = data["scenes"][0]["rows"];
  for (std::size_t s = 0; s <= 8; ++s) {
    ASSERT_EQ(rows[s]["subpixel_bits"], rows[s + 13]["subpixel_bits"]);
    EXPECT_GT(rows[s + 13]["wrong_ppm"].get<double>(), rows[s]["wrong_ppm"].get<double>()) << s;
  }
}

TEST(LabCharts, TheFormulasBitsAreExactAndOneFewerIsNot) {
  const Json data = accumulator_chart(nullptr);
  ASSERT_EQ(data["scenes"].size(), 6u);
  for (const Json& scene : data["scenes"]) {
    EXPECT_EQ(scene["formula_bits"], scene["needed_bits"]) << scene["name"];
    for (const Json& row : scene["rows"]) {
      const bool enough = row["bits"].get<int>() >= scene["formula_bits"].get<int>();
      EXPECT_EQ(row["wrong"].get<std::uint64_t>() == 0, enough)
          << scene["name"] << ", " << row["bits"] << " bits";
    }
  }
}

TEST(LabCharts, MoreBitsNeverInterpolateMuchWorse) {
  const RealScene scene = random_scene(902, 300, 24, 256, 256);
  const Json data = interpolation_chart(&scene);
  const Json& by_r = data["by_reciprocal_bits"];
  ASSERT_EQ(by_r.size(), 11u);
  for (std::size_t i = 1; i < by_r.size(); ++i) {
    EXPECT_LT(by_r[i]["attribute_max_lsb"].get<double>(),
              by_r[i - 1]["attribute_max_lsb"].get<double>() + 0.02);
  }
  EXPECT_LT(by_r.back()["attribute_max_lsb"].get<double>(), 0.54);
  EXPECT_GT(by_r.front()["attribute_max_lsb"].get<double>(), 2.0);
  EXPECT_LT(data["by_gradient_bits"].back()["depth_max_lsb"].get<double>(), 0.66);
  EXPECT_GT(data["by_gradient_bits"][0]["depth_max_lsb"].get<double>(), 0.66);
}

// The 16 px tiles are counted by the chart alone; the counts must be those of the model where it
// has the tile, so the smaller ones are counted twice: a larger tile can only hold a smaller one.
TEST(LabCharts, LargerTilesWasteMoreAndCoverMoreAClock) {
  const RealScene scene = random_scene(903, 400, 64, 512, 512);
  const Json data = efficiency_chart(&scene);
  ASSERT_EQ(data["tiles"].size(), 3u);
  for (std::size_t i = 1; i < 3; ++i) {
    const Json& small = data["tiles"][i - 1]["total"];
    const Json& large = data["tiles"][i]["total"];
    EXPECT_EQ(small["samples_covered"], large["samples_covered"]);
    EXPECT_GT(small["efficiency"].get<double>(), large["efficiency"].get<double>());
    EXPECT_LT(small["pixels_per_clock"].get<double>(), large["pixels_per_clock"].get<double>());
    EXPECT_GE(small["tiles_tested"].get<std::uint64_t>(),
              large["tiles_tested"].get<std::uint64_t>());
    EXPECT_LE(small["tiles_tested"].get<std::uint64_t>(),
              4 * large["tiles_tested"].get<std::uint64_t>());
  }
}

TEST(LabCharts, TheEngineIsAsWrongAsTheStagesAtEveryWidth) {
  const RealScene scene = random_scene(905, 40, 24, 96, 96);
  const Json data = methods_chart(&scene);
  std::map<std::string, double> wrong;
  for (const Json& p : data["panels"][0]["points"]) wrong[p["method"]] = p["wrong_ppm"];
  for (int bits = 0; bits <= 12; ++bits) {
    const std::string width = std::to_string(bits);
    ASSERT_TRUE(wrong.count("engine_s" + width)) << bits;
    EXPECT_EQ(wrong["engine_s" + width], wrong["halfspace_s" + width]) << bits;
  }
  EXPECT_GT(wrong["engine_s0"], 4 * wrong["engine_s4"]);
}

TEST(LabCharts, OraclePixelsAreTheModelsWhenVerticesAreOnTheGrid) {
  RealScene scene = random_scene(904, 500, 20, 128, 128);
  for (oracle::Corners& t : scene.triangles) {
    for (oracle::Vec& v : t) v = {std::nearbyint(v.x * 256) / 256, std::nearbyint(v.y * 256) / 256};
  }
  const Config config;
  const Difference d =
      compare(model_pixels(snapped(scene, config), scene, config), oracle_pixels(scene));
  EXPECT_GT(d.covered, 10000u);
  EXPECT_EQ(d.missing + d.extra, 0u);
}

}  // namespace
}  // namespace halfspace::lab
