// SPDX-License-Identifier: Apache-2.0
#include "clipping.hpp"
#include "projection.hpp"

namespace halfspace::methods {
namespace {

constexpr double kGuardBand = 32768;  // px

ClipPoint clip_point(const Vertex& v, const View& view) {
  const double x = 2 * v.x / view.width - 1;
  const double y = 1 - 2 * v.y / view.height;
  return {{x * v.w, y * v.w, (2 * v.z - 1) * v.w, v.w}, v.color};
}

// A triangle of the window as a polygon and as segments.
void add_shapes(const Facet& f, Drawing& out) {
  out.polygons.push_back({{{f[0].position(), f[1].position(), f[2].position()}}});
  for (std::size_t i = 0; i < 3; ++i) {
    out.segments.push_back({f[i].position(), f[(i + 1) % 3].position()});
  }
}

}  // namespace

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
    out.origin.push_back(static_cast<std::uint32_t>(out.origin.size()));
    add_shapes(f, out);
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

Drawing drawing_of(std::vector<ClipFacet> clip, int width, int height) {
  Drawing out;
  out.view.width = width;
  out.view.height = height;
  const std::vector<Plane4> planes = guard_band(out.view, kGuardBand);
  for (std::size_t i = 0; i < clip.size(); ++i) {
    for (const ClipFacet& piece : clip_facet(clip[i], planes)) {
      out.origin.push_back(static_cast<std::uint32_t>(i));
      out.facets.push_back({window_vertex(piece[0], out.view), window_vertex(piece[1], out.view),
                            window_vertex(piece[2], out.view)});
      add_shapes(out.facets.back(), out);
    }
  }
  out.clip = std::move(clip);
  return out;
}

}  // namespace halfspace::methods
