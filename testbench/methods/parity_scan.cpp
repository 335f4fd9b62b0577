// SPDX-License-Identifier: Apache-2.0
//
// Any polygon, row by row: a pixel is inside when an odd number of edges was crossed on the way to
// it. Which ends of an edge count decides what happens at vertices level with a row.
#include <algorithm>
#include <cmath>

#include "catalogue.hpp"
#include "polygon.hpp"

namespace halfspace::methods {
namespace {

enum class Ends { kClosed, kOpen, kTopIn };  // both count, neither, the one with the least y

bool crosses(const PolygonEdge& e, double y, Ends ends) {
  if (e.top.y == e.bottom.y) return false;  // horizontal edges never count
  switch (ends) {
    case Ends::kClosed: return e.top.y <= y && y <= e.bottom.y;
    case Ends::kOpen: return e.top.y < y && y < e.bottom.y;
    case Ends::kTopIn: return e.top.y <= y && y < e.bottom.y;
  }
  return false;
}

// Sorted pixels at which the parity changes, to pixels drawn.
void fill_odd(std::vector<std::int64_t>& changes, int y, Canvas& canvas) {
  std::sort(changes.begin(), changes.end());
  for (std::size_t i = 0; i + 1 < changes.size(); i += 2) {
    const auto last = std::min<std::int64_t>(changes[i + 1] - 1, canvas.x_last());
    for (auto x = std::max<std::int64_t>(changes[i], canvas.x_first()); x <= last; ++x) {
      canvas.hit(static_cast<int>(x), y);
    }
  }
  // An odd crossing left over: everything to the right counts as inside.
  if (changes.size() % 2 == 0) return;
  for (auto x = std::max<std::int64_t>(changes.back(), canvas.x_first()); x <= canvas.x_last(); ++x)
    canvas.hit(static_cast<int>(x), y);
}

void draw(const Polygon& polygon, Canvas& canvas, Ends ends, bool exact) {
  std::vector<PolygonEdge> edges = polygon_edges(polygon);
  double top = 65536, bottom = -65536;
  for (PolygonEdge& e : edges) {
    if (exact) {
      for (double* v : {&e.top.x, &e.top.y, &e.bottom.x, &e.bottom.y}) {
        *v = std::nearbyint(*v * 256) / 256;
      }
    }
    top = std::min(top, e.top.y);
    bottom = std::max(bottom, e.bottom.y);
  }
  const int last = last_centre(bottom, canvas.y_first(), canvas.y_last());
  std::vector<std::int64_t> changes;
  for (int y = first_centre(top, canvas.y_first(), canvas.y_last()); y <= last; ++y) {
    if (!canvas.spend(edges.size())) return;
    changes.clear();
    for (const PolygonEdge& e : edges) {
      if (!crosses(e, y + 0.5, ends)) continue;
      changes.push_back(exact ? crossing_pixel(e, y)
                              : static_cast<std::int64_t>(std::ceil(crossing_x(e, y + 0.5) - 0.5)));
    }
    fill_odd(changes, y, canvas);
  }
}

void add(std::vector<Method>& list, const char* name, const char* title, Ends ends, bool exact,
         const char* fails) {
  Method m;
  m.name = std::string("parity_") + name;
  m.row = 13;
  m.family = "polygons";
  m.title = std::string("Polygons by parity, ") + title;
  m.source = kMao;
  m.complexity = "O(rows x edges)";
  m.use = "any polygon, concave, with holes or crossing itself, without triangulating it";
  m.fails = fails;
  m.rule = ends == Ends::kTopIn ? Rule::kHalfOpen : Rule::kUnspecified;
  m.precision = exact ? "fixed, 8 subpixel bits" : "double";
  m.subpixel_bits = exact ? 8 : -1;
  m.exact = exact;
  m.draw = DrawPolygon([ends, exact](const Polygon& p, Canvas& c) { draw(p, c, ends, exact); });
  list.push_back(std::move(m));
}

}  // namespace

void add_parity_scan(std::vector<Method>& list) {
  constexpr const char* kVertex =
      "a vertex level with a row counts twice or not at all: rows are missing or spill over";
  add(list, "closed", "both ends of an edge count", Ends::kClosed, false, kVertex);
  add(list, "open", "no end of an edge counts", Ends::kOpen, false, kVertex);
  add(list, "top_in", "Ymin counts, Ymax does not", Ends::kTopIn, false,
      "the crossing's quotient rounds: a tie may fall either way");
  add(list, "exact", "Ymin counts, Ymax does not, exact quotients", Ends::kTopIn, true, "");
}

}  // namespace halfspace::methods
