// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "Vstage_coverage_full.h"
#include "Vstage_coverage_msaa4.h"
#include "Vstage_coverage_samples16.h"
#include "Vstage_coverage_tiny.h"
#include "rtl/rtl_configs.hpp"
#include "stage_model.hpp"

namespace halfspace {
namespace {

const std::array kVariants{
    StageVariant{"tiny", kTiny, 0, make_stage<Vstage_coverage_tiny, kTiny>},
    StageVariant{"full", kFull, 0, make_stage<Vstage_coverage_full, kFull>},
    StageVariant{"msaa4", kMsaa4, 0, make_stage<Vstage_coverage_msaa4, kMsaa4>},
    StageVariant{"samples16", kTestSamples16, 0,
                 make_stage<Vstage_coverage_samples16, kTestSamples16>}};

}  // namespace

std::span<const StageVariant> coverage_stages() { return kVariants; }

}  // namespace halfspace
