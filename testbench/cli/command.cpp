// SPDX-License-Identifier: Apache-2.0
#include "command.hpp"

#include <span>

#include "choice.hpp"
#include "io/config_json.hpp"
#include "io/error.hpp"
#include "lab_door.hpp"
#include "number_checks.hpp"
#include "rtl_link.hpp"

namespace halfspace {
namespace {

// None: auto.
constexpr Choice<std::optional<Fidelity>> kLevels[] = {{"coverage", Fidelity::kCoverage},
                                                       {"bit", Fidelity::kBit},
                                                       {"cycle", Fidelity::kCycle},
                                                       {"rtl", Fidelity::kRtl},
                                                       {"auto", std::nullopt}};
constexpr Choice<Cull> kCulls[] = {
    {"none", Cull::kNone}, {"back", Cull::kBack}, {"front", Cull::kFront}};

}  // namespace

void add_level_option(Command& command, std::string& level) {
  command
      .add_option("--level", level,
                  "How much is modelled; auto: coverage, with the clocks predicted")
      ->type_name(type_name_of(std::span(kLevels)))
      ->capture_default_str();
}

std::optional<Fidelity> parse_level(const std::string& name) {
  return chosen(std::span(kLevels), name, "--level");
}

void require_level(Fidelity level, const Config& config) {
  if (level == Fidelity::kRtl) require_rtl(config, "--level");
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
      ->type_name(type_name_of(std::span(kCulls)))
      ->capture_default_str();
}

Cull parse_cull(const std::string& name) { return chosen(std::span(kCulls), name, "--cull"); }

}  // namespace halfspace
