// SPDX-License-Identifier: Apache-2.0
//
// What the subcommands share: option values that several of them take, and their registration.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "camera_options.hpp"
#include "config.hpp"
#include "framebuffer.hpp"
#include "options.hpp"
#include "packets.hpp"

namespace halfspace {

class Scene;
struct LabDoor;
struct RunStats;

// How much is modelled. docs/01_overview/levels.md.
enum class Fidelity { kCoverage, kBit, kCycle, kRtl };

// --level coverage|bit|cycle|rtl|auto. None: auto. Throws Error(kUsage) for an unknown name.
void add_level_option(Command& command, std::string& level);
std::optional<Fidelity> parse_level(const std::string& name);

// --config and --samples, the same everywhere.
struct ConfigOptions {
  std::string name = "full";
  int samples = 0;  // 0: as configured

  void add_to(Command& command);
  Config load() const;  // legal; throws Error
};

// Builds the RTL if need be when the level is rtl. Throws Error(kLevel) where it cannot be built.
void require_level(Fidelity level, const Config& config);

// --cull none|back|front.
void add_cull_option(Command& command, std::string& cull);
Cull parse_cull(const std::string& name);

// How render draws a frame by a method of the gallery.
struct MethodDrawing {
  // Throws Error(kMethod) or Error(kMethodOption) when there is no such method, or it cannot draw
  // the shade.
  void (*require)(const std::string& method, const std::string& shade);
  // method_picture() of it.
  Image (*draw)(const Scene& scene, std::size_t index, const FrameState& frame,
                const std::string& method, const std::string& shade, RunStats& stats);
};

// halfspace cosim: a scene or TCOV file through model and RTL, compared.
struct CosimRequest {
  std::string in;
  std::string format;  // of standard input
  std::string size;
  std::string stats;
  std::string trace;
  std::string cull = "none";
  double stall = 0;
  std::uint64_t seed = 1;
  bool seed_given = false;
  int case_id = -1;
  int views = 1;
  CameraArguments camera;
  ConfigOptions config;
};
// Exit status: 0 identical, 1 not (a line on stderr says where, and how to replay it). Throws
// Error.
int run_cosim(const CosimRequest& request);

// gallery, lab: null in a program without, where what needs it is refused.
Action add_render_command(Command& program, const MethodDrawing* gallery);
Action add_coverage_command(Command& program);
Action add_config_command(Command& program);
Action add_cosim_command(Command& program);
Action add_chart_command(Command& program, const LabDoor* lab);
Action add_explain_command(Command& program, const LabDoor* lab);
Action add_bench_command(Command& program);
Action add_vectors_command(Command& program);
Action add_fit_command(Command& program);
Action add_sweep_command(Command& program);
Action add_merge_command(Command& program);
Action add_soak_command(Command& program);
Action add_methods_command(Command& program);
Action add_report_command(Command& program, const LabDoor* lab);
Action add_stability_command(Command& program, const LabDoor* lab);

}  // namespace halfspace
