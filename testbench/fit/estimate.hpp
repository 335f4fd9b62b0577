// SPDX-License-Identifier: Apache-2.0
//
// Level auto: the clocks of a frame without running all of it at level cycle. The whole frame at
// level coverage, which says how much work each triangle is; windows of triangles, chosen at
// random, at level cycle; clocks per work from those. docs/01_overview/levels.md.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

struct ClockEstimate {
  double clocks = 0;
  double low = 0;  // the interval that holds level cycle's clocks with probability kConfidence
  double high = 0;
  bool exact = false;         // everything was run: sampling would not have been less work
  std::uint64_t windows = 0;  // run, and of how many
  std::uint64_t of = 0;
  std::uint64_t triangles_at_cycle = 0;  // warm-up included
  std::uint64_t triangles = 0;
  static constexpr double kConfidence = 0.95;

  // A few stretches of what was run at level cycle, spread over the stream, each cut after some
  // thousand clocks of work: for another model to run again from reset (fit/replay.hpp).
  struct Stretch {
    std::size_t begin = 0;  // triangles, as submitted
    std::size_t end = 0;
  };
  std::vector<Stretch> stretches;
};

// The clocks of CycleModel::clocks() for the frame without stalls.
//
//   triangles  as submitted to setup, all of the frame
//   seed       which windows are chosen: the same seed, the same answer
//
// A window's clocks are those between its last packet and the last one before it, in a run that
// begins some work earlier, so that the pipeline is full. The first window is always run: it has
// the latency. The others are a simple random sample; total = their clocks over their work, times
// all work; the interval is Student's, from the residuals of the windows, with the correction for
// a finite population.
ClockEstimate estimate_clocks(std::span<const Triangle> triangles, const FrameState& frame,
                              const Config& config, std::uint64_t seed);

}  // namespace halfspace
