// SPDX-License-Identifier: Apache-2.0
//
// Kernels by the name of their instruction set. Kernels: a struct with `std::string_view isa`, one
// of avx3_dl (AVX-512 with VBMI), avx3 (AVX-512), avx2, sse4, ssse3, neon, emu128 and scalar.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "../../fixed.hpp"

namespace halfspace::simd {

template <class Kernels>
std::vector<std::string_view> isas(std::span<const Kernels> all) {
  std::vector<std::string_view> names;
  for (const Kernels& kernels : all) names.push_back(kernels.isa);
  return names;
}

// all: the best first, never empty. isa: one of isas(all), checked; empty for the best.
template <class Kernels>
const Kernels& find_isa(std::span<const Kernels> all, std::string_view isa) {
  if (isa.empty()) return all.front();
  for (const Kernels& kernels : all) {
    if (kernels.isa == isa) return kernels;
  }
  HS_CHECK(false && "no such instruction set");
}

}  // namespace halfspace::simd
