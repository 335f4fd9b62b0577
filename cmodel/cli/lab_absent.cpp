// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "../io/error.hpp"
#include "lab_link.hpp"

namespace halfspace {
namespace {

[[noreturn]] void absent() {
  throw Error(ErrorCode::kNoLab, "", "this program was built without the lab (HALFSPACE_LAB=OFF)");
}

}  // namespace

const std::vector<ChartKind>& chart_kinds() { absent(); }

nlohmann::ordered_json chart_data(const ChartKind&, const SceneOptions&) { absent(); }

std::string stability_list() { absent(); }

nlohmann::ordered_json stability_data(const std::vector<std::string>&,
                                      const std::vector<std::string>&) {
  absent();
}

std::string stability_table(const nlohmann::ordered_json&) { absent(); }

Image scene_picture(const SceneOptions&, const std::string&) { absent(); }

StabilityPicture stability_picture(const std::string&, const std::string&) { absent(); }

nlohmann::ordered_json method_explanation(const std::string&, const Scene&, const methods::Method&,
                                          const FrameState&, int, int, bool) {
  absent();
}

std::string method_explanation_text(const nlohmann::ordered_json&) { absent(); }

}  // namespace halfspace
