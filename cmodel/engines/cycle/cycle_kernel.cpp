// SPDX-License-Identifier: Apache-2.0
//
// Compiled once per instruction set: Highway includes this file again for each.
#include "cycle_kernel.hpp"

#include "../common/targets.hpp"

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HALFSPACE_UNUSED_TARGETS | HWY_AVX3_DL)  // VBMI gains nothing here

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engines/cycle/cycle_kernel.cpp"  // found from cmodel/
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

static constexpr CycleKernels kernels(std::string_view isa) { return {isa, &run}; }

}  // namespace halfspace::cycle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
#include "../common/dispatch.hpp"

namespace halfspace::cycle {

std::span<const CycleKernels> cycle_kernels() {
  static constexpr simd::Candidate<CycleKernels> kCandidates[] = {
      HS_COMPILED{0, {"scalar", &run_scalar}}};
  return simd::runnable(kCandidates);
}

}  // namespace halfspace::cycle
#endif  // HWY_ONCE
