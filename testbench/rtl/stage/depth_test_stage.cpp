// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "Vstage_depth_test_32.h"
#include "Vstage_depth_test_full.h"
#include "Vstage_depth_test_tiny.h"
#include "rtl/rtl_configs.hpp"
#include "stage_model.hpp"

namespace halfspace {
namespace {

// Least and greatest depth; few slots, so that tiles meet.
constexpr Config kTiny16 = with_depth_bits(kTiny, 16);
constexpr Config kFull32 = with_depth_bits(kFull, 32);
const std::array kVariants{
    StageVariant{"full", kFull, 9, make_stage<Vstage_depth_test_full, kFull>},
    StageVariant{"tiny", kTiny16, 2, make_stage<Vstage_depth_test_tiny, kTiny16>},
    StageVariant{"full, 32 bits", kFull32, 3, make_stage<Vstage_depth_test_32, kFull32>}};

}  // namespace

std::span<const StageVariant> depth_test_stages() { return kVariants; }

}  // namespace halfspace
