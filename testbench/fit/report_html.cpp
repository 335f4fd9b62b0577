// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/escape.hpp"
#include "report.hpp"

namespace halfspace {
namespace {

struct ChartPoint {
  int x;
  double y;
};

struct Chart {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<ChartPoint> points;
  int chosen;        // x of the marked point
  double limit = 0;  // a line across; 0: none
  bool logarithmic = true;
};

// 0 has no logarithm: it is drawn a decade below the least of the others.
double floor_of(const Chart& chart) {
  double least = chart.limit > 0 ? chart.limit : 1e30;
  for (const ChartPoint& p : chart.points) {
    if (p.y > 0) least = std::min(least, p.y);
  }
  return least / 10;
}

std::string y_label(const ChartPoint& point, double x, double y) {
  return fmt::format(
      "<text x='{}' y='{:.1f}' text-anchor='end'>{}</text>", x, y,
      point.y < 100 ? fmt::format("{:.3g}", point.y) : fmt::format("{:.0f}", point.y));
}

std::string axis_titles(const Chart& chart) {
  return fmt::format(
      "<text x='230' y='232' text-anchor='middle'>{}</text><text x='12' "
      "y='120' transform='rotate(-90 12 120)' text-anchor='middle'>{}</text>"
      "</svg>\n",
      escaped(chart.x_label), escaped(chart.y_label));
}

// A line chart, 420 x 240, axis labels at its ends and at the chosen point.
std::string svg(const Chart& chart) {
  constexpr double kLeft = 75, kRight = 400, kTop = 30, kBottom = 200;
  if (chart.points.size() < 2) return "";
  const double floor = floor_of(chart);
  const auto height = [&](double y) {
    return chart.logarithmic ? std::log10(std::max(y, floor)) : y;
  };
  double low = 1e30, high = -1e30;
  for (const ChartPoint& p : chart.points) {
    low = std::min(low, height(p.y));
    high = std::max(high, height(p.y));
  }
  if (chart.limit > 0) {
    low = std::min(low, height(chart.limit));
    high = std::max(high, height(chart.limit));
  }
  if (!chart.logarithmic) low = std::min(low, 0.0);
  if (high - low < 1) {  // less than a decade is no slope
    const double middle = (high + low) / 2;
    low = middle - 0.5;
    high = middle + 0.5;
  }
  const double x0 = chart.points.front().x, x1 = chart.points.back().x;
  const auto px = [&](double x) { return kLeft + (kRight - kLeft) * (x - x0) / (x1 - x0); };
  const auto py = [&](double y) {
    return kBottom - (kBottom - kTop) * (height(y) - low) / (high - low);
  };
  std::string out = fmt::format(
      "<svg viewBox='0 0 420 240' width='420' height='240' font-family='sans-serif' "
      "font-size='11'><text x='10' y='16' font-weight='bold'>{}</text>"
      "<path d='M{} {}V{}H{}' fill='none' stroke='#888'/>",
      escaped(chart.title), kLeft, kTop, kBottom, kRight);
  std::string line;
  for (const ChartPoint& p : chart.points) {
    line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", px(p.x), py(p.y));
    out += fmt::format(
        "<circle cx='{:.1f}' cy='{:.1f}' r='2.5' fill='#2a6'><title>{}: {:.4g}"
        "</title></circle><text x='{:.1f}' y='{}' text-anchor='middle'>{}</text>",
        px(p.x), py(p.y), p.x, p.y, px(p.x), kBottom + 14, p.x);
    if (p.x != chart.chosen) continue;
    out += fmt::format(
        "<circle cx='{0:.1f}' cy='{1:.1f}' r='6' fill='none' stroke='#c22' "
        "stroke-width='2'/><text x='{0:.1f}' y='{2:.1f}' fill='#c22' "
        "text-anchor='middle'>{3:.4g}</text>",
        px(p.x), py(p.y), py(p.y) - 10, p.y);
  }
  out += fmt::format("<path d='{}' fill='none' stroke='#2a6'/>", line);
  const ChartPoint &first = chart.points.front(), &last = chart.points.back();
  out += y_label(first, kLeft - 5, py(first.y) + 4);
  if (std::abs(py(first.y) - py(last.y)) > 12) out += y_label(last, kLeft - 5, py(last.y) + 4);
  if (chart.limit > 0) {
    out += fmt::format(
        "<path d='M{0} {2:.1f}H{1}' stroke='#c22' stroke-dasharray='4 3'/>"
        "<text x='{1}' y='{3:.1f}' text-anchor='end' fill='#c22'>limit {4:g}</text>",
        kLeft, kRight, py(chart.limit), py(chart.limit) - 3, chart.limit);
  }
  return out + axis_titles(chart);
}

std::vector<ChartPoint> points_of(const std::vector<AccuracyPoint>& curve) {
  std::vector<ChartPoint> points;
  for (const AccuracyPoint& p : curve) points.push_back({p.bits, p.error});
  return points;
}

// The estimated area by the bits of one field, the others as fitted.
std::string cost_chart(const Config& fitted, const std::string& of, const std::string& name,
                       ConfigField field, int from, int to) {
  std::vector<ChartPoint> luts;
  for (int bits = from; bits <= to; ++bits) {
    Config config = fitted;
    config.*field = bits;
    luts.push_back({bits, std::round(area_estimate(config).luts())});
  }
  return svg({fmt::format("What each {} costs (estimated)", of), name, "LUT4 + 2 CCU2C", luts,
              fitted.*field, 0, false});
}

std::string cost_charts(const Config& fitted) {
  std::string out =
      cost_chart(fitted, "subpixel bit", "subpixel_bits", &Config::subpixel_bits, 0, 12);
  if (fitted.extent_bits != 0) {
    out += cost_chart(fitted, "bit of the longest edge", "extent_bits", &Config::extent_bits, 1,
                      fitted.viewport_bits);
  }
  return out + cost_chart(fitted, "bit of the frame's side", "viewport_bits",
                          &Config::viewport_bits,
                          std::max(fitted.extent_bits, fitted.guard_bits == 0 ? 5 : 12),
                          fitted.guard_bits == 0 ? 12 : fitted.guard_bits);
}

std::string fifo_table(const FitResult& result) {
  if (!result.fifos || result.fifos->clocks == 0) return "";
  std::string out =
      "<h2>FIFOs</h2>\n<p>Two entries each, at level cycle without stalls; not fitted: "
      "docs/02_use/fit.md says why.</p>\n<table><tr><th>in front of level</th><th>packets</th>"
      "<th>into the second entry</th><th>clocks with both full</th></tr>\n";
  for (const FifoUse& use : result.fifos->fifo) {
    out += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{:.1f} %</td></tr>\n", use.level, use.packets,
        use.waited,
        100 * static_cast<double>(use.both_clocks) / static_cast<double>(result.fifos->clocks));
  }
  return out + "</table>\n";
}

std::string coverage_charts(const FitReport& report) {
  const FitResult& r = report.result;
  std::string out;
  if (r.coverage) {
    std::vector<ChartPoint> ppm;
    for (int s = 0; s <= 12; ++s) {
      ppm.push_back({s, r.coverage->error[static_cast<std::size_t>(s)].ppm()});
    }
    out +=
        svg({"Coverage error against unsnapped vertices", "subpixel bits", "ppm of covered samples",
             ppm, r.config.subpixel_bits, report.options.max_error.value_or(0)});
  }
  return out;
}

std::string attribute_charts(const FitReport& report) {
  if (!report.result.attributes) return "";
  const AttributeCurves& curves = *report.result.attributes;
  const Config& config = report.result.config;
  const double limit = report.options.max_attribute_error.value_or(0);
  const char* label = "greatest error, levels of 255";
  return "<h2>Attributes</h2>\n" +
         svg({"Precision of 1/w", "inverse_w_bits", label, points_of(curves.inverse_w),
              config.inverse_w_bits, limit}) +
         svg({"Fraction of a gradient", "gradient_bits", label, points_of(curves.gradient),
              config.gradient_bits, limit}) +
         svg({"Mantissa of the reciprocal", "reciprocal_bits", label, points_of(curves.reciprocal),
              config.reciprocal_bits, limit});
}

// The area after each thing left out, as bars.
std::string step_table(const FitResult& result) {
  const std::vector<AreaStep> steps = area_steps(result);
  const double full = steps.front().area.luts();
  std::string out =
      "<table><tr><th>after</th><th>LUT4 + 2 CCU2C</th><th>flip-flops</th><th>of full</th></tr>\n";
  for (const AreaStep& step : steps) {
    const double share = 100 * step.area.luts() / full;
    out += fmt::format(
        "<tr><td>{}</td><td>{:.0f}</td><td>{:.0f}</td><td><div class='bar' "
        "style='width:{:.0f}px'></div> {:.0f} %</td></tr>\n",
        escaped(step.name), step.area.luts(), step.area.flip_flops, 2 * share, share);
  }
  return out + "</table>\n";
}

std::string shape_table(const FitResult& result) {
  std::string out =
      "<table><tr><th>lanes</th><th>setup interval</th><th>clocks</th><th>px/clk</th>"
      "<th>LUT4 + 2 CCU2C</th><th>target</th></tr>\n";
  for (std::size_t i = 0; i < result.shapes.size(); ++i) {
    const FitShape& s = result.shapes[i];
    out += fmt::format(
        "<tr{}><td>{}</td><td>{}</td><td>{}</td><td>{:.2f}</td><td>{:.0f}</td>"
        "<td>{}</td></tr>\n",
        i == result.shape ? " class='chosen'" : "", 1 << (2 * s.grid_log2), s.setup_interval,
        s.clocks, s.pixels_per_clock(), s.area.luts(), s.meets ? "met" : "missed");
  }
  return out + "</table>\n";
}

}  // namespace

std::string fit_report_html(const FitReport& report) {
  const std::string promise = fit_report_json(report)["ranges"]["promise"];
  return fmt::format(
      "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><title>halfspace fit</title>"
      "<style>body{{font-family:sans-serif;max-width:60em;margin:2em auto}}"
      "td,th{{padding:2px 10px;text-align:left}}.bar{{background:#2a6;height:10px;"
      "display:inline-block}}.chosen{{background:#fdd}}</style></head><body>\n"
      "<h1>halfspace fit</h1>\n<p><code>{}</code></p>\n<pre>{}</pre>\n<p>{}</p>\n"
      "<h2>Coverage</h2>\n{}{}<h2>What each bit costs</h2>\n{}<h2>Area by "
      "feature</h2>\n<p>Estimated, each row with all rows above "
      "it; error of the estimate {:g} % (flip-flops {:g} %).</p>\n{}<h2>Shapes</h2>\n{}{}"
      "</body></html>\n",
      escaped(report.command), escaped(fit_summary(report)), escaped(promise),
      coverage_charts(report), attribute_charts(report), cost_charts(report.result.config),
      kAreaErrorPercent, kFlipFlopErrorPercent, step_table(report.result),
      shape_table(report.result), fifo_table(report.result));
}

}  // namespace halfspace
