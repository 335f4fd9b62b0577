// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fit.hpp"
#include "lod.hpp"

namespace halfspace {

// What a report says beyond the result itself.
struct FitReport {
  std::string command;  // as typed
  const FitOptions& options;
  const FitResult& result;
  std::size_t views = 0;
  std::optional<nlohmann::ordered_json> measured;  // --synth: yosys's figures of the configuration
  std::optional<LodError> lod;                     // --simplify
  std::optional<nlohmann::ordered_json> measured_full;  // and those of `full`
  std::vector<nlohmann::ordered_json> cosim;            // --cosim: statistics of each run
};

// The estimated area on the way from `full` to the result, one choice after the other.
struct AreaStep {
  std::string name;
  AreaEstimate area;
};
std::vector<AreaStep> area_steps(const FitResult& result);

// Everything, as data. docs/02_use/fit.md lists the fields.
nlohmann::ordered_json fit_report_json(const FitReport& report);

// The same as one page with charts, complete in itself.
std::string fit_report_html(const FitReport& report);

// A table for the terminal: before, after.
std::string fit_summary(const FitReport& report);

}  // namespace halfspace
