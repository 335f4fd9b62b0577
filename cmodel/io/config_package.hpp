// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "../config.hpp"

namespace halfspace {

// The text of an hs_config_pkg.sv, as rtl/config/<preset> has them: every free value that the RTL
// knows, as macro and as parameter. twin: where the same values are for the reader.
std::string config_package(const Config& config, const std::string& twin);

}  // namespace halfspace
