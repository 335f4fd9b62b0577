// SPDX-License-Identifier: Apache-2.0
//
// Compiled once per instruction set: Highway includes this file again for each.
#include "kernel.hpp"

#include <vector>

#include "targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/simd/kernel.cpp"  // found from cmodel/
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include <hwy/highway.h>

// The scalar kernel needs no vectors: scalar_kernel.cpp.
#if HWY_TARGET != HWY_SCALAR
#include "cover-inl.hpp"
#endif

#if HWY_ONCE
namespace halfspace::simd {
namespace {

struct Candidate {
  std::int64_t target;
  KernelChoice choice;
};

constexpr Candidate kCandidates[] = {
#if HWY_TARGETS & HWY_AVX3_DL
    {HWY_AVX3_DL, {"avx3_dl", &N_AVX3_DL::Cover}},
#endif
#if HWY_TARGETS & HWY_AVX3
    {HWY_AVX3, {"avx3", &N_AVX3::Cover}},
#endif
#if HWY_TARGETS & HWY_AVX2
    {HWY_AVX2, {"avx2", &N_AVX2::Cover}},
#endif
#if HWY_TARGETS & HWY_SSE4
    {HWY_SSE4, {"sse4", &N_SSE4::Cover}},
#endif
#if HWY_TARGETS & HWY_SSSE3
    {HWY_SSSE3, {"ssse3", &N_SSSE3::Cover}},
#endif
#if HWY_TARGETS & HWY_NEON
    {HWY_NEON, {"neon", &N_NEON::Cover}},
#endif
#if HWY_TARGETS & HWY_EMU128
    {HWY_EMU128, {"emu128", &N_EMU128::Cover}},
#endif
    {0, {"scalar", &cover_scalar}},
};

}  // namespace

std::span<const KernelChoice> kernels() {
  static const std::vector<KernelChoice> runnable = [] {
    std::vector<KernelChoice> out;
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

}  // namespace halfspace::simd
#endif  // HWY_ONCE
