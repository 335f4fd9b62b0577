// SPDX-License-Identifier: Apache-2.0
//
// halfspace config: show a configuration and the widths derived from it.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <nlohmann/json.hpp>

#include "../io/config_json.hpp"
#include "command.hpp"

namespace halfspace {
namespace {

nlohmann::ordered_json derived_json(const Config& c) {
  nlohmann::ordered_json json;
  json["vertex_bits"] = c.vertex_bits();
  json["delta_bits"] = c.delta_bits();
  json["area_bits"] = c.area_bits();
  json["edge_full_bits"] = c.edge_full_bits();
  json["edge_bits"] = c.edge_bits();
  json["lane_bits"] = c.lane_bits();
  json["levels"] = c.levels();
  std::vector<int> nodes;
  for (int level = 0; level < c.levels(); ++level) nodes.push_back(c.node_bits(c.node_log2(level)));
  json["node_bits"] = nodes;
  return json;
}

}  // namespace

Action add_config_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "config", "Print a configuration as JSON, or with --derived the widths that follow from it");
  auto options = std::make_shared<ConfigOptions>();
  auto derived = std::make_shared<bool>(false);
  options->add_to(*command);
  command->add_flag("--derived", *derived, "Print derived widths (bits) instead");
  command->footer("Example: halfspace config --config d3d --derived");
  return [options, derived] {
    const Config config = options->load();
    fmt::print("{}\n", (*derived ? derived_json(config) : config_json(config)).dump(2));
    return 0;
  };
}

}  // namespace halfspace
