// SPDX-License-Identifier: Apache-2.0
//
// halfspace config: show a configuration and the widths derived from it.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "fit/area_model.hpp"
#include "io/config_json.hpp"
#include "io/config_package.hpp"

namespace halfspace {
namespace {

nlohmann::ordered_json derived_json(const Config& c) {
  nlohmann::ordered_json json;
  json["vertex_bits"] = c.vertex_bits();
  json["delta_bits"] = c.delta_bits();
  json["area_bits"] = c.area_bits();
  json["constant_bits"] = c.constant_bits();
  json["edge_full_bits"] = c.edge_full_bits();
  json["edge_bits"] = c.edge_bits();
  json["lane_bits"] = c.lane_bits();
  json["levels"] = c.levels();
  std::vector<int> nodes;
  for (int level = 0; level < c.levels(); ++level) nodes.push_back(c.node_bits(c.node_log2(level)));
  json["node_bits"] = nodes;
  return json;
}

nlohmann::ordered_json area_json(const Config& config) {
  const AreaFeatures f = area_features(config);
  const AreaEstimate area = area_estimate(config);
  nlohmann::ordered_json json;
  json["unit"] = kAreaUnit;
  json["luts"] = std::llround(area.luts());
  json["lut4"] = std::llround(area.lut4);
  json["ccu2c"] = std::llround(area.ccu2c);
  json["ff"] = std::llround(area.flip_flops);
  json["mult18"] = std::llround(area.multipliers);
  json["luts_error_percent"] = kAreaErrorPercent;
  json["ff_error_percent"] = kFlipFlopErrorPercent;
  json["features"] = {{"pyramid_adders", f.pyramid_adders}, {"setup_adders", f.setup_adders},
                      {"multiplexer", f.multiplexer},       {"lanes", f.lanes},
                      {"pyramid_state", f.pyramid_state},   {"setup_state", f.setup_state}};
  return json;
}

}  // namespace

Action add_config_command(Command& program) {
  Command* command = program.add_subcommand(
      "config", "Print a configuration as JSON, or with --derived the widths that follow from it");
  auto options = std::make_shared<ConfigOptions>();
  auto derived = std::make_shared<bool>(false);
  auto area = std::make_shared<bool>(false);
  auto package = std::make_shared<bool>(false);
  options->add_to(*command);
  Option* widths = command->add_flag("--derived", *derived, "Print derived widths (bits) instead");
  Option* cells =
      command
          ->add_flag("--area", *area,
                     "Print the estimated area instead (ECP5 cells; luts: LUT4 + 2 CCU2C)")
          ->excludes(widths);
  command
      ->add_flag("--package", *package, "Print hs_config_pkg.sv of it instead, for the RTL in rtl/")
      ->excludes(widths)
      ->excludes(cells);
  command->footer("Example: halfspace config --config d3d --derived");
  return [options, derived, area, package] {
    const Config config = options->load();
    if (*package) {
      fmt::print("{}", config_package(config, "what halfspace config was asked for"));
      return 0;
    }
    fmt::print("{}\n", (*area      ? area_json(config)
                        : *derived ? derived_json(config)
                                   : config_json(config))
                           .dump(2));
    return 0;
  };
}

}  // namespace halfspace
