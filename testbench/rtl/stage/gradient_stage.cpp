// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "Vstage_gradient_d3d.h"
#include "Vstage_gradient_full.h"
#include "Vstage_gradient_msaa4.h"
#include "Vstage_gradient_tiny.h"
#include "pipeline_model.hpp"
#include "rtl/rtl_configs.hpp"

namespace halfspace {
namespace {

// Least and greatest fraction, and the widest vertices.
const std::array kVariants{
    PipelineVariant{"full", kFull, 1, 13, make_pipeline<Vstage_gradient_full>},
    PipelineVariant{"d3d", kD3d, 2, 14, make_pipeline<Vstage_gradient_d3d>},
    PipelineVariant{"tiny", with_gradient_bits(kTiny, 0), 1, 13,
                    make_pipeline<Vstage_gradient_tiny>},
    PipelineVariant{"msaa4", with_gradient_bits(kMsaa4, 20), 2, 14,
                    make_pipeline<Vstage_gradient_msaa4>}};

}  // namespace

std::span<const PipelineVariant> gradient_stages() { return kVariants; }

}  // namespace halfspace
