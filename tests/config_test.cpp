// SPDX-License-Identifier: Apache-2.0
#include "config.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "compare.hpp"
#include "extremes.hpp"
#include "fixed.hpp"
#include "samples.hpp"
#include "vectors/generators.hpp"

namespace halfspace {
namespace {

constexpr Config k2048{.viewport_bits = 11, .guard_bits = 0};

TEST(Config, WidthsOfTheDocumentedExamples) {
  const auto expect = [](const Config& config, int delta, int full, int edge, int tile) {
    EXPECT_EQ(config.delta_bits(), delta) << describe(config);
    EXPECT_EQ(config.edge_full_bits(), full) << describe(config);
    EXPECT_EQ(config.edge_bits(), edge) << describe(config);
    EXPECT_EQ(config.node_bits(3), tile) << describe(config);
  };
  expect(k2048, 21, 39, 31, 24);
  expect(kFull, 23, 45, 37, 27);
  expect(kD3d, 25, 49, 41, 29);
}

TEST(Config, PresetsAreLegalAndFoundByName) {
  for (const Preset& preset : kPresets) {
    EXPECT_EQ(validate(preset.config), "") << preset.name;
    EXPECT_EQ(find_preset(preset.name), preset.config);
  }
  EXPECT_EQ(find_preset("nothing"), std::nullopt);
}

TEST(Config, LegalCoordinatesReachTheGuardBandOrTheFramesFarEdge) {
  EXPECT_EQ(kFull.coordinate_max(), 8192 * 256 - 1);  // strictly less than 2^13 px
  EXPECT_EQ(kFull.coordinate_min(), -8192 * 256 + 1);
  EXPECT_EQ(kTiny.coordinate_max(), 512 * 16);  // the far edge itself is legal
  EXPECT_EQ(kTiny.coordinate_min(), 0);
  EXPECT_EQ(kD3d.coordinate_max(), 32768 * 256 - 1);
}

TEST(Config, PyramidCoversTheViewportWithTheFewestLevels) {
  for (int n = 3; n <= 15; ++n) {
    for (int g = 2; g <= 3; ++g) {
      const Config config{.viewport_bits = n, .guard_bits = 0, .grid_log2 = g};
      EXPECT_GE(config.node_log2(0), n);
      EXPECT_LT(config.node_log2(1), n);
      EXPECT_EQ(config.node_log2(config.levels() - 1), g);
    }
  }
}

struct Field {
  const char* name;
  ConfigField value;
  int low;
  int high;
};

TEST(Config, EveryFieldJustOutsideItsRangeIsRefusedByName) {
  const std::vector<Field> fields{{"subpixel_bits", &Config::subpixel_bits, 0, 12},
                                  {"viewport_bits", &Config::viewport_bits, 3, 15},
                                  {"guard_bits", &Config::guard_bits, 12, 16},
                                  {"extent_bits", &Config::extent_bits, 0, 14},
                                  {"samples", &Config::samples, 1, 16},
                                  {"grid_log2", &Config::grid_log2, 2, 3},
                                  {"setup_interval", &Config::setup_interval, 1, 3},
                                  {"tag_bits", &Config::tag_bits, 1, 32},
                                  {"depth_bits", &Config::depth_bits, 16, 32},
                                  {"attributes", &Config::attributes, 0, 8},
                                  {"inverse_w_bits", &Config::inverse_w_bits, 12, 30},
                                  {"gradient_bits", &Config::gradient_bits, 0, 20},
                                  {"reciprocal_bits", &Config::reciprocal_bits, 6, 16}};
  for (const Field& field : fields) {
    for (const int value : {field.low, field.high, field.low - 1, field.high + 1}) {
      Config config;  // viewport_bits 12, so that guard_bits starts at 12
      config.*field.value = value;
      if (field.value == &Config::viewport_bits) config.guard_bits = 0;
      const bool legal = value >= field.low && value <= field.high;
      const std::string wrong = validate(config);
      EXPECT_EQ(wrong.empty(), legal) << field.name << " = " << value;
      if (legal) continue;
      EXPECT_EQ(wrong.rfind(std::string(field.name) + " = " + std::to_string(value), 0), 0u)
          << wrong;
    }
  }
}

TEST(Config, ValuesInTheHolesOfARangeAreRefused) {
  for (const int samples : {3, 5, 6, 7, 9, 12, 15, -4}) {
    EXPECT_NE(validate(Config{.samples = samples}), "") << samples;
  }
  EXPECT_NE(validate(Config{.setup_interval = 2}), "");
  EXPECT_NE(validate(Config{.guard_bits = 11}), "");  // less than the viewport
  EXPECT_NE(validate(Config{.viewport_bits = 14}), "");
  EXPECT_NE(validate(Config{.guard_bits = -1}), "");
  EXPECT_EQ(validate(Config{.guard_bits = 0}), "");
}

TEST(Config, SamplePositionsAreWholeInTheirBits) {
  for (const int samples : {1, 2, 4, 8, 16}) {
    const Config config{.samples = samples};
    const int step = 16 >> config.sample_position_bits();
    bool finer = false;  // some position needs the last bit
    for (const SamplePosition p : sample_positions(samples)) {
      EXPECT_EQ(p.x % step, 0);
      EXPECT_EQ(p.y % step, 0);
      finer = finer || p.x % (2 * step) != 0 || p.y % (2 * step) != 0;
    }
    EXPECT_TRUE(finer) << samples;
  }
}

TEST(Config, SampleTableIsTheStandardsInOrder) {
  for (const int samples : {1, 2, 4, 8, 16}) {
    const auto mine = sample_positions(samples);
    const auto standard = oracle::standard_samples(samples);
    ASSERT_EQ(mine.size(), standard.size());
    for (std::size_t m = 0; m < mine.size(); ++m) {
      EXPECT_EQ(mine[m].x, 16 * standard[m].x) << samples << " samples, number " << m;
      EXPECT_EQ(mine[m].y, 16 * standard[m].y) << samples << " samples, number " << m;
    }
  }
}

// Every width of triangle_setup over every triangle of the widest vertices, at the frame's
// outermost samples, from the formulas of docs/03_design/triangle_setup.md in 64 bits.
struct SetupExtremes {
  Extremes vertex, delta, area, full, dropped;
};

SetupExtremes setup_extremes(const Config& config) {
  SetupExtremes seen;
  const int up = config.position_bits() - config.subpixel_bits;
  const int last = config.max_size() - 1;
  std::vector<Point> sample;  // in 2^-f px
  for (const SamplePosition p : sample_positions(config.samples)) {
    for (const int y : {0, last}) {
      for (const int x : {0, last}) {
        sample.push_back({((16 * x + p.x) << config.position_bits()) >> 4,
                          ((16 * y + p.y) << config.position_bits()) >> 4});
      }
    }
  }
  for (const Triangle& triangle : widest_triangles(config)) {
    const auto& v = triangle.vertex;
    const std::int64_t area = std::int64_t{v[1].x - v[0].x} * (v[2].y - v[0].y) -
                              std::int64_t{v[2].x - v[0].x} * (v[1].y - v[0].y);
    seen.area.see(area);
    for (std::size_t i = 0; i < 3 && area != 0; ++i) {
      const Point from = v[area > 0 ? i : (i + 1) % 3];
      const Point to = v[area > 0 ? (i + 1) % 3 : i];
      const std::int64_t a = from.y - to.y;
      const std::int64_t b = to.x - from.x;
      const int bias = a > 0 || (a == 0 && b > 0) ? 0 : -1;
      for (const std::int64_t value : {from.x, from.y}) seen.vertex.see(value);
      for (const std::int64_t value : {a, b}) seen.delta.see(value);
      for (const Point p : sample) {
        const std::int64_t e = a * (p.x - (std::int64_t{from.x} << up)) +
                               b * (p.y - (std::int64_t{from.y} << up)) + bias;
        seen.full.see(e);
        seen.dropped.see(floor_shift(e, config.dropped_bits()));
      }
    }
  }
  return seen;
}

TEST(Config, SetupWidthsHoldTheWidestTrianglesAndOneBitFewerDoesNot) {
  for (const int samples : {1, 2, 4, 8, 16}) {
    for (const int s : {0, 1, 3, 5}) {
      for (const int k : {0, 3, 4, 6}) {
        const Config config{
            .subpixel_bits = s, .viewport_bits = 3, .guard_bits = k, .samples = samples};
        const SetupExtremes seen = setup_extremes(config);
        expect_sharp(seen.vertex, config.vertex_bits(), "vertex", config);
        expect_sharp(seen.delta, config.delta_bits(), "A, B", config);
        expect_sharp(seen.area, config.area_bits(), "area", config);
        expect_sharp(seen.full, config.edge_full_bits(), "E", config);
        expect_sharp(seen.dropped, config.edge_bits(), "e", config);
      }
    }
  }
}

// A leaf near the diagonal that a steep edge x + y = c cuts: cut one bit narrower, its value at the
// leaf's origin would give some sample the wrong sign.
TEST(Config, LeafNodeWidthIsNeededInEveryPreset) {
  for (const Preset& preset : kPresets) {
    const Config& config = preset.config;
    const int size = config.max_size();
    const FrameState frame{size, size, Cull::kNone};
    const bool guard = config.has_guard_band();
    const int x = guard ? 0 : size / 2;
    const int y = guard ? 0 : size / 2 - config.grid();
    const auto low = static_cast<std::int32_t>(config.coordinate_min());
    const auto high = static_cast<std::int32_t>(config.coordinate_max());
    const int narrower = config.node_bits(config.grid_log2) - 1;
    bool needed = false;
    for (int cut = x + y + 1; cut <= x + y + 2 * config.grid(); ++cut) {
      const std::int32_t c = cut << config.subpixel_bits;
      const bool near = !guard && c <= high;  // the line leaves the square by x = 0 and y = 0
      const Triangle t{{{near ? Point{c, 0} : Point{high, c - high},
                         near ? Point{0, c} : Point{c - high, high}, Point{low, low}}},
                       0};
      const auto setup = triangle_setup(t, frame, config);
      ASSERT_TRUE(setup);
      const auto leaf = model_leaf(*setup, x, y, config);
      if (!leaf) continue;
      for (int m = 0; m < config.samples; ++m) {
        const SamplePosition at = sample_offset(config, m);
        const int inside = (config.grid() - 1) << config.sample_bits();
        const std::int64_t walk = std::int64_t{setup->slope[0].a} * (inside + at.x) +
                                  std::int64_t{setup->slope[0].b} * (inside + at.y);
        needed = needed || (leaf->e[0] + walk >= 0) != (saturate(leaf->e[0], narrower) + walk >= 0);
      }
    }
    EXPECT_TRUE(needed) << preset.name;
  }
}

TEST(Config, LaneWidthIsNeededInEveryPreset) {
  for (const Preset& preset : kPresets) {
    const Config& config = preset.config;
    const int size = config.max_size();
    const int last = config.grid() - 1;
    Extremes seen;
    for (const Triangle& t : widest_triangles(config)) {
      const auto setup = triangle_setup(t, {size, size, Cull::kNone}, config);
      if (!setup) continue;
      for (const int corner : {0, 1, 2, 3}) {
        const int x = (corner & 1) * (size - config.grid());
        const int y = (corner >> 1) * (size - config.grid());
        const auto leaf = model_leaf(*setup, x, y, config);
        if (!leaf) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          const std::int64_t base = floor_shift(leaf->e[i], config.sample_bits());
          for (const int lane : {0, 1, 2, 3}) {
            seen.see(base + std::int64_t{setup->slope[i].a} * (lane & 1) * last +
                     std::int64_t{setup->slope[i].b} * (lane >> 1) * last);
          }
        }
      }
    }
    expect_sharp(seen, config.lane_bits(), "lane", config);
  }
}

}  // namespace
}  // namespace halfspace
