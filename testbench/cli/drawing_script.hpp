// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace halfspace {

// Charts are drawn by testbench/charts/charts.py with Debian's python3 and python3-matplotlib: the
// file that HALFSPACE_CHARTS names, else the one of the source tree above the program.

// Throws Error(kDrawing) when the script or matplotlib is missing; asked before long work.
void require_drawing_script();

// Draws `data` as chart `name` into `out` (.svg or .png). Throws Error(kDrawing).
void draw_chart(const std::string& name, const nlohmann::ordered_json& data,
                const std::string& out);

}  // namespace halfspace
