// SPDX-License-Identifier: Apache-2.0
//
// F' = F / k, where k is F at the opposite vertex: positive inside whatever the winding.
#include "arithmetic.hpp"
#include "catalogue.hpp"
#include "implicit_line.hpp"

namespace halfspace::methods {
namespace {

template <class Real>
void draw(const Facet& facet, Canvas& canvas, bool strict) {
  std::array<ImplicitLine<Real>, 3> line;
  for (std::size_t i = 0; i < 3; ++i) {
    line[i] = implicit_line<Real>(facet[(i + 1) % 3].position(), facet[(i + 2) % 3].position());
    const Real k = line[i].at(facet[i].position());
    line[i] = {line[i].a / k, line[i].b / k, line[i].c / k};
  }
  const PixelBox box = pixel_box(facet, canvas);
  for (int y = box.y_first; y <= box.y_last; ++y) {
    if (!canvas.spend(box.empty() ? 1 : box.width())) return;
    for (int x = box.x_first; x <= box.x_last; ++x) {
      bool in = true;
      for (std::size_t i = 0; i < 3 && in; ++i) {
        const Real f = line[i].at({x + 0.5, y + 0.5});
        in = strict ? f > 0 : f >= 0;
      }
      if (in) canvas.hit(x, y);
    }
  }
}

template <class Real>
void add(std::vector<Method>& list, const char* precision, bool strict) {
  Method m;
  m.name = std::string("scaled_") + precision + (strict ? "_strict" : "_inclusive");
  m.row = 9;
  m.family = "edge_functions";
  m.title = std::string("Implicit lines scaled to 1 at the opposite vertex, ") + precision +
            (strict ? ", > 0" : ", >= 0");
  m.source = kPolygons;
  m.complexity = "O(box area)";
  m.use = "either winding without a test of orientation";
  m.fails = strict
                ? "gaps at samples on edges; k = 0 makes NaN or infinities"
                : "division rounds each side of an edge apart: gaps and doubles; k = 0 makes NaN";
  m.rule = strict ? Rule::kSkipTies : Rule::kDrawTies;
  m.precision = precision;
  m.draw = DrawFacet([strict](const Facet& f, Canvas& c) { draw<Real>(f, c, strict); });
  list.push_back(std::move(m));
}

}  // namespace

void add_scaled_line(std::vector<Method>& list) {
  add<float>(list, "float", false);
  add<float>(list, "float", true);
  add<double>(list, "double", false);
  add<double>(list, "double", true);
}

}  // namespace halfspace::methods
