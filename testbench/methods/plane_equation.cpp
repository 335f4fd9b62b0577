// SPDX-License-Identifier: Apache-2.0
//
// Attributes as planes r = A x + B y + C. The rows of the edge functions' matrix, divided by the
// doubled area, turn the values at the vertices into A, B and C.
#include "catalogue.hpp"
#include "covered.hpp"

namespace halfspace::methods {
namespace {

template <class Real>
struct Plane {
  Real a{}, b{}, c{};
};

// Column i of the matrix belongs to vertex i: the edge opposite of it.
template <class Real>
class EdgeMatrix {
 public:
  explicit EdgeMatrix(const Facet& f) {
    Real area = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const auto xj = static_cast<Real>(f[j].x), yj = static_cast<Real>(f[j].y);
      const auto xk = static_cast<Real>(f[k].x), yk = static_cast<Real>(f[k].y);
      column_[i] = {yj - yk, xk - xj, xj * yk - xk * yj};
      area += column_[i].c;
    }
    inverse_area_ = 1 / area;
  }
  Plane<Real> plane(double r0, double r1, double r2) const {
    const std::array<Real, 3> r{static_cast<Real>(r0), static_cast<Real>(r1),
                                static_cast<Real>(r2)};
    Plane<Real> p;
    for (std::size_t i = 0; i < 3; ++i) {
      p.a += column_[i].a * r[i];
      p.b += column_[i].b * r[i];
      p.c += column_[i].c * r[i];
    }
    return {p.a * inverse_area_, p.b * inverse_area_, p.c * inverse_area_};
  }

 private:
  std::array<Plane<Real>, 3> column_;
  Real inverse_area_;
};

// The triangle moved so that its first vertex is the origin, when asked: C then cannot cancel.
template <class Real>
void draw(const Facet& facet, Canvas& canvas, bool relative) {
  const Position origin = relative ? facet[0].position() : Position{};
  Facet moved = facet;
  for (Vertex& v : moved) v.x -= origin.x, v.y -= origin.y;
  const EdgeMatrix<Real> matrix(moved);
  const Plane<Real> z = matrix.plane(facet[0].z, facet[1].z, facet[2].z);
  std::array<Plane<Real>, 3> color;
  for (std::size_t i = 0; i < 3; ++i) {
    color[i] = matrix.plane(facet[0].color[i], facet[1].color[i], facet[2].color[i]);
  }
  for_each_covered(facet, canvas, [&](int x, int y) {
    const auto px = static_cast<Real>(x + 0.5 - origin.x);
    const auto py = static_cast<Real>(y + 0.5 - origin.y);
    const auto at = [&](const Plane<Real>& p) {
      return static_cast<double>(p.a * px + p.b * py + p.c);
    };
    canvas.fragment(x, y, at(z), {at(color[0]), at(color[1]), at(color[2])});
  });
}

template <class Real>
void add(std::vector<Method>& list, const char* precision, bool relative) {
  Method m;
  m.name = std::string("plane_") + precision + (relative ? "_relative" : "");
  m.row = 6;
  m.family = "interpolation";
  m.title = std::string("Plane equations from the edge matrix, ") + precision +
            (relative ? ", origin at a vertex" : "");
  m.source = kLuebke;
  m.complexity = "9 products per attribute and triangle, 2 per attribute and pixel";
  m.use = "attributes linear on the screen: depth, and everything under an orthographic camera";
  m.fails = relative
                ? "perspective: colours are linear on the screen, not in the world"
                : "C cancels far from the origin and in slivers; perspective as plane_*_relative";
  m.rule = Rule::kTopLeft;
  m.precision = precision;
  m.subpixel_bits = 8;
  m.exact = true;
  m.attributes = true;
  m.draw = DrawFacet([relative](const Facet& f, Canvas& c) { draw<Real>(f, c, relative); });
  list.push_back(std::move(m));
}

}  // namespace

void add_plane_equation(std::vector<Method>& list) {
  add<float>(list, "float", false);
  add<float>(list, "float", true);
  add<double>(list, "double", false);
  add<double>(list, "double", true);
}

}  // namespace halfspace::methods
