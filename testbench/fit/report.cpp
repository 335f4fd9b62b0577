// SPDX-License-Identifier: Apache-2.0
#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/config_json.hpp"

namespace halfspace {
namespace {

using Json = nlohmann::ordered_json;

Json widths_json(const Config& c) {
  return {{"vertex_bits", c.vertex_bits()}, {"delta_bits", c.delta_bits()},
          {"area_bits", c.area_bits()},     {"constant_bits", c.constant_bits()},
          {"edge_bits", c.edge_bits()},     {"root_bits", c.node_bits(c.node_log2(0))},
          {"lane_bits", c.lane_bits()},     {"levels", c.levels()}};
}

Json area_json(const AreaEstimate& area) {
  return {{"luts", std::llround(area.luts())},
          {"lut4", std::llround(area.lut4)},
          {"ccu2c", std::llround(area.ccu2c)},
          {"ff", std::llround(area.flip_flops)},
          {"mult18", std::llround(area.multipliers)}};
}

Json coverage_json(const CoverageCurve& curve) {
  Json points;
  for (std::size_t s = 0; s < curve.error.size(); ++s) {
    const CoverageError& e = curve.error[s];
    points.push_back({{"subpixel_bits", s},
                      {"ppm", e.ppm()},
                      {"covered", e.covered},
                      {"missing", e.missing},
                      {"extra", e.extra}});
  }
  return {{"triangles_measured", curve.triangles}, {"triangles", curve.of}, {"curve", points}};
}

Json points_json(const std::vector<AccuracyPoint>& curve) {
  Json points;
  for (const AccuracyPoint& p : curve) points.push_back({{"bits", p.bits}, {"levels", p.error}});
  return points;
}

Json shapes_json(const FitResult& result) {
  Json shapes;
  for (std::size_t i = 0; i < result.shapes.size(); ++i) {
    const FitShape& shape = result.shapes[i];
    shapes.push_back({{"grid_log2", shape.grid_log2},
                      {"setup_interval", shape.setup_interval},
                      {"clocks", shape.clocks},
                      {"clocks_of_slowest_view", shape.worst_clocks},
                      {"pixels_per_clock", shape.pixels_per_clock()},
                      {"meets_target", shape.meets},
                      {"chosen", i == result.shape},
                      {"area", area_json(shape.area)}});
  }
  return shapes;
}

Json fifos_json(const FifoUses& uses) {
  Json list = Json::array();
  for (const FifoUse& use : uses.fifo) {
    list.push_back({{"level", use.level},
                    {"packets", use.packets},
                    {"waited", use.waited},
                    {"both_entries_clocks", use.both_clocks}});
  }
  return {{"clocks", uses.clocks}, {"fifo", list}};
}

Json cosim_json(const Json& run) {
  Json some;
  for (const char* key : {"identical", "stall", "seed", "cases", "cases_skipped", "triangles",
                          "packets_compared", "cycles"}) {
    some[key] = run.at(key);
  }
  return some;
}

const char* promise(const FitRanges& ranges) {
  if (ranges.cut_anyway) {
    return "A triangle reaches the eye's plane or beyond every guard band, so triangles are cut at "
           "the sides as `full` cuts them, and no limit on edges is fitted.";
  }
  return "Every submitted triangle of these views, after snapping, is within the ranges: the "
         "maxima "
         "are over all of them, not over samples. Of other views nothing is promised: a triangle "
         "outside is refused with its index (HS022), never wrapped.";
}

}  // namespace

std::vector<AreaStep> area_steps(const FitResult& result) {
  Config at = kFull;
  std::vector<AreaStep> steps;
  const auto step = [&](const std::string& name) { steps.push_back({name, area_estimate(at)}); };
  step("full");
  const Config& to = result.config;
  at.samples = to.samples;
  if (at.samples != kFull.samples) step(fmt::format("{} samples", to.samples));
  at.subpixel_bits = to.subpixel_bits;
  step(fmt::format("{} subpixel bits", to.subpixel_bits));
  at.viewport_bits = to.viewport_bits;
  at.guard_bits = std::max(kFull.guard_bits, to.viewport_bits);
  step(fmt::format("frame of {0} x {0}", to.max_size()));
  at.guard_bits = to.guard_bits;
  step(to.guard_bits == 0 ? "no guard band" : fmt::format("guard band of 2^{}", to.guard_bits));
  at.extent_bits = to.extent_bits;
  step(fmt::format("edges below 2^{} px", to.extent_bits));
  at.tag_bits = to.tag_bits;
  step(fmt::format("{} tag bits", to.tag_bits));
  at.grid_log2 = to.grid_log2;
  step(fmt::format("{0} x {0} lanes", to.grid()));
  at.setup_interval = to.setup_interval;
  step(fmt::format("setup every {} clocks", to.setup_interval));
  return steps;
}

Json fit_report_json(const FitReport& report) {
  const FitResult& r = report.result;
  const FitRanges& ranges = r.ranges;
  Json json;
  json["command"] = report.command;
  json["views"] = report.views;
  json["views_empty"] = r.views_empty;
  json["triangles"] = ranges.triangles;
  json["triangles_no_sample"] = r.triangles_no_sample;
  json["config"] = config_json(r.config);
  json["reference"] = config_json(r.reference);
  json["samples_covered"] = r.samples_covered;
  json["samples_different_from_reference"] = r.samples_different;
  json["ranges"] = {
      {"promise", promise(ranges)},
      {"extent_px", std::ldexp(static_cast<double>(ranges.extent), -r.config.subpixel_bits)},
      {"widest", ranges.widest},
      {"cut_anyway", ranges.cut_anyway}};
  json["widths"] = {{"full", widths_json(kFull)}, {"fitted", widths_json(r.config)}};
  if (report.options.max_error) json["max_error_ppm"] = *report.options.max_error;
  if (r.coverage) json["coverage_error"] = coverage_json(*r.coverage);
  if (r.attributes) {
    json["attribute_error"] = {{"levels", r.attribute_error},
                               {"fragments_measured", r.attributes->fragments},
                               {"inverse_w_bits", points_json(r.attributes->inverse_w)},
                               {"gradient_bits", points_json(r.attributes->gradient)},
                               {"reciprocal_bits", points_json(r.attributes->reciprocal)}};
  }
  json["shapes"] = shapes_json(r);
  Json steps;
  for (const AreaStep& step : area_steps(r)) {
    Json area = area_json(step.area);
    area["step"] = step.name;
    steps.push_back(area);
  }
  json["area"] = {{"unit", kAreaUnit},
                  {"estimated_full", area_json(area_estimate(kFull))},
                  {"estimated", area_json(area_estimate(r.config))},
                  {"luts_error_percent", kAreaErrorPercent},
                  {"ff_error_percent", kFlipFlopErrorPercent},
                  {"steps", steps}};
  if (report.lod) {
    json["simplified"] = {{"triangles_before", report.lod->triangles_before},
                          {"triangles", report.lod->triangles_after},
                          {"pixels_covered", report.lod->pixels_covered},
                          {"pixels_wrong", report.lod->pixels_wrong},
                          {"hit_counts_wrong", report.lod->counts_wrong}};
  }
  if (report.measured) json["area"]["measured"] = *report.measured;
  if (report.measured_full) json["area"]["measured_full"] = *report.measured_full;
  if (r.fifos) json["fifos"] = fifos_json(*r.fifos);
  for (const Json& run : report.cosim) json["cosim"].push_back(cosim_json(run));
  return json;
}

namespace {

// Before and after, a row each.
std::string summary_table(const FitReport& report) {
  const Config& c = report.result.config;
  std::string out = fmt::format("{:<28}{:>10}{:>10}\n", "", "full", "fitted");
  const auto row = [&out](const char* name, auto full, auto fitted) {
    out += fmt::format("{:<28}{:>10}{:>10}\n", name, full, fitted);
  };
  row("subpixel bits", kFull.subpixel_bits, c.subpixel_bits);
  row("viewport bits", kFull.viewport_bits, c.viewport_bits);
  row("guard bits (0: none)", kFull.guard_bits, c.guard_bits);
  row("extent bits (0: no limit)", kFull.extent_bits, c.extent_bits);
  row("lanes", kFull.lanes(), c.lanes());
  row("levels", kFull.levels(), c.levels());
  row("setup interval", kFull.setup_interval, c.setup_interval);
  row("bits of A, B", kFull.delta_bits(), c.delta_bits());
  row("bits of a lane", kFull.lane_bits(), c.lane_bits());
  const AreaEstimate full = area_estimate(kFull), fitted = area_estimate(c);
  row("LUT4 + 2 CCU2C, estimated", std::llround(full.luts()), std::llround(fitted.luts()));
  row("flip-flops, estimated", std::llround(full.flip_flops), std::llround(fitted.flip_flops));
  row("MULT18, estimated", std::llround(full.multipliers), std::llround(fitted.multipliers));
  const auto share = [&out](const char* tool, double before, double after) {
    out += fmt::format("{:<38}{:>8.0f} %\n", fmt::format("LUT4 + 2 CCU2C of full's, {}", tool),
                       100 * after / before);
  };
  if (!report.measured) share("estimated", full.luts(), fitted.luts());
  if (report.measured) {
    const auto measured = [&](const char* key) {
      return std::pair(report.measured_full ? report.measured_full->at(key).dump() : "-",
                       report.measured->at(key).dump());
    };
    for (const auto& [name, key] : {std::pair("LUT4 + 2 CCU2C, yosys", "luts"),
                                    {"flip-flops, yosys", "ff"},
                                    {"MULT18, yosys", "mult18"}}) {
      const auto [before, after] = measured(key);
      row(name, before, after);
    }
    if (report.measured_full) {
      share("yosys", report.measured_full->at("luts"), report.measured->at("luts"));
    }
  }
  return out;
}

// What the fitted configuration does, a line each.
std::string summary_lines(const FitReport& report) {
  const FitResult& r = report.result;
  const Config& c = r.config;
  std::string out;
  const FitShape& shape = r.shapes[r.shape];
  out += fmt::format("{} clocks for {} view{}, {:.2f} px/clk\n", shape.clocks, report.views,
                     report.views == 1 ? "" : "s", shape.pixels_per_clock());
  if (r.views_empty != 0) {
    out += fmt::format("{} of {} views are empty: they ask for nothing\n", r.views_empty,
                       report.views);
  }
  out += fmt::format("{} of {} samples differ from full at {} subpixel bits\n", r.samples_different,
                     r.samples_covered, c.subpixel_bits);
  if (r.coverage) {
    const auto at = [&](int s) { return r.coverage->error[static_cast<std::size_t>(s)].ppm(); };
    out +=
        fmt::format("{:.0f} ppm of covered samples differ from unsnapped vertices (full: {:.0f})\n",
                    at(c.subpixel_bits), at(kFull.subpixel_bits));
  }
  if (r.attributes) {
    out += fmt::format("attributes within {:.3f} of 255 levels\n", r.attribute_error);
  }
  out += fmt::format("{} of {} triangles cover no sample\n", r.triangles_no_sample,
                     r.ranges.triangles);
  if (report.lod) {
    out += fmt::format("simplified: {} of {} triangles, {} of {} covered pixels wrong\n",
                       report.lod->triangles_after, report.lod->triangles_before,
                       report.lod->pixels_wrong, report.lod->pixels_covered);
  }
  for (const Json& run : report.cosim) {
    out += fmt::format("RTL and model {}: {} triangles, {} packets in {} clocks\n",
                       run.at("identical").get<bool>() ? "identical in bits and clocks" : "DIFFER",
                       run.at("triangles").dump(), run.at("packets_compared").dump(),
                       run.at("cycles").dump());
  }
  return out;
}

}  // namespace

std::string fit_summary(const FitReport& report) {
  return summary_table(report) + summary_lines(report);
}

}  // namespace halfspace
