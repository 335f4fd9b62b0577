// SPDX-License-Identifier: Apache-2.0
#include "report_html.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/escape.hpp"

namespace halfspace {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kEnoughPpm = 1000;  // wrong pixels that a picture may have before it is named

constexpr const char* kStyle = R"(
body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 70rem; padding: 0 1rem;
       color: #1a202c; background: #fff; }
h1 { font-size: 1.6rem; margin-bottom: 0; } h2 { font-size: 1.2rem; margin-top: 2.2rem; }
.from { color: #4a5568; } code { background: #edf2f7; padding: 0 .25em; }
figure { margin: .6rem 0; } figcaption { color: #4a5568; font-size: .9rem; }
.row { display: flex; flex-wrap: wrap; gap: 1rem; } .row figure { flex: 1 1 20rem; }
img { max-width: 100%; height: auto; border: 1px solid #e2e8f0; }
table { border-collapse: collapse; margin: .6rem 0; }
td, th { padding: .2rem .8rem; border-bottom: 1px solid #e2e8f0; text-align: right; }
td:first-child, th:first-child { text-align: left; }
.good { color: #276749; } .bad { color: #c53030; }
)";

std::string row(const std::vector<std::string>& cells, const char* tag = "td") {
  std::string out = "<tr>";
  for (const std::string& cell : cells) out += fmt::format("<{0}>{1}</{0}>", tag, cell);
  return out + "</tr>\n";
}

std::string figure(const std::string& file, const std::string& caption) {
  return fmt::format("<figure><img src=\"{0}\" alt=\"{1}\"><figcaption>{1}</figcaption></figure>\n",
                     file, escaped(caption));
}

std::string chart(const ReportData& data, const std::string& name, const std::string& caption) {
  const bool drawn = std::find(data.drawn.begin(), data.drawn.end(), name) != data.drawn.end();
  return drawn ? figure(name + ".svg", caption) : std::string();
}

// Wrong per million at s subpixel bits, rounded to nearest even.
double subpixel_ppm(const Json& chart, int bits) {
  for (const Json& r : chart["scenes"][0]["rows"]) {
    if (r["snap"] == "nearest_even" && r["subpixel_bits"] == bits) return r["wrong_ppm"];
  }
  return 0;
}

// The fewest subpixel bits that leave no more than kEnoughPpm wrong; -1: none does.
int enough_bits(const Json& chart) {
  for (int bits = 0; bits <= 12; ++bits) {
    if (subpixel_ppm(chart, bits) <= kEnoughPpm) return bits;
  }
  return -1;
}

struct Weak {
  std::string method;
  double ppm;
  std::string marks;
};
std::vector<Weak> weak_methods(const Json& stability) {
  std::vector<Weak> weak;
  for (const Json& cell : stability["cells"]) {
    std::string marks;
    for (const Json& mark : cell["marks"]) marks += mark.get<std::string>() + ' ';
    if (cell["wrong_ppm"] > 0.0) weak.push_back({cell["method"], cell["wrong_ppm"], marks});
  }
  std::sort(weak.begin(), weak.end(), [](const Weak& a, const Weak& b) { return a.ppm > b.ppm; });
  return weak;
}

const Json* level(const ReportData& data, const std::string& name) {
  for (const Json& r : data.ladder["levels"]) {
    if (r["level"] == name && r.contains("cpu_seconds")) return &r;
  }
  return nullptr;
}

std::string in_short(const ReportData& data) {
  const RasterStats& r = data.stats.raster;
  const std::uint64_t clocks = data.stats.cycles.value_or(0);
  std::string out = "<ul>\n";
  out += fmt::format(
      "<li>{} triangles were submitted, {} entered setup, {} fragments came out in {} clocks: "
      "<b>{:.1f} covered pixels per clock</b> of {} lanes.</li>\n",
      data.stats.geometry.triangles_in, r.triangles, r.fragments, clocks,
      clocks == 0 ? 0.0 : static_cast<double>(r.fragments) / static_cast<double>(clocks),
      data.config.lanes());
  const int bits = enough_bits(data.subpixel);
  out += fmt::format(
      "<li>Snapping: {} subpixel bits leave {:.0f} wrong pixels per million covered; ",
      data.config.subpixel_bits, subpixel_ppm(data.subpixel, data.config.subpixel_bits));
  out += bits >= 0
             ? fmt::format("<b>{} bits leave no more than {:.0f}</b>.</li>\n", bits, kEnoughPpm)
             : fmt::format("even 12 do not reach {:.0f}.</li>\n", kEnoughPpm);
  const int needed = data.accumulator["scenes"][0]["needed_bits"];
  out += fmt::format(
      "<li>Edge values of this scene need <b>{} bits</b> at 8 subpixel bits; the configuration "
      "provides {}. A 32-bit rasterizer would be {}.</li>\n",
      needed, data.config.edge_bits(),
      needed <= 32 ? "<span class=good>exact</span>" : "<span class=bad>wrong</span>");
  const Json* coverage = level(data, "coverage");
  const Json* cycle = level(data, "cycle");
  if (coverage != nullptr && cycle != nullptr) {
    out += fmt::format(
        "<li>If only the picture matters, level <code>coverage</code> suffices ({:.0f} Mpx per CPU "
        "second); clocks need level <code>cycle</code>, {:.1f} times its time.</li>\n",
        (*coverage)["mpixels_per_cpu_second"].get<double>(),
        (*cycle)["cpu_seconds"].get<double>() / (*coverage)["cpu_seconds"].get<double>());
  }
  const std::size_t weak = weak_methods(data.stability).size();
  out += fmt::format(
      "<li><b>{} of {} methods</b> of the gallery draw this scene with at least one "
      "pixel wrong.</li>\n</ul>\n",
      weak, data.stability["cells"].size());
  return out;
}

std::string accuracy(const ReportData& data) {
  std::string out = "<h2>What accuracy costs here</h2>\n<table>\n";
  out += row({"subpixel bits", "wrong per million, rounded", "edge value, bits"}, "th");
  for (const int bits : {0, 2, 4, 6, 8, 10, 12}) {
    Config config = data.config;
    config.subpixel_bits = bits;
    out += row({std::to_string(bits), fmt::format("{:.0f}", subpixel_ppm(data.subpixel, bits)),
                std::to_string(config.edge_bits())});
  }
  out += "</table>\n";
  out += chart(data, "subpixel",
               "Wrong pixels against vertices that were not snapped; cost of the "
               "RTL by width (preset tiny).");
  out += chart(data, "interpolation", "Attribute and depth error on this scene's triangles.");
  return out;
}

std::string configuration(const ReportData& data) {
  std::string out = "<h2>Which level and configuration suffice</h2>\n<table>\n";
  out += row({"level", "coverage", "packets", "clocks", "Mpx per CPU second"}, "th");
  for (const Json& r : data.ladder["levels"]) {
    out += row({r["level"], r["coverage"], r["packets"], r["clocks"],
                r.contains("mpixels_per_cpu_second")
                    ? fmt::format("{:.1f}", r["mpixels_per_cpu_second"].get<double>())
                    : "not in this build"});
  }
  out += "</table>\n<table>\n";
  out += row({"tile", "covered / tested samples", "pixels per clock", "tiles tested"}, "th");
  for (const Json& tile : data.efficiency["tiles"]) {
    const Json& t = tile["total"];
    out += row({fmt::format("{0}x{0} px{1}", tile["tile_px"].get<int>(),
                            tile["how"] == "counted" ? " (counted, not built)" : ""),
                fmt::format("{:.3f}", t["efficiency"].get<double>()),
                fmt::format("{:.1f}", t["pixels_per_clock"].get<double>()),
                std::to_string(t["tiles_tested"].get<std::uint64_t>())});
  }
  out += "</table>\n";
  out += chart(data, "efficiency", "Tile sides on this scene's triangles, by size.");
  out += chart(data, "accumulator", "Wrong samples when edge values wrap at fewer bits.");
  return out + chart(data, "ladder", "Speed of each level, and what it gets right.");
}

std::string weaker(const ReportData& data) {
  const std::vector<Weak> weak = weak_methods(data.stability);
  std::string out = "<h2>Where a weaker method would fail</h2>\n";
  if (weak.empty()) {
    return out + "<p class=good>No method of the gallery has a pixel wrong here.</p>\n";
  }
  out +=
      "<p>Hits per pixel against exact predicates on the unsnapped vertices; fixed-point "
      "methods pay for snapping here.</p>\n<table>\n";
  out += row({"method", "wrong per million covered", "marks"}, "th");
  for (std::size_t i = 0; i < std::min<std::size_t>(weak.size(), 15); ++i) {
    out += row({escaped(weak[i].method), fmt::format("{:.1f}", weak[i].ppm), weak[i].marks});
  }
  out += "</table>\n";
  out += figure("worst.png", weak[0].method +
                                 ": magnified where it is wrong most. Magenta: not "
                                 "drawn; orange: drawn too often.");
  return out + chart(data, "stability", "Every method on this scene.");
}

}  // namespace

std::string report_html(const ReportData& data) {
  const RasterStats& r = data.stats.raster;
  const GeometryStats& g = data.stats.geometry;
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<title>{0}: Halfspace report</title>\n<style>{1}</style></head><body>\n"
      "<h1>{0}</h1>\n<p class=from>{2}x{3} px, {4} subpixel bits, {5} sample(s). "
      "<code>{6}</code></p>\n",
      escaped(data.scene), kStyle, data.frame.width, data.frame.height, data.config.subpixel_bits,
      data.config.samples, escaped(data.command));
  out += in_short(data);
  out += "<div class=row>\n" + figure("picture.png", "The picture.") +
         figure("hits.png", "Triangles per pixel: blue 1, teal 2, green 3, yellow 4 ...") +
         figure("tiles.png", "Tiles tested: green covered, red empty.") + "</div>\n";
  out += accuracy(data) + configuration(data) + weaker(data);
  out += "<h2>Statistics</h2>\n<table>\n";
  const auto count = [&](const char* name, std::uint64_t value) {
    out += row({name, std::to_string(value)});
  };
  count("triangles submitted", g.triangles_in);
  count("outside the view", g.outside);
  count("cut by a plane", g.clipped);
  count("to setup", r.triangles);
  count("zero area", r.triangles_zero_area);
  count("no sample", r.triangles_no_sample);
  count("leaf tiles tested", r.tiles_visited);
  count("of these covered", r.tiles_covered);
  count("samples tested", r.samples_tested);
  count("samples covered", r.samples_covered);
  count("fragments", r.fragments);
  count("clocks", data.stats.cycles.value_or(0));
  return out + "</table>\n</body></html>\n";
}

}  // namespace halfspace
