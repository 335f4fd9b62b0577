// SPDX-License-Identifier: Apache-2.0
#include "method.hpp"

#include <algorithm>

#include "catalogue.hpp"

namespace halfspace::methods {
namespace {

std::vector<Method> collect() {
  std::vector<Method> list;
  add_lines(list);
  add_edge_walk(list);
  add_edge_function(list);
  add_speed_hacks(list);
  add_fill_rules(list);
  add_plane_equation(list);
  add_barycentric(list);
  add_reference_point(list);
  add_scaled_line(list);
  add_tiled(list);
  add_mask_table(list);
  add_warnock(list);
  add_micropolygons(list);
  add_parity_scan(list);
  add_active_edge_table(list);
  add_decomposition(list);
  add_constrained(list);
  add_shading(list);
  add_projection(list);
  add_clipping(list);
  add_pipeline(list);
  return list;
}

ClipPoint clip_point(const Vertex& v, const View& view) {
  const double x = 2 * v.x / view.width - 1;
  const double y = 1 - 2 * v.y / view.height;
  return {{x * v.w, y * v.w, (2 * v.z - 1) * v.w, v.w}, v.color};
}

// One primitive after another, while the budget lasts.
template <class Primitive, class One>
void each(const std::vector<Primitive>& primitives, Canvas& canvas, One&& one) {
  for (const Primitive& primitive : primitives) {
    if (canvas.exhausted()) return;
    one(primitive);
  }
}

}  // namespace

std::span<const Method> all() {
  static const std::vector<Method> list = collect();
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

Drawing drawing_of(std::span<const Facet> facets, int width, int height) {
  Drawing out;
  out.view.width = width;
  out.view.height = height;
  // One world unit is a pixel, y up, and the window's depth runs along the view.
  Camera& camera = out.view.camera;
  camera.eye = {width / 2.0, height / 2.0, 0.0};
  camera.target = camera.eye - glm::dvec3(0, 0, 1);
  camera.orthographic = true;
  camera.ortho_height = height;
  camera.near = 0;
  camera.far = 1;
  out.facets.assign(facets.begin(), facets.end());
  for (const Facet& f : facets) {
    out.polygons.push_back({{{f[0].position(), f[1].position(), f[2].position()}}});
    for (std::size_t i = 0; i < 3; ++i) {
      out.segments.push_back({f[i].position(), f[(i + 1) % 3].position()});
    }
    ClipFacet clip;
    WorldFacet world;
    for (std::size_t i = 0; i < 3; ++i) {
      clip[i] = clip_point(f[i], out.view);
      world[i] = {{f[i].x, height - f[i].y, -f[i].z}, f[i].color};
    }
    out.clip.push_back(clip);
    out.world.push_back(world);
  }
  return out;
}

void draw(const Method& method, const Drawing& drawing, Canvas& canvas) {
  const auto* facet = std::get_if<DrawFacet>(&method.draw);
  const auto* polygon = std::get_if<DrawPolygon>(&method.draw);
  const auto* segment = std::get_if<DrawSegment>(&method.draw);
  const auto* clip = std::get_if<DrawClip>(&method.draw);
  const auto* world = std::get_if<DrawWorld>(&method.draw);
  if (facet) each(drawing.facets, canvas, [&](const Facet& f) { (*facet)(f, canvas); });
  if (polygon) each(drawing.polygons, canvas, [&](const Polygon& p) { (*polygon)(p, canvas); });
  if (segment) each(drawing.segments, canvas, [&](const Segment& s) { (*segment)(s, canvas); });
  if (clip) {
    each(drawing.clip, canvas, [&](const ClipFacet& f) { (*clip)(f, drawing.view, canvas); });
  }
  if (world) {
    each(drawing.world, canvas, [&](const WorldFacet& f) { (*world)(f, drawing.view, canvas); });
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

}  // namespace halfspace::methods
