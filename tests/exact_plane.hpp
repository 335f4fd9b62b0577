// SPDX-License-Identifier: Apache-2.0
//
// A triangle's plane in exact integers, from its clip-space vertices: what depth and colour should
// be anywhere. From the definition, which the model's geometry does not share.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "geometry.hpp"

namespace halfspace {

using Exact = boost::multiprecision::int1024_t;

// Coordinates must be whole multiples of 2^-kExactBits, attributes whole numbers.
inline constexpr int kExactBits = 30;
inline double exactly(double v) {
  return std::ldexp(std::nearbyint(std::ldexp(v, kExactBits)), -kExactBits);
}

class ExactPlane {
 public:
  // bits: fraction bits of the positions asked for, px.
  ExactPlane(const std::array<ClipVertex, 3>& t, const FrameState& frame, int bits) : t_(t) {
    const auto whole = [](double v) { return Exact(std::ldexp(v, kExactBits)); };
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec4& p = t[i].position;
      x_[i] = ((whole(p.x) + whole(p.w)) * frame.width) << bits;
      y_[i] = ((whole(p.w) - whole(p.y)) * frame.height) << bits;
      z_[i] = whole(p.z) + whole(p.w);
      w_[i] = whole(p.w);
    }
  }

  struct Values {
    Exact scale;                     // not 0 unless the plane is seen edge-on
    Exact depth;                     // (z/w + 1) is depth / scale
    Exact weight;                    // 1/w is weight / scale
    std::array<Exact, 3> attribute;  // times weight
  };
  Values at(std::int64_t x, std::int64_t y) const {
    std::array<Exact, 3> dx, dy;
    for (std::size_t i = 0; i < 3; ++i) {
      dx[i] = x_[i] - 2 * w_[i] * x;
      dy[i] = y_[i] - 2 * w_[i] * y;
    }
    Values out{0, 0, 0, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const Exact weight = dx[j] * dy[k] - dy[j] * dx[k];
      out.scale += weight * w_[i];
      out.depth += weight * z_[i];
      out.weight += weight;
      for (std::size_t n = 0; n < 3; ++n) {
        out.attribute[n] += weight * static_cast<std::int64_t>(t_[i].attribute[n]);
      }
    }
    return out;
  }

 private:
  std::array<ClipVertex, 3> t_;
  std::array<Exact, 3> x_, y_, z_, w_;
};

inline double ratio(Exact numerator, Exact denominator) {
  if (denominator < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  const Exact whole = numerator / denominator;
  const Exact rest = numerator - whole * denominator;
  // The remainder's leading 60 bits decide.
  const Exact part = (rest << 60) / denominator;
  return whole.convert_to<double>() + std::ldexp(part.convert_to<double>(), -60);
}

// |got - clamp(numerator / denominator, 0, most)|.
inline double error_of(std::uint32_t got, const Exact& numerator, const Exact& denominator,
                       std::int64_t most) {
  const double far = ratio(numerator, denominator);
  if (far <= 0) return got;
  if (far >= static_cast<double>(most)) return static_cast<double>(most - got);
  return std::abs(ratio(got * denominator - numerator, denominator));
}

}  // namespace halfspace
