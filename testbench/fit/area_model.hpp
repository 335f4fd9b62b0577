// SPDX-License-Identifier: Apache-2.0
//
// The area of a configuration without synthesis: what its RTL is made of, counted, times what
// yosys made of each. docs/02_use/fit.md has the error.
#pragma once

#include "config.hpp"

namespace halfspace {

// Structure, counted from the sources in rtl/.
struct AreaFeatures {
  double pyramid_adders = 0;  // bits of all adders of the grids and their steps
  double setup_adders = 0;
  double multiplexer = 0;    // bits of two-way multiplexers that follow adders
  double lanes = 0;          // of all grids
  double pyramid_state = 0;  // bits of registers
  double setup_state = 0;
};
AreaFeatures area_features(const Config& config);

// ECP5 cells as synth_ecp5 counts them.
struct AreaEstimate {
  double lut4 = 0;
  double ccu2c = 0;
  double flip_flops = 0;
  double multipliers = 0;                           // MULT18X18D
  double luts() const { return lut4 + 2 * ccu2c; }  // a CCU2C takes two LUT4s
};
AreaEstimate area_estimate(const Config& config);

// What `luts` of an area is, for readers of JSON.
inline constexpr const char* kAreaUnit =
    "cells of yosys synth_ecp5; luts = lut4 + 2 ccu2c, as a CCU2C takes two LUT4s";

// Greatest error of luts() and of flip_flops against the measured configurations, in percent, each
// predicted by coefficients fitted to the others. docs/charts/fit_area.json has the measurements.
inline constexpr double kAreaErrorPercent = 4.0;
inline constexpr double kFlipFlopErrorPercent = 6.0;

}  // namespace halfspace
