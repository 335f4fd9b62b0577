// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "bins.hpp"
#include "directed.hpp"

namespace halfspace {

// A unit and what it hits.
struct SampledUnit {
  VectorUnit unit;
  BinSet hits;
};

// Draws directed units until the reachable bins hit are at least `goal` (0..1) of all reachable
// ones and every bin hit has been met several times, or `tries` units were drawn. The units kept
// hit all that was hit; the same seed gives the same units.
//
//   progress  called after each draw with the reachable bins hit so far
std::vector<SampledUnit> search_goal(const BinModel& model, double goal, std::uint64_t tries,
                                     std::uint64_t seed,
                                     const std::function<void(std::size_t)>& progress);

// Units that hit the same reachable bins, in as few triangles as a greedy choice finds: the unit
// with most new bins a triangle first, the earlier of equals; then each unit that the others make
// needless is dropped. Order: as chosen.
std::vector<SampledUnit> minimal_units(std::vector<SampledUnit> units, const BinModel& model);

// The same triangles by frame, frames in order of first appearance, tags in order; a unit's
// triangles stay together.
std::vector<VectorUnit> by_frame(const std::vector<SampledUnit>& units, const Config& config);

}  // namespace halfspace
