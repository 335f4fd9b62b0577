// SPDX-License-Identifier: Apache-2.0
//
// What the subcommands share: option values that several of them take, and their registration.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "../config.hpp"
#include "../packets.hpp"
#include "camera_options.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace halfspace {

// How much is modelled. docs/01_overview/levels.md.
enum class Level { kCoverage, kBit, kCycle, kRtl };

// Throws Error(kUsage) for an unknown name.
Level parse_level(const std::string& name);

// --config and --samples, the same everywhere.
struct ConfigOptions {
  std::string name = "full";
  int samples = 0;  // 0: as configured

  void add_to(CLI::App& command);
  Config load() const;  // legal; throws Error
};

// An option that makes the command do another thing: together with any but those of `with` it is
// refused, because they would do nothing. Call it after the last option was added.
void stands_alone(CLI::App& command, CLI::Option* option,
                  const std::vector<std::string>& with = {});

// Builds the RTL if need be when the level is rtl. Throws Error(kLevel) where it cannot be built.
void require_level(Level level, const Config& config);

// --cull none|back|front.
void add_cull_option(CLI::App& command, std::string& cull);
Cull parse_cull(const std::string& name);

// halfspace cosim: a scene or TCOV file through model and RTL, compared.
struct CosimRequest {
  std::string in;
  std::string size;
  std::string stats;
  std::string trace;
  std::string cull = "none";
  double stall = 0;
  std::uint64_t seed = 1;
  int case_id = -1;
  int views = 1;
  CameraArguments camera;
  ConfigOptions config;
};
// Exit status: 0 identical, 1 not (a line on stderr says where, and how to replay it). Throws
// Error.
int run_cosim(const CosimRequest& request);

// A subcommand adds itself to the program and returns what to run when it is chosen.
using Action = std::function<int()>;  // returns the exit status
Action add_render_command(CLI::App& program);
Action add_coverage_command(CLI::App& program);
Action add_config_command(CLI::App& program);
Action add_cosim_command(CLI::App& program);
Action add_chart_command(CLI::App& program);
Action add_explain_command(CLI::App& program);
Action add_bench_command(CLI::App& program);
Action add_vectors_command(CLI::App& program);
Action add_fit_command(CLI::App& program);
Action add_methods_command(CLI::App& program);
Action add_report_command(CLI::App& program);
Action add_stability_command(CLI::App& program);

}  // namespace halfspace
