// SPDX-License-Identifier: Apache-2.0
//
// Barycentric coordinates decide coverage and interpolate in one go: three ways to find them.
#include <cmath>

#include "arithmetic.hpp"
#include "catalogue.hpp"
#include "implicit_line.hpp"

namespace halfspace::methods {
namespace {

enum class Way { kHeight, kArea, kShoelace, kRatio, kIncremental };

struct Variant {
  const char* name;
  const char* title;
  Way way;
  bool upper_bound;  // all in [0, 1], not only 0 or more
};

template <class Real>
using Weights = std::array<Real, 3>;

template <class Real>
Real doubled_area(Position a, Position b, Position c) {
  const auto ax = static_cast<Real>(a.x), ay = static_cast<Real>(a.y);
  return (static_cast<Real>(b.x) - ax) * (static_cast<Real>(c.y) - ay) -
         (static_cast<Real>(c.x) - ax) * (static_cast<Real>(b.y) - ay);
}

// The same from absolute coordinates: what a general polygon's area formula gives.
template <class Real>
Real shoelace_area(Position a, Position b, Position c) {
  const auto part = [](Position p, Position q) {
    return static_cast<Real>(p.x) * static_cast<Real>(q.y) -
           static_cast<Real>(q.x) * static_cast<Real>(p.y);
  };
  return part(a, b) + part(b, c) + part(c, a);
}

// Weights at one point, by the way asked for.
template <class Real>
class Barycentric {
 public:
  Barycentric(const Facet& f, Way way) : way_(way) {
    for (std::size_t i = 0; i < 3; ++i) {
      p_[i] = f[i].position();
      line_[i] = implicit_line<Real>(f[(i + 1) % 3].position(), f[(i + 2) % 3].position());
      scale_[i] = line_[i].at(p_[i]);
      length_[i] = std::hypot(line_[i].a, line_[i].b);
    }
    area_ = way == Way::kShoelace ? shoelace_area<Real>(p_[0], p_[1], p_[2])
                                  : doubled_area<Real>(p_[0], p_[1], p_[2]);
  }
  Weights<Real> at(Position p) const {
    Weights<Real> w;
    for (std::size_t i = 0; i < 3; ++i) {
      switch (way_) {
        case Way::kHeight:  // distance to the side over the height above it, both signed
          w[i] = (line_[i].at(p) / length_[i]) / (scale_[i] / length_[i]);
          break;
        case Way::kArea:
          w[i] = doubled_area<Real>(p, p_[(i + 1) % 3], p_[(i + 2) % 3]) / area_;
          break;
        case Way::kShoelace:
          w[i] = shoelace_area<Real>(p, p_[(i + 1) % 3], p_[(i + 2) % 3]) / area_;
          break;
        default: w[i] = line_[i].at(p) / scale_[i]; break;
      }
    }
    return w;
  }
  // Change per pixel right.
  Weights<Real> step() const {
    return {line_[0].a / scale_[0], line_[1].a / scale_[1], line_[2].a / scale_[2]};
  }

 private:
  Way way_;
  std::array<Position, 3> p_;
  std::array<ImplicitLine<Real>, 3> line_;
  Weights<Real> scale_{}, length_{};
  Real area_{};
};

template <class Real>
bool inside(const Weights<Real>& w, bool upper_bound) {
  if (!(w[0] >= 0 && w[1] >= 0 && w[2] >= 0)) return false;
  return !upper_bound || (w[0] <= 1 && w[1] <= 1 && w[2] <= 1);
}

template <class Real>
void shade(const Facet& f, const Weights<Real>& w, int x, int y, Canvas& canvas) {
  if (!canvas.wants_attributes()) return canvas.hit(x, y);
  const auto mix = [&w](double a, double b, double c) {
    return static_cast<double>(w[0] * static_cast<Real>(a) + w[1] * static_cast<Real>(b) +
                               w[2] * static_cast<Real>(c));
  };
  Color color;
  for (std::size_t i = 0; i < 3; ++i) color[i] = mix(f[0].color[i], f[1].color[i], f[2].color[i]);
  canvas.fragment(x, y, mix(f[0].z, f[1].z, f[2].z), color);
}

template <class Real>
void draw(const Facet& facet, Canvas& canvas, const Variant& variant) {
  const Barycentric<Real> barycentric(facet, variant.way);
  const Weights<Real> step = barycentric.step();
  const PixelBox box = pixel_box(facet, canvas);
  for (int y = box.y_first; y <= box.y_last; ++y) {
    if (!canvas.spend(box.empty() ? 1 : box.width())) return;
    Weights<Real> w = barycentric.at({box.x_first + 0.5, y + 0.5});
    for (int x = box.x_first; x <= box.x_last; ++x) {
      if (variant.way != Way::kIncremental) w = barycentric.at({x + 0.5, y + 0.5});
      if (inside(w, variant.upper_bound)) shade(facet, w, x, y, canvas);
      if (variant.way != Way::kIncremental) continue;
      for (std::size_t i = 0; i < 3; ++i) w[i] += step[i];
    }
  }
}

constexpr std::array<Variant, 6> kVariants{{
    {"height", "distance to a side over the height", Way::kHeight, true},
    {"area", "ratio of areas", Way::kArea, false},
    {"shoelace", "ratio of areas by the shoelace formula", Way::kShoelace, false},
    {"ratio", "f(p) / f(vertex), all in [0, 1]", Way::kRatio, true},
    {"ratio_unbounded", "f(p) / f(vertex), all >= 0", Way::kRatio, false},
    {"incremental", "f(p) / f(vertex) by addition along a row", Way::kIncremental, false},
}};

template <class Real>
void add(std::vector<Method>& list, const Variant& v, const char* precision) {
  Method m;
  m.name = std::string("bary_") + v.name + "_" + precision;
  m.row = 7;
  m.family = "barycentric";
  m.title = std::string("Barycentric coordinates, ") + precision + ": " + v.title;
  m.source = std::string(kDrawing) + "; " + kShinar;
  m.complexity = v.way == Way::kIncremental ? "O(box area), 3 additions a pixel"
                                            : "O(box area), 3 divisions a pixel";
  m.use = "coverage and attributes from the same three numbers";
  m.fails =
      v.upper_bound
          ? "samples on shared edges are drawn twice; no area divides by 0, which draws nothing"
          : "samples on shared edges are drawn twice; no area divides by 0: the test sees "
            "infinities";
  m.rule = Rule::kDrawTies;
  m.precision = precision;
  m.attributes = true;
  m.draw = DrawFacet([v](const Facet& f, Canvas& c) { draw<Real>(f, c, v); });
  list.push_back(std::move(m));
}

}  // namespace

void add_barycentric(std::vector<Method>& list) {
  for (const Variant& v : kVariants) add<float>(list, v, "float");
  for (const Variant& v : kVariants) add<double>(list, v, "double");
}

}  // namespace halfspace::methods
