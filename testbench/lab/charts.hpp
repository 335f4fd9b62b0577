// SPDX-License-Identifier: Apache-2.0
//
// The measurements behind docs/charts: each returns the data of one chart, ready to draw. All
// seeds are constants. Only what is named "cpu" is timed; the rest is counted and the same on every
// machine.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "real_scene.hpp"

namespace halfspace::lab {

using Json = nlohmann::ordered_json;

// Wrong pixels for 0..12 subpixel bits, by rounding mode, against the oracle on vertices that were
// not snapped. scene: null for random triangles of 4, 16 and 64 px.
Json subpixel_chart(const RealScene* scene);

// Samples tested and pixels per clock for tiles of 4, 8 and 16 px by triangle size; the scene's own
// triangles by size class when there is one.
Json efficiency_chart(const RealScene* scene);

// Greatest and RMS error of an 8-bit attribute and of depth, against exact 128-bit evaluation, by
// reciprocal and by gradient bits. scene: its triangles, with depth, 1/w and attributes invented.
Json interpolation_chart(const RealScene* scene);

// Wrong pixels against CPU time per triangle, for every method of the gallery and the coverage
// engine, for triangles of 4, 32 and 256 px. Cells of one triangle with vertices anywhere (timed)
// and a mesh on half pixels are judged together; the scene's triangles alone when there is one.
Json methods_chart(const RealScene* scene);

// Wrong samples when edge values are kept in too few bits and wrap, by width and scene extent.
Json accumulator_chart(const RealScene* scene);

}  // namespace halfspace::lab
