// SPDX-License-Identifier: Apache-2.0
//
// Compiled once per instruction set: Highway includes this file again for each.
#include "coverage_kernel.hpp"

#include "../common/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engines/coverage/coverage_kernel.cpp"  // found from cmodel/
#include <hwy/foreach_target.h>
// foreach_target.h comes first
#include <hwy/highway.h>

// The scalar kernel needs no vectors: coverage_scalar.cpp.
#if HWY_TARGET != HWY_SCALAR
#include "cover-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace halfspace::simd::HWY_NAMESPACE {

static constexpr CoverageKernels kernels(std::string_view isa) { return {isa, &Cover}; }

}  // namespace halfspace::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
#include "../common/dispatch.hpp"

namespace halfspace::simd {

std::span<const CoverageKernels> coverage_kernels() {
  static constexpr Candidate<CoverageKernels> kCandidates[] = {
      HS_COMPILED{0, {"scalar", &cover_scalar}}};
  return runnable(kCandidates);
}

}  // namespace halfspace::simd
#endif  // HWY_ONCE
