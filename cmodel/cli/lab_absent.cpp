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

}  // namespace halfspace
