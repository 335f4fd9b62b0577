// SPDX-License-Identifier: Apache-2.0
//
// For which instruction sets Highway compiles the kernels. Comes before hwy/foreach_target.h.
#pragma once

// All targets are built, baseline or not, so that tests can run them. AVX3_DL is AVX-512 with VBMI.
#define HWY_COMPILE_ALL_ATTAINABLE
#define HWY_WANT_AVX3_DL

// Vectors whose length is not known when compiling, and HWY_SCALAR, which has no vectors (our own
// portable kernels stand in). Before GCC 12.3 Highway takes it for the portable target; as the only
// baseline it cannot be left out, and then comes last, where the kernels' files pass over it.
#define HALFSPACE_NO_LENGTH (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#if defined(__SSSE3__) || defined(__ARM_NEON)
#define HALFSPACE_UNUSED_TARGETS (HALFSPACE_NO_LENGTH | HWY_SCALAR)
#else
#define HALFSPACE_UNUSED_TARGETS HALFSPACE_NO_LENGTH
#endif
#define HWY_DISABLED_TARGETS HALFSPACE_UNUSED_TARGETS
