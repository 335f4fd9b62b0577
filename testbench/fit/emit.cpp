// SPDX-License-Identifier: Apache-2.0
#include "emit.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include "io/child_process.hpp"
#include "io/config_json.hpp"
#include "io/config_package.hpp"
#include "io/error.hpp"
#include "io/escape.hpp"
#include "io/output_file.hpp"

namespace halfspace {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const fs::path& path) {
  std::vector<std::string> lines;
  std::istringstream stream(read_file(path.string()));
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

std::string script(const std::vector<EmitRun>& runs) {
  std::error_code ignored;
  std::string text = R"SH(#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Lints this configuration's RTL with Verilator and yosys, and compares it with the model, every
# packet in bits and clock. $HALFSPACE names another program. Written by halfspace fit.
set -eu
cd "$(dirname "$0")"
)SH";
  text += fmt::format(R"SH(halfspace=${{HALFSPACE:-{}}}
rm -f cosim_*.json
checkers=$(sed 's|^|rtl/checkers/|' rtl/checkers/checkers.f)
verilator --lint-only -Wall --assert --top-module hs_rasterizer rtl/hs_lint.vlt \
  $(cat files.f) $checkers
echo 'verilator -Wall: nothing to warn of'
yosys -q -p "read_verilog -sv $(tr '\n' ' ' < files.f)
hierarchy -check -top hs_rasterizer
proc
check -assert"
echo 'yosys check: no problem'
HALFSPACE_RTL=$(pwd)/rtl
export HALFSPACE_RTL
)SH",
                      quoted(fs::read_symlink("/proc/self/exe", ignored).string()));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    text += fmt::format("\"$halfspace\" cosim {}{} --config config.json --stall 0.3 --stats {}\n",
                        quoted(fs::absolute(runs[i].scene).string()), runs[i].options,
                        emitted_stats(i));
  }
  return text;
}

}  // namespace

std::string emitted_stats(std::size_t run) { return fmt::format("cosim_{}.json", run); }

std::string file_in(OutputFolder& folder, const std::string& path, const std::string& name) {
  const fs::path whole = fs::path(path) / name;
  std::error_code ignored;
  if (fs::is_directory(whole, ignored)) {
    throw Error(ErrorCode::kFileWrite, whole.string(), "cannot write: it is a directory");
  }
  return folder.file(name);
}

// The outermost first, so that the others make no folder that it would have to be.
RtlFolder::RtlFolder(const std::string& folder, const std::string& source)
    : folder_(folder),
      source_(source),
      top_(folder),
      rtl_((fs::path(folder) / "rtl").string()),
      checkers_((fs::path(folder) / "rtl/checkers").string()) {
  if (fs::exists(fs::path(source) / "rtl/rtl.f")) return;
  throw Error(ErrorCode::kFitTool, "--emit-rtl",
              fmt::format("no RTL in {} (give the source tree with --source)", source));
}

// The sources, in the order of compilation, relative to the emitted folder.
std::vector<std::string> RtlFolder::copy_rtl() {
  const auto copy = [&](OutputFolder& to, const std::string& folder, const std::string& name) {
    const std::string text = read_file((fs::path(source_) / folder / name).string());
    write_text(file_in(to, (fs::path(folder_) / folder).string(), name), text);
  };
  const fs::path from = fs::path(source_) / "rtl";
  std::vector<std::string> files;
  copy(rtl_, "rtl", "rtl.f");
  copy(rtl_, "rtl", "hs_lint.vlt");
  copy(checkers_, "rtl/checkers", "checkers.f");
  for (const std::string& name : lines_of(from / "rtl.f")) {
    copy(rtl_, "rtl", name);
    files.push_back("rtl/" + name);
  }
  for (const std::string& name : lines_of(from / "checkers/checkers.f")) {
    copy(checkers_, "rtl/checkers", name);
  }
  return files;
}

void RtlFolder::write(const Config& config, const std::vector<EmitRun>& runs) {
  const auto write = [&](const std::string& name, const std::string& text) {
    const std::string path = file_in(top_, folder_, name);
    write_text(path, text);
    return path;
  };
  std::vector<std::string> files = copy_rtl();
  files.insert(files.begin(), "hs_config_pkg.sv");
  std::string list;
  for (const std::string& file : files) list += file + "\n";
  write("files.f", list);
  write("hs_config_pkg.sv", config_package(config, "config.json beside it"));
  write("config.json", config_json(config).dump(2) + "\n");
  const std::string path = write("cosim.sh", script(runs));
  std::error_code ignored;
  fs::permissions(path, fs::perms::owner_exec | fs::perms::group_exec, fs::perm_options::add,
                  ignored);
}

void RtlFolder::commit() {
  for (OutputFolder* folder : {&top_, &rtl_, &checkers_}) folder->commit();
}

void run_tool(const std::string& command, const std::string& log, const std::string& what) {
  const std::string line = fmt::format("{} > {} 2>&1", command, quoted(log));
  if (run_child({"/bin/sh", "-c", line}) == 0) return;
  throw Error(ErrorCode::kFitTool, what, fmt::format("failed: see {}", log));
}

}  // namespace halfspace
