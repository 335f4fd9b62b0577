// SPDX-License-Identifier: Apache-2.0
//
// The project's own stages as one more method: snap, triangle_setup, tile_traversal, coverage and
// interpolation, at every width of the subpixels.
#include <bit>
#include <cmath>

#include "catalogue.hpp"
#include "geometry.hpp"
#include "interpolation.hpp"
#include "rasterizer.hpp"

namespace halfspace::methods {
namespace {

// The widest frame and guard band there are, so that only subpixel_bits differs.
Config config_of(int subpixel_bits) {
  Config config;
  config.subpixel_bits = subpixel_bits;
  config.viewport_bits = 15;
  config.guard_bits = 16;
  return config;
}

std::uint32_t rounded(double value, double maximum) {
  return value > 0 ? static_cast<std::uint32_t>(std::min(value, maximum) + 0.5) : 0u;
}

std::array<VertexAttributes, 3> packed(const Facet& facet, const Config& config) {
  std::array<VertexAttributes, 3> out;
  int exponent = 0;
  std::frexp(1 / std::min({facet[0].w, facet[1].w, facet[2].w}), &exponent);
  for (std::size_t i = 0; i < 3; ++i) {
    const double scale =
        std::ldexp(std::ldexp(1.0, config.depth_bits) - 1, kPlaneBits - config.depth_bits);
    out[i].depth = static_cast<std::int32_t>(rounded(facet[i].z * scale, scale));
    out[i].inverse_w =
        std::max(1u, rounded(std::ldexp(1 / facet[i].w, config.inverse_w_bits - exponent),
                             static_cast<double>((1u << config.inverse_w_bits) - 1)));
    for (std::size_t c = 0; c < 3; ++c) {
      out[i].value[c] = static_cast<std::int32_t>(rounded(facet[i].color[c] * 256, 255 * 256));
    }
  }
  return out;
}

// The fragments of one tile.
void shade(const CoverageTile& tile, const InterpolationSetup& planes, const Config& config,
           Canvas& canvas) {
  const auto at = [&](const Plane& plane) {
    return tile_plane(plane, planes.origin, tile.x, tile.y, config);
  };
  const TilePlane depth = at(planes.depth), inverse_w = at(planes.inverse_w);
  const std::array<TilePlane, 3> color{at(planes.attribute[0]), at(planes.attribute[1]),
                                       at(planes.attribute[2])};
  const double far = std::ldexp(1.0, config.depth_bits) - 1;
  for (GridMask rest = tile.mask[0]; rest != 0; rest &= rest - 1) {
    const int lane = std::countr_zero(rest);
    const int i = lane % config.grid(), j = lane / config.grid();
    Color out;
    for (std::size_t c = 0; c < 3; ++c) {
      out[c] = perspective(color[c].at(i, j), inverse_w.at(i, j), planes.level[c], config);
    }
    canvas.fragment(tile.x + i, tile.y + j, depth_value(depth.at(i, j), config) / far, out);
  }
}

void draw_pipeline(const Facet& facet, Canvas& canvas, const Config& config) {
  ShadedTriangle shaded;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::isnan(facet[i].x) || std::isnan(facet[i].y)) return;
    const std::int64_t x = snap(facet[i].x, config), y = snap(facet[i].y, config);
    if (std::max(std::abs(x), std::abs(y)) > config.coordinate_max()) return;
    shaded.triangle.vertex[i] = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
  }
  // The frame starts at 0; pixels outside the canvas's window are dropped by it.
  const FrameState frame{std::clamp(canvas.x_last() + 1, 1, config.max_size()),
                         std::clamp(canvas.y_last() + 1, 1, config.max_size()), Cull::kNone};
  RasterStats stats;
  InterpolationSetup planes;
  const bool shading = canvas.wants_attributes();
  rasterize(
      shaded.triangle, frame, config, stats,
      [&](const SetupTriangle& setup) {
        if (!shading) return;
        planes = interpolation_setup(setup, shaded.triangle, packed(facet, config), 3, config);
      },
      [&](const Node&, int, bool) { canvas.spend(static_cast<std::uint64_t>(config.lanes())); },
      [&](const CoverageTile& tile) {
        if (shading) return shade(tile, planes, config, canvas);
        for (GridMask rest = tile.mask[0]; rest != 0; rest &= rest - 1) {
          const int lane = std::countr_zero(rest);
          canvas.hit(tile.x + lane % config.grid(), tile.y + lane / config.grid());
        }
      });
}

}  // namespace

void add_pipeline(std::vector<Method>& list) {
  for (int bits = 0; bits <= 12; ++bits) {
    Method m;
    m.name = "halfspace_s" + std::to_string(bits);
    m.row = 18;
    m.family = "tiled";
    m.title = "The project's pipeline, vertices on 1/" + std::to_string(1 << bits) + " px";
    m.source = std::string("this project, docs/03_design; ") + kPineda;
    m.complexity = "O(log side + tiles touched), 64 pixels at once in hardware";
    m.use = "hardware; any mesh whose samples must have one owner each";
    m.fails = "";
    m.rule = Rule::kTopLeft;
    m.precision = "fixed, " + std::to_string(bits) + " subpixel bits";
    m.subpixel_bits = bits;
    m.exact = true;
    m.attributes = true;
    const Config config = config_of(bits);
    m.draw = DrawFacet(
        [config](const Facet& facet, Canvas& canvas) { draw_pipeline(facet, canvas, config); });
    list.push_back(std::move(m));
  }
}

}  // namespace halfspace::methods
