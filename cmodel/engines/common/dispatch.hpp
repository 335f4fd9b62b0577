// SPDX-License-Identifier: Apache-2.0
//
// Which of an engine's kernels this machine can run. For the one file of each engine that Highway
// compiles once per instruction set; comes after hwy/foreach_target.h, below HWY_ONCE.
//
// The file's HWY_NAMESPACE has `static constexpr Kernels kernels(std::string_view isa)`, what is
// compiled for that instruction set.
#pragma once

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// {target, kernels}, for each target that the file was compiled for; the best first.
#if HWY_TARGETS & HWY_AVX3_DL
#define HS_AVX3_DL {HWY_AVX3_DL, N_AVX3_DL::kernels("avx3_dl")},
#else
#define HS_AVX3_DL
#endif
#if HWY_TARGETS & HWY_AVX3
#define HS_AVX3 {HWY_AVX3, N_AVX3::kernels("avx3")},
#else
#define HS_AVX3
#endif
#if HWY_TARGETS & HWY_AVX2
#define HS_AVX2 {HWY_AVX2, N_AVX2::kernels("avx2")},
#else
#define HS_AVX2
#endif
#if HWY_TARGETS & HWY_SSE4
#define HS_SSE4 {HWY_SSE4, N_SSE4::kernels("sse4")},
#else
#define HS_SSE4
#endif
#if HWY_TARGETS & HWY_SSSE3
#define HS_SSSE3 {HWY_SSSE3, N_SSSE3::kernels("ssse3")},
#else
#define HS_SSSE3
#endif
#if HWY_TARGETS & HWY_NEON
#define HS_NEON {HWY_NEON, N_NEON::kernels("neon")},
#else
#define HS_NEON
#endif
#if HWY_TARGETS & HWY_EMU128
#define HS_EMU128 {HWY_EMU128, N_EMU128::kernels("emu128")},
#else
#define HS_EMU128
#endif
#define HS_COMPILED HS_AVX3_DL HS_AVX3 HS_AVX2 HS_SSE4 HS_SSSE3 HS_NEON HS_EMU128

namespace halfspace::simd {

// Kernels has the name `isa`. target: a Highway target; 0 for portable code without vectors.
template <class Kernels>
struct Candidate {
  std::int64_t target;
  Kernels kernels;
};

// Those of the candidates that this machine can run, in their order; made once.
template <class Kernels, std::size_t n>
std::span<const Kernels> runnable(const Candidate<Kernels> (&candidates)[n]) {
  static const std::vector<Kernels> list = [&] {
    std::vector<Kernels> out;
    // Portable code runs everywhere, whatever the machine lists.
    const std::int64_t supported = hwy::SupportedTargets() | HWY_EMU128;
    for (const Candidate<Kernels>& candidate : candidates) {
      const bool portable = candidate.target == 0;
      if (portable || (candidate.target & supported) != 0) out.push_back(candidate.kernels);
    }
    return out;
  }();
  return list;
}

}  // namespace halfspace::simd
