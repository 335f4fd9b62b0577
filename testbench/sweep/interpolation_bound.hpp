// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// Depth and attributes of every covered sample against exact rationals: weights are ratios of
// areas, as whole numbers of 128 bits. What is first beyond the bound of
// docs/03_design/interpolation.md; empty: nothing. An attribute is left alone where 1/w is within
// its own error of zero.
std::string interpolation_fault(const ShadedTriangle& shaded, const FrameState& frame,
                                const Config& config);

}  // namespace halfspace
