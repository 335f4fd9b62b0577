// SPDX-License-Identifier: Apache-2.0
#include "edge_function.hpp"

#include "catalogue.hpp"

namespace halfspace::methods {
namespace {

struct Variant {
  const char* name;
  const char* title;
  Constant constant;
  Rule rule;
  const char* fails;
};

constexpr const char* kTies = "samples on a shared edge are nobody's: gaps";
constexpr const char* kCancel =
    "C cancels: wrong pixels that grow with the distance from the origin";

constexpr std::array<Variant, 6> kVariants{{
    {"strict", "C averaged over both vertices, > 0", Constant::kAverage, Rule::kSkipTies, kTies},
    {"inclusive", "relative to a vertex, >= 0", Constant::kRelative, Rule::kDrawTies,
     "samples on a shared edge are drawn twice"},
    {"cross", "C = x0 y1 - x1 y0", Constant::kCross, Rule::kTopLeft, kCancel},
    {"vertex", "C = -A x0 - B y0", Constant::kVertex, Rule::kTopLeft, kCancel},
    {"average", "C averaged over both vertices", Constant::kAverage, Rule::kTopLeft, kCancel},
    {"relative", "A (x - x0) + B (y - y0)", Constant::kRelative, Rule::kTopLeft,
     "differences and products round once they need more bits than the significand has"},
}};

template <class Real>
void add(std::vector<Method>& list, const Variant& v, const char* precision) {
  Method m;
  m.name = std::string("edge_") + precision + "_" + v.name;
  m.row = 3;
  m.family = "edge_functions";
  m.title = std::string("Edge functions over the bounding box, ") + precision + ": " + v.title;
  m.source = std::string(kLuebke) + "; " + kPineda;
  m.complexity = "O(box area)";
  m.use = "a first rasterizer; pixels are independent, so it parallelises";
  m.fails = v.fails;
  m.rule = v.rule;
  m.precision = precision;
  // 2^14 px in 1/512 px is 23 bits; sums of two products of 24-bit differences fit 53 bits.
  m.exact = std::is_same_v<Real, double> && v.rule == Rule::kTopLeft;
  m.draw = DrawFacet([v](const Facet& facet, Canvas& canvas) {
    draw_edge_function(facet, canvas, Floating<Real>{}, v.constant, v.rule);
  });
  m.edges = edges_at(Floating<Real>{}, v.constant, v.rule);
  if (m.exact) m.fails = "real-valued vertices: products round, and a tie may fall either way";
  list.push_back(std::move(m));
}

void add_fixed(std::vector<Method>& list, int bits) {
  Method m;
  m.name = "edge_fixed_s" + std::to_string(bits);
  m.row = 3;
  m.family = "edge_functions";
  m.title = "Edge functions over the bounding box, integers, vertices on 1/" +
            std::to_string(1 << bits) + " px";
  m.source = std::string(kPineda) + "; Direct3D 11.3 specification (top-left rule)";
  m.complexity = "O(box area)";
  m.use = "whenever every sample of a mesh must have one owner";
  m.fails = "";
  m.rule = Rule::kTopLeft;
  m.precision = "fixed, " + std::to_string(bits) + " subpixel bits";
  m.subpixel_bits = bits;
  m.exact = true;
  m.draw = DrawFacet([bits](const Facet& facet, Canvas& canvas) {
    draw_edge_function(facet, canvas, Fixed{bits}, Constant::kRelative, Rule::kTopLeft);
  });
  m.edges = edges_at(Fixed{bits}, Constant::kRelative, Rule::kTopLeft);
  list.push_back(std::move(m));
}

// Int32 that wraps, as an accumulator too narrow does in silence.
struct Wrapping {
  std::uint32_t bits = 0;
  std::int32_t value() const { return static_cast<std::int32_t>(bits); }
};
Wrapping wrap(std::int64_t v) { return {static_cast<std::uint32_t>(v)}; }

// The edge's value in units of 1/256 px, less the bias. Doubled units would waste two bits.
Wrapping wrapped_value(const EdgeLine<std::int64_t>& e, int x, int y, int bias) {
  const Fixed fixed{8};
  return wrap(e.at(fixed.centre(x), fixed.centre(y)) / 4 - bias);
}

void draw_wrapping(const Facet& facet, Canvas& canvas) {
  const Fixed fixed{8};
  if (!fixed.holds(facet)) return;
  const Corners<std::int64_t> c = oriented(facet, fixed);
  if (c.area <= 0) return;
  const PixelBox box = pixel_box(facet, canvas, 0.5);
  for (int y = box.y_first; y <= box.y_last; ++y) {
    if (!canvas.spend(box.empty() ? 1 : box.width())) return;
    for (int x = box.x_first; x <= box.x_last; ++x) {
      bool covered = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const EdgeLine<std::int64_t> e = edge_line(c, i, Constant::kRelative);
        covered = covered && wrapped_value(e, x, y, e.top_left() ? 0 : 1).value() >= 0;
      }
      if (covered) canvas.hit(x, y);
    }
  }
}

OwnEdges wrapping_edges(const Facet& facet, int x, int y) {
  const Fixed fixed{8};
  if (!fixed.holds(facet)) return std::nullopt;
  const Corners<std::int64_t> c = oriented(facet, fixed);
  if (c.area <= 0) return std::nullopt;
  std::array<OwnEdge, 3> out;
  for (std::size_t i = 0; i < 3; ++i) {
    const EdgeLine<std::int64_t> e = edge_line(c, corner_edge(c, i), Constant::kRelative);
    const auto px2 = [&](int bias) {
      return std::ldexp(wrapped_value(e, x, y, bias).value(), -16);
    };
    const double biased = px2(e.top_left() ? 0 : 1);
    out[i] = {px2(0), biased, biased >= 0};
  }
  return out;
}

}  // namespace

void add_edge_function(std::vector<Method>& list) {
  for (const Variant& variant : kVariants) add<float>(list, variant, "float");
  for (const Variant& variant : kVariants) add<double>(list, variant, "double");
  for (const int bits : {4, 6, 8, 10, 12}) add_fixed(list, bits);
  Method narrow = list.back();
  narrow.name = "edge_fixed_s8_int32";
  narrow.title = "Edge functions over the bounding box, 8 subpixel bits in 32-bit integers";
  narrow.fails = "wraps in silence once an edge value needs more than 32 bits (2^7.5 px a side)";
  narrow.precision = "fixed, 8 subpixel bits, int32";
  narrow.use = "triangles below 128 px, where no edge value can wrap";
  narrow.subpixel_bits = 8;
  narrow.exact = false;
  narrow.draw = DrawFacet(draw_wrapping);
  narrow.edges = wrapping_edges;
  list.push_back(std::move(narrow));
}

}  // namespace halfspace::methods
