// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "cycle_model.hpp"
#include "vector_set.hpp"

namespace halfspace {

// Stimulus in, a whole set of vectors out: everything that a record says beyond its stimulus is the
// model's answer, so a set is checked by building it again from its own stimulus.
//
// Cost: that of the model; memory: the set.
class VectorBuilder {
 public:
  explicit VectorBuilder(const VectorMeta& meta);

  // Starts a run: reset, frame, stalls (probability as U0.32).
  void run(const FrameState& frame, std::uint32_t stall, std::uint64_t stall_seed);

  // The next input's port, legal by stimulus_fault(). Corners of traversal_layout() are computed
  // again. After run(). Throws std::length_error when clocks or counts pass 2^32 - 1.
  void add(const Values& ports);

  VectorSet finish();

 private:
  void add_rasterizer(const Values& ports);
  std::size_t begin_input(const Values& ports);
  void output(const Values& values);
  void end_run();

  VectorSet set_;
  FrameState frame_;
  Stalls stalls_;
  std::optional<CycleModel> model_;
  std::size_t run_at_ = 0;    // its record
  std::uint64_t inputs_ = 0;  // in the run
  std::uint64_t outputs_ = 0;
  std::uint64_t next_offer_ = 0;
};

// The first difference between a set and what the model makes of its stimulus.
struct VectorDifference {
  std::size_t record = 0;  // number in the file, from 0
  std::string text;        // "in 3: field=outputs file=2 model=1", "is missing", ...
};

// Builds the set again and compares. The stimulus is legal (stimulus_fault, run_fault), the first
// record is a run. Nothing: equal.
std::optional<VectorDifference> check_vectors(const VectorSet& set);

}  // namespace halfspace
