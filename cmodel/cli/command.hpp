// SPDX-License-Identifier: Apache-2.0
//
// What the subcommands share: option values that several of them take, and their registration.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "../config.hpp"
#include "../packets.hpp"

namespace halfspace {

// How much is modelled. docs/01_overview/levels.md.
enum class Level { kCoverage, kBit, kCycle, kRtl };

// Throws Error(kLevel) for a level this build does not have, kUsage for an unknown name.
Level parse_level(const std::string& name);

// --config and --samples, the same everywhere.
struct ConfigOptions {
  std::string name = "full";
  int samples = 0;  // 0: as configured

  void add_to(CLI::App& command);
  Config load() const;  // legal; throws Error
};

// --cull none|back|front.
void add_cull_option(CLI::App& command, std::string& cull);
Cull parse_cull(const std::string& name);

// A subcommand adds itself to the program and returns what to run when it is chosen.
using Action = std::function<void()>;
Action add_render_command(CLI::App& program);
Action add_coverage_command(CLI::App& program);
Action add_config_command(CLI::App& program);

}  // namespace halfspace
