// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "../config.hpp"

namespace halfspace {

// A configuration from a preset's name or, when the name ends in .json, from a file. The file holds
// one object with Config's fields and, optionally, "preset" for the values it leaves out (default
// full). Throws Error: kConfigRead, kConfigKey (unknown key or preset) or kConfigRange, all naming
// the key. The result is legal.
Config load_config(const std::string& name_or_path);

// The same from JSON text; place is used in messages.
Config parse_config(const std::string& text, const std::string& place);

// Sets one field, which may leave the configuration illegal. Throws Error: kConfigKey, or
// kConfigRange for a value of the wrong type.
void set_config_field(Config& config, const std::string& key, const nlohmann::json& value,
                      const std::string& place);

// Every free value. parse_config(config_json(c).dump(), "") == c.
nlohmann::ordered_json config_json(const Config& config);

// Throws Error(kConfigRange) when the configuration is not legal.
void require_legal(const Config& config, const std::string& place);

}  // namespace halfspace
