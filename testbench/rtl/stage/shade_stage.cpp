// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "Vstage_shade_4.h"
#include "Vstage_shade_8.h"
#include "Vstage_shade_tiny_1.h"
#include "Vstage_shade_tiny_8.h"
#include "rtl/rtl_configs.hpp"
#include "stage_model.hpp"

namespace halfspace {
namespace {

constexpr Config kFull7 = with_reciprocal_bits(kFull, 7);
const std::array kVariants{StageVariant{"full", kFull, 8, make_stage<Vstage_shade_8, kFull>},
                           StageVariant{"full", kFull7, 4, make_stage<Vstage_shade_4, kFull7>},
                           StageVariant{"tiny", kTiny, 8, make_stage<Vstage_shade_tiny_8, kTiny>},
                           StageVariant{"tiny", kTiny, 1, make_stage<Vstage_shade_tiny_1, kTiny>}};

}  // namespace

std::span<const StageVariant> shade_stages() { return kVariants; }

}  // namespace halfspace
