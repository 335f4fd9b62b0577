// SPDX-License-Identifier: Apache-2.0
//
// Ports back to packets: the inverse of layout.hpp's values_of(), for the stimulus of each stage.
#pragma once

#include "depth.hpp"
#include "interpolation.hpp"
#include "layout.hpp"
#include "packets.hpp"
#include "vector_set.hpp"

namespace halfspace {

// Values of triangle_layout().
Triangle triangle_of(const Values& ports);

// Values of setup_layout(); the corners are functions of the slopes and not read.
SetupTriangle setup_of(const Values& ports);

// Values of traversal_layout(); the corners are functions of the slopes and not read.
struct NodeOfTriangle {
  Node node;
  SetupTriangle setup;  // slopes, box and tag
};
NodeOfTriangle node_of(const Values& ports);

// Values of coverage_layout().
CoverageTile coverage_of(const Values& ports, const Config& config);

// Values of interpolation_in_layout().
struct InterpolationInput {
  SetupTriangle setup;  // slopes and flipped
  Triangle triangle;    // vertex 0
  std::array<VertexAttributes, 3> attributes;
  std::int32_t x = 0, y = 0;
  int sample = 0;
  int lane = 0;
};
InterpolationInput interpolation_input_of(const Values& ports, const Config& config);
Values values_of(const InterpolationInput& input, const Config& config);

// Values of depth_in_layout().
struct DepthInput {
  GridMask covered = 0;
  TilePlane plane;
  DepthFunction function = DepthFunction::kLess;
  DepthTile stored{};
};
DepthInput depth_input_of(const Values& ports, const Config& config);
Values values_of(const DepthInput& input, const Config& config);

// Why a stage must not be given this stimulus ("vertex1.x is out of range"); empty when it may.
// Every value fits its field. A stage's own checks end the program; files are judged by this first.
std::string stimulus_fault(const Values& ports, const VectorMeta& meta);

// The same for a run record.
std::string run_fault(const Values& run, const VectorMeta& meta);

}  // namespace halfspace
