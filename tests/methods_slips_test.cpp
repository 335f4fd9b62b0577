// SPDX-License-Identifier: Apache-2.0
//
// Slips of the lecture notes, each shown wrong beside the right form. The wrong forms live here
// only.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "methods/implicit_line.hpp"
#include "methods/projection.hpp"
#include "methods_support.hpp"

namespace halfspace::methods {
namespace {

struct Line {
  double a, b, c;
  double at(double x, double y) const { return a * x + b * y + c; }
};

// Mao: A = y0 - y1, B = x0 - x1, C = -(x0 y1 - x1 y0).
TEST(Slips, EdgeOfTheRasterizationChapterMissesItsOwnEnds) {
  const double x0 = 2, y0 = 3, x1 = 7, y1 = 5;
  const Line wrong{y0 - y1, x0 - x1, -(x0 * y1 - x1 * y0)};
  EXPECT_EQ(wrong.at(x0, y0), -8);
  EXPECT_EQ(wrong.at(x1, y1), -28);
  const Line right{y0 - y1, x1 - x0, x0 * y1 - x1 * y0};
  EXPECT_EQ(right.at(x0, y0), 0);
  EXPECT_EQ(right.at(x1, y1), 0);
}

// Luebke: (A, B) = -C / (x0 y1 - x1 y0) (y1 - y0, x1 - x0); the text then has B = x1 - x0.
TEST(Slips, MatrixFormHasTheSignOfBWrong) {
  const double x0 = 2, y0 = 3, x1 = 7, y1 = 5, c = x0 * y1 - x1 * y0;
  const double scale = -c / (x0 * y1 - x1 * y0);
  const Line wrong{scale * (y1 - y0), scale * (x1 - x0), c};
  EXPECT_NE(wrong.at(x0, y0), 0);
  const Line right{y0 - y1, x1 - x0, c};  // the text's own result
  EXPECT_EQ(wrong.a, right.a);
  EXPECT_EQ(wrong.b, -right.b);
}

// Every pixel of the quad's box against integer edges, 1/2 px units.
template <class Test>
int pixels_of_quad(Test&& test) {
  int count = 0;
  for (const oracle::Corners& t : oracle::quad_on_samples()) {
    const Corners<std::int64_t> c = oriented(facets_of(std::span(&t, 1))[0], Fixed{1});
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 12; ++x) {
        std::array<std::int64_t, 3> e{};
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t j = (i + 1) % 3;
          const std::int64_t px = 2 * (2 * x + 1), py = 2 * (2 * y + 1);
          e[i] = (c.y[i] - c.y[j]) * (px - c.x[i]) + (c.x[j] - c.x[i]) * (py - c.y[i]);
        }
        count += test(e[0], e[1], e[2]) ? 1 : 0;
      }
    }
  }
  return count;
}

// Luebke: `if (e0|e1|e2 > 0)`.
TEST(Slips, OrTestParsesAsSomethingElseAndChangesTheFillRule) {
  using I = std::int64_t;
  const int as_parsed =
      pixels_of_quad([](I a, I b, I c) { return (a | b | static_cast<I>(c > 0)) != 0; });
  const int as_meant = pixels_of_quad([](I a, I b, I c) { return (a | b | c) > 0; });
  const int strict = pixels_of_quad([](I a, I b, I c) { return a > 0 && b > 0 && c > 0; });
  const int inclusive = pixels_of_quad([](I a, I b, I c) { return a >= 0 && b >= 0 && c >= 0; });
  EXPECT_GT(as_parsed, 250);       // of 2 x 144: nearly everything
  EXPECT_EQ(strict, 64 - 22);      // what the slide before it draws
  EXPECT_EQ(as_meant, inclusive);  // the hack draws ties,
  EXPECT_EQ(as_meant, 81 + 9);     // the closed square, its diagonal twice: another rule
}

// Drawing Triangles has > in the text and >= in the code; the slides of Polygons have >= on one
// page and > on the next.
TEST(Slips, StrictAndInclusiveAreNotTheSameMethod) {
  for (const auto& [strict, inclusive] :
       {std::pair{"edge_double_strict", "edge_double_inclusive"},
        std::pair{"scaled_double_strict", "scaled_double_inclusive"}}) {
    const oracle::Window window{16, 16, 0, 0};
    EXPECT_EQ(errors_of(strict, oracle::quad_on_samples(), window).gaps, 22u) << strict;
    EXPECT_EQ(errors_of(inclusive, oracle::quad_on_samples(), window).doubles, 25u) << inclusive;
  }
}

// Drawing Triangles: top = near tan(fovy) in the list, tan(fovy / 2) in the code.
TEST(Slips, TopOfTheNearPlaneIsAtHalfTheAngle) {
  const double near = 0.5, far = 10, aspect = 1.5, fovy = 0.7;
  const double wrong_top = near * std::tan(fovy), right_top = near * std::tan(fovy / 2);
  const glm::dmat4 library = glm::perspective(fovy, aspect, near, far);
  EXPECT_NEAR(library[1][1], near / right_top, 1e-12);
  EXPECT_GT(std::abs(library[1][1] - near / wrong_top), 1.0);
  // A point at the top edge of the view is at y = 1 in the right form only.
  const glm::dvec4 top(0, 3 * std::tan(fovy / 2), -3, 1);
  EXPECT_NEAR((perspective_matrix(fovy, aspect, near, far) * top).y / 3, 1.0, 1e-12);
  EXPECT_LT(top.y * near / wrong_top / 3, 0.5);
}

// Drawing Triangles: `int x = (affine_tri.x + 1.0f) * globalWidth / 2.0`.
TEST(Slips, VerticesTruncatedToIntegersMoveByUpToAPixel) {
  auto mesh = oracle::jittered_mesh({.size = 256});
  const auto exact = oracle::exact_hits(mesh, {256, 256, 0, 0});
  // Each triangle against itself: the mesh stays closed, its pixels change hands.
  oracle::HitErrors sum;
  for (const oracle::Corners& t : mesh) {
    oracle::Corners cut = t;
    for (oracle::Vec& v : cut) v = {std::trunc(v.x), std::trunc(v.y)};
    const oracle::Window window{256, 256, 0, 0};
    sum += oracle::compare_hits(oracle::exact_hits(std::span(&cut, 1), window),
                                oracle::exact_hits(std::span(&t, 1), window));
  }
  EXPECT_GT(sum.ppm(), 50000);  // against 909 at 8 subpixel bits
}

// Drawing Triangles divides by w without a test.
TEST(Slips, DivisionByWIsUnguarded) {
  View view;
  view.width = view.height = 64;
  const Vertex at_eye = window_vertex({{1, 1, 1, 0}, {}}, view);
  EXPECT_TRUE(std::isinf(at_eye.x));
  const Vertex behind = window_vertex({{1, 1, 1, -2}, {}}, view);
  const Vertex before = window_vertex({{-1, -1, -1, 2}, {}}, view);
  EXPECT_EQ(behind.x, before.x);  // a point behind the eye passes for one before it
  EXPECT_EQ(behind.y, before.y);
}

// Shinar: beta = f_ca / f_ca(b) on one slide, f_ac / f_ac(b) on a later one. The same number, but
// for a triangle without area the zero below it has another sign.
TEST(Slips, ExchangedIndicesAndNoUpperBoundFillADegenerateTriangle) {
  const auto t = oracle::collinear();
  const Position a{t[0].x, t[0].y}, b{t[1].x, t[1].y}, c{t[2].x, t[2].y};
  const auto bc = implicit_line<double>(b, c), ab = implicit_line<double>(a, b);
  const auto ca = implicit_line<double>(c, a), ac = implicit_line<double>(a, c);
  int exchanged = 0, not_finite = 0, bounded = 0, right = 0;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 100; ++x) {
      const Position p{x + 0.5, y + 0.5};
      if (p.x < 10.5 || p.x > 90.5 || p.y < 10.5 || p.y > 90.5) continue;  // the bounding box
      const double alpha = bc.at(p) / bc.at(a), gamma = ab.at(p) / ab.at(c);
      const double beta_ac = ac.at(p) / ac.at(b), beta_ca = ca.at(p) / ca.at(b);
      const bool filled = alpha >= 0 && beta_ac >= 0 && gamma >= 0;
      exchanged += filled ? 1 : 0;
      bounded += filled && alpha <= 1 && beta_ac <= 1 && gamma <= 1 ? 1 : 0;
      right += alpha >= 0 && beta_ca >= 0 && gamma >= 0 ? 1 : 0;
      const double red = alpha * 255 + beta_ac * 0 + gamma * 0;
      not_finite += filled && std::isnan(red) ? 1 : 0;
    }
  }
  EXPECT_EQ(exchanged, 3240);
  EXPECT_EQ(not_finite, 3240);
  EXPECT_EQ(bounded, 0);
  EXPECT_EQ(right, 0);
  const oracle::Window window{100, 100, 0, 0};
  for (const char* name : {"bary_ratio_float", "bary_ratio_double", "bary_ratio_unbounded_float"}) {
    EXPECT_EQ(errors_of(name, {t}, window).wrong, 0u) << name;
  }
}

}  // namespace
}  // namespace halfspace::methods
