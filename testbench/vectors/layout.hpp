// SPDX-License-Identifier: Apache-2.0
//
// The packed structs of rtl/hs_pkg.sv by their fields: what a stage's ports carry, as numbers with
// names.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

struct PortField {
  std::string name;
  int bits = 0;  // 1..64
  bool is_signed = false;
};
using Layout = std::vector<PortField>;     // first field in the highest bits
using Values = std::vector<std::int64_t>;  // one per field
using PortWords = std::vector<std::uint32_t>;

int layout_bits(const Layout& layout);  // of the whole struct

Layout triangle_layout(const Config& config);
Layout setup_layout(const Config& config);      // with the corners that only the RTL has
Layout traversal_layout(const Config& config);  // a node and what it needs of its triangle
Layout coverage_layout(const Config& config);
Layout frame_layout(const Config& config);
Layout grid_in_layout(const Config& config);   // base_i, slope_i
Layout grid_out_layout(const Config& config);  // ab_o, covered_o

// Stages without a twin. Interpolation: one sample of one lane of one tile, and the planes on the
// way to it. Depth: one sample plane of one tile.
Layout interpolation_in_layout(const Config& config);
Layout interpolation_out_layout(const Config& config);
Layout depth_in_layout(const Config& config);
Layout depth_out_layout(const Config& config);

Values values_of(const Triangle& triangle, const Config& config);
Values values_of(const SetupTriangle& setup, const Config& config);
Values values_of(const Node& node, const SetupTriangle& setup, const Config& config);
Values values_of(const CoverageTile& tile, const Config& config);
Values values_of(const FrameState& frame);

PortWords pack(const Values& values, const Layout& layout);
Values unpack(const PortWords& words, const Layout& layout);

// "field=NAME model=VALUE rtl=VALUE" of the first field that differs; empty when none does.
std::string first_difference(const Values& model, const Values& rtl, const Layout& layout);

}  // namespace halfspace
