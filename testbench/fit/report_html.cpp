// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/escape.hpp"
#include "io/html_page.hpp"
#include "report.hpp"

namespace halfspace {
namespace {

std::vector<ChartLine> line_of(const std::vector<AccuracyPoint>& curve) {
  ChartLine line;
  for (const AccuracyPoint& p : curve)
    line.points.push_back({static_cast<double>(p.bits), p.error});
  return {line};
}

// The estimated area by the bits of one field, the others as fitted.
std::string cost_chart(const Config& fitted, const std::string& of, const std::string& name,
                       ConfigField field, int from, int to) {
  ChartLine luts;
  for (int bits = from; bits <= to; ++bits) {
    Config config = fitted;
    config.*field = bits;
    luts.points.push_back({static_cast<double>(bits), std::round(area_estimate(config).luts())});
  }
  return line_chart({fmt::format("What each {} costs (estimated)", of),
                     name,
                     "LUT4 + 2 CCU2C",
                     {luts},
                     static_cast<double>(fitted.*field),
                     0,
                     false});
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
      "docs/02_use/fit.md says why.</p>\n<table>\n";
  out += table_row(
      {"in front of level", "packets", "into the second entry", "clocks with both full"}, "th");
  for (const FifoUse& use : result.fifos->fifo) {
    out += table_row({std::to_string(use.level), std::to_string(use.packets),
                      std::to_string(use.waited),
                      fmt::format("{:.1f} %", 100 * static_cast<double>(use.both_clocks) /
                                                  static_cast<double>(result.fifos->clocks))});
  }
  return out + "</table>\n";
}

std::string coverage_charts(const FitReport& report) {
  const FitResult& r = report.result;
  std::string out;
  if (r.coverage) {
    ChartLine ppm;
    for (int s = 0; s <= 12; ++s) {
      ppm.points.push_back(
          {static_cast<double>(s), r.coverage->error[static_cast<std::size_t>(s)].ppm()});
    }
    out += line_chart({"Coverage error against unsnapped vertices",
                       "subpixel bits",
                       "wrong per million covered",
                       {ppm},
                       static_cast<double>(r.config.subpixel_bits),
                       report.options.max_error.value_or(0)});
  }
  return out;
}

std::string attribute_charts(const FitReport& report) {
  if (!report.result.attributes) return "";
  const AttributeCurves& curves = *report.result.attributes;
  const Config& config = report.result.config;
  const double limit = report.options.max_attribute_error.value_or(0);
  const char* label = "greatest error, levels of 255";
  const auto chart = [&](const char* title, const char* field,
                         const std::vector<AccuracyPoint>& curve, int chosen) {
    return line_chart({title, field, label, line_of(curve), static_cast<double>(chosen), limit});
  };
  return "<h2>Attributes</h2>\n" +
         chart("Precision of 1/w", "inverse_w_bits", curves.inverse_w, config.inverse_w_bits) +
         chart("Fraction of a gradient", "gradient_bits", curves.gradient, config.gradient_bits) +
         chart("Mantissa of the reciprocal", "reciprocal_bits", curves.reciprocal,
               config.reciprocal_bits);
}

// The area after each thing left out, as bars.
std::string step_table(const FitResult& result) {
  const std::vector<AreaStep> steps = area_steps(result);
  const double full = steps.front().area.luts();
  std::string out = "<table>\n";
  out += table_row({"after", "LUT4 + 2 CCU2C", "flip-flops", "of full", ""}, "th");
  for (const AreaStep& step : steps) {
    const double share = step.area.luts() / full;
    out += table_row({escaped(step.name), fmt::format("{:.0f}", step.area.luts()),
                      fmt::format("{:.0f}", step.area.flip_flops),
                      fmt::format("{:.0f} %", 100 * share), bar(share)});
  }
  return out + "</table>\n";
}

std::string shape_table(const FitResult& result) {
  std::string out = "<table>\n";
  out +=
      table_row({"lanes", "setup interval", "clocks", "px/clk", "LUT4 + 2 CCU2C", "target"}, "th");
  for (std::size_t i = 0; i < result.shapes.size(); ++i) {
    const FitShape& s = result.shapes[i];
    out += table_row({std::to_string(1 << (2 * s.grid_log2)), std::to_string(s.setup_interval),
                      std::to_string(s.clocks), fmt::format("{:.2f}", s.pixels_per_clock()),
                      fmt::format("{:.0f}", s.area.luts()), s.meets ? "met" : "missed"},
                     "td", i == result.shape ? "chosen" : "");
  }
  return out + "</table>\n";
}

}  // namespace

std::string fit_report_html(const FitReport& report) {
  const std::string promise = fit_report_json(report)["ranges"]["promise"];
  return page_head("halfspace fit") +
         fmt::format(
             "<h1>halfspace fit</h1>\n<p><code>{}</code></p>\n<pre>{}</pre>\n<p>{}</p>\n"
             "<h2>Coverage</h2>\n{}{}<h2>What each bit costs</h2>\n{}<h2>Area by "
             "feature</h2>\n<p>Estimated, each row with all rows above "
             "it; error of the estimate {:g} % (flip-flops {:g} %).</p>\n{}<h2>Shapes</h2>\n{}{}",
             escaped(report.command), escaped(fit_summary(report)), escaped(promise),
             coverage_charts(report), attribute_charts(report), cost_charts(report.result.config),
             kAreaErrorPercent, kFlipFlopErrorPercent, step_table(report.result),
             shape_table(report.result), fifo_table(report.result)) +
         page_end();
}

}  // namespace halfspace
