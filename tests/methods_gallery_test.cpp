// SPDX-License-Identifier: Apache-2.0
//
// The gallery as a whole: complete, documented, exact where it says so.
#include <algorithm>
#include <cmath>
#include <set>

#include "methods/decomposition.hpp"
#include "methods_support.hpp"

namespace halfspace::methods {
namespace {

using oracle::Corners;

std::vector<Corners> snapped_corners(std::vector<Corners> triangles, int bits) {
  for (Corners& t : triangles) {
    for (oracle::Vec& v : t) {
      v.x = std::ldexp(std::nearbyint(std::ldexp(v.x, bits)), -bits);
      v.y = std::ldexp(std::nearbyint(std::ldexp(v.y, bits)), -bits);
    }
  }
  return triangles;
}

TEST(Gallery, HasAllEighteenRowsAndSaysWhatEachIsFor) {
  std::set<int> rows;
  std::set<std::string> names;
  for (const Method& m : all()) {
    rows.insert(m.row);
    EXPECT_TRUE(names.insert(m.name).second) << m.name << " twice";
    for (const std::string* text :
         {&m.family, &m.title, &m.source, &m.complexity, &m.use, &m.precision}) {
      EXPECT_FALSE(text->empty()) << m.name;
    }
    EXPECT_TRUE(m.exact || !m.fails.empty()) << m.name << " is not exact but never fails";
    EXPECT_EQ(find(m.name), &m);
  }
  EXPECT_EQ(rows.size(), 18u);
  EXPECT_EQ(*rows.begin(), 1);
  EXPECT_EQ(*rows.rbegin(), 18);
  EXPECT_EQ(find("no such method"), nullptr);
}

// The natural input of a row: triangles, or triangles as polygons, lines, clip space, world.
TEST(Gallery, EveryMethodDrawsAMeshNearlyRight) {
  const auto mesh = oracle::jittered_mesh({.seed = 3, .size = 256, .amplitude = 0.2});
  const auto exact = oracle::exact_hits(mesh, {256, 256, 0, 0});
  for (const Method& m : all()) {
    const Canvas canvas = drawn(m, mesh, {256, 256, 0, 0});
    if (m.input() == InputKind::kLines) {
      const auto hit = std::count_if(canvas.hits().begin(), canvas.hits().end(),
                                     [](std::uint32_t h) { return h > 0; });
      EXPECT_GT(hit, 256 * 256 / 10) << m.name;
      EXPECT_LT(hit, 256 * 256 / 3) << m.name;
      continue;
    }
    EXPECT_LT(oracle::compare_hits(canvas.hits(), exact).ppm(), 200000) << m.name;
  }
}

// Method 0 of the tables: the exact ones, on everything that breaks the others.
TEST(Gallery, ExactMethodsHaveNoWrongPixelOnAnyReproducer) {
  struct Case {
    const char* name;
    std::vector<Corners> triangles;
    int size;
    int first;
  };
  const std::vector<Case> cases{
      {"quad", oracle::quad_on_samples(), 16, 0},
      {"sliver", {oracle::thin_sliver()}, 96, 0},
      {"collinear", {oracle::collinear()}, 96, 0},
      {"mesh16", oracle::jittered_mesh({.size = 256}), 256, 0},
      {"mesh4", oracle::jittered_mesh({.size = 128, .cell = 4}), 128, 0},
      {"mesh_h", oracle::jittered_mesh({.size = 256, .grid = 1, .phase = 0.5, .square = false}),
       256, 0},
      {"mesh16 far", oracle::jittered_mesh({.size = 128, .offset = 15800}), 128, 15800},
      {"fan", oracle::needle_fan(100), 1024, 0},
      {"huge", oracle::random_triangles(5, 12, 16000, 16380), 128, 8000},
      {"real", oracle::random_triangles(6, 300, 30, 120), 128, 0},
  };
  for (const Case& c : cases) {
    const oracle::Window window{c.size, c.size, c.first, c.first};
    for (const Method& m : all()) {
      if (!m.exact || m.input() == InputKind::kLines) continue;
      const auto triangles =
          snapped_corners(c.triangles, m.subpixel_bits < 0 ? 8 : m.subpixel_bits);
      const Canvas canvas = drawn(m, triangles, window);
      const auto e = oracle::compare_hits(canvas.hits(), oracle::exact_hits(triangles, window));
      EXPECT_EQ(e.wrong, 0u) << m.name << " on " << c.name << ": " << e.gaps << " gaps, "
                             << e.doubles << " doubles of " << e.covered;
    }
  }
}

TEST(Gallery, NothingThatIsNotFiniteCrashesAMethod) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (const double bad : {inf, -inf, nan, 1e300, -1e300}) {
    const std::vector<Corners> triangles{{{{bad, 4}, {9, 5}, {3, 30}}},
                                         {{{2, 2}, {9, bad}, {30, 3}}}};
    for (const Method& m : all()) {
      Canvas canvas(32, 32, 0, 0, 1 << 20);
      draw(m, drawing_of(facets_of(triangles), 32, 32), canvas);
    }
  }
}

TEST(Gallery, BudgetStopsAMethodInItsTracks) {
  for (const Method& m : all()) {
    Canvas canvas(256, 256, 0, 0, 3);
    draw(m, drawing_of(facets_of(oracle::jittered_mesh({.size = 256})), 256, 256), canvas);
    EXPECT_TRUE(canvas.exhausted()) << m.name;
  }
}

// A concave ring with a hole, and a ring that crosses itself.
TEST(Polygons, HolesAndConcaveRingsAgainstTheOracle) {
  const Ring outer{{2.5, 2.5}, {60.5, 4.25}, {40.5, 30.5}, {61.5, 60.5}, {6.5, 50.5}};
  const Ring hole{{15.5, 15.5}, {30.5, 18.5}, {20.5, 40.5}};
  const auto check = [](const char* name, const Polygon& p, bool right) {
    std::vector<oracle::Rings> rings(1);
    for (const Ring& ring : p.rings) {
      rings[0].emplace_back();
      for (const Position& v : ring) rings[0].back().push_back({v.x, v.y});
    }
    Canvas canvas(64, 64);
    std::get<DrawPolygon>(method(name).draw)(p, canvas);
    const auto e = oracle::compare_hits(canvas.hits(), oracle::exact_hits(rings, {64, 64, 0, 0}));
    EXPECT_EQ(e.wrong == 0, right) << name << ": " << e.wrong << " of " << e.covered;
  };
  for (const char* name : {"parity_top_in", "parity_exact", "decompose_ear"}) {
    check(name, {{outer}}, true);
  }
  check("aet_double", {{outer}}, false);  // its sums of slopes round at centres on edges
  Ring turned = outer;
  std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  check("decompose_fan", {{turned}}, false);  // concave, and not star-shaped from there
  for (const char* name : {"parity_top_in", "parity_exact", "decompose_constrained"}) {
    check(name, {{outer, hole}}, true);
  }
  check("decompose_ear", {{outer, hole}}, false);  // fills the hole twice
  const Ring star{{32, 2}, {50, 60}, {2, 22}, {62, 22}, {14, 60}};
  check("parity_exact", {{star}}, true);
  check("decompose_fan", {{star}}, false);
}

}  // namespace
}  // namespace halfspace::methods
