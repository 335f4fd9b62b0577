// SPDX-License-Identifier: Apache-2.0
#include "outputs.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/config_json.hpp"
#include "io/interrupt.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

constexpr std::array kReportFiles{"report.json", "index.html"};

std::string in(const std::string& folder, const char* name) {
  return folder.empty() ? std::string() : (fs::path(folder) / name).string();
}

}  // namespace

FitOutputs::FitOutputs(const std::string& out, const std::string& report, const std::string& emit,
                       const std::string& source)
    : report_folder_(report) {
  // Folders are compared by a name that no file in them has.
  check_distinct({in(report, "*"), in(emit, "*"), in(emit, "rtl/*"), in(emit, "rtl/checkers/*")});
  std::vector<std::string> files{out};
  for (const char* name : kReportFiles) files.push_back(in(report, name));
  for (const char* name : {"files.f", "hs_config_pkg.sv", "config.json", "cosim.sh"}) {
    files.push_back(in(emit, name));
  }
  check_distinct(files);
  if (!out.empty()) out_.emplace(out);
  if (!report.empty()) open_report();
  if (!emit.empty()) rtl_.emplace(emit, source);
}

void FitOutputs::write(const FitReport& report, const std::vector<EmitRun>& runs) {
  const Config& config = report.result.config;
  if (rtl_) rtl_->write(config, runs);
  if (report_) write_report(report);
  if (out_) {
    out_->write(config_json(config).dump(2) + "\n");
    out_->finish();
  }
  flush_standard_output();
  const InterruptsHeld held;  // all or none
  if (rtl_) rtl_->commit();
  if (report_) report_->commit();
  if (out_) out_->commit();
}

void FitOutputs::rewrite(const FitReport& report) {
  if (report_folder_.empty()) return;
  open_report();
  write_report(report);
  report_->commit();
}

void FitOutputs::open_report() {
  report_.reset();
  report_.emplace(report_folder_);
  for (std::size_t i = 0; i < kReportFiles.size(); ++i) {
    report_paths_[i] = file_in(*report_, report_folder_, kReportFiles[i]);
  }
}

void FitOutputs::write_report(const FitReport& report) {
  write_text(report_paths_[0], fit_report_json(report).dump(2) + "\n");
  write_text(report_paths_[1], fit_report_html(report));
}

}  // namespace halfspace
