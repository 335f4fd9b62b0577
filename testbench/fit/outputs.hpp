// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "emit.hpp"
#include "io/output_file.hpp"
#include "io/output_folder.hpp"
#include "report.hpp"

namespace halfspace {

// What fit writes without a tool: opened before work begins, and all of it finished before the
// first is in place. Destroyed or interrupted before that, it leaves nothing behind.
class FitOutputs {
 public:
  // out: file of the configuration; report, emit: folders; empty: none. source: the project's
  // source tree. Throws Error(kFileWrite), Error(kUsage) when two have one name, Error(kFitTool).
  FitOutputs(const std::string& out, const std::string& report, const std::string& emit,
             const std::string& source);

  // Everything, in place. Throws Error(kFileWrite). From here on an interrupt says that it stays.
  void write(const FitReport& report, const std::vector<EmitRun>& runs);
  // The report again, with what a tool has measured.
  void rewrite(const FitReport& report);

 private:
  void open_report();
  void write_report(const FitReport& report);

  std::string report_folder_;
  std::optional<OutputFile> out_;
  std::optional<OutputFolder> report_;
  std::array<std::string, 2> report_paths_;
  std::optional<RtlFolder> rtl_;
};

}  // namespace halfspace
