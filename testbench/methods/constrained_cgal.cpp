// SPDX-License-Identifier: Apache-2.0
//
// Polygons with holes: a constrained Delaunay triangulation by CGAL, whose faces are inside when an
// odd number of rings lies between them and infinity. Kept apart because CGAL is optional here.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <deque>

#include "catalogue.hpp"
#include "decomposition.hpp"

namespace halfspace::methods {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_2<Kernel>;
using FaceInfo = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, Structure, CGAL::No_constraint_intersection_requiring_constructions_tag>;

// Crossings of a constraint on the way from infinity to each face, breadth first: faces behind a
// constraint wait until those before it are done.
void count_nesting(Triangulation& t) {
  for (auto face : t.all_face_handles()) face->info() = -1;
  std::deque<std::pair<Triangulation::Face_handle, int>> waiting{{t.infinite_face(), 0}};
  while (!waiting.empty()) {
    const auto [face, nesting] = waiting.front();
    waiting.pop_front();
    if (face->info() != -1) continue;
    face->info() = nesting;
    for (int i = 0; i < 3; ++i) {
      const auto neighbour = face->neighbor(i);
      if (neighbour->info() != -1) continue;
      if (face->is_constrained(i)) waiting.emplace_back(neighbour, nesting + 1);
      if (!face->is_constrained(i)) waiting.emplace_front(neighbour, nesting);
    }
  }
}

}  // namespace

Pieces constrained_pieces(const Polygon& polygon) {
  Triangulation t;
  try {
    for (const Ring& ring : polygon.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Position a = ring[i], b = ring[(i + 1) % ring.size()];
        if (a == b) continue;
        t.insert_constraint(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y));
      }
    }
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return {};  // rings that cross need new vertices, which would not be where the rings are
  }
  count_nesting(t);
  Pieces pieces;
  for (auto face : t.finite_face_handles()) {
    if (face->info() % 2 == 0) continue;
    const auto at = [&face](int i) {
      const auto& p = face->vertex(i)->point();
      return Position{p.x(), p.y()};
    };
    pieces.push_back({at(0), at(1), at(2)});
  }
  return pieces;
}

void add_constrained(std::vector<Method>& list) {
  Method m;
  m.name = "decompose_constrained";
  m.row = 14;
  m.family = "polygons";
  m.title = "Polygons as triangles: constrained Delaunay triangulation (CGAL), holes by parity";
  m.source = std::string(kPolygons) + "; CGAL, 2D Triangulations";
  m.complexity = "O(n log n)";
  m.use = "polygons with holes; well-shaped pieces";
  m.fails = "rings that cross each other are refused: nothing is drawn";
  m.rule = Rule::kTopLeft;
  m.precision = "fixed, 8 subpixel bits";
  m.subpixel_bits = 8;
  m.exact = true;
  m.draw = DrawPolygon([](const Polygon& polygon, Canvas& canvas) {
    draw_pieces(constrained_pieces(snapped_polygon(polygon)), canvas);
  });
  list.push_back(std::move(m));
}

}  // namespace halfspace::methods
