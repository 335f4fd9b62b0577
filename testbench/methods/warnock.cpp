// SPDX-License-Identifier: Apache-2.0
//
// Recursive subdivision of the screen: a square is empty, full, or cut into four, down to pixels.
#include <bit>

#include "catalogue.hpp"
#include "edge_function.hpp"

namespace halfspace::methods {
namespace {

class Warnock {
 public:
  Warnock(const Facet& facet, Canvas& canvas) : canvas_(canvas) {
    if (!fixed_.holds(facet)) return;
    const Corners<std::int64_t> corners = oriented(facet, fixed_);
    if (corners.area <= 0) return;
    for (std::size_t i = 0; i < 3; ++i) edge_[i] = edge_line(corners, i, Constant::kRelative);
    const auto side = static_cast<unsigned>(std::max(canvas.width(), canvas.height()));
    divide(canvas.x_first(), canvas.y_first(), static_cast<int>(std::bit_ceil(side)));
  }

 private:
  enum class State { kOutside, kInside, kMixed };

  // The square's corner centres against all edges, ties included.
  State state(int x, int y, int side) const {
    bool inside_all = true;
    for (const EdgeLine<std::int64_t>& e : edge_) {
      int in = 0;
      for (const int cy : {y, y + side - 1}) {
        for (const int cx : {x, x + side - 1}) {
          in += inside(e, e.at(fixed_.centre(cx), fixed_.centre(cy)), Rule::kTopLeft) ? 1 : 0;
        }
      }
      if (in == 0) return State::kOutside;
      inside_all = inside_all && in == 4;
    }
    return inside_all ? State::kInside : State::kMixed;
  }

  void divide(int x, int y, int side) {
    if (x > canvas_.x_last() || y > canvas_.y_last() || !canvas_.spend(1)) return;
    const State s = state(x, y, side);
    if (s == State::kOutside) return;
    if (s == State::kInside) return fill(x, y, side);
    const int half = side / 2;  // a pixel is never mixed: its four corners are one centre
    for (const int cy : {y, y + half}) {
      for (const int cx : {x, x + half}) divide(cx, cy, half);
    }
  }

  void fill(int x, int y, int side) {
    const int right = std::min(x + side - 1, canvas_.x_last());
    const int bottom = std::min(y + side - 1, canvas_.y_last());
    for (int py = y; py <= bottom; ++py) {
      for (int px = x; px <= right; ++px) canvas_.hit(px, py);
    }
  }

  Fixed fixed_{8};
  Canvas& canvas_;
  std::array<EdgeLine<std::int64_t>, 3> edge_;
};

}  // namespace

void add_warnock(std::vector<Method>& list) {
  Method m;
  m.name = "warnock";
  m.row = 12;
  m.family = "subdivision";
  m.title = "Recursive subdivision of the screen, in integers";
  m.source =
      std::string(kLuebke) +
      "; J. Warnock, A Hidden Surface Algorithm for Computer Generated Halftone Pictures, 1969";
  m.complexity = "O(perimeter x log side)";
  m.use = "large shapes; the same quadtree that a pyramid of grids walks 64 squares at a time";
  m.fails = "";
  m.rule = Rule::kTopLeft;
  m.precision = "fixed, 8 subpixel bits";
  m.subpixel_bits = 8;
  m.exact = true;
  m.draw = DrawFacet([](const Facet& facet, Canvas& canvas) { Warnock(facet, canvas); });
  list.push_back(std::move(m));
}

}  // namespace halfspace::methods
