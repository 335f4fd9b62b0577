// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace halfspace {

// splitmix64 (Steele, Lea and Flood, Fast Splittable Pseudorandom Number Generators, OOPSLA 2014):
// a counter in steps of kSplitmixStep, each value mixed. The same sequence on every platform.
inline constexpr std::uint64_t kSplitmixStep = 0x9e3779b97f4a7c15u;

// The finishing steps: a bijection on 64 bits in which every input bit reaches every output bit.
constexpr std::uint64_t splitmix_mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

// The next word of the sequence.
constexpr std::uint64_t splitmix_next(std::uint64_t& state) {
  state += kSplitmixStep;
  return splitmix_mixed(state);
}

}  // namespace halfspace
