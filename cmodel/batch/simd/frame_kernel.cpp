// SPDX-License-Identifier: Apache-2.0
//
// Compiled once per instruction set: Highway includes this file again for each.
#include "frame_kernel.hpp"

#include <numeric>
#include <vector>

#include "targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch/simd/frame_kernel.cpp"  // found from cmodel/
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include <hwy/highway.h>

// The scalar kernels need no vectors: frame_scalar.cpp.
#if HWY_TARGET != HWY_SCALAR
#include "frame_bins-inl.hpp"
#include "frame_depth-inl.hpp"
#include "frame_project-inl.hpp"
#include "frame_resolve-inl.hpp"
#include "frame_shade-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

constexpr FrameKernels kernels(std::string_view isa) {
  return {isa, &Highest, &Project, &Planes, &Depth, &Bins, &Shade, &Resolve, &ShadeOnly, &Divide};
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
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
    {HWY_AVX3_DL, N_AVX3_DL::kernels("avx3_dl")},
#endif
#if HWY_TARGETS & HWY_AVX3
    {HWY_AVX3, N_AVX3::kernels("avx3")},
#endif
#if HWY_TARGETS & HWY_AVX2
    {HWY_AVX2, N_AVX2::kernels("avx2")},
#endif
#if HWY_TARGETS & HWY_SSE4
    {HWY_SSE4, N_SSE4::kernels("sse4")},
#endif
#if HWY_TARGETS & HWY_SSSE3
    {HWY_SSSE3, N_SSSE3::kernels("ssse3")},
#endif
#if HWY_TARGETS & HWY_NEON
    {HWY_NEON, N_NEON::kernels("neon")},
#endif
#if HWY_TARGETS & HWY_EMU128
    {HWY_EMU128, N_EMU128::kernels("emu128")},
#endif
    {0,
     {"scalar", &highest_scalar, &project_scalar, &planes_scalar, &depth_scalar, nullptr,
      &shade_scalar, nullptr, &shade_planes_scalar, &divide_scalar}},
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
