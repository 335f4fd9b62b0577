// SPDX-License-Identifier: Apache-2.0
//
// Gouraud shading with a z-buffer: coverage is exact in all variants, they differ in how an
// attribute gets from the vertices to a pixel.
#include "attribute_shading.hpp"

#include <cmath>

#include "catalogue.hpp"
#include "covered.hpp"

namespace halfspace::methods {
namespace {

// The weights of the three vertices at a point, relative to the first vertex.
template <class Real>
class Weights {
 public:
  explicit Weights(const Facet& f) : x_(f[0].x), y_(f[0].y) {
    const auto x1 = static_cast<Real>(f[1].x - x_), y1 = static_cast<Real>(f[1].y - y_);
    const auto x2 = static_cast<Real>(f[2].x - x_), y2 = static_cast<Real>(f[2].y - y_);
    const Real scale = 1 / (x1 * y2 - x2 * y1);
    dx1_ = y2 * scale, dy1_ = -x2 * scale;
    dx2_ = -y1 * scale, dy2_ = x1 * scale;
  }
  std::array<Real, 3> at(int px, int py) const {
    const auto x = static_cast<Real>(px + 0.5 - x_), y = static_cast<Real>(py + 0.5 - y_);
    const Real b = dx1_ * x + dy1_ * y, c = dx2_ * x + dy2_ * y;
    return {1 - b - c, b, c};
  }

 private:
  double x_, y_;
  Real dx1_, dy1_, dx2_, dy2_;
};

// dot(weights, values), values of double rounded to Real.
template <class Real>
Real mix(const std::array<Real, 3>& weight, double a, double b, double c) {
  return weight[0] * static_cast<Real>(a) + weight[1] * static_cast<Real>(b) +
         weight[2] * static_cast<Real>(c);
}

// divide(over, w): over / w in the variant's way, given sums of attribute / w and of 1 / w.
template <class Real, class Divide>
void draw(const Facet& f, Canvas& canvas, bool perspective, Divide&& divide) {
  const Facet at8 = snapped(f, 8);
  const Weights<Real> weights(at8);
  std::array<double, 3> inverse_w{1, 1, 1};
  if (perspective) inverse_w = {1 / f[0].w, 1 / f[1].w, 1 / f[2].w};
  for_each_covered(f, canvas, [&](int x, int y) {
    const std::array<Real, 3> w = weights.at(x, y);
    const double over = static_cast<double>(mix(w, inverse_w[0], inverse_w[1], inverse_w[2]));
    Color color;
    for (std::size_t i = 0; i < 3; ++i) {
      const Real sum = mix(w, f[0].color[i] * inverse_w[0], f[1].color[i] * inverse_w[1],
                           f[2].color[i] * inverse_w[2]);
      color[i] = perspective ? divide(static_cast<double>(sum), over) : static_cast<double>(sum);
    }
    canvas.fragment(x, y, static_cast<double>(mix(w, f[0].z, f[1].z, f[2].z)), color);
  });
}

// Affine colour by addition: the value at the row's first pixel and the gradient rounded to 2^-bits
// levels, then one sum per pixel.
void draw_gradient(const Facet& f, Canvas& canvas, int bits) {
  const Facet at8 = snapped(f, 8);
  const Weights<double> weights(at8);
  const PixelBox box = pixel_box(f, canvas, 0.5);
  const auto round = [bits](double v) {
    return static_cast<std::int64_t>(std::llrint(std::ldexp(v, bits)));
  };
  const auto color_at = [&](std::size_t i, int x, int y) {
    return mix(weights.at(x, y), f[0].color[i], f[1].color[i], f[2].color[i]);
  };
  std::array<std::int64_t, 3> step;
  for (std::size_t i = 0; i < 3; ++i) step[i] = round(color_at(i, 1, 0) - color_at(i, 0, 0));
  int row = canvas.y_first() - 1, column = 0;
  std::array<std::int64_t, 3> value{};
  for_each_covered(f, canvas, [&](int x, int y) {
    if (y != row) {
      row = y, column = box.x_first;
      for (std::size_t i = 0; i < 3; ++i) value[i] = round(color_at(i, column, y));
    }
    for (; column < x; ++column) {
      for (std::size_t i = 0; i < 3; ++i) value[i] += step[i];
    }
    Color color;
    for (std::size_t i = 0; i < 3; ++i) color[i] = std::ldexp(static_cast<double>(value[i]), -bits);
    canvas.fragment(x, y, mix(weights.at(x, y), f[0].z, f[1].z, f[2].z), color);
  });
}

Method base(const std::string& name, const std::string& title, const std::string& precision) {
  Method m;
  m.name = "shade_" + name;
  m.row = 15;
  m.family = "interpolation";
  m.title = "Gouraud shading and z-buffer, " + title;
  m.source = std::string(kDrawing) + "; " + kShinar +
             "; H. Gouraud, Continuous Shading of Curved Surfaces, 1971";
  m.complexity = "2 products and, with perspective, a division per attribute and pixel";
  m.use = "attributes of surfaces seen in perspective";
  m.rule = Rule::kTopLeft;
  m.precision = precision;
  m.subpixel_bits = 8;
  m.exact = true;
  m.attributes = true;
  return m;
}

}  // namespace

double reciprocal(double v, int bits) {
  int exponent = 0;
  const double significand = std::frexp(1 / v, &exponent);  // in [1/2, 1)
  const double rounded = std::nearbyint(std::ldexp(significand, bits + 1));
  return std::ldexp(rounded, exponent - bits - 1);
}

void add_shading(std::vector<Method>& list) {
  const auto quotient = [](double over, double w) { return over / w; };
  const auto add = [&list](Method m, const char* fails, DrawFacet draw_one) {
    m.fails = fails;
    m.draw = std::move(draw_one);
    list.push_back(std::move(m));
  };
  add(base("affine", "linear on the screen", "double"),
      "perspective: textures and colours slide towards the far side of a triangle",
      [=](const Facet& f, Canvas& c) { draw<double>(f, c, false, quotient); });
  add(base("perspective", "attribute / w over 1 / w", "double"), "w = 0: clip first",
      [=](const Facet& f, Canvas& c) { draw<double>(f, c, true, quotient); });
  add(base("perspective_float", "attribute / w over 1 / w, in float", "float"),
      "slivers: the weights lose bits as the area cancels",
      [=](const Facet& f, Canvas& c) { draw<float>(f, c, true, quotient); });
  for (const int bits : {8, 10, 12, 16}) {
    const std::string b = std::to_string(bits);
    add(base("reciprocal_r" + b, "attribute / w times a reciprocal of " + b + " bits",
             "reciprocal of " + b + " fraction bits"),
        "the reciprocal's rounding times 255 levels", [bits](const Facet& f, Canvas& c) {
          draw<double>(f, c, true,
                       [bits](double over, double w) { return over * reciprocal(w, bits); });
        });
  }
  for (const int bits : {8, 12, 16}) {
    const std::string b = std::to_string(bits);
    Method m = base("gradient_f" + b, "linear on the screen, gradients of " + b + " fraction bits",
                    "gradient of " + b + " fraction bits");
    m.complexity = "1 addition per attribute and pixel";
    add(m, "half a unit of the gradient per step, along a row; perspective as shade_affine",
        [bits](const Facet& f, Canvas& c) { draw_gradient(f, c, bits); });
  }
}

}  // namespace halfspace::methods
