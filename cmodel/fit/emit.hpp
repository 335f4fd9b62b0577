// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "../config.hpp"

namespace halfspace {

// How the emitted folder's script runs the fitted scenes again.
struct EmitRun {
  std::string scene;    // path
  std::string options;  // of halfspace cosim, each with a space before it
};

// Writes a configuration's RTL into `folder`, which is created: config.json, hs_config_pkg.sv,
// rtl/ (a copy of `source`/rtl), files.f (what to compile, in order) and cosim.sh, which lints,
// builds the program with this RTL and compares it with the model on the runs; each leaves its
// statistics in emitted_stats(). source: the
// project's source tree. Throws Error(kFileWrite), Error(kFitTool) when the source is not there.
void emit_rtl(const std::string& folder, const std::string& source, const Config& config,
              const std::vector<EmitRun>& runs);

// The file of run number `run`, in the emitted folder: what halfspace cosim --stats writes.
std::string emitted_stats(std::size_t run);

// Runs a command of the shell, its output into `log`. Throws Error(kFitTool) naming `what` and the
// log when it fails.
void run_tool(const std::string& command, const std::string& log, const std::string& what);

}  // namespace halfspace
