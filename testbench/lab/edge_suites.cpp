// SPDX-License-Identifier: Apache-2.0
#include <numeric>

#include "suite_shapes.hpp"

namespace halfspace::lab {
namespace {

std::vector<SuiteCase> shared_edges() {
  std::vector<Facet> quad;
  add_quad(quad, {1.5, 1.5}, {9.5, 1.5}, {9.5, 9.5}, {1.5, 9.5});
  return {area_case("one quad between pixel centres", quad, {16, 16}),
          area_case("mesh on half pixels", facets_of(jittered_mesh(861, 256, 16, 128, kShapeGrid)),
                    {256, 256})};
}

std::vector<SuiteCase> fine_mesh() {
  return {
      area_case("separate triangles", separate(866, 12, 16, 1.0 / 256), {192, 192}),

      area_case("4 px cells", facets_of(jittered_mesh(862, 128, 4, 1, kShapeGrid)), {128, 128}),
      area_case("16 px cells", facets_of(jittered_mesh(863, 256, 16, 1, kShapeGrid)), {256, 256})};
}

std::vector<SuiteCase> tiny_triangles() {
  return {area_case("1 px cells", facets_of(jittered_mesh(864, 64, 1, 1, kShapeGrid)), {64, 64})};
}

// A tilted strip of slivers of length L and width L / aspect between two large halves: every pixel
// of the rectangle belongs to one triangle.
SuiteCase sliver_case(double aspect) {
  const double length = std::max(64.0, std::ceil(aspect / 250));
  const double width = std::max(on_grid(length / aspect), 1.0 / 256);
  const int strips = static_cast<int>(std::min(24.0, 48 / width));
  const double top = on_grid(16.3);
  const double fall = on_grid(length / 64 + 3.2);
  std::vector<Facet> out;
  const Position left{0.5, top}, right{length + 0.5, top + fall};
  const auto below = [](Position p, double d) { return Position{p.x, p.y + d}; };
  add_quad(out, {0.5, 0.5}, {length + 0.5, 0.5}, right, left);
  for (int n = 0; n < strips; ++n) {
    add_quad(out, below(left, n * width), below(right, n * width), below(right, (n + 1) * width),
             below(left, (n + 1) * width));
  }
  const double depth = std::ceil(top + fall + strips * width) + 16.5;
  add_quad(out, below(left, strips * width), below(right, strips * width), {length + 0.5, depth},
           {0.5, depth});
  char name[32];
  std::snprintf(name, sizeof name, "aspect %g", aspect);
  return area_case(name, out, {static_cast<int>(length) + 2, static_cast<int>(depth) + 1});
}

std::vector<SuiteCase> slivers() {
  std::vector<SuiteCase> out;
  for (int power = 0; power <= 6; ++power) out.push_back(sliver_case(std::pow(10.0, power)));
  return out;
}

std::vector<SuiteCase> needle_fan() {
  return {area_case("2000 slivers, radius 250",
                    facets_of(fan(256.25, 256.75, 250, 2000, kShapeGrid)), {512, 512})};
}

// Triangles without area, then two that fill the frame.
std::vector<SuiteCase> zero_area() {
  std::vector<Facet> out;
  const std::vector<std::array<Position, 3>> flat{
      {{{10.5, 10.5}, {50.5, 50.5}, {90.5, 90.5}}}, {{{20.5, 8.5}, {20.5, 99.5}, {20.5, 40.5}}},
      {{{8.5, 70.5}, {120.5, 70.5}, {30.5, 70.5}}}, {{{64.5, 64.5}, {64.5, 64.5}, {64.5, 64.5}}},
      {{{5.5, 100.5}, {99.5, 6.5}, {5.5, 100.5}}},  {{{30.25, 17.5}, {60.75, 78.5}, {45.5, 48}}}};
  for (const auto& p : flat) out.push_back(facet_of(p[0], p[1], p[2]));
  add_quad(out, {0, 0}, {128, 0}, {128, 128}, {0, 128});
  return {area_case("collinear and repeated vertices", out, {128, 128})};
}

// A grid of rectangles with edges on integers, centres and quarters.
std::vector<SuiteCase> axis_edges() {
  std::vector<SuiteCase> cases;
  for (const double shift : {0.0, 0.5, 0.25}) {
    std::vector<Facet> out;
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 8; ++x) {
        const double x0 = 11 * x + shift, y0 = 9 * y + shift;
        add_quad(out, {x0, y0}, {x0 + 11, y0}, {x0 + 11, y0 + 9}, {x0, y0 + 9});
      }
    }
    SuiteCase one = area_case("edges at n + " + std::to_string(shift).substr(0, 4), out, {96, 80});
    one.drawing.segments.clear();
    for (int n = 0; n < 8; ++n) {
      one.drawing.segments.push_back({{3 + shift, 5 * n + shift}, {80 + shift, 5 * n + shift}});
      one.drawing.segments.push_back({{9 * n + shift, 2 + shift}, {9 * n + shift, 60 + shift}});
    }
    one.kinds = kAreaKinds | kLineKinds;
    cases.push_back(std::move(one));
  }
  return cases;
}

// Convex polygons whose vertices lie on rows of pixel centres; as polygons and as fans.
std::vector<SuiteCase> scanline_vertices() {
  std::vector<Facet> fans;
  std::vector<methods::Polygon> polygons;
  const auto add = [&](std::vector<Position> ring) {
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      fans.push_back(facet_of(ring[0], ring[i], ring[i + 1]));
    }
    polygons.push_back({{std::move(ring)}});
  };
  for (int n = 0; n < 64; ++n) {
    const double x = 12 * (n % 8) + 8.5, y = 12 * (n / 8) + 6.5;
    const double r = n % 5 + 1, s = n % 3 + 1;
    add({{x, y - s}, {x + r, y}, {x, y + s}, {x - r, y}});
  }
  SuiteCase one = area_case("diamonds on rows of centres", fans, {104, 104});
  one.drawing.polygons = std::move(polygons);
  return {one};
}

// The doubled area of one 2^-16 px^2: the least there is. Consecutive terms of a continued
// fraction span such a triangle however long its sides are.
std::vector<SuiteCase> least_area() {
  std::vector<Facet> out;
  Random random(865);
  const Position o{2.5, 2.5};
  for (int n = 0; n < 12; ++n) {
    std::int64_t p = 0, q = 1, p1 = 1, q1 = 0;  // neighbours: p q1 - q p1 = -1
    while (q + q1 < 60000 && p + p1 < 60000) {
      const std::int64_t a = random.in(1, 6);
      const std::int64_t p2 = a * p1 + p, q2 = a * q1 + q;
      if (p2 >= 60000 || q2 >= 60000) break;
      p = p1, q = q1, p1 = p2, q1 = q2;
    }
    const Position a{o.x + static_cast<double>(q) / 256, o.y + static_cast<double>(p) / 256};
    const Position b{o.x + static_cast<double>(q1) / 256, o.y + static_cast<double>(p1) / 256};
    // The sliver and a triangle on each side of it.
    out.push_back(facet_of(o, a, b));
    out.push_back(facet_of(o, b, {2.5, 250.5}));
    out.push_back(facet_of(o, {250.5, 2.5}, b));
  }
  return {area_case("doubled area of one unit", out, {256, 256})};
}

// Polygons with corners that turn both ways: a comb and a star.
std::vector<SuiteCase> concave() {
  SuiteCase one;
  one.name = "comb and star";
  one.kinds = kPolygonKinds;
  one.window = {160, 96};
  std::vector<Position> comb{{4.5, 80.5}};
  for (int n = 0; n < 9; ++n) {
    comb.push_back({4.5 + 8 * n, 8.5});
    comb.push_back({8.5 + 8 * n, 60.5});
  }
  comb.push_back({76.5, 80.5});
  std::vector<Position> star;
  for (int n = 0; n < 14; ++n) {
    const double angle = 3.14159265358979 * n / 7, r = n % 2 == 0 ? 36 : 14;
    star.push_back({on_grid(118.5 + r * std::cos(angle)), on_grid(44.5 + r * std::sin(angle))});
  }
  one.drawing.view.width = 160;
  one.drawing.view.height = 96;
  one.drawing.polygons = {{{comb}}, {{star}}};
  return {one};
}

}  // namespace

void add_edge_suites(std::vector<Suite>& list) {
  list.push_back({"shared_edges", "shared edges on samples",
                  "every tie rule but top-left draws a sample on a shared edge twice or not at all",
                  Judge::kHits, true, shared_edges});
  list.push_back({"fine_mesh", "separate triangles, meshes of 4 and 16 px cells",
                  "no ties to speak of: what is wrong here comes from rounding or from spans",
                  Judge::kHits, true, fine_mesh});
  list.push_back({"tiny", "triangles smaller than a pixel",
                  "most hold no sample; a method that gives each triangle a pixel draws too many",
                  Judge::kHits, true, tiny_triangles});
  list.push_back({"slivers", "slivers of aspect 1 to 10^6",
                  "nearly parallel edges: a rounded edge crosses its neighbour", Judge::kHits, true,
                  slivers});
  list.push_back({"needle_fan", "fan of 2000 needles",
                  "2000 edges meet in a vertex: errors of all of them add up there", Judge::kHits,
                  true, needle_fan});
  list.push_back({"zero_area", "collinear and repeated vertices",
                  "area 0: weights are 0/0, and a dropped upper bound fills the line", Judge::kHits,
                  true, zero_area, true});
  list.push_back({"least_area", "triangles of the least area",
                  "scale factors and areas next to 0: F/k and weights lose all digits",
                  Judge::kHits, true, least_area, true});
  list.push_back({"axis_edges", "horizontal and vertical edges",
                  "slope 0 or infinite; both ends of a span on a centre", Judge::kHits, true,
                  axis_edges});
  list.push_back({"scanline", "vertices on rows of centres",
                  "a crossing at a vertex counts once, twice or never: parity turns over",
                  Judge::kHits, true, scanline_vertices});
  list.push_back({"concave", "concave polygons", "a fan is right for convex polygons alone",
                  Judge::kHits, true, concave});
}

}  // namespace halfspace::lab
