// SPDX-License-Identifier: Apache-2.0
//
// Compiled once per instruction set: Highway includes this file again for each.
#include "frame_kernel.hpp"

#include <vector>

#define HWY_WANT_AVX3_DL
#define HWY_COMPILE_ALL_ATTAINABLE
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/simd/frame_kernel.cpp"  // found from cmodel/
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include <hwy/highway.h>

// The scalar kernels need no vectors: frame_scalar.cpp.
#if HWY_TARGET != HWY_SCALAR
#include "frame_depth-inl.hpp"
#include "frame_project-inl.hpp"
#include "frame_shade-inl.hpp"
#endif

#if HWY_ONCE
namespace halfspace::simd {
namespace {

struct Candidate {
  std::int64_t target;
  FrameKernels kernels;
};

constexpr Candidate kCandidates[] = {
#if HWY_TARGETS & HWY_AVX3_DL
    {HWY_AVX3_DL,
     {"avx3_dl", &N_AVX3_DL::Highest, &N_AVX3_DL::Project, &N_AVX3_DL::Planes, &N_AVX3_DL::Depth,
      &N_AVX3_DL::Shade}},
#endif
#if HWY_TARGETS & HWY_AVX3
    {HWY_AVX3,
     {"avx3", &N_AVX3::Highest, &N_AVX3::Project, &N_AVX3::Planes, &N_AVX3::Depth, &N_AVX3::Shade}},
#endif
#if HWY_TARGETS & HWY_AVX2
    {HWY_AVX2,
     {"avx2", &N_AVX2::Highest, &N_AVX2::Project, &N_AVX2::Planes, &N_AVX2::Depth, &N_AVX2::Shade}},
#endif
#if HWY_TARGETS & HWY_SSE4
    {HWY_SSE4,
     {"sse4", &N_SSE4::Highest, &N_SSE4::Project, &N_SSE4::Planes, &N_SSE4::Depth, &N_SSE4::Shade}},
#endif
#if HWY_TARGETS & HWY_SSSE3
    {HWY_SSSE3,
     {"ssse3", &N_SSSE3::Highest, &N_SSSE3::Project, &N_SSSE3::Planes, &N_SSSE3::Depth,
      &N_SSSE3::Shade}},
#endif
#if HWY_TARGETS & HWY_NEON
    {HWY_NEON,
     {"neon", &N_NEON::Highest, &N_NEON::Project, &N_NEON::Planes, &N_NEON::Depth, &N_NEON::Shade}},
#endif
#if HWY_TARGETS & HWY_EMU128
    {HWY_EMU128,
     {"emu128", &N_EMU128::Highest, &N_EMU128::Project, &N_EMU128::Planes, &N_EMU128::Depth,
      &N_EMU128::Shade}},
#endif
    {0, {"scalar", &highest_scalar, &project_scalar, &planes_scalar, &depth_scalar, &shade_scalar}},
};

}  // namespace

std::span<const FrameKernels> frame_kernels() {
  static const std::vector<FrameKernels> runnable = [] {
    std::vector<FrameKernels> out;
    // Portable code runs everywhere, whatever the machine lists.
    const std::int64_t supported = hwy::SupportedTargets() | HWY_EMU128;
    for (const Candidate& candidate : kCandidates) {
      const bool portable = candidate.target == 0;
      if (portable || (candidate.target & supported) != 0) out.push_back(candidate.kernels);
    }
    return out;
  }();
  return runnable;
}

}  // namespace halfspace::simd
#endif  // HWY_ONCE
