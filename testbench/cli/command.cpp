// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"

#include <fmt/format.h>

#include "io/config_json.hpp"
#include "io/error.hpp"
#include "lab_door.hpp"
#include "number_checks.hpp"
#include "rtl_link.hpp"

namespace halfspace {

Level parse_level(const std::string& name) {
  if (name == "coverage") return Level::kCoverage;
  if (name == "bit") return Level::kBit;
  if (name == "cycle") return Level::kCycle;
  if (name == "rtl") return Level::kRtl;
  throw Error(ErrorCode::kUsage, "--level",
              fmt::format("'{}' is not coverage, bit, cycle, rtl or auto", name));
}

void require_level(Level level, const Config& config) {
  if (level == Level::kRtl) require_rtl(config, "--level");
}

const LabDoor& require_lab(const LabDoor* lab) {
  if (lab != nullptr) return *lab;
  throw Error(ErrorCode::kNoLab, "", "this program was built without the lab (HALFSPACE_LAB=OFF)");
}

void ConfigOptions::add_to(Command& command) {
  command.add_option("--config", name, "Preset (tiny, full, d3d, msaa4) or a .json file")
      ->type_name("NAME|FILE")
      ->capture_default_str();
  command.add_option("--samples", samples, "Samples per pixel, instead of the configuration's")
      ->type_name("1|2|4|8|16")
      ->check(whole(1));
}

Config ConfigOptions::load() const {
  Config config = load_config(name);
  if (samples != 0) {
    config.samples = samples;
    require_legal(config, "--samples");
  }
  return config;
}

void add_cull_option(Command& command, std::string& cull) {
  command.add_option("--cull", cull, "Faces to drop; front is counter-clockwise as seen")
      ->type_name("none|back|front")
      ->capture_default_str();
}

Cull parse_cull(const std::string& name) {
  if (name == "none") return Cull::kNone;
  if (name == "back") return Cull::kBack;
  if (name == "front") return Cull::kFront;
  throw Error(ErrorCode::kUsage, "--cull", fmt::format("'{}' is not none, back or front", name));
}

}  // namespace halfspace
