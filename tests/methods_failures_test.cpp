// SPDX-License-Identifier: Apache-2.0
//
// Every failure that docs/05_methods quotes, reproduced: exactly where the figure does not depend
// on the order of float operations, within a factor of two where it does.
#include <bit>
#include <cmath>

#include "methods/clipping.hpp"
#include "methods/implicit_line.hpp"
#include "methods/mask_table.hpp"
#include "methods_support.hpp"
#include "vectors/generators.hpp"

namespace halfspace::methods {
namespace {

using oracle::HitErrors;

constexpr oracle::Window kSmall{16, 16, 0, 0};

TEST(Failures, StrictEdgesLose22Of64PixelsAndTheirMeshesGap) {
  const HitErrors quad = errors_of("edge_float_strict", oracle::quad_on_samples(), kSmall);
  EXPECT_EQ(quad.covered, 64u);
  EXPECT_EQ(quad.gaps, 22u);
  EXPECT_EQ(quad.doubles, 0u);
  expect_about(errors_of("edge_float_strict", oracle::needle_fan(), kMegapixel).ppm(), 4579, "fan");
  expect_about(errors_of("edge_float_strict", oracle::mesh_h(), kMegapixel).ppm(), 24186, "mesh_h");
}

TEST(Failures, InclusiveEdgesDraw25PixelsTooMany) {
  for (const char* name : {"edge_float_inclusive", "fill_draw_ties", "hack_or_strict"}) {
    const HitErrors quad = errors_of(name, oracle::quad_on_samples(), kSmall);
    EXPECT_EQ(quad.doubles, 25u) << name;
    EXPECT_EQ(quad.gaps, 0u) << name;
    // Eight of them lie on the diagonal and were drawn twice.
    const Canvas canvas = drawn(method(name), oracle::quad_on_samples(), kSmall);
    int twice = 0;
    for (int i = 1; i < 9; ++i) twice += canvas.hits()[canvas.index(i, i)] == 2 ? 1 : 0;
    EXPECT_EQ(twice, 8) << name;
    const HitErrors mesh = errors_of(name, oracle::mesh_h(), kMegapixel);
    expect_about(mesh.ppm(), 24189, name);
    EXPECT_EQ(mesh.gaps, 0u) << name;
  }
}

TEST(Failures, CrossProductConstantCancelsWithTheOffset) {
  const auto ppm = [](const char* name, int offset) {
    return errors_of(name, oracle::mesh16(offset), {1024, 1024, offset, offset}).ppm();
  };
  expect_about(ppm("edge_float_cross", 4096), 421, "offset 4096");
  expect_about(ppm("edge_float_cross", 15800), 6246, "offset 15800");
  EXPECT_LT(ppm("edge_float_cross", 0), 27);
  for (const int offset : {0, 4096, 15800}) {
    EXPECT_EQ(ppm("edge_float_relative", offset), 0) << offset;
    EXPECT_EQ(ppm("edge_double_cross", offset), 0) << offset;
  }
  // Averaging is the better constant at every offset, as the notes say. (Both triangles at an edge
  // compute exact negatives, so what is left is below the 216 ppm of a sum along the rows.)
  EXPECT_LT(ppm("edge_float_average", 15800), 216);
  EXPECT_LT(ppm("edge_float_average", 15800), ppm("edge_float_vertex", 15800));
  EXPECT_LT(ppm("edge_float_vertex", 15800), ppm("edge_float_cross", 15800));
}

TEST(Failures, IncrementalFloatEdgesDriftAlongLongRows) {
  // Edges whose steps need more bits than are left beside a large edge value.
  const auto big = oracle::jittered_mesh({.size = 4096, .cell = 2048, .amplitude = 0.2});
  const oracle::Window window{4096, 4096, 0, 0};
  EXPECT_EQ(errors_of("hack_incremental", big, window).wrong, 0u);
  const HitErrors direct = errors_of("edge_float_relative", big, window);
  const HitErrors summed = errors_of("hack_incremental_float", big, window);
  EXPECT_GT(summed.wrong, direct.wrong);
}

TEST(Failures, BarycentricAreasInFloatDoubleOnMesh4) {
  const HitErrors e = errors_of("bary_shoelace_float", oracle::mesh4(), kMegapixel);
  expect_about(e.ppm(), 4350, "mesh4");
  EXPECT_GT(e.doubles, 19 * e.gaps);  // nearly all double
}

TEST(Failures, OffscreenPointLeavesTheDiagonalToNobody) {
  for (const char* name : {"offscreen_float", "offscreen_double"}) {
    const Canvas canvas = drawn(method(name), oracle::quad_on_samples(), kSmall);
    for (int i = 2; i < 9; ++i) EXPECT_EQ(canvas.hits()[canvas.index(i, i)], 0u) << name;
  }
  expect_about(errors_of("offscreen_float", oracle::mesh_h(), kMegapixel).ppm(), 427, "mesh_h");
  expect_about(errors_of("offscreen_float", oracle::needle_fan(), kMegapixel).ppm(), 1034, "fan");
}

TEST(Failures, ScaledLinesGapAndDivideByZero) {
  const HitErrors e = errors_of("scaled_float_inclusive", oracle::mesh_h(), kMegapixel);
  const double gaps_ppm = 1e6 * static_cast<double>(e.gaps) / static_cast<double>(e.covered);
  expect_about(gaps_ppm, 723, "gaps of mesh_h");
  const auto t = oracle::collinear();
  const auto line = implicit_line<float>({t[0].x, t[0].y}, {t[1].x, t[1].y});
  const float k = line.at({t[2].x, t[2].y});
  EXPECT_EQ(k, 0.0f);
  EXPECT_TRUE(std::isnan(line.at({20.5, 20.5}) / k));
}

TEST(Failures, ClosedSpansDoubleAndNoPrestepLosesSlivers) {
  expect_about(errors_of("walk_closed", oracle::mesh16(), kMegapixel).ppm(), 134635, "mesh16");
  expect_about(errors_of("walk_closed", oracle::mesh4(), kMegapixel).ppm(), 458945, "mesh4");
  EXPECT_EQ(errors_of("walk_closed", oracle::mesh16(), kMegapixel).gaps, 0u);
  const oracle::Window window{96, 16, 0, 0};
  const HitErrors sliver = errors_of("walk_no_prestep", {oracle::thin_sliver()}, window);
  EXPECT_EQ(sliver.covered, 29u);
  EXPECT_EQ(sliver.gaps, 29u);
  EXPECT_EQ(errors_of("walk_prestep", {oracle::thin_sliver()}, window).wrong, 0u);
  expect_about(errors_of("walk_no_prestep", oracle::mesh16(), kMegapixel).ppm(), 1606, "mesh16");
}

TEST(Failures, ParityNeedsYminInAndYmaxOut) {
  Polygon diamond{{{}}};
  for (const oracle::Vec& v : oracle::diamond()) diamond.rings[0].push_back({v.x, v.y});
  const auto covered = [&](const char* name) {
    Canvas canvas(10, 10);
    std::get<DrawPolygon>(method(name).draw)(diamond, canvas);
    int count = 0;
    for (const std::uint32_t h : canvas.hits()) count += h == 1 ? 1 : 0;
    return count;
  };
  EXPECT_EQ(covered("parity_closed"), 24);
  EXPECT_EQ(covered("parity_open"), 24);
  EXPECT_EQ(covered("parity_top_in"), 32);
  EXPECT_EQ(covered("parity_exact"), 32);
  EXPECT_EQ(covered("aet_double"), 32);
}

TEST(Failures, DividingByWWithoutClippingGetsMostOfTheScreenWrong) {
  // A floor that reaches behind the eye; z = w - 2 near, so that the near plane is w = near.
  constexpr double kNear = 0.01;
  const auto at = [](double x, double y, double w) {
    return ClipPoint{{x, y, w - 2 * kNear, w}, {}};
  };
  const ClipFacet floor{at(-4, -1, 4), at(4, -1, 4), at(0, -1, -0.5)};
  View view;
  view.width = view.height = 256;
  const auto hits = [&](const char* name) {
    Canvas canvas(256, 256);
    std::get<DrawClip>(method(name).draw)(floor, view, canvas);
    return canvas.hits();
  };
  const auto clipped = hits("clip_near"), divided = hits("clip_none");
  int wrong = 0;
  for (std::size_t i = 0; i < clipped.size(); ++i) wrong += clipped[i] != divided[i] ? 1 : 0;
  EXPECT_NEAR(wrong / 65536.0, 0.826, 0.005);
  EXPECT_EQ(hits("clip_six"), hits("clip_guard_band"));
}

TEST(Failures, MaskTablesAreAsFineAsTheirBorderSteps) {
  Random random(11);
  const auto real = [&random] { return static_cast<double>(random.in(0, 1 << 20)) / (1 << 17); };
  std::uint64_t bits = 0;
  std::array<std::uint64_t, 4> wrong{};
  for (int i = 0; i < 200'000; ++i) {
    // A line through two points of the tile, its direction random.
    const double x0 = real(), y0 = real(), x1 = real(), y1 = real();
    const TileLine line{y0 - y1, x1 - x0, x0 * y1 - x1 * y0};
    TileMask exact = 0;
    for (int p = 0; p < 64; ++p) {
      if (line.a * (p % 8 + 0.5) + line.b * (p / 8 + 0.5) + line.c >= 0) exact |= TileMask{1} << p;
    }
    bits += 64;
    const std::array<TileMask, 4> masks{
        table_mask(line, 8, Crossing::kTruncated), table_mask(line, 64, Crossing::kTruncated),
        table_mask(line, 8, Crossing::kNearest), table_mask(line, 64, Crossing::kNearest)};
    for (std::size_t m = 0; m < 4; ++m) {
      wrong[m] += static_cast<std::uint64_t>(std::popcount(exact ^ masks[m]));
    }
  }
  const auto ppm = [bits](std::uint64_t w) {
    return 1e6 * static_cast<double>(w) / static_cast<double>(bits);
  };
  expect_about(ppm(wrong[0]), 5061, "8 steps a pixel");
  expect_about(ppm(wrong[1]), 714, "64 steps a pixel");
  for (std::size_t m = 0; m < 2; ++m) {
    // Crossings rounded to the nearest step, as the gallery does, are a third better.
    EXPECT_NEAR(ppm(wrong[m + 2]) / ppm(wrong[m]), 0.67, 0.1) << m;
  }
}

TEST(Failures, EverySubpixelBitHalvesTheErrorAgainstRealVertices) {
  const auto triangles = oracle::random_triangles(12, 20'000, 16, 1008);
  const auto ppm = [&](int bits) {
    return hit_errors_alone(method("halfspace_s" + std::to_string(bits)), triangles).ppm();
  };
  expect_about(ppm(4), 15428, "s = 4");
  expect_about(ppm(6), 3956, "s = 6");
  expect_about(ppm(8), 909, "s = 8");
  expect_about(ppm(10), 284, "s = 10");
}

}  // namespace
}  // namespace halfspace::methods
