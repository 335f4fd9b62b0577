// SPDX-License-Identifier: Apache-2.0
#include "emit.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include "../io/config_json.hpp"
#include "../io/config_package.hpp"
#include "../io/error.hpp"
#include "../io/escape.hpp"
#include "../io/output_file.hpp"

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

// The sources, in the order of compilation, relative to the emitted folder.
std::vector<std::string> copy_rtl(const fs::path& from, const fs::path& to) {
  std::vector<std::string> files;
  std::error_code code;
  fs::create_directories(to / "checkers", code);
  const auto copy = [&](const std::string& name) {
    write_text(to / name, read_file((from / name).string()));
  };
  copy("rtl.f");
  copy("hs_lint.vlt");
  copy("checkers/checkers.f");
  for (const std::string& name : lines_of(from / "rtl.f")) {
    copy(name);
    files.push_back("rtl/" + name);
  }
  for (const std::string& name : lines_of(from / "checkers/checkers.f")) {
    copy("checkers/" + name);
  }
  return files;
}

std::string script(const std::string& source, const std::vector<EmitRun>& runs) {
  std::string text = R"SH(#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Lints this configuration's RTL with Verilator and yosys, builds halfspace with it and compares it
# with the model, every packet in bits and clock. Written by halfspace fit.
set -eu
cd "$(dirname "$0")"
here=$(pwd)
)SH";
  text += "source=" + quoted(source) + R"SH(
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
echo 'building halfspace with this RTL (minutes; log: build.log)'
{
  cmake -S "$source" -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DHALFSPACE_TESTS=OFF \
    -DHALFSPACE_LAB=OFF -DHALFSPACE_RTL=ON -DHALFSPACE_RTL_CONFIGS=none "-DHALFSPACE_RTL_EXTRA=$here" &&
  cmake --build build --target halfspace
} > build.log 2>&1 || { cat build.log >&2; exit 1; }
)SH";
  for (std::size_t i = 0; i < runs.size(); ++i) {
    text += fmt::format(
        "build/cmodel/halfspace cosim {}{} --config config.json --stall 0.3 --stats {}\n",
        quoted(fs::absolute(runs[i].scene).string()), runs[i].options, emitted_stats(i));
  }
  return text;
}

}  // namespace

std::string emitted_stats(std::size_t run) { return fmt::format("cosim_{}.json", run); }

void emit_rtl(const std::string& folder, const std::string& source, const Config& config,
              const std::vector<EmitRun>& runs) {
  const fs::path rtl = fs::path(source) / "rtl";
  if (!fs::exists(rtl / "rtl.f")) {
    throw Error(ErrorCode::kFitTool, "--emit-rtl",
                fmt::format("no RTL in {} (give the source tree with --source)", source));
  }
  const fs::path to(folder);
  std::error_code code;
  fs::create_directories(to, code);  // what fails here fails again at the first file
  std::vector<std::string> files = copy_rtl(rtl, to / "rtl");
  files.insert(files.begin(), "hs_config_pkg.sv");
  std::string list;
  for (const std::string& file : files) list += file + "\n";
  write_text(to / "files.f", list);
  write_text(to / "hs_config_pkg.sv",
             config_package(config, "config.json beside it; the compiler compares them"));
  write_text(to / "config.json", config_json(config).dump(2) + "\n");
  write_text(to / "cosim.sh", script(fs::absolute(source).string(), runs));
  fs::permissions(to / "cosim.sh", fs::perms::owner_exec | fs::perms::group_exec,
                  fs::perm_options::add, code);
}

void run_tool(const std::string& command, const std::string& log, const std::string& what) {
  const std::string line = fmt::format("{} > {} 2>&1", command, quoted(log));
  if (std::system(line.c_str()) == 0) return;
  throw Error(ErrorCode::kFitTool, what, fmt::format("failed: see {}", log));
}

}  // namespace halfspace
