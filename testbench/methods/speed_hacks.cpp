// SPDX-License-Identifier: Apache-2.0
//
// The inner loop of edge functions made faster, each trick alone and all together. Integers of
// 8 subpixel bits, except where float is the point.
#include "catalogue.hpp"
#include "edge_function.hpp"

namespace halfspace::methods {
namespace {

// How three edge values become one decision.
enum class Test {
  kEach,      // bias of the top-left rule, then each >= 0
  kOrStrict,  // (e0 | e1 | e2) > 0 without a bias, as the notes have it
  kOrBiased   // bias of the top-left rule, then (e0 | e1 | e2) >= 0: one sign for three
};

struct Hacks {
  bool incremental = false;  // e += A per pixel, e += B per row
  bool early_exit = false;   // leave the row at the first pixel outside after one inside
  Test test = Test::kEach;
};

bool passes(const std::array<std::int64_t, 3>& e, Test test) {
  if (test == Test::kOrStrict) return (e[0] | e[1] | e[2]) > 0;
  if (test == Test::kOrBiased) return (e[0] | e[1] | e[2]) >= 0;
  return e[0] >= 0 && e[1] >= 0 && e[2] >= 0;
}

void draw(const Facet& facet, Canvas& canvas, const Hacks& hacks) {
  const Fixed fixed{8};
  if (!fixed.holds(facet)) return;
  const Corners<std::int64_t> corners = oriented(facet, fixed);
  if (corners.area <= 0) return;
  const PixelBox box = pixel_box(facet, canvas, 0.5);
  const std::int64_t pixel = std::int64_t{2} << fixed.bits;
  std::array<EdgeLine<std::int64_t>, 3> edge;
  std::array<std::int64_t, 3> row{}, bias{};
  const auto value = [&](std::size_t i, int x, int y) {
    return edge[i].at(fixed.centre(x), fixed.centre(y)) - bias[i];
  };
  for (std::size_t i = 0; i < 3; ++i) {
    edge[i] = edge_line(corners, i, Constant::kRelative);
    bias[i] = hacks.test == Test::kOrStrict || edge[i].top_left() ? 0 : 1;
    row[i] = value(i, box.x_first, box.y_first);
  }
  for (int y = box.y_first; y <= box.y_last; ++y) {
    if (!canvas.spend(box.empty() ? 1 : box.width())) return;
    std::array<std::int64_t, 3> e = row;
    bool was_inside = false;
    for (int x = box.x_first; x <= box.x_last; ++x) {
      if (!hacks.incremental) e = {value(0, x, y), value(1, x, y), value(2, x, y)};
      const bool in = passes(e, hacks.test);
      if (in) canvas.hit(x, y);
      if (hacks.early_exit && was_inside && !in) break;
      was_inside = in;
      for (std::size_t i = 0; i < 3; ++i) e[i] += edge[i].a * pixel;
    }
    for (std::size_t i = 0; i < 3; ++i) row[i] += edge[i].b * pixel;
  }
}

// e += A in float: every addition rounds, so the end of a row depends on where it began.
void draw_float(const Facet& facet, Canvas& canvas) {
  const Floating<float> real;
  const Corners<float> corners = oriented(facet, real);
  if (!(corners.area > 0)) return;
  const PixelBox box = pixel_box(facet, canvas);
  std::array<EdgeLine<float>, 3> edge;
  std::array<float, 3> row{};
  for (std::size_t i = 0; i < 3; ++i) {
    edge[i] = edge_line(corners, i, Constant::kRelative);
    row[i] = edge[i].at(real.centre(box.x_first), real.centre(box.y_first));
  }
  for (int y = box.y_first; y <= box.y_last; ++y) {
    if (!canvas.spend(box.empty() ? 1 : box.width())) return;
    std::array<float, 3> e = row;
    for (int x = box.x_first; x <= box.x_last; ++x) {
      if (inside(edge[0], e[0], Rule::kTopLeft) && inside(edge[1], e[1], Rule::kTopLeft) &&
          inside(edge[2], e[2], Rule::kTopLeft)) {
        canvas.hit(x, y);
      }
      for (std::size_t i = 0; i < 3; ++i) e[i] += edge[i].a;
    }
    for (std::size_t i = 0; i < 3; ++i) row[i] += edge[i].b;
  }
}

struct Variant {
  const char* name;
  const char* title;
  Hacks hacks;
};
constexpr std::array<Variant, 6> kVariants{{
    {"none", "no speed hack, for comparison", {}},
    {"incremental", "edge values by addition", {.incremental = true}},
    {"early_exit", "a row ends where the triangle does", {.early_exit = true}},
    {"sign", "one sign test of the three biased values ORed", {.test = Test::kOrBiased}},
    {"or_strict", "(e0 | e1 | e2) > 0 without a bias", {.test = Test::kOrStrict}},
    {"all",
     "addition, early exit and one sign test",
     {.incremental = true, .early_exit = true, .test = Test::kOrBiased}},
}};

}  // namespace

void add_speed_hacks(std::vector<Method>& list) {
  for (const Variant& v : kVariants) {
    Method m;
    m.name = std::string("hack_") + v.name;
    m.row = 4;
    m.family = "edge_functions";
    m.title = std::string("Edge functions in integers: ") + v.title;
    m.source = std::string(kLuebke) + "; " + kPolygons;
    m.complexity = "O(box area), one addition per edge and pixel at best";
    m.use = "the same picture with less work per pixel";
    m.exact = v.hacks.test != Test::kOrStrict;
    m.fails =
        m.exact ? "" : "the OR is positive on an edge too: it draws ties, so they are drawn twice";
    m.rule = m.exact ? Rule::kTopLeft : Rule::kDrawTies;
    m.precision = "fixed, 8 subpixel bits";
    m.subpixel_bits = 8;
    m.draw = DrawFacet([hacks = v.hacks](const Facet& f, Canvas& c) { draw(f, c, hacks); });
    // Sums of integers are the products. The OR of three takes an edge value of 0 for inside.
    m.edges = edges_at(Fixed{8}, Constant::kRelative, m.rule);
    list.push_back(std::move(m));
  }
  Method m = list.back();
  m.name = "hack_incremental_float";
  m.title = "Edge functions in float by addition";
  m.fails = "the sums round: they drift along long rows of large triangles";
  m.precision = "float";
  m.subpixel_bits = -1;
  m.exact = false;
  m.draw = DrawFacet(draw_float);
  m.edges = nullptr;  // a value depends on the pixel that its row began at
  list.push_back(std::move(m));
}

}  // namespace halfspace::methods
