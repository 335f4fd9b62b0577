// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "Vstage_depth_setup_d3d.h"
#include "Vstage_depth_setup_tiny.h"
#include "pipeline_model.hpp"

namespace halfspace {
namespace {

constexpr PipelineOutput kArea = PipelineOutput::kArea;
const std::array kPlanes{
    PipelineVariant{"d3d", kD3d, 2, 49, make_pipeline<Vstage_depth_setup_d3d>},
    PipelineVariant{"tiny", kTiny, 1, 48, make_pipeline<Vstage_depth_setup_tiny>}};
const std::array kAreas{
    PipelineVariant{"d3d", kD3d, 2, 35, make_pipeline<Vstage_depth_setup_d3d, kArea>},
    PipelineVariant{"tiny", kTiny, 1, 35, make_pipeline<Vstage_depth_setup_tiny, kArea>}};

}  // namespace

std::span<const PipelineVariant> depth_setup_stages() { return kPlanes; }
std::span<const PipelineVariant> depth_setup_area_stages() { return kAreas; }

}  // namespace halfspace
