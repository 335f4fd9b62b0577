// SPDX-License-Identifier: Apache-2.0
#include "report_html.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/escape.hpp"
#include "io/html_page.hpp"

namespace halfspace {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kEnoughPpm = 1000;  // wrong pixels that a picture may have before it is named

std::string figure(const std::string& file, const std::string& caption) {
  return fmt::format("<figure><img src=\"{0}\" alt=\"{1}\"><figcaption>{1}</figcaption></figure>\n",
                     file, escaped(caption));
}

// A line of one field of rows over another.
ChartLine line_of(const Json& rows, const char* x, const char* y, const std::string& name = "",
                  bool dashed = false) {
  ChartLine line{name, {}, dashed};
  for (const Json& r : rows) line.points.push_back({r[x].get<double>(), r[y].get<double>()});
  return line;
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
        "<li>If only hits per pixel matter, level <code>coverage</code> suffices ({:.0f} Mpx per "
        "CPU "
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

// Wrong per million by subpixel bits, for one way of rounding.
ChartLine snap_line(const ReportData& data, const char* snap, const char* name, bool dashed) {
  Json rows = Json::array();
  for (const Json& r : data.subpixel["scenes"][0]["rows"]) {
    if (r["snap"] == snap) rows.push_back(r);
  }
  return line_of(rows, "subpixel_bits", "wrong_ppm", name, dashed);
}

std::string accuracy(const ReportData& data) {
  ChartLine edge;
  for (int bits = 0; bits <= 12; ++bits) {
    Config config = data.config;
    config.subpixel_bits = bits;
    edge.points.push_back({static_cast<double>(bits), static_cast<double>(config.edge_bits())});
  }
  const double chosen = data.config.subpixel_bits;
  const Json& scene = data.accumulator["scenes"][0];
  const char* lsb = "error, LSB";
  return "<h2>What accuracy costs here</h2>\n<div>\n" +
         line_chart({"Vertices snapped",
                     "subpixel bits",
                     "wrong pixels per million",
                     {snap_line(data, "nearest_even", "rounded", false),
                      snap_line(data, "truncate", "truncated", true)},
                     chosen,
                     kEnoughPpm}) +
         line_chart({"Width of an edge value", "subpixel bits", "bits", {edge}, chosen, 0, false}) +
         line_chart({"Edge values that wrap",
                     "bits of the register",
                     "wrong samples per million",
                     {line_of(scene["rows"], "bits", "wrong_ppm")},
                     scene["needed_bits"].get<double>()}) +
         line_chart({"8-bit attribute",
                     "reciprocal bits",
                     lsb,
                     {line_of(data.interpolation["by_reciprocal_bits"], "reciprocal_bits",
                              "attribute_max_lsb", "greatest"),
                      line_of(data.interpolation["by_reciprocal_bits"], "reciprocal_bits",
                              "attribute_rms_lsb", "RMS", true)},
                     static_cast<double>(data.config.reciprocal_bits)}) +
         line_chart({fmt::format("{}-bit depth", data.config.depth_bits),
                     "gradient fraction bits",
                     lsb,
                     {line_of(data.interpolation["by_gradient_bits"], "gradient_bits",
                              "depth_max_lsb", "greatest"),
                      line_of(data.interpolation["by_gradient_bits"], "gradient_bits",
                              "depth_rms_lsb", "RMS", true)},
                     static_cast<double>(data.config.gradient_bits)}) +
         "</div>\n<p class=from>A ring marks what this configuration has, and the bits that this "
         "scene's edge values need. Depth, 1/w and attributes are invented, positions are the "
         "scene's.</p>\n";
}

std::string levels(const ReportData& data) {
  double most = 0;
  for (const Json& r : data.ladder["levels"]) {
    most = std::max(most, r.value("mpixels_per_cpu_second", 0.0));
  }
  std::string out = "<table>\n";
  out += table_row(
      {"level: computed by", "coverage", "packets", "clocks", "Mpx per CPU second", ""}, "th");
  for (const Json& r : data.ladder["levels"]) {
    const double speed = r.value("mpixels_per_cpu_second", 0.0);
    out += table_row({r["level"].get<std::string>() + ": " + r["engine"].get<std::string>(),
                      r["coverage"], r["packets"], r["clocks"],
                      speed > 0 ? fmt::format("{:.1f}", speed) : "not in this build",
                      speed > 0 ? bar(speed / most) : ""});
  }
  return out + "</table>\n";
}

std::string tiles(const ReportData& data) {
  std::string out = "<table>\n";
  out += table_row({"tile", "covered / tested samples", "pixels per clock", "tiles tested"}, "th");
  LineChart efficiency{"Covered samples per tested sample",
                       "side of the triangle's box, px",
                       "share",
                       {},
                       std::nullopt,
                       0,
                       false,
                       true};
  LineChart speed{"Covered pixels per clock",
                  "side of the triangle's box, px",
                  "pixels",
                  {},
                  std::nullopt,
                  0,
                  true,
                  true};
  for (const Json& tile : data.efficiency["tiles"]) {
    const bool counted = tile["how"] == "counted";
    const std::string name = fmt::format("{0}x{0} px{1}", tile["tile_px"].get<int>(),
                                         counted ? " (counted, not built)" : "");
    efficiency.lines.push_back(line_of(tile["rows"], "side_px", "efficiency", name, counted));
    speed.lines.push_back(line_of(tile["rows"], "side_px", "pixels_per_clock", name, counted));
    const Json& t = tile["total"];
    out += table_row({name, fmt::format("{:.3f}", t["efficiency"].get<double>()),
                      fmt::format("{:.1f}", t["pixels_per_clock"].get<double>()),
                      std::to_string(t["tiles_tested"].get<std::uint64_t>())});
  }
  return out + "</table>\n<div>\n" + line_chart(efficiency) + line_chart(speed) + "</div>\n";
}

std::string configuration(const ReportData& data) {
  return "<h2>Which level and configuration suffice</h2>\n" + levels(data) + tiles(data);
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
  out += table_row({"method", "wrong per million covered", "", "marks"}, "th");
  for (std::size_t i = 0; i < std::min<std::size_t>(weak.size(), 15); ++i) {
    out += table_row({escaped(weak[i].method), fmt::format("{:.1f}", weak[i].ppm),
                      bar(weak[i].ppm / weak[0].ppm), weak[i].marks});
  }
  out += "</table>\n";
  return out + figure("worst.png", weak[0].method +
                                       ": magnified where it is wrong most. Magenta: not "
                                       "drawn; orange: drawn too often.");
}

}  // namespace

std::string report_html(const ReportData& data) {
  const RasterStats& r = data.stats.raster;
  const GeometryStats& g = data.stats.geometry;
  std::string out = page_head(data.scene + ": Halfspace report");
  out += fmt::format(
      "<h1>{}</h1>\n<p class=from>{}x{} px, {} subpixel bits, {} sample(s). <code>{}</code></p>\n",
      escaped(data.scene), data.frame.width, data.frame.height, data.config.subpixel_bits,
      data.config.samples, escaped(data.command));
  out += in_short(data);
  out += "<div class=row>\n" + figure("picture.png", "The picture.") +
         figure("hits.png", "Triangles per pixel: blue 1, teal 2, green 3, yellow 4 ...") +
         figure("tiles.png", "Tiles tested: green covered, red empty.") + "</div>\n";
  out += accuracy(data) + configuration(data) + weaker(data);
  out += "<h2>Statistics</h2>\n<table>\n";
  const auto count = [&](const char* name, std::uint64_t value) {
    out += table_row({name, std::to_string(value)});
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
  return out + "</table>\n" + page_end();
}

}  // namespace halfspace
