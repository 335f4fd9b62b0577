// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "config.hpp"
#include "io/output_folder.hpp"

namespace halfspace {

// How the emitted folder's script runs the fitted scenes again.
struct EmitRun {
  std::string scene;    // path
  std::string options;  // of halfspace cosim, each with a space before it
};

// A folder with a configuration's RTL, whole or as it was: config.json, hs_config_pkg.sv, rtl/ (a
// copy of the source tree's), files.f (what to compile, in order) and cosim.sh, which lints and
// compares this RTL with the model on the runs; each leaves its statistics in emitted_stats().
// Destroyed without commit(), or interrupted, it leaves nothing behind.
class RtlFolder {
 public:
  // source: the project's source tree. Throws Error(kFileWrite) when the folder cannot be written,
  // Error(kFitTool) when the source is not there.
  RtlFolder(const std::string& folder, const std::string& source);

  // Every file, none of them in place yet. Throws Error(kFileWrite), also when the name of one is a
  // folder's.
  void write(const Config& config, const std::vector<EmitRun>& runs);
  void commit();

 private:
  std::vector<std::string> copy_rtl();

  std::string folder_, source_;
  OutputFolder top_, rtl_, checkers_;
};

// Where to write that file of the folder. Throws Error(kFileWrite) when there is a folder of that
// name, which a file cannot replace.
std::string file_in(OutputFolder& folder, const std::string& path, const std::string& name);

// The file of run number `run`, in the emitted folder: what halfspace cosim --stats writes.
std::string emitted_stats(std::size_t run);

// Runs a command of the shell, its output into `log`. Throws Error(kFitTool) naming `what` and the
// log when it fails.
void run_tool(const std::string& command, const std::string& log, const std::string& what);

}  // namespace halfspace
