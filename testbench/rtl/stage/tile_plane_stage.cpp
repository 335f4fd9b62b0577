// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "Vstage_tile_plane_full.h"
#include "Vstage_tile_plane_msaa4.h"
#include "Vstage_tile_plane_tiny.h"
#include "rtl/rtl_configs.hpp"
#include "stage_model.hpp"

namespace halfspace {
namespace {

// Least and greatest fraction; one plane and four.
constexpr Config kTinyWhole = with_gradient_bits(kTiny, 0);
constexpr Config kMsaa4Fine = with_gradient_bits(kMsaa4, 20);
const std::array kVariants{
    StageVariant{"full", kFull, 1, make_stage<Vstage_tile_plane_full, kFull>},
    StageVariant{"tiny", kTinyWhole, 4, make_stage<Vstage_tile_plane_tiny, kTinyWhole>},
    StageVariant{"msaa4", kMsaa4Fine, 1, make_stage<Vstage_tile_plane_msaa4, kMsaa4Fine>}};

}  // namespace

std::span<const StageVariant> tile_plane_stages() { return kVariants; }

}  // namespace halfspace
