// SPDX-License-Identifier: Apache-2.0
#include "method.hpp"

#include "catalogue.hpp"

namespace halfspace::methods {
namespace {

// Row by row of docs/05_methods.
constexpr void (*kCatalogue[])(std::vector<Method>&) = {
    add_lines,         add_edge_walk,      add_edge_function,     add_speed_hacks,
    add_fill_rules,    add_plane_equation, add_barycentric,       add_reference_point,
    add_scaled_line,   add_tiled,          add_mask_table,        add_warnock,
    add_micropolygons, add_parity_scan,    add_active_edge_table, add_decomposition,
#ifdef HALFSPACE_HAS_CGAL
    add_constrained,
#endif
    add_shading,       add_projection,     add_clipping,          add_pipeline,
};

// One primitive after another, while the budget lasts.
template <class Primitive, class One>
void each(const std::vector<Primitive>& primitives, Canvas& canvas, const AfterPrimitive& after,
          One&& one) {
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    if (canvas.exhausted()) return;
    one(primitives[i]);
    if (after) after(i);
  }
}

}  // namespace

std::span<const Method> all() {
  static const std::vector<Method> list = [] {
    std::vector<Method> methods;
    for (const auto add : kCatalogue) add(methods);
    return methods;
  }();
  return list;
}

const Method* find(std::string_view name) {
  for (const Method& method : all()) {
    if (method.name == name) return &method;
  }
  return nullptr;
}

const char* input_name(InputKind kind) {
  constexpr std::array<const char*, 5> names{"triangles", "polygons", "lines", "clip space",
                                             "world"};
  return names[static_cast<std::size_t>(kind)];
}

const char* rule_name(Rule rule) {
  constexpr std::array<const char*, 6> names{"top-left",  "draws ties", "skips ties",
                                             "half-open", "off-screen", "unspecified"};
  return names[static_cast<std::size_t>(rule)];
}

void draw(const Method& method, const Drawing& drawing, Canvas& canvas) {
  draw(method, drawing, canvas, {});
}

void draw(const Method& method, const Drawing& drawing, Canvas& canvas,
          const AfterPrimitive& after) {
  const auto* facet = std::get_if<DrawFacet>(&method.draw);
  const auto* polygon = std::get_if<DrawPolygon>(&method.draw);
  const auto* segment = std::get_if<DrawSegment>(&method.draw);
  const auto* clip = std::get_if<DrawClip>(&method.draw);
  const auto* world = std::get_if<DrawWorld>(&method.draw);
  const View& view = drawing.view;
  if (facet) each(drawing.facets, canvas, after, [&](const Facet& f) { (*facet)(f, canvas); });
  if (polygon) {
    each(drawing.polygons, canvas, after, [&](const Polygon& p) { (*polygon)(p, canvas); });
  }
  if (segment) {
    each(drawing.segments, canvas, after, [&](const Segment& s) { (*segment)(s, canvas); });
  }
  if (clip) {
    each(drawing.clip, canvas, after, [&](const ClipFacet& f) { (*clip)(f, view, canvas); });
  }
  if (world) {
    each(drawing.world, canvas, after, [&](const WorldFacet& f) { (*world)(f, view, canvas); });
  }
}

std::size_t primitives(const Method& method, const Drawing& drawing) {
  switch (method.input()) {
    case InputKind::kTriangles: return drawing.facets.size();
    case InputKind::kPolygons: return drawing.polygons.size();
    case InputKind::kLines: return drawing.segments.size();
    case InputKind::kClipSpace: return drawing.clip.size();
    case InputKind::kWorld: return drawing.world.size();
  }
  return 0;
}

std::size_t triangle_of(InputKind kind, const Drawing& drawing, std::size_t i) {
  switch (kind) {
    case InputKind::kTriangles:
    case InputKind::kPolygons: return drawing.origin[i];
    case InputKind::kLines: return drawing.origin[i / 3];
    case InputKind::kClipSpace:
    case InputKind::kWorld: break;
  }
  return i;
}

}  // namespace halfspace::methods
