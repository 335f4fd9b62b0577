// SPDX-License-Identifier: Apache-2.0
#include "config_json.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "error.hpp"
#include "json_text.hpp"
#include "output_file.hpp"

namespace halfspace {
namespace {

struct Field {
  const char* key;
  ConfigField value;
};

constexpr std::array<Field, 13> kFields{{
    {"subpixel_bits", &Config::subpixel_bits},
    {"viewport_bits", &Config::viewport_bits},
    {"guard_bits", &Config::guard_bits},
    {"extent_bits", &Config::extent_bits},
    {"samples", &Config::samples},
    {"grid_log2", &Config::grid_log2},
    {"setup_interval", &Config::setup_interval},
    {"tag_bits", &Config::tag_bits},
    {"depth_bits", &Config::depth_bits},
    {"attributes", &Config::attributes},
    {"inverse_w_bits", &Config::inverse_w_bits},
    {"gradient_bits", &Config::gradient_bits},
    {"reciprocal_bits", &Config::reciprocal_bits},
}};

constexpr std::array<const char*, 3> kSnapNames{"nearest_even", "half_away", "truncate"};

std::string preset_names() {
  std::string names;
  for (const Preset& preset : kPresets) {
    names += (names.empty() ? "" : ", ") + std::string(preset.name);
  }
  return names;
}

Config require_preset(const std::string& name, const std::string& place) {
  if (const std::optional<Config> preset = find_preset(name)) return *preset;
  throw Error(ErrorCode::kConfigKey, place,
              fmt::format("no preset '{:.40}' (there are {}; a file must end in .json)", name,
                          preset_names()));
}

}  // namespace

void set_config_field(Config& config, const std::string& key, const nlohmann::json& value,
                      const std::string& place) {
  const auto refuse = [&](const char* expected) {
    throw Error(ErrorCode::kConfigRange, place,
                fmt::format("{} = {:.40} is not {}", key, value.dump(), expected));
  };
  if (key == "snap") {
    for (std::size_t i = 0; i < kSnapNames.size(); ++i) {
      if (value == kSnapNames[i]) {
        config.snap = static_cast<SnapMode>(i);
        return;
      }
    }
    refuse("nearest_even, half_away or truncate");
  }
  for (const Field& field : kFields) {
    if (key != field.key) continue;
    if (!value.is_number_integer() || value < -1000000 || value > 1000000) {
      refuse("a whole number in range");
    }
    config.*field.value = value.get<int>();
    return;
  }
  throw Error(ErrorCode::kConfigKey, place, fmt::format("unknown key '{:.40}'", key));
}

void require_legal(const Config& config, const std::string& place) {
  const std::string wrong = validate(config);
  if (!wrong.empty()) throw Error(ErrorCode::kConfigRange, place, wrong);
}

Config parse_config(const std::string& text, const std::string& place) {
  const nlohmann::json json = parse_json(
      text, place, {ErrorCode::kConfigRead, ErrorCode::kConfigKey, ErrorCode::kConfigRange});
  if (!json.is_object()) throw Error(ErrorCode::kConfigRead, place, "not a JSON object");
  Config config;
  if (json.contains("preset")) {
    if (!json["preset"].is_string()) {
      throw Error(ErrorCode::kConfigRange, place, "preset is not a string");
    }
    config = require_preset(json["preset"], place);
  }
  for (const auto& [key, value] : json.items()) {
    if (key != "preset") set_config_field(config, key, value, place);
  }
  require_legal(config, place);
  return config;
}

Config load_config(const std::string& name_or_path) {
  if (!name_or_path.ends_with(".json")) return require_preset(name_or_path, "--config");
  std::string text;
  try {
    text = read_file(name_or_path);
  } catch (const Error& error) {
    throw Error(ErrorCode::kConfigRead, "", error.what());
  }
  return parse_config(text, name_or_path);
}

nlohmann::ordered_json config_json(const Config& config) {
  nlohmann::ordered_json json;
  for (const Field& field : kFields) json[field.key] = config.*field.value;
  json["snap"] = kSnapNames[static_cast<std::size_t>(config.snap)];
  return json;
}

}  // namespace halfspace
