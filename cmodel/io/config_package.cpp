// SPDX-License-Identifier: Apache-2.0
#include "config_package.hpp"

#include <fmt/format.h>

namespace halfspace {
namespace {

struct Macro {
  const char* name;
  ConfigField value;
};

constexpr Macro kMacros[] = {{"SUBPIXEL_BITS", &Config::subpixel_bits},
                             {"VIEWPORT_BITS", &Config::viewport_bits},
                             {"GUARD_BITS", &Config::guard_bits},
                             {"EXTENT_BITS", &Config::extent_bits},
                             {"SAMPLES", &Config::samples},
                             {"GRID_LOG2", &Config::grid_log2},
                             {"SETUP_INTERVAL", &Config::setup_interval},
                             {"TAG_BITS", &Config::tag_bits}};

}  // namespace

std::string config_package(const Config& config, const std::string& twin) {
  std::string text = fmt::format(
      "// SPDX-License-Identifier: Apache-2.0\n//\n"
      "// The free values of a configuration. Meaning and ranges: docs/03_design/config.md.\n//\n"
      "// Compile before rtl.f. Twin: {}.\n",
      twin);
  for (const Macro& macro : kMacros) {
    text += fmt::format("`define HS_{} {}\n", macro.name, config.*macro.value);
  }
  text += "\npackage hs_config_pkg;\n";
  for (const Macro& macro : kMacros) {
    text += fmt::format("  localparam int {0} /*verilator public*/ = `HS_{0};\n", macro.name);
  }
  return text + "endpackage\n";
}

}  // namespace halfspace
