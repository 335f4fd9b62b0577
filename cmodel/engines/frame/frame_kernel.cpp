// SPDX-License-Identifier: Apache-2.0
//
// Compiled once per instruction set: Highway includes this file again for each.
#include "frame_kernel.hpp"

#include <numeric>

#include "../common/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engines/frame/frame_kernel.cpp"  // found from cmodel/
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include <hwy/highway.h>

// The scalar kernels need no vectors: frame_scalar.cpp.
#if HWY_TARGET != HWY_SCALAR
#include "frame_buckets-inl.hpp"
#include "frame_depth-inl.hpp"
#include "frame_project-inl.hpp"
#include "frame_shade-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

static constexpr FrameKernels kernels(std::string_view isa) {
  return {isa, &Highest, &Project, &Planes, &Depth, &Buckets, &Shade, &ShadeOnly, &Divide};
}

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
#include "../common/dispatch.hpp"

namespace halfspace::simd {

std::span<const FrameKernels> frame_kernels() {
  static constexpr Candidate<FrameKernels> kCandidates[] = {
      HS_COMPILED{0,
                  {"scalar", &highest_scalar, &project_scalar, &planes_scalar, &depth_scalar,
                   nullptr, &shade_scalar, &shade_planes_scalar, &divide_scalar}}};
  return runnable(kCandidates);
}

}  // namespace halfspace::simd
#endif  // HWY_ONCE
