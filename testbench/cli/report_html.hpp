// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "io/stats_json.hpp"

namespace halfspace {

// What a report says of a scene.
struct ReportData {
  std::string scene;
  std::string command;
  FrameState frame;
  Config config;
  RunStats stats;  // level cycle
  nlohmann::ordered_json subpixel, efficiency, interpolation, accumulator, ladder, stability;
};

// One page that needs nothing but the files beside it: picture.png, hits.png, tiles.png and
// worst.png.
std::string report_html(const ReportData& data);

}  // namespace halfspace
