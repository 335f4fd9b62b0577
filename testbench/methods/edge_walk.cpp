// SPDX-License-Identifier: Apache-2.0
//
// Edge walking: two x follow the left and the right edge from row to row, the span between them is
// filled.
#include <cmath>
#include <optional>

#include "arithmetic.hpp"
#include "catalogue.hpp"

namespace halfspace::methods {
namespace {

struct Variant {
  const char* name;
  bool prestep = true;     // start at the first row's centre, not at the vertex
  bool closed = false;     // x <= xR, both ends truncated, as the code of the notes
  int fraction_bits = -1;  // of x and of the slope; -1: Real
};

// What varies linearly down an edge and across a span.
struct Carried {
  double z = 0;
  Color color{};
};
Carried mix(const Carried& a, const Carried& b, double t) {
  Carried out{a.z + t * (b.z - a.z), {}};
  for (std::size_t i = 0; i < 3; ++i) out.color[i] = a.color[i] + t * (b.color[i] - a.color[i]);
  return out;
}
Carried carried(const Vertex& v) { return {v.z, v.color}; }

// One edge on its way down.
template <class Real>
class Walker {
 public:
  Walker(const Vertex& top, const Vertex& bottom, int row, const Variant& variant)
      : top_(top), bottom_(bottom) {
    const Real dy = static_cast<Real>(bottom.y) - static_cast<Real>(top.y);
    slope_ = (static_cast<Real>(bottom.x) - static_cast<Real>(top.x)) / dy;
    const Real down = static_cast<Real>(row) + Real(0.5) - static_cast<Real>(top.y);
    x_ = static_cast<Real>(top.x) + (variant.prestep ? down * slope_ : 0);
    if (variant.fraction_bits >= 0) {
      slope_ = rounded(slope_, variant.fraction_bits);
      x_ = rounded(x_, variant.fraction_bits);
    }
  }
  Real x() const { return x_; }
  void step() { x_ += slope_; }
  Carried at(int row) const {
    return mix(carried(top_), carried(bottom_), (row + 0.5 - top_.y) / (bottom_.y - top_.y));
  }

 private:
  static Real rounded(Real v, int bits) {
    return std::ldexp(std::nearbyint(std::ldexp(v, bits)), -bits);
  }
  const Vertex& top_;
  const Vertex& bottom_;
  Real slope_;
  Real x_;
};

template <class Real>
void fill(const Walker<Real>& left, const Walker<Real>& right, int y, const Variant& variant,
          Canvas& canvas) {
  const double from = static_cast<double>(left.x()), to = static_cast<double>(right.x());
  int first = first_centre(from, canvas.x_first(), canvas.x_last());
  int last = first_centre(to, canvas.x_first(), canvas.x_last()) - 1;
  if (variant.closed) {
    first = last_centre(from + 0.5, canvas.x_first(), canvas.x_last());
    last = last_centre(to + 0.5, canvas.x_first(), canvas.x_last());
  }
  if (!canvas.wants_attributes()) {
    for (int x = first; x <= last; ++x) canvas.hit(x, y);
    return;
  }
  const Carried l = left.at(y), r = right.at(y);
  for (int x = first; x <= last; ++x) {
    const Carried here = mix(l, r, (x + 0.5 - from) / (to - from));
    canvas.fragment(x, y, here.z, here.color);
  }
}

// Rows first..last between two edges; long_left says which of them is at the left.
template <class Real>
bool walk(Walker<Real>& along, Walker<Real>& across, bool long_left, int first, int last,
          const Variant& variant, Canvas& canvas) {
  for (int y = first; y <= last; ++y) {
    const Walker<Real>& left = long_left ? along : across;
    const Walker<Real>& right = long_left ? across : along;
    const double span = std::abs(static_cast<double>(right.x()) - static_cast<double>(left.x()));
    if (!canvas.spend(1 + static_cast<std::uint64_t>(std::min(span, 1e9)))) return false;
    if (y >= canvas.y_first()) fill(left, right, y, variant, canvas);
    along.step();
    across.step();
  }
  return true;
}

template <class Real>
void draw(const Facet& facet, Canvas& canvas, const Variant& variant) {
  std::array<const Vertex*, 3> v{&facet[0], &facet[1], &facet[2]};
  for (const Vertex* p : v) {
    if (!(std::abs(p->x) < 1e6 && std::abs(p->y) < 1e6)) return;  // NaN too
  }
  std::sort(v.begin(), v.end(), [](const Vertex* a, const Vertex* b) { return a->y < b->y; });
  const Vertex &top = *v[0], &middle = *v[1], &bottom = *v[2];
  if (!(top.y < bottom.y)) return;
  // Rows whose centre is at or below the top and above the bottom; a centre level with the middle
  // vertex belongs to the part above, if there is one.
  const auto from = [](double y) { return static_cast<int>(std::ceil(y - 0.5)); };
  const int first = from(top.y);
  const int last = std::min(from(bottom.y) - 1, canvas.y_last());
  const int above = std::min(static_cast<int>(std::floor(middle.y - 0.5)), last);
  const double turn =
      (middle.x - top.x) * (bottom.y - top.y) - (bottom.x - top.x) * (middle.y - top.y);
  Walker<Real> along(top, bottom, first, variant);
  int next = first;
  if (top.y < middle.y) {
    Walker<Real> across(top, middle, first, variant);
    if (!walk(along, across, turn > 0, first, above, variant, canvas)) return;
    next = std::max(first, above + 1);
  }
  if (middle.y < bottom.y) {
    Walker<Real> across(middle, bottom, next, variant);
    walk(along, across, turn > 0, next, last, variant, canvas);
  }
}

// Both ends of every span as exact quotients: ceil of the crossing, in subpixels.
void draw_exact(const Facet& facet, Canvas& canvas) {
  const Fixed fixed{8};
  if (!fixed.holds(facet)) return;
  const Corners<std::int64_t> c = oriented(facet, fixed);
  if (c.area == 0) return;
  const PixelBox box = pixel_box(facet, canvas, 0.5);
  const std::int64_t unit = std::int64_t{2} << fixed.bits;
  for (int y = box.y_first; y <= box.y_last; ++y) {
    if (!canvas.spend(box.empty() ? 1 : box.width())) return;
    const std::int64_t py = fixed.centre(y);
    std::int64_t first = box.x_first, last = box.x_last;
    bool crossed = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if ((c.y[i] <= py) == (c.y[j] <= py)) continue;  // does not cross: top in, bottom out
      crossed = true;
      // Least pixel with x + 1/2 at or beyond the crossing; the denominator made positive.
      std::int64_t dy = c.y[j] - c.y[i];
      std::int64_t numerator = (c.x[j] - c.x[i]) * (py - c.y[i]) + (c.x[i] - unit / 2) * dy;
      const bool left = dy < 0;  // going up, the inside is at its right
      if (dy < 0) numerator = -numerator, dy = -dy;
      const auto pixel = static_cast<std::int64_t>(-floor_div(-numerator, __int128{dy} * unit));
      if (left) first = std::max(first, pixel);
      if (!left) last = std::min(last, pixel - 1);
    }
    if (!crossed) continue;
    for (auto x = static_cast<int>(first); x <= last; ++x) canvas.hit(x, y);
  }
}

Method base(const std::string& name, const std::string& title) {
  Method m;
  m.name = name;
  m.row = 2;
  m.family = "edge_walking";
  m.title = "Edge walking, " + title;
  m.source = std::string(kLuebke) + "; " + kMao;
  m.complexity = "O(rows + pixels covered)";
  m.use = "software on one thread: no pixel outside is tested";
  m.fails = "ties: the sum of slopes rounds, so edges that meet a centre may fall either way";
  m.rule = Rule::kHalfOpen;
  m.precision = "double";
  m.attributes = true;
  return m;
}

}  // namespace

void add_edge_walk(std::vector<Method>& list) {
  Method m = base("walk_prestep", "spans half-open, started at the first row's centre");
  m.draw = DrawFacet([](const Facet& f, Canvas& c) { draw<double>(f, c, {.name = ""}); });
  list.push_back(m);
  m = base("walk_float", "as walk_prestep, in float");
  m.precision = "float";
  m.draw = DrawFacet([](const Facet& f, Canvas& c) { draw<float>(f, c, {.name = ""}); });
  list.push_back(m);
  m = base("walk_closed", "spans closed at both ends (x <= xR)");
  m.fails = "draws the last pixel of every span twice: the next span starts there";
  m.rule = Rule::kDrawTies;
  m.draw = DrawFacet(
      [](const Facet& f, Canvas& c) { draw<double>(f, c, {.name = "", .closed = true}); });
  list.push_back(m);
  m = base("walk_no_prestep", "without the fractional offset to the first row's centre");
  m.fails = "edges start up to a row's slope too far back: slivers vanish, shapes shift";
  m.draw = DrawFacet(
      [](const Facet& f, Canvas& c) { draw<double>(f, c, {.name = "", .prestep = false}); });
  list.push_back(m);
  for (const int bits : {8, 12, 16}) {
    m = base("walk_fixed_f" + std::to_string(bits),
             "slopes with " + std::to_string(bits) + " fraction bits");
    m.precision = "fixed, " + std::to_string(bits) + " fraction bits of x and slope";
    m.fails = "long edges drift by half a unit of the slope per row";
    m.draw = DrawFacet([bits](const Facet& f, Canvas& c) {
      draw<double>(f, c, {.name = "", .fraction_bits = bits});
    });
    list.push_back(m);
  }
  m = base("walk_exact", "span ends as exact quotients of integers");
  m.use = "software on one thread that must not leave a gap; one division per span end";
  m.fails = "";
  m.precision = "fixed, 8 subpixel bits";
  m.subpixel_bits = 8;
  m.exact = true;
  m.attributes = false;
  m.draw = DrawFacet(draw_exact);
  list.push_back(m);
}

}  // namespace halfspace::methods
