// SPDX-License-Identifier: Apache-2.0
//
// Clipping a triangle against planes before the division by w, and what happens without.
#include "clipping.hpp"

#include "catalogue.hpp"
#include "covered.hpp"
#include "projection.hpp"

namespace halfspace::methods {
namespace {

constexpr double kBand = 32768;  // px

// Projects, then draws exactly; w may be anything here.
void draw_projected(const ClipFacet& facet, const View& view, Canvas& canvas) {
  const Facet window{window_vertex(facet[0], view), window_vertex(facet[1], view),
                     window_vertex(facet[2], view)};
  const auto* shade = find("shade_perspective");
  std::get<DrawFacet>(shade->draw)(window, canvas);
}

void draw_clipped(const ClipFacet& facet, const View& view, Canvas& canvas,
                  std::span<const Plane4> planes) {
  for (const ClipFacet& piece : clip_facet(facet, planes)) draw_projected(piece, view, canvas);
}

void add(std::vector<Method>& list, const char* name, const char* title, const char* use,
         const char* fails, DrawClip draw) {
  Method m;
  m.name = std::string("clip_") + name;
  m.row = 17;
  m.family = "projection";
  m.title = std::string("Clip, divide by w, draw exactly: ") + title;
  m.source =
      std::string(kShinar) + "; I. Sutherland and G. Hodgman, Reentrant Polygon Clipping, 1974";
  m.complexity = "O(planes) per triangle, up to one vertex more per plane";
  m.use = use;
  m.fails = fails;
  m.rule = Rule::kTopLeft;
  m.precision = "double, then fixed with 8 subpixel bits";
  m.attributes = true;
  m.draw = std::move(draw);
  list.push_back(std::move(m));
}

}  // namespace

std::span<const Plane4> view_volume() {
  static const std::array<Plane4, 6> planes{{{{0, 0, 1, 1}},
                                             {{0, 0, -1, 1}},
                                             {{1, 0, 0, 1}},
                                             {{-1, 0, 0, 1}},
                                             {{0, 1, 0, 1}},
                                             {{0, -1, 0, 1}}}};
  return planes;
}

std::span<const Plane4> near_plane() { return view_volume().first(1); }

std::vector<Plane4> guard_band(const View& view, double band) {
  // x = (X / w + 1) width / 2 >= -band, and so on.
  const double x = 2 * band / view.width, y = 2 * band / view.height;
  return {{{0, 0, 1, 1}},      {{0, 0, -1, 1}},    {{1, 0, 0, 1 + x}},
          {{-1, 0, 0, x - 1}}, {{0, 1, 0, y - 1}}, {{0, -1, 0, 1 + y}}};
}

std::vector<ClipPoint> clip_polygon(std::span<const ClipPoint> polygon, const Plane4& plane) {
  std::vector<ClipPoint> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ClipPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double fa = glm::dot(plane.normal, a.position), fb = glm::dot(plane.normal, b.position);
    if (fa >= 0) out.push_back(a);
    if (!(fa * fb < 0)) continue;  // both on one side, or an end on the plane
    const double t = fa / (fa - fb);
    ClipPoint cut;
    cut.position = a.position + t * (b.position - a.position);
    for (std::size_t c = 0; c < 3; ++c) cut.color[c] = a.color[c] + t * (b.color[c] - a.color[c]);
    out.push_back(cut);
  }
  return out;
}

std::vector<ClipFacet> clip_facet(const ClipFacet& facet, std::span<const Plane4> planes) {
  std::vector<ClipPoint> polygon(facet.begin(), facet.end());
  for (const Plane4& plane : planes) polygon = clip_polygon(polygon, plane);
  std::vector<ClipFacet> out;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    out.push_back({polygon[0], polygon[i], polygon[i + 1]});
  }
  return out;
}

void add_clipping(std::vector<Method>& list) {
  add(list, "none", "not clipped", "scenes that lie wholly before the eye",
      "w <= 0: vertices behind the eye appear mirrored before it; w = 0 is at infinity",
      draw_projected);
  add(list, "near", "near plane alone", "rasterizers that take any x and y",
      "vertices far outside the window exceed any fixed width",
      [](const ClipFacet& f, const View& v, Canvas& c) { draw_clipped(f, v, c, near_plane()); });
  add(list, "six", "all six planes", "the least coordinates: 0..width, 0..height",
      "cut edges move by a rounding at the frame's border, so shared edges there may show",
      [](const ClipFacet& f, const View& v, Canvas& c) { draw_clipped(f, v, c, view_volume()); });
  add(list, "guard_band", "near, far and a guard band of 2^15 px",
      "hardware: only what exceeds the widths is cut, far outside the frame",
      "cuts at the near plane round, as in clip_near; the band costs bits in every width",
      [](const ClipFacet& f, const View& v, Canvas& c) {
        draw_clipped(f, v, c, guard_band(v, kBand));
      });
}

}  // namespace halfspace::methods
