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
// ones, and, for a goal of 1, every bin was met often enough to choose from, or until `tries` units
// were drawn. The units kept hit all that was hit; the same seed gives the same units.
//
//   times     how often minimal_units() will want each bin
//   progress  called after each draw with the reachable bins hit so far
std::vector<SampledUnit> search_goal(const BinModel& model, double goal, std::size_t times,
                                     std::uint64_t tries, std::uint64_t seed,
                                     const std::function<void(std::size_t)>& progress);

// Units that hit every bin `times` times, or as often as all do, in as few triangles as a greedy
// choice finds: the unit with most new hits a triangle first, the earlier of equals; then each unit
// that the others make needless is dropped. Order: as chosen. times: 1 at least.
std::vector<SampledUnit> minimal_units(const std::vector<SampledUnit>& units, std::size_t times,
                                       const BinModel& model);

// The triangles of one run.
struct VectorRun {
  FrameState frame;
  bool stalled = false;
  std::vector<Triangle> triangles;
};

// Units by frame, frames in order of first appearance, tags in order; a unit's triangles stay
// together. stalls: every second unit goes into a run with stalls.
std::vector<VectorRun> by_frame(const std::vector<SampledUnit>& units, bool stalls,
                                const Config& config);

}  // namespace halfspace
