// SPDX-License-Identifier: Apache-2.0
//
// Who owns a sample on an edge: the three answers of the notes, in exact integers, so that nothing
// but the rule differs.
#include "catalogue.hpp"
#include "edge_function.hpp"

namespace halfspace::methods {

void add_fill_rules(std::vector<Method>& list) {
  struct Variant {
    const char* name;
    const char* title;
    Rule rule;
    const char* use;
    const char* fails;
  };
  constexpr std::array<Variant, 3> kVariants{{
      {"draw_ties", "every triangle that touches a sample draws it", Rule::kDrawTies,
       "opaque single triangles, or conservative masks",
       "shared edges are drawn twice: the picture depends on the order, blending is wrong"},
      {"skip_ties", "nobody draws a sample on an edge", Rule::kSkipTies,
       "tests for strictly inside",
       "shared edges are not drawn at all: gaps where samples lie on them"},
      {"top_left", "the triangle at whose left or top the sample lies", Rule::kTopLeft,
       "always: each sample of a mesh has one owner", ""},
  }};
  for (const Variant& v : kVariants) {
    Method m;
    m.name = std::string("fill_") + v.name;
    m.row = 5;
    m.family = "fill_rules";
    m.title = std::string("Fill rule in exact integers: ") + v.title;
    m.source = std::string(kLuebke) + "; " + kDrawing + "; " + kPolygons;
    m.complexity = "O(box area)";
    m.use = v.use;
    m.fails = v.fails;
    m.rule = v.rule;
    m.precision = "fixed, 8 subpixel bits";
    m.subpixel_bits = 8;
    m.exact = v.rule == Rule::kTopLeft;
    m.draw = DrawFacet([rule = v.rule](const Facet& facet, Canvas& canvas) {
      draw_edge_function(facet, canvas, Fixed{8}, Constant::kRelative, rule);
    });
    m.edges = edges_at(Fixed{8}, Constant::kRelative, v.rule);
    list.push_back(std::move(m));
  }
}

}  // namespace halfspace::methods
