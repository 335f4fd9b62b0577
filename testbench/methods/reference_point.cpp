// SPDX-License-Identifier: Apache-2.0
//
// Barycentric coordinates; a sample on an edge belongs to the triangle on the same side of it as a
// fixed point off the screen.
#include "arithmetic.hpp"
#include "catalogue.hpp"
#include "implicit_line.hpp"

namespace halfspace::methods {
namespace {

template <class Real>
void draw(const Facet& facet, Canvas& canvas, const Position& reference) {
  std::array<ImplicitLine<Real>, 3> line;
  std::array<Real, 3> scale{}, at_reference{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    line[i] = implicit_line<Real>(facet[j].position(), facet[k].position());
    scale[i] = line[i].at(facet[i].position());
    at_reference[i] = line[i].at(reference);
  }
  const PixelBox box = pixel_box(facet, canvas);
  for (int y = box.y_first; y <= box.y_last; ++y) {
    if (!canvas.spend(box.empty() ? 1 : box.width())) return;
    for (int x = box.x_first; x <= box.x_last; ++x) {
      bool in = true;
      for (std::size_t i = 0; i < 3 && in; ++i) {
        const Real weight = line[i].at({x + 0.5, y + 0.5}) / scale[i];
        in = weight >= 0 && (weight > 0 || scale[i] * at_reference[i] > 0);
      }
      if (in) canvas.hit(x, y);
    }
  }
}

template <class Real>
void add(std::vector<Method>& list, const char* name, const char* precision, Position reference) {
  Method m;
  m.name = name;
  m.row = 8;
  m.family = "fill_rules";
  m.title = std::string("Barycentric, shared edges by an off-screen point, ") + precision;
  m.source =
      std::string(kShinar) + "; P. Shirley and S. Marschner, Fundamentals of Computer Graphics";
  m.complexity = "O(box area), 3 divisions a pixel";
  m.use = "scenes whose edges never point at the reference point";
  m.fails = "an edge whose line meets the point has f(r) = 0: its samples are nobody's";
  m.rule = Rule::kOffscreen;
  m.precision = precision;
  m.draw = DrawFacet(
      [reference](const Facet& facet, Canvas& canvas) { draw<Real>(facet, canvas, reference); });
  list.push_back(std::move(m));
}

}  // namespace

void add_reference_point(std::vector<Method>& list) {
  add<float>(list, "offscreen_float", "float, (-1, -1)", {-1, -1});
  add<double>(list, "offscreen_double", "double, (-1, -1)", {-1, -1});
  add<double>(list, "offscreen_irrational", "double, (-pi, -e)",
              {-3.14159265358979, -2.71828182845905});
}

}  // namespace halfspace::methods
