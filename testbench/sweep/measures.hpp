// SPDX-License-Identifier: Apache-2.0
//
// What is measured of one case, as its record.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cases.hpp"
#include "fit/fit.hpp"
#include "rtl/rtl_rasterizer.hpp"

namespace halfspace {

// Measures cases. Keeps what the next one may need again: the scene, the real triangles' coverage,
// the RTL. work: a folder for what yosys writes.
class CaseMeasurer {
 public:
  CaseMeasurer(const SweepSpecification& specification, std::string work);

  // The same bytes for the same case, program and machine type. What throws Error while a case is
  // measured becomes the record's `error`.
  nlohmann::ordered_json measure(const SweepCase& at);

 private:
  const FitView& view_of(const SweepCase& at);
  nlohmann::ordered_json measured(Measure measure, const FitView& view, const Config& config);
  nlohmann::ordered_json coverage_error_of(const FitView& view, const Config& config);
  nlohmann::ordered_json rtl_of(const FitView& view, const Config& config);
  nlohmann::ordered_json synth_of(const Config& config) const;

  const SweepSpecification& specification_;
  std::string work_;
  std::optional<std::pair<std::size_t, std::size_t>> open_;  // scene and size of views_
  std::vector<FitView> views_;
  std::optional<std::pair<const FitView*, int>> metered_;  // view and samples of meter_
  CoverageMeter meter_;
  std::unique_ptr<RtlRasterizer> rtl_;
};

}  // namespace halfspace
