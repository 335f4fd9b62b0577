// SPDX-License-Identifier: Apache-2.0
//
// Tiles of the bounding box: rejected when outside one edge, filled when inside all, else pixel by
// pixel.
#include "catalogue.hpp"
#include "edge_function.hpp"

namespace halfspace::methods {
namespace {

// One edge with the values, relative to the tile's first centre, of its best and worst corner.
template <class Number>
struct TileEdge {
  EdgeLine<Number> line;
  Number best{};
  Number worst{};
};

template <class Number>
TileEdge<Number> tile_edge(const EdgeLine<Number>& line, Number reach) {
  const Number zero{};
  return {line, std::max(line.a * reach, zero) + std::max(line.b * reach, zero),
          std::min(line.a * reach, zero) + std::min(line.b * reach, zero)};
}

// Pixels x_first..x_last of one tile.
template <class Arithmetic, class Number>
void draw_tile(const std::array<TileEdge<Number>, 3>& edge, const PixelBox& tile, bool accepted,
               const Arithmetic& arithmetic, Canvas& canvas) {
  for (int y = tile.y_first; y <= tile.y_last; ++y) {
    for (int x = tile.x_first; x <= tile.x_last; ++x) {
      bool in = true;
      for (std::size_t i = 0; i < 3 && in && !accepted; ++i) {
        const Number e = edge[i].line.at(arithmetic.centre(x), arithmetic.centre(y));
        in = inside(edge[i].line, e, Rule::kTopLeft);
      }
      if (in) canvas.hit(x, y);
    }
  }
}

template <class Arithmetic>
void draw(const Facet& facet, Canvas& canvas, const Arithmetic& arithmetic, int side) {
  using Number = typename Arithmetic::Number;
  if (!arithmetic.holds(facet)) return;
  const Corners<Number> corners = oriented(facet, arithmetic);
  if (!(corners.area > 0)) return;
  const PixelBox box = pixel_box(facet, canvas, 0.5);
  if (box.empty()) return;
  const Number reach = arithmetic.centre(side - 1) - arithmetic.centre(0);
  std::array<TileEdge<Number>, 3> edge;
  for (std::size_t i = 0; i < 3; ++i) {
    edge[i] = tile_edge(edge_line(corners, i, Constant::kRelative), reach);
  }
  const auto aligned = [side](int v) { return v & ~(side - 1); };  // side is a power of two
  for (int y = aligned(box.y_first); y <= box.y_last; y += side) {
    for (int x = aligned(box.x_first); x <= box.x_last; x += side) {
      if (!canvas.spend(1)) return;
      bool rejected = false, accepted = true;
      for (const TileEdge<Number>& e : edge) {
        const Number origin = e.line.at(arithmetic.centre(x), arithmetic.centre(y));
        rejected = rejected || origin + e.best < 0;
        accepted = accepted && origin + e.worst > 0;
      }
      if (rejected) continue;
      const PixelBox tile{std::max(x, box.x_first), std::max(y, box.y_first),
                          std::min(x + side - 1, box.x_last), std::min(y + side - 1, box.y_last)};
      if (!canvas.spend(tile.width() * tile.height())) return;
      draw_tile(edge, tile, accepted, arithmetic, canvas);
    }
  }
}

Method base(int side) {
  Method m;
  m.name = "tiled_" + std::to_string(side);
  m.row = 10;
  m.family = "tiled";
  m.title = "Tiles of " + std::to_string(side) + " x " + std::to_string(side) +
            " px with trivial reject and accept";
  m.source = std::string(kDrawing) + "; " + kPineda;
  m.complexity = "O(tiles of the box + pixels of the tiles on the border)";
  m.use = "large triangles: whole tiles are decided at once; hardware works a tile at a time";
  m.rule = Rule::kTopLeft;
  return m;
}

}  // namespace

void add_tiled(std::vector<Method>& list) {
  for (const int side : {4, 8, 16}) {
    Method m = base(side);
    m.precision = "fixed, 8 subpixel bits";
    m.subpixel_bits = 8;
    m.exact = true;
    m.draw = DrawFacet([side](const Facet& f, Canvas& c) { draw(f, c, Fixed{8}, side); });
    list.push_back(std::move(m));
  }
  Method m = base(8);
  m.name += "_float";
  m.title += ", float";
  m.precision = "float";
  m.fails = "the corner's sum rounds apart from the pixel's: tiles on an edge go either way";
  m.draw = DrawFacet([](const Facet& f, Canvas& c) { draw(f, c, Floating<float>{}, 8); });
  list.push_back(std::move(m));
}

}  // namespace halfspace::methods
