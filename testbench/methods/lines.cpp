// SPDX-License-Identifier: Apache-2.0
//
// Lines: one pixel per step along the longer axis, the nearest one across.
#include <cmath>

#include "catalogue.hpp"

namespace halfspace::methods {
namespace {

// A segment seen so that its longer axis is u, and u grows.
struct Steep {
  double u0, v0, u1, v1;
  bool swapped;  // u is y

  explicit Steep(const Segment& s)
      : swapped(std::abs(s.to.y - s.from.y) > std::abs(s.to.x - s.from.x)) {
    const auto u = [this](const Position& p) { return swapped ? p.y : p.x; };
    const auto v = [this](const Position& p) { return swapped ? p.x : p.y; };
    const bool back = u(s.to) < u(s.from);
    const Position &a = back ? s.to : s.from, &b = back ? s.from : s.to;
    u0 = u(a), v0 = v(a), u1 = u(b), v1 = v(b);
  }
  double slope() const { return u1 > u0 ? (v1 - v0) / (u1 - u0) : 0.0; }
};

// Calls plot(u, v) for u in first..last, the pixels of the canvas whose centres lie between the
// ends; v_at(u) is the minor coordinate in px.
template <class At>
void draw_line(const Segment& segment, Canvas& canvas, At&& make_v_at) {
  for (const double c : {segment.from.x, segment.from.y, segment.to.x, segment.to.y}) {
    if (!(std::abs(c) < 1e6)) return;
  }
  const Steep s(segment);
  const auto first = static_cast<int>(std::ceil(s.u0 - 0.5));
  const int end = s.swapped ? canvas.y_last() : canvas.x_last();
  const int last = std::min(static_cast<int>(std::floor(s.u1 - 0.5)), end);
  if (first > last || !canvas.spend(static_cast<std::uint64_t>(last - first + 1))) return;
  auto v_at = make_v_at(s, first);
  for (int u = first; u <= last; ++u) {
    // The pixel that holds v is the one whose centre is nearest.
    const auto v = static_cast<int>(v_at(u));
    if (s.swapped) canvas.hit(v, u);
    if (!s.swapped) canvas.hit(u, v);
  }
}

template <class Real>
void naive(const Segment& segment, Canvas& canvas, bool round) {
  draw_line(segment, canvas, [round](const Steep& s, int) {
    return [m = static_cast<Real>(s.slope()), u0 = static_cast<Real>(s.u0),
            v0 = static_cast<Real>(s.v0), round](int u) {
      const Real v = m * (static_cast<Real>(u) + Real(0.5) - u0) + v0;
      return std::floor(round ? v : v - Real(0.5));
    };
  });
}

template <class Real>
void dda(const Segment& segment, Canvas& canvas) {
  draw_line(segment, canvas, [](const Steep& s, int first) {
    const auto m = static_cast<Real>(s.slope());
    Real v = m * (static_cast<Real>(first) + Real(0.5) - static_cast<Real>(s.u0)) +
             static_cast<Real>(s.v0) - m;
    return [m, v](int) mutable { return std::floor(v += m); };
  });
}

// v and slope as integers of 2^-bits px; the start is rounded to nearest, the slope as asked.
void dda_fixed(const Segment& segment, Canvas& canvas, int bits, bool round) {
  draw_line(segment, canvas, [bits, round](const Steep& s, int first) {
    const double start = s.v0 + s.slope() * (first + 0.5 - s.u0);
    const double scaled = std::ldexp(s.slope(), bits);
    const auto m = static_cast<std::int64_t>(round ? std::nearbyint(scaled) : std::trunc(scaled));
    std::int64_t v = static_cast<std::int64_t>(std::nearbyint(std::ldexp(start, bits))) - m;
    return [m, v, bits](int) mutable { return (v += m) >> bits; };
  });
}

// Bresenham's idea for ends between pixels: the same DDA with the remainder kept, in 1/256 px.
void exact(const Segment& segment, Canvas& canvas) {
  const auto grid = [](Position p) {
    return Position{std::nearbyint(p.x * 256) / 256, std::nearbyint(p.y * 256) / 256};
  };
  draw_line({grid(segment.from), grid(segment.to)}, canvas, [](const Steep& s, int first) {
    const auto unit = [](double v) { return static_cast<std::int64_t>(v * 256); };
    const std::int64_t du = std::max<std::int64_t>(unit(s.u1) - unit(s.u0), 1);
    const std::int64_t dv = unit(s.v1) - unit(s.v0);
    // v = (v0 du + dv (u - u0)) / du in 1/256 px; quotient in pixels, remainder below 256 du.
    std::int64_t rest = unit(s.v0) * du + dv * (std::int64_t{first} * 256 + 128 - unit(s.u0));
    const std::int64_t pixel = 256 * du;
    std::int64_t v = rest / pixel - (rest % pixel < 0 ? 1 : 0);
    rest -= v * pixel;
    bool started = false;
    return [=](int) mutable {
      if (started) rest += 256 * dv;
      started = true;
      while (rest >= pixel) rest -= pixel, ++v;
      while (rest < 0) rest += pixel, --v;
      return v;
    };
  });
}

Method base(const std::string& name, const std::string& title, const std::string& precision) {
  Method m;
  m.name = "line_" + name;
  m.row = 1;
  m.family = "lines";
  m.title = "Line, " + title;
  m.source = kMao;
  m.complexity = "O(longer side)";
  m.use = "wireframes, and the inner loop of edge walking";
  m.precision = precision;
  return m;
}

}  // namespace

void add_lines(std::vector<Method>& list) {
  const auto add = [&list](Method m, const char* fails, DrawSegment draw) {
    m.fails = fails;
    m.draw = std::move(draw);
    list.push_back(std::move(m));
  };
  constexpr const char* kTie = "a line exactly between two pixels may take either";
  add(base("naive", "y = m x + B at every column, nearest pixel", "double"), kTie,
      [](const Segment& s, Canvas& c) { naive<double>(s, c, true); });
  add(base("naive_float", "as line_naive, in float", "float"),
      "far from the origin the pixel is off by the float's own spacing",
      [](const Segment& s, Canvas& c) { naive<float>(s, c, true); });
  add(base("naive_floor", "y = m x + B truncated to the grid of centres, not rounded", "double"),
      "half a pixel too high on average: truncation is not rounding",
      [](const Segment& s, Canvas& c) { naive<double>(s, c, false); });
  add(base("dda", "y += m (DDA)", "double"), kTie,
      [](const Segment& s, Canvas& c) { dda<double>(s, c); });
  add(base("dda_float", "y += m (DDA), in float", "float"),
      "errors of the additions accumulate along the line",
      [](const Segment& s, Canvas& c) { dda<float>(s, c); });
  for (const int bits : {8, 12, 16}) {
    const std::string b = std::to_string(bits);
    add(base("dda_fixed_f" + b, "y += m with " + b + " fraction bits, slope rounded",
             "fixed, " + b + " fraction bits"),
        "drifts by up to half a unit of the slope per step",
        [bits](const Segment& s, Canvas& c) { dda_fixed(s, c, bits, true); });
  }
  add(base("dda_fixed_f8_truncate", "y += m with 8 fraction bits, slope truncated",
           "fixed, 8 fraction bits"),
      "drifts by up to a unit of the slope per step, always to the same side",
      [](const Segment& s, Canvas& c) { dda_fixed(s, c, 8, false); });
  Method m =
      base("exact", "DDA that keeps the remainder (after Bresenham)", "fixed, 8 subpixel bits");
  m.source = std::string(kMao) +
             "; J. Bresenham, Algorithm for computer control of a digital plotter, 1965";
  m.subpixel_bits = 8;
  m.exact = true;
  add(m, "", exact);
}

}  // namespace halfspace::methods
