// SPDX-License-Identifier: Apache-2.0
#include "config.hpp"

namespace halfspace {
namespace {

// One range, said the same way for every field.
std::string out_of_range(std::string_view field, int value, std::string_view range) {
  return std::string(field) + " = " + std::to_string(value) + " is out of range (" +
         std::string(range) + ")";
}

struct Range {
  std::string_view field;
  ConfigField value;
  int low;
  int high;
};

constexpr std::array<Range, 9> kRanges{{
    {"subpixel_bits", &Config::subpixel_bits, 0, 12},
    {"viewport_bits", &Config::viewport_bits, 3, 15},
    {"grid_log2", &Config::grid_log2, 2, 3},
    {"tag_bits", &Config::tag_bits, 1, 32},
    {"depth_bits", &Config::depth_bits, 16, 32},
    {"attributes", &Config::attributes, 0, 8},
    {"inverse_w_bits", &Config::inverse_w_bits, 12, 30},
    {"gradient_bits", &Config::gradient_bits, 0, 20},
    {"reciprocal_bits", &Config::reciprocal_bits, 6, 16},
}};

}  // namespace

std::optional<Config> find_preset(std::string_view name) {
  for (const Preset& preset : kPresets) {
    if (preset.name == name) return preset.config;
  }
  return std::nullopt;
}

std::string validate(const Config& config) {
  for (const Range& range : kRanges) {
    const int value = config.*range.value;
    if (value < range.low || value > range.high) {
      return out_of_range(range.field, value,
                          std::to_string(range.low) + ".." + std::to_string(range.high));
    }
  }
  if (config.guard_bits != 0 &&
      (config.guard_bits < config.viewport_bits || config.guard_bits > 16)) {
    return out_of_range("guard_bits", config.guard_bits,
                        "0 for none, or viewport_bits.." + std::to_string(16));
  }
  const int widest = (config.has_guard_band() ? config.guard_bits : config.viewport_bits) + 1;
  if (config.extent_bits < 0 || config.extent_bits > widest) {
    return out_of_range("extent_bits", config.extent_bits,
                        "0 for no limit, or 1.." + std::to_string(widest));
  }
  const int samples = config.samples;
  if (samples != 1 && samples != 2 && samples != 4 && samples != 8 && samples != 16) {
    return out_of_range("samples", samples, "1, 2, 4, 8 or 16");
  }
  if (config.setup_interval != 1 && config.setup_interval != 3) {
    return out_of_range("setup_interval", config.setup_interval, "1 or 3");
  }
  return {};
}

}  // namespace halfspace
