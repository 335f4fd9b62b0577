// SPDX-License-Identifier: Apache-2.0
//
// For which instruction sets Highway compiles the kernels, and what each can do. Comes before
// hwy/foreach_target.h.
#pragma once

// All targets are built, baseline or not, so that tests can run them. AVX3_DL is AVX-512 with VBMI.
#define HWY_COMPILE_ALL_ATTAINABLE
#define HWY_WANT_AVX3_DL

// Vectors whose length is not known when compiling, and HWY_SCALAR, which has no vectors (our own
// portable kernels stand in). Before GCC 12.3 Highway takes it for the portable target; as the only
// baseline it cannot be left out, and then comes last, where the kernels' files pass over it.
#define HALFSPACE_NO_LENGTH (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
// Of x86 also what only later Highways have a name for: what is above AVX3_DL, of which the kernels
// have no use, and below SSSE3 (SSE2: no shuffle of bytes). A better target has a lower bit.
#define HALFSPACE_UNUSED_X86 ((HWY_AVX3_DL - 1) | HWY_SSSE3 << 1 | HWY_SSSE3 << 2)
#if defined(__SSSE3__) || defined(__ARM_NEON)
#define HALFSPACE_UNUSED_TARGETS (HALFSPACE_NO_LENGTH | HALFSPACE_UNUSED_X86 | HWY_SCALAR)
#else
#define HALFSPACE_UNUSED_TARGETS (HALFSPACE_NO_LENGTH | HALFSPACE_UNUSED_X86)
#endif
#define HWY_DISABLED_TARGETS HALFSPACE_UNUSED_TARGETS

// What the target being compiled has: 512-bit vectors, with permutations of bytes (VBMI), 256-bit
// vectors, 128-bit ones of x86. By rank, not by name; targets of other processors rank lower.
#define HALFSPACE_AVX512 (HWY_TARGET <= HWY_AVX3)
#define HALFSPACE_VBMI (HWY_TARGET <= HWY_AVX3_DL)
#define HALFSPACE_AVX2 (HWY_TARGET > HWY_AVX3 && HWY_TARGET <= HWY_AVX2)
#define HALFSPACE_SSE (HWY_TARGET > HWY_AVX2 && HWY_TARGET <= HWY_SSSE3)
