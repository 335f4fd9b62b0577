// SPDX-License-Identifier: Apache-2.0
//
// Compiled once per instruction set: Highway includes this file again for each.
#include "cycle_kernel.hpp"

#include <vector>

#include "simd/targets.hpp"

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HALFSPACE_UNUSED_TARGETS | HWY_AVX3_DL)  // VBMI gains nothing here

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/cycle_kernel.cpp"  // found from cmodel/
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "cycle_walk-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::cycle::HWY_NAMESPACE {

void run(State& state, std::span<const Triangle> triangles) {
  const SetupConstants constants(state);
  const bool plain = state.timing.plain() && !state.want_nodes;
  if (!plain && state.timing.flows()) state.timing.stop_flow();
  Walk<true> plain_walk(state);
  Walk<false> walk(state);
  Batch batch;
  for (std::size_t done = 0; done < triangles.size(); done += kBatch) {
    if (state.buffer.full()) state.flush();
    const std::size_t count = std::min(kBatch, triangles.size() - done);
    set_up(constants, triangles.data() + done, count, batch);
    for (std::size_t i = 0; i < count; ++i) {
      const auto index = static_cast<std::uint32_t>(done + i);
      plain ? plain_walk.draw(batch, i, index) : walk.draw(batch, i, index);
    }
  }
  state.flush();
}

}  // namespace halfspace::cycle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace halfspace::cycle {
namespace {

struct Candidate {
  std::int64_t target;
  Choice choice;
};

constexpr Candidate kCandidates[] = {
#if HWY_TARGETS & HWY_AVX3
    {HWY_AVX3, {"avx3", &N_AVX3::run}},
#endif
#if HWY_TARGETS & HWY_AVX2
    {HWY_AVX2, {"avx2", &N_AVX2::run}},
#endif
#if HWY_TARGETS & HWY_SSE4
    {HWY_SSE4, {"sse4", &N_SSE4::run}},
#endif
#if HWY_TARGETS & HWY_SSSE3
    {HWY_SSSE3, {"ssse3", &N_SSSE3::run}},
#endif
#if HWY_TARGETS & HWY_NEON
    {HWY_NEON, {"neon", &N_NEON::run}},
#endif
#if HWY_TARGETS & HWY_EMU128
    {HWY_EMU128, {"emu128", &N_EMU128::run}},
#endif
    {0, {"scalar", &run_scalar}},
};

}  // namespace

std::span<const Choice> kernels() {
  static const std::vector<Choice> runnable = [] {
    std::vector<Choice> out;
    // Portable code runs everywhere, whatever the machine lists.
    const std::int64_t supported = hwy::SupportedTargets() | HWY_EMU128;
    for (const Candidate& candidate : kCandidates) {
      const bool portable = candidate.target == 0;
      if (portable || (candidate.target & supported) != 0) out.push_back(candidate.choice);
    }
    return out;
  }();
  return runnable;
}

}  // namespace halfspace::cycle
#endif  // HWY_ONCE
