// SPDX-License-Identifier: Apache-2.0
//
// method_pictures DIRECTORY: the pictures of docs/05_methods. Each shows a method that fails at the
// left and one that does not at the right, with the wrong pixels marked.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "io/error.hpp"
#include "io/png_file.hpp"
#include "method_judge.hpp"
#include "vectors/reproducers.hpp"

namespace {

using namespace halfspace;
using oracle::Corners;

constexpr Rgb kEmpty{24, 26, 33}, kRight{96, 125, 160}, kGap{227, 47, 39}, kDouble{253, 231, 37};
constexpr Rgb kLine{255, 255, 255};
constexpr int kMargin = 8;  // between the two panels, px

Image blank(int width, int height) {
  return {
      width, height,
      std::vector<Rgb>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kLine)};
}

methods::Canvas drawn(const char* name, const methods::Drawing& drawing,
                      const oracle::Window& window, bool attributes) {
  methods::Canvas canvas(window.width, window.height, window.x_first, window.y_first);
  if (attributes) canvas.keep_attributes();
  methods::draw(*methods::find(name), drawing, canvas);
  return canvas;
}

Rgb judged(std::uint32_t hits, std::uint32_t exact) {
  if (hits == exact) return hits == 0 ? kEmpty : kRight;
  return hits < exact ? kGap : kDouble;
}

Rgb colored(const methods::Canvas& canvas, std::size_t i) {
  Rgb out = kEmpty;
  for (std::size_t c = 0; c < 3 && canvas.hits()[i] != 0; ++c) {
    out[c] = static_cast<std::uint8_t>(canvas.color()[i][c]);
  }
  return out;
}

// Two panels, every pixel `scale` wide. exact empty: colours instead of right and wrong.
void write(const std::string& path, const std::vector<const char*>& names,
           const methods::Drawing& drawing, const oracle::Window& window, int scale,
           const std::vector<std::uint32_t>& exact) {
  const int wide = window.width * scale, high = window.height * scale;
  Image image = blank(2 * wide + kMargin, high);
  for (std::size_t panel = 0; panel < 2; ++panel) {
    const methods::Canvas canvas = drawn(names[panel], drawing, window, exact.empty());
    for (int y = 0; y < high; ++y) {
      for (int x = 0; x < wide; ++x) {
        const auto i = static_cast<std::size_t>(y / scale * window.width + x / scale);
        image.at(static_cast<int>(panel) * (wide + kMargin) + x, y) =
            exact.empty() ? colored(canvas, i) : judged(canvas.hits()[i], exact[i]);
      }
    }
  }
  write_png(path, image);
  fmt::print("{}: {} | {}\n", path, names[0], names[1]);
}

void pair(const std::string& path, const std::vector<const char*>& names,
          const std::vector<Corners>& triangles, const oracle::Window& window, int scale) {
  write(path, names,
        methods::drawing_of(methods::facets_of(triangles), window.width, window.height), window,
        scale, oracle::exact_hits(triangles, window));
}

void polygon_pair(const std::string& path, const std::vector<const char*>& names,
                  const oracle::Rings& rings, const oracle::Window& window, int scale) {
  methods::Drawing drawing;
  methods::Polygon& polygon = drawing.polygons.emplace_back();
  for (const auto& ring : rings) {
    polygon.rings.emplace_back();
    for (const oracle::Vec& v : ring) polygon.rings.back().push_back({v.x, v.y});
  }
  write(path, names, drawing, window, scale, oracle::exact_hits(std::span(&rings, 1), window));
}

// The last rows of a long line; the truth is line_exact.
void line_pair(const std::string& path) {
  const oracle::Window window{40, 24, 743, 2024};
  methods::Drawing drawing;
  drawing.segments.push_back({{8.25, 0.5}, {8.25 + 94.5 / 256 * 2048, 2048.5}});
  const auto exact = drawn("line_exact", drawing, window, false).hits();
  write(path, {"line_dda_fixed_f8", "line_dda_fixed_f16"}, drawing, window, 8, exact);
}

// A square floor in perspective, red to green along it.
void floor_pair(const std::string& path, const char* failing) {
  const oracle::Window window{128, 96, 0, 0};
  const auto at = [](double x, double y, double w, double level) {
    methods::Vertex v{x, y, 0.5, w, {}};
    v.color = {255 - level, level, 60};
    return v;
  };
  const methods::Vertex a = at(44, 8, 6, 0), b = at(84, 8, 6, 0), c = at(126, 94, 1, 255),
                        d = at(2, 94, 1, 255);
  methods::Drawing drawing;
  drawing.facets = {{a, b, c}, {a, c, d}};
  write(path, {failing, "shade_perspective"}, drawing, window, 3, {});
}

// The floor that reaches behind the eye: y grows without bound as w goes to 0.
void clip_pair(const std::string& path) {
  const oracle::Window window{96, 96, 0, 0};
  methods::Drawing drawing;
  drawing.view.width = drawing.view.height = 96;
  const auto at = [](double x, double y, double w) {
    return methods::ClipPoint{{x, y, w - 0.02, w}, {}};
  };
  drawing.clip.push_back({at(-4, -1, 4), at(4, -1, 4), at(0, -1, -0.5)});
  const auto exact = drawn("clip_guard_band", drawing, window, false).hits();
  write(path, {"clip_none", "clip_guard_band"}, drawing, window, 3, exact);
}

// Thin triangles a few pixels apart.
std::vector<Corners> slivers() {
  std::vector<Corners> out;
  for (int i = 0; i < 7; ++i)
    out.push_back({{{2, 6.25 + 8 * i}, {62, 2.5 + 8 * i}, {61, 4.75 + 8 * i}}});
  return out;
}

void run(const std::string& out) {
  const oracle::Window small{12, 12, 0, 0}, patch{64, 64, 256, 256}, far{64, 64, 16056, 16056};
  line_pair(out + "/lines.png");
  pair(out + "/edge_walking.png", {"walk_no_prestep", "walk_prestep"}, {oracle::thin_sliver()},
       {62, 10, 0, 0}, 6);
  pair(out + "/edge_walking_closed.png", {"walk_closed", "walk_exact"}, oracle::mesh16(), patch, 4);
  pair(out + "/edge_functions.png", {"edge_float_cross", "edge_float_relative"},
       oracle::mesh16(15800), far, 4);
  pair(out + "/barycentric.png", {"bary_shoelace_float", "bary_area_float"}, oracle::mesh16(15800),
       far, 4);
  pair(out + "/fill_rules.png", {"fill_skip_ties", "fill_top_left"}, oracle::mesh_h(), patch, 4);
  pair(out + "/fill_rules_quad.png", {"fill_draw_ties", "fill_top_left"}, oracle::quad_on_samples(),
       small, 16);
  pair(out + "/tiled.png", {"table_n8", "tiled_8"}, slivers(), {64, 64, 0, 0}, 4);
  polygon_pair(out + "/polygons.png", {"parity_closed", "parity_top_in"}, {oracle::diamond()},
               {10, 10, 0, 0}, 16);
  polygon_pair(out + "/polygons_fan.png", {"decompose_fan", "decompose_ear"},
               {{{60, 4}, {40, 30}, {61, 60}, {6, 50}, {2, 2}}}, {64, 64, 0, 0}, 4);
  floor_pair(out + "/interpolation.png", "shade_affine");
  floor_pair(out + "/subdivision.png", "micropolygons");
  clip_pair(out + "/projection.png");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: method_pictures DIRECTORY\n");
    return 2;
  }
  try {
    run(argv[1]);
  } catch (const Error& error) {
    fmt::print(stderr, "method_pictures: {}\n", error.what());
    return 2;
  }
  return 0;
}
