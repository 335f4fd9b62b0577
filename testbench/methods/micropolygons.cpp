// SPDX-License-Identifier: Apache-2.0
//
// Recursive subdivision of the triangle: cut at the edges' midpoints into four until it is no wider
// than a pixel, then each micropolygon owns the centres in it. After REYES, which dices into quads.
#include "arithmetic.hpp"
#include "catalogue.hpp"
#include "edge_function.hpp"

namespace halfspace::methods {
namespace {

Vertex middle(const Vertex& a, const Vertex& b) {
  Vertex m{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2, (a.w + b.w) / 2, {}};
  for (std::size_t i = 0; i < 3; ++i) m.color[i] = (a.color[i] + b.color[i]) / 2;
  return m;
}

// One colour for all of a micropolygon: that is what makes it one.
void draw_small(const Facet& facet, Canvas& canvas, const PixelBox& box) {
  const Corners<double> corners = oriented(facet, Floating<double>{});
  if (!(corners.area > 0)) return;
  std::array<EdgeLine<double>, 3> edge;
  for (std::size_t i = 0; i < 3; ++i) edge[i] = edge_line(corners, i, Constant::kRelative);
  Color color;
  for (std::size_t c = 0; c < 3; ++c) {
    color[c] = (facet[0].color[c] + facet[1].color[c] + facet[2].color[c]) / 3;
  }
  for (int y = box.y_first; y <= box.y_last; ++y) {
    for (int x = box.x_first; x <= box.x_last; ++x) {
      bool in = true;
      for (const EdgeLine<double>& e : edge) {
        in = in && inside(e, e.at(x + 0.5, y + 0.5), Rule::kTopLeft);
      }
      if (in) canvas.fragment(x, y, (facet[0].z + facet[1].z + facet[2].z) / 3, color);
    }
  }
}

// depth: cuts still allowed; a coordinate beyond all reason must not recurse for ever.
void divide(const Facet& facet, Canvas& canvas, double size, int depth) {
  if (!canvas.spend(1)) return;
  const PixelBox box = pixel_box(facet, canvas);
  if (box.empty()) return;  // no centre in it
  const auto [left, right] = std::minmax({facet[0].x, facet[1].x, facet[2].x});
  const auto [top, bottom] = std::minmax({facet[0].y, facet[1].y, facet[2].y});
  if (depth == 0 || (right - left <= size && bottom - top <= size)) {
    return draw_small(facet, canvas, box);
  }
  const Vertex ab = middle(facet[0], facet[1]), bc = middle(facet[1], facet[2]),
               ca = middle(facet[2], facet[0]);
  divide({facet[0], ab, ca}, canvas, size, depth - 1);
  divide({ab, facet[1], bc}, canvas, size, depth - 1);
  divide({ca, bc, facet[2]}, canvas, size, depth - 1);
  divide({ab, bc, ca}, canvas, size, depth - 1);
}

}  // namespace

void add_micropolygons(std::vector<Method>& list) {
  Method m;
  m.name = "micropolygons";
  m.row = 12;
  m.family = "subdivision";
  m.title = "Recursive subdivision of the triangle down to 1 px, double";
  m.source = std::string(kLuebke) +
             "; R. Cook, L. Carpenter and E. Catmull, The Reyes Image Rendering Architecture, 1987";
  m.complexity = "O(box area x 4/3), a small triangle per pixel";
  m.use = "displaced or curved surfaces, where small pieces are wanted anyway";
  m.fails =
      "diced in the window, colours are affine: wrong in perspective; vertices with too many bits "
      "make midpoints round";
  m.rule = Rule::kTopLeft;
  m.precision = "double";
  // Midpoints add a bit a level: 14 + 8 + 15 bits. Differences within a pixel: products fit 53.
  m.exact = true;
  m.attributes = true;
  m.draw = DrawFacet([](const Facet& facet, Canvas& canvas) { divide(facet, canvas, 1.0, 20); });
  list.push_back(std::move(m));
}

}  // namespace halfspace::methods
