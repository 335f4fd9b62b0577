// SPDX-License-Identifier: Apache-2.0
//
// Parity again, but edges wait sorted by their first row, live in an active table while rows cross
// them, and move their crossing by addition.
#include <algorithm>
#include <cmath>

#include "catalogue.hpp"
#include "polygon.hpp"

namespace halfspace::methods {
namespace {

// An edge while it is active: rows first..last.
template <class Real>
struct Active {
  int first = 0;
  int last = -1;
  Real x{};  // crossing at the current row's centre
  Real slope{};
};

template <class Real>
std::vector<Active<Real>> waiting_edges(const Polygon& polygon, const Canvas& canvas) {
  std::vector<Active<Real>> list;
  for (const PolygonEdge& e : polygon_edges(polygon)) {
    // Ymin in, Ymax out; a horizontal edge has no row.
    Active<Real> edge;
    edge.first = first_centre(e.top.y, canvas.y_first(), canvas.y_last());
    edge.last = first_centre(e.bottom.y, canvas.y_first(), canvas.y_last()) - 1;
    if (edge.first > edge.last) continue;
    edge.x = static_cast<Real>(crossing_x(e, edge.first + 0.5));
    edge.slope = static_cast<Real>((e.bottom.x - e.top.x) / (e.bottom.y - e.top.y));
    list.push_back(edge);
  }
  std::sort(list.begin(), list.end(),
            [](const Active<Real>& a, const Active<Real>& b) { return a.first < b.first; });
  return list;
}

template <class Real>
void draw(const Polygon& polygon, Canvas& canvas) {
  const std::vector<Active<Real>> waiting = waiting_edges<Real>(polygon, canvas);
  std::vector<Active<Real>> active;
  std::size_t next = 0;
  for (int y = canvas.y_first(); y <= canvas.y_last(); ++y) {
    if (active.empty() && next == waiting.size()) return;
    std::erase_if(active, [y](const Active<Real>& e) { return e.last < y; });
    while (next < waiting.size() && waiting[next].first == y) active.push_back(waiting[next++]);
    if (!canvas.spend(1 + active.size())) return;
    std::sort(active.begin(), active.end(),
              [](const Active<Real>& a, const Active<Real>& b) { return a.x < b.x; });
    for (std::size_t i = 0; i + 1 < active.size(); i += 2) {
      const auto from = static_cast<double>(active[i].x), to = static_cast<double>(active[i + 1].x);
      const int last = first_centre(to, canvas.x_first(), canvas.x_last()) - 1;
      for (int x = first_centre(from, canvas.x_first(), canvas.x_last()); x <= last; ++x) {
        canvas.hit(x, y);
      }
    }
    for (Active<Real>& e : active) e.x += e.slope;
  }
}

template <class Real>
void add(std::vector<Method>& list, const char* precision, const char* fails) {
  Method m;
  m.name = std::string("aet_") + precision;
  m.row = 13;
  m.family = "polygons";
  m.title = std::string("Polygons by an active edge table, ") + precision;
  m.source = kMao;
  m.complexity = "O(edges log edges + rows x active edges)";
  m.use = "polygons with many edges: a row looks only at those that cross it";
  m.fails = fails;
  m.rule = Rule::kHalfOpen;
  m.precision = precision;
  m.draw = DrawPolygon([](const Polygon& p, Canvas& c) { draw<Real>(p, c); });
  list.push_back(std::move(m));
}

}  // namespace

void add_active_edge_table(std::vector<Method>& list) {
  add<double>(list, "double", "the sum of slopes rounds: a tie may fall either way");
  add<float>(list, "float", "the sum of slopes drifts down long edges");
}

}  // namespace halfspace::methods
