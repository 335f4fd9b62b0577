// SPDX-License-Identifier: Apache-2.0
#include "uncut_plane.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace halfspace {
namespace {

// Both errors are exact (Knuth; Dekker and Veltkamp).
Twofold sum(double a, double b) {
  const double high = a + b;
  const double part = high - a;
  return {high, (a - (high - part)) + (b - part)};
}

Twofold product(double a, double b) {
  constexpr double kSplit = 134217729.0;  // 2^27 + 1
  const auto upper = [](double v) {
    const double big = kSplit * v;
    return big - (big - v);
  };
  const double high = a * b;
  const double a1 = upper(a), b1 = upper(b);
  const double a2 = a - a1, b2 = b - b1;
  return {high, ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2};
}

// |b| is below |a|, or a is 0.
Twofold renormalized(double a, double b) {
  const double high = a + b;
  return {high, b - (high - a)};
}

Twofold operator+(const Twofold& a, const Twofold& b) {
  const Twofold high = sum(a.high, b.high);
  const Twofold low = sum(a.low, b.low);
  const Twofold first = renormalized(high.high, high.low + low.high);
  return renormalized(first.high, first.low + low.low);
}

Twofold operator-(const Twofold& a, const Twofold& b) { return a + Twofold{-b.high, -b.low}; }

Twofold operator*(const Twofold& a, const Twofold& b) {
  const Twofold high = product(a.high, b.high);
  return renormalized(high.high, high.low + (a.high * b.low + a.low * b.high));
}

Twofold operator*(const Twofold& a, double b) { return a * Twofold{b, 0.0}; }

double quotient(const Twofold& a, const Twofold& b) { return (a.high + a.low) / (b.high + b.low); }

// An order of the vertices that does not depend on the one they came in.
bool before(const ClipVertex& a, const ClipVertex& b) {
  const auto key = [](const ClipVertex& v) {
    const glm::dvec4& p = v.position;
    return std::tie(p.x, p.y, p.z, p.w, v.attribute);
  };
  return key(a) < key(b);
}

}  // namespace

UncutPlane::UncutPlane(const std::array<ClipVertex, 3>& triangle, double half_width,
                       double half_height) {
  std::array<ClipVertex, 3> sorted = triangle;
  double greatest = 0.0;
  for (ClipVertex& vertex : sorted) {
    for (int axis = 0; axis < 4; ++axis) {
      greatest = std::max(greatest, std::abs(vertex.position[axis]));
    }
    // As projection packs them; a NaN counts as 0.
    for (double& value : vertex.attribute) value = value > 0.0 ? std::min(value, 255.0) : 0.0;
  }
  std::sort(sorted.begin(), sorted.end(), before);
  int exponent = 0;
  std::frexp(greatest, &exponent);
  unit_ = std::ldexp(1.0, -exponent);  // products of three stay far from the ends of the range
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec4 p = sorted[i].position * unit_;
    corner_[i] = {sum(p.x, p.w) * half_width, sum(p.w, -p.y) * half_height, sum(p.z, p.w), p.w,
                  sorted[i].attribute};
  }
}

UncutPlane::Values UncutPlane::at(const Point& point, int attributes) const {
  std::array<Twofold, 3> x, y, weight;
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = corner_[i].x - product(corner_[i].w, point.x);
    y[i] = corner_[i].y - product(corner_[i].w, point.y);
  }
  Twofold all, of_w, of_z;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    weight[i] = x[j] * y[k] - y[j] * x[k];
    all = all + weight[i];
    of_w = of_w + weight[i] * corner_[i].w;
    of_z = of_z + weight[i] * corner_[i].z;
  }
  Values out;
  out.depth = quotient(of_z, of_w) / 2.0;
  out.inverse_w = quotient(all, of_w) * unit_;
  for (std::size_t n = 0; n < static_cast<std::size_t>(attributes); ++n) {
    Twofold of_attribute;
    for (std::size_t i = 0; i < 3; ++i) {
      of_attribute = of_attribute + weight[i] * corner_[i].attribute[n];
    }
    out.attribute[n] = quotient(of_attribute, all);
  }
  return out;
}

}  // namespace halfspace
