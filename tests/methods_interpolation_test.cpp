// SPDX-License-Identifier: Apache-2.0
//
// How far attributes and lines are from the truth, by the bits that they are given.
#include <cmath>

#include "methods/attribute_shading.hpp"
#include "methods_support.hpp"
#include "vectors/generators.hpp"

namespace halfspace::methods {
namespace {

TEST(Interpolation, ReciprocalBitsBoundTheErrorOfAnAttribute) {
  const std::vector<Facet> facets = shaded_triangles(21, 40'000);
  const std::array<std::pair<int, double>, 4> figures{
      {{8, 0.46}, {10, 0.116}, {12, 0.030}, {16, 0.002}}};
  for (const auto& [bits, figure] : figures) {
    const std::string name = "shade_reciprocal_r" + std::to_string(bits);
    const oracle::ErrorSummary e = attribute_errors(method(name), facets, true);
    EXPECT_GT(e.count, 100'000u);
    EXPECT_EQ(e.not_finite, 0u);
    expect_about(e.greatest, figure, name);
    EXPECT_LE(e.greatest, 255 * std::ldexp(1.0, -bits - 1) * 1.0001) << name;  // the bound
  }
  EXPECT_LT(attribute_errors(method("shade_perspective"), facets, true).greatest, 1e-9);
}

TEST(Interpolation, ReciprocalIsRoundedToItsBits) {
  for (int i = 1; i < 4000; ++i) {
    const double v = i * 0.37;
    for (const int bits : {8, 16}) {
      EXPECT_LE(std::abs(reciprocal(v, bits) * v - 1), std::ldexp(1.0, -bits - 1) * 1.0001) << v;
    }
  }
  EXPECT_EQ(reciprocal(4.0, 8), 0.25);
}

TEST(Interpolation, AffineColoursAreWrongInPerspective) {
  const std::vector<Facet> facets = shaded_triangles(21, 2'000);
  EXPECT_GT(attribute_errors(method("shade_affine"), facets, true).greatest, 50);
  EXPECT_LT(attribute_errors(method("shade_affine"), facets, false).greatest, 1e-9);
}

// One row of 1024 px whose gradient lies half a unit of the last place between two.
TEST(Interpolation, GradientErrorGrowsByHalfAUnitPerStep) {
  for (const auto& [bits, figure] :
       {std::pair{8, 2.0}, std::pair{12, 0.125}, std::pair{16, 0.008}}) {
    const double gradient = (20 + 0.5) * std::ldexp(1.0, -bits);
    Facet f{};
    f[0].x = 0, f[0].y = 0;
    f[1].x = 1024, f[1].y = 0;
    f[2].x = 0, f[2].y = 60;
    f[1].color[0] = 1024 * gradient;
    const auto e = attribute_errors(method("shade_gradient_f" + std::to_string(bits)),
                                    std::span(&f, 1), false);
    EXPECT_NEAR(e.greatest, figure, 0.06 * figure) << bits;
    // A gradient that fits adds nothing: what is left is the first value's own rounding.
    f[1].color[0] = 1024 * 20 * std::ldexp(1.0, -bits);
    const auto fits = attribute_errors(method("shade_gradient_f" + std::to_string(bits)),
                                       std::span(&f, 1), false);
    EXPECT_LE(fits.greatest, std::ldexp(0.5, -bits)) << bits;
  }
}

TEST(Interpolation, PlanesFromTheEdgeMatrixCancelFarFromTheOrigin) {
  Facet f = facets_of(
      std::vector<oracle::Corners>{{{{1900.5, 40.25}, {1908.25, 41.5}, {1903.5, 47.75}}}})[0];
  f[0].color[0] = 10, f[1].color[0] = 250, f[2].color[0] = 100;
  const double absolute = attribute_errors(method("plane_float"), std::span(&f, 1), false).greatest;
  const double relative =
      attribute_errors(method("plane_float_relative"), std::span(&f, 1), false).greatest;
  EXPECT_GT(absolute, 100 * relative);
  EXPECT_LT(relative, 1e-3);
  EXPECT_LT(attribute_errors(method("plane_double"), std::span(&f, 1), false).greatest, 1e-6);
}

TEST(Interpolation, PipelineIsWithinItsDocumentedHalfLevelAndABit) {
  const std::vector<Facet> facets = shaded_triangles(21, 2'000);
  EXPECT_LT(attribute_errors(method("halfspace_s8"), facets, true).greatest, 0.6);
}

// How far beyond half a pixel the pixels of a steep line of 2048 rows are from it.
double drift_from(const std::string& name, double start, double dx) {
  const Segment s{{start, 0.5}, {start + dx, 2048.5}};
  Canvas canvas(1100, 2050);
  std::get<DrawSegment>(method(name).draw)(s, canvas);
  double worst = 0;
  for (int y = 0; y < 2048; ++y) {
    const double x = s.from.x + dx * y / 2048;
    const int middle = static_cast<int>(x);
    for (int column = std::max(0, middle - 8); column < middle + 8; ++column) {
      if (canvas.hits()[canvas.index(column, y)] == 0) continue;
      worst = std::max(worst, std::abs(column + 0.5 - x) - 0.5);
    }
  }
  return worst;
}

// The worst of several starts: whether a small drift shows depends on where rows meet the grid.
double drift(const std::string& name, double dx) {
  double worst = -1;
  for (int i = 0; i < 32; ++i) worst = std::max(worst, drift_from(name, 8 + i / 32.0, dx));
  return worst;
}

TEST(Lines, DdaDriftsByHalfAUnitOfTheSlopePerRow) {
  for (const auto& [bits, figure] :
       {std::pair{8, 4.0}, std::pair{12, 0.25}, std::pair{16, 0.016}}) {
    const std::string name = "line_dda_fixed_f" + std::to_string(bits);
    // A slope half a unit between two of the grid, and near 0.37 so that all phases occur.
    const double slope = (std::floor(0.37 * std::ldexp(1.0, bits)) + 0.5) * std::ldexp(1.0, -bits);
    expect_about(drift(name, slope * 2048), figure, name);
  }
  EXPECT_LT(drift("line_dda", 757.25), 1e-6);
  EXPECT_LT(drift("line_naive", 757.25), 1e-6);
  EXPECT_LE(drift("line_exact", 757.25), 0.0);
  EXPECT_GT(drift("line_dda_fixed_f8_truncate", 757.25), drift("line_dda_fixed_f8", 757.25));
  EXPECT_GT(drift("line_naive_floor", 757.25), 0.49);  // half a pixel off
}

// Nearest pixel of every column or row, by integers of 1/512 px; a tie goes to the greater.
TEST(Lines, ExactLineIsTheNearestPixelEverywhere) {
  Random random(31);
  for (int i = 0; i < 2000; ++i) {
    const auto at = [&random] { return static_cast<double>(random.in(0, 96 * 256)) / 256; };
    const double x0 = at(), y0 = at(), x1 = at(), y1 = at();
    Canvas canvas(96, 96);
    std::get<DrawSegment>(method("line_exact").draw)({{x0, y0}, {x1, y1}}, canvas);
    const bool steep = std::abs(y1 - y0) > std::abs(x1 - x0);
    const double u0 = steep ? y0 : x0, v0 = steep ? x0 : y0;
    const double u1 = steep ? y1 : x1, v1 = steep ? x1 : y1;
    if (u0 == u1) continue;
    for (int u = 0; u < 96; ++u) {
      const double c = u + 0.5;
      if (c < std::min(u0, u1) || c > std::max(u0, u1)) continue;
      // Exact in double: 16-bit coordinates, one product; the division's floor by products again.
      const double numerator = (v1 - v0) * (c - u0) + v0 * (u1 - u0), below = u1 - u0;
      double v = std::floor(numerator / below);
      const double sign = below > 0 ? 1 : -1;
      while (sign * (numerator - v * below) < 0) --v;
      while (sign * (numerator - (v + 1) * below) >= 0) ++v;
      if (v < 0 || v >= 96) continue;
      const int x = steep ? static_cast<int>(v) : u, y = steep ? u : static_cast<int>(v);
      EXPECT_EQ(canvas.hits()[canvas.index(x, y)], 1u)
          << "seed 31, line " << i << ": " << x0 << " " << y0 << " " << x1 << " " << y1;
    }
  }
}

}  // namespace
}  // namespace halfspace::methods
