// SPDX-License-Identifier: Apache-2.0
//
// method_pictures DIRECTORY: the pictures of docs/05_methods. Each shows a method that fails beside
// one that does not. Where pixels can be right or wrong it is an SVG with the pixel grid, what was
// drawn into it, and the wrong pixels marked; where colours are compared it is a PNG.
#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "io/error.hpp"
#include "io/output_file.hpp"
#include "io/png_file.hpp"
#include "method_judge.hpp"
#include "vectors/reproducers.hpp"

namespace {

using namespace halfspace;
using oracle::Corners;

constexpr Rgb kEmpty{24, 26, 33}, kLine{255, 255, 255};
constexpr int kMargin = 8;                            // between the two panels of a PNG, px
constexpr int kCard = 24, kTitle = 34, kLegend = 34;  // borders of an SVG, px

// What becomes of a pixel: its colour in a picture, and what the legend says.
struct Verdict {
  const char* fill;
  const char* name;
};
constexpr std::array<Verdict, 3> kVerdicts{
    {{"#93c5fd", "right"}, {"#c2410c", "gap: not drawn"}, {"#fbbf24", "drawn wrongly, or twice"}}};

using Names = std::array<const char*, 2>;
using Outline = std::vector<std::array<double, 2>>;  // closed, px

// What two methods draw, and the truth.
struct Pair {
  Names names;
  methods::Drawing drawing;
  oracle::Window window;
  std::vector<std::uint32_t> exact;
  std::vector<Outline> outlines;
  int scale;           // a pixel's side
  bool below = false;  // the second under the first, not beside it
};

methods::Canvas drawn(const char* name, const methods::Drawing& drawing,
                      const oracle::Window& window, bool attributes) {
  methods::Canvas canvas(window.width, window.height, window.x_first, window.y_first);
  if (attributes) canvas.keep_attributes();
  methods::draw(*methods::find(name), drawing, canvas);
  return canvas;
}

// The pixels of one verdict, a rectangle for each run of a row.
std::string pixels(const Pair& pair, const std::vector<std::uint32_t>& hits, std::size_t verdict) {
  const auto is = [&](int x, int y) {
    const auto i = static_cast<std::size_t>(y * pair.window.width + x);
    if (hits[i] == pair.exact[i]) return verdict == 0 && hits[i] != 0;
    return verdict == (hits[i] < pair.exact[i] ? 1u : 2u);
  };
  std::string path;
  for (int y = 0; y < pair.window.height; ++y) {
    for (int x = 0; x < pair.window.width; ++x) {
      if (!is(x, y)) continue;
      const int first = x;
      while (x + 1 < pair.window.width && is(x + 1, y)) ++x;
      path += fmt::format("M{} {}h{}v1h{}z", first, y, x + 1 - first, first - x - 1);
    }
  }
  if (path.empty()) return path;
  return fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", path, kVerdicts[verdict].fill);
}

std::string grid(const Pair& pair) {
  std::string path;
  for (int x = 0; x <= pair.window.width; ++x) {
    path += fmt::format("M{} 0v{}", x, pair.window.height);
  }
  for (int y = 0; y <= pair.window.height; ++y)
    path += fmt::format("M0 {}h{}", y, pair.window.width);
  return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#d1d5db\" stroke-width=\"{:.3f}\"/>\n",
                     path, 0.6 / pair.scale);
}

// The centres, where a pixel is large enough to hold a dot.
std::string centres(const Pair& pair) {
  if (pair.scale < 10) return "";
  std::string path;
  for (int y = 0; y < pair.window.height; ++y) {
    for (int x = 0; x < pair.window.width; ++x) path += fmt::format("M{}.5 {}.5h0", x, y);
  }
  return fmt::format(
      "<path d=\"{}\" stroke=\"#6b7280\" stroke-width=\"{:.3f}\" stroke-linecap=\"round\"/>\n",
      path, 2.4 / pair.scale);
}

// What reaches into the window.
std::string outlines(const Pair& pair) {
  std::string path;
  for (const Outline& outline : pair.outlines) {
    std::string one;
    bool left = true, right = true, above = true, below = true;  // all of it is on that side
    for (const auto& corner : outline) {
      const double x = corner[0] - pair.window.x_first, y = corner[1] - pair.window.y_first;
      left = left && x < 0, right = right && x > pair.window.width;
      above = above && y < 0, below = below && y > pair.window.height;
      one += fmt::format("{}{:.3f} {:.3f}", one.empty() ? "M" : "L", x, y);
    }
    if (!left && !right && !above && !below) path += one + "z";
  }
  return fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"#1f2937\" stroke-width=\"{:.3f}\" "
      "stroke-linejoin=\"round\"/>\n",
      path, (pair.scale < 10 ? 0.8 : 1.2) / pair.scale);
}

std::string panel(const Pair& pair, std::size_t number, int x, int y) {
  const auto hits = drawn(pair.names[number], pair.drawing, pair.window, false).hits();
  std::string out = fmt::format(
      "<text x=\"{}\" y=\"{}\" font-weight=\"bold\">{}</text>\n"
      "<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\">\n",
      x, y + 16, pair.names[number], x, y + kTitle - 8, pair.window.width * pair.scale,
      pair.window.height * pair.scale, pair.window.width, pair.window.height);
  for (std::size_t verdict = 0; verdict < kVerdicts.size(); ++verdict) {
    out += pixels(pair, hits, verdict);
  }
  return out + grid(pair) + centres(pair) + outlines(pair) + "</svg>\n";
}

std::string legend(int y) {
  std::string out;
  int x = kCard;
  for (const Verdict& verdict : kVerdicts) {
    out += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"12\" height=\"12\" fill=\"{}\"/>\n"
        "<text x=\"{}\" y=\"{}\" font-size=\"12\">{}</text>\n",
        x, y, verdict.fill, x + 18, y + 11, verdict.name);
    x += 42 + 7 * static_cast<int>(std::string_view(verdict.name).size());
  }
  return out;
}

void write(const std::string& path, const Pair& pair) {
  const int wide = pair.window.width * pair.scale, high = pair.window.height * pair.scale + kTitle;
  const int width = 2 * kCard + (pair.below ? wide : 2 * wide + kCard);
  const int height = kCard / 2 + (pair.below ? 2 : 1) * high + kLegend + (pair.below ? 8 : 0);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" "
      "font-family=\"sans-serif\" font-size=\"13\" fill=\"#1f2937\">\n"
      "<title>{2} fails, {3} does not</title>\n"
      "<rect x=\"1\" y=\"1\" width=\"{4}\" height=\"{5}\" rx=\"12\" fill=\"#ffffff\" "
      "stroke=\"#d1d5db\"/>\n",
      width, height, pair.names[0], pair.names[1], width - 2, height - 2);
  svg += panel(pair, 0, kCard, kCard / 2);
  svg += pair.below ? panel(pair, 1, kCard, kCard / 2 + high + 8)
                    : panel(pair, 1, 2 * kCard + wide, kCard / 2);
  write_text(path, svg + legend(height - 26) + "</svg>\n");
  fmt::print("{}: {} | {}\n", path, pair.names[0], pair.names[1]);
}

void triangles(const std::string& path, const Names& names, const std::vector<Corners>& corners,
               const oracle::Window& window, int scale, bool below = false) {
  Pair pair{names,  methods::drawing_of(methods::facets_of(corners), window.width, window.height),
            window, oracle::exact_hits(corners, window),
            {},     scale,
            below};
  for (const Corners& c : corners) {
    pair.outlines.push_back({{c[0].x, c[0].y}, {c[1].x, c[1].y}, {c[2].x, c[2].y}});
  }
  write(path, pair);
}

void polygon(const std::string& path, const Names& names, const oracle::Rings& rings,
             const oracle::Window& window, int scale) {
  Pair pair{names, {}, window, oracle::exact_hits(std::span(&rings, 1), window), {}, scale};
  methods::Polygon& polygon = pair.drawing.polygons.emplace_back();
  for (const auto& ring : rings) {
    polygon.rings.emplace_back();
    pair.outlines.emplace_back();
    for (const oracle::Vec& v : ring) {
      polygon.rings.back().push_back({v.x, v.y});
      pair.outlines.back().push_back({v.x, v.y});
    }
  }
  write(path, pair);
}

// The last rows of a long line; the truth is line_exact.
void line(const std::string& path) {
  Pair pair{{"line_dda_fixed_f8", "line_dda_fixed_f16"}, {}, {40, 24, 743, 2024}, {}, {}, 10};
  const oracle::Vec from{8.25, 0.5}, to{8.25 + 94.5 / 256 * 2048, 2048.5};
  pair.drawing.segments.push_back({{from.x, from.y}, {to.x, to.y}});
  pair.exact = drawn("line_exact", pair.drawing, pair.window, false).hits();
  pair.outlines.push_back({{from.x, from.y}, {to.x, to.y}});
  write(path, pair);
}

Rgb colored(const methods::Canvas& canvas, std::size_t i) {
  Rgb out = kEmpty;
  for (std::size_t c = 0; c < 3 && canvas.hits()[i] != 0; ++c) {
    out[c] = static_cast<std::uint8_t>(canvas.color()[i][c]);
  }
  return out;
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
  constexpr int kScale = 3;
  const int wide = window.width * kScale, high = window.height * kScale;
  Image image{2 * wide + kMargin, high, {}};
  image.pixel.assign(static_cast<std::size_t>(image.width * high), kLine);
  for (int panel = 0; panel < 2; ++panel) {
    const auto canvas = drawn(panel == 0 ? failing : "shade_perspective", drawing, window, true);
    for (int y = 0; y < high; ++y) {
      for (int x = 0; x < wide; ++x) {
        const auto i = static_cast<std::size_t>(y / kScale * window.width + x / kScale);
        image.at(panel * (wide + kMargin) + x, y) = colored(canvas, i);
      }
    }
  }
  write_png(path, image);
  fmt::print("{}: {} | shade_perspective\n", path, failing);
}

// The floor that reaches behind the eye: y grows without bound as w goes to 0.
void clip_pair(const std::string& path) {
  Pair pair{{"clip_none", "clip_guard_band"}, {}, {96, 96, 0, 0}, {}, {}, 4};
  pair.drawing.view.width = pair.drawing.view.height = 96;
  const auto at = [](double x, double y, double w) {
    return methods::ClipPoint{{x, y, w - 0.02, w}, {}};
  };
  pair.drawing.clip.push_back({at(-4, -1, 4), at(4, -1, 4), at(0, -1, -0.5)});
  pair.exact = drawn("clip_guard_band", pair.drawing, pair.window, false).hits();
  write(path, pair);
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
  line(out + "/lines.svg");
  triangles(out + "/edge_walking.svg", {"walk_no_prestep", "walk_prestep"}, {oracle::thin_sliver()},
            {62, 6, 0, 3}, 14, true);
  triangles(out + "/edge_walking_closed.svg", {"walk_closed", "walk_exact"}, oracle::mesh16(),
            patch, 6);
  triangles(out + "/edge_functions.svg", {"edge_float_cross", "edge_float_relative"},
            oracle::mesh16(15800), far, 6);
  triangles(out + "/barycentric.svg", {"bary_shoelace_float", "bary_area_float"},
            oracle::mesh16(15800), far, 6);
  triangles(out + "/fill_rules.svg", {"fill_skip_ties", "fill_top_left"}, oracle::mesh_h(), patch,
            6);
  triangles(out + "/fill_rules_quad.svg", {"fill_draw_ties", "fill_top_left"},
            oracle::quad_on_samples(), small, 30);
  triangles(out + "/tiled.svg", {"table_n8", "tiled_8"}, slivers(), {64, 16, 0, 0}, 13, true);
  polygon(out + "/polygons.svg", {"parity_closed", "parity_top_in"}, {oracle::diamond()},
          {10, 10, 0, 0}, 36);
  polygon(out + "/polygons_fan.svg", {"decompose_fan", "decompose_ear"},
          {{{60, 4}, {40, 30}, {61, 60}, {6, 50}, {2, 2}}}, {64, 64, 0, 0}, 6);
  floor_pair(out + "/interpolation.png", "shade_affine");
  floor_pair(out + "/subdivision.png", "micropolygons");
  clip_pair(out + "/projection.svg");
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
