// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "Vstage_traversal_msaa4_0.h"
#include "Vstage_traversal_msaa4_1.h"
#include "Vstage_traversal_tiny_0.h"
#include "Vstage_traversal_tiny_3.h"
#include "stage_model.hpp"

namespace halfspace {
namespace {

// tiny: a root of two lanes a side, buffered; the last level, not buffered. msaa4: a full root, not
// buffered; a level in the middle, buffered.
const std::array kVariants{
    StageVariant{"tiny", kTiny, 0, make_stage<Vstage_traversal_tiny_0, kTiny>},
    StageVariant{"tiny", kTiny, 3, make_stage<Vstage_traversal_tiny_3, kTiny>},
    StageVariant{"msaa4", kMsaa4, 0, make_stage<Vstage_traversal_msaa4_0, kMsaa4>},
    StageVariant{"msaa4", kMsaa4, 1, make_stage<Vstage_traversal_msaa4_1, kMsaa4>}};

}  // namespace

std::span<const StageVariant> tile_traversal_stages() { return kVariants; }

}  // namespace halfspace
