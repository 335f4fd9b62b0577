// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// The samples of one leaf tile that one triangle covers.
//
//   tile      leaf node: origin a multiple of grid(), e of node_bits(grid_log2) (checked)
//   triangle  slopes, box and tag
//   return    one mask per sample, or nothing when all are zero
//
// Exact: bit set when E >= 0 for all three biased edges at that sample and its pixel is in the box.
// Cost: three grids per sample. Twin: rtl/hs_coverage.sv.
std::optional<CoverageTile> coverage(const Node& tile, const SetupTriangle& triangle,
                                     const Config& config);

}  // namespace halfspace
