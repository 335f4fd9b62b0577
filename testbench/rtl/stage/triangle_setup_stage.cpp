// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "Vstage_setup_interval3.h"
#include "Vstage_setup_msaa4.h"
#include "Vstage_setup_tiny.h"
#include "rtl/rtl_configs.hpp"
#include "stage_model.hpp"

namespace halfspace {
namespace {

const std::array kVariants{StageVariant{"tiny", kTiny, 0, make_stage<Vstage_setup_tiny, kTiny>},
                           StageVariant{"msaa4", kMsaa4, 0, make_stage<Vstage_setup_msaa4, kMsaa4>},
                           StageVariant{"interval3", kTestInterval3, 0,
                                        make_stage<Vstage_setup_interval3, kTestInterval3>}};

}  // namespace

std::span<const StageVariant> triangle_setup_stages() { return kVariants; }

}  // namespace halfspace
