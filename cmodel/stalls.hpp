// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "splitmix.hpp"

namespace halfspace {

// When the outside world holds the rasterizer up: gaps before triangles at its input and clocks at
// which its output is not taken. A function of index and clock alone, so that the model, the RTL
// and a replay see the same pattern whatever they do in between.
class Stalls {
 public:
  // No gap, always ready.
  Stalls() = default;
  // At each clock, and before each triangle, with this probability (0 <= p < 1) the world is busy;
  // a gap before a triangle lasts 1..8 clocks.
  Stalls(double probability, std::uint64_t seed)
      : threshold_(static_cast<std::uint64_t>(probability * 0x1p32)), seed_(seed) {}

  bool any() const { return threshold_ != 0; }

  // Clocks the source waits, after its previous triangle was accepted, before it offers this one.
  std::uint64_t gap(std::uint64_t triangle) const {
    if (threshold_ == 0) return 0;
    const std::uint64_t word = hash(2 * triangle);
    return (word & 0xffffffffu) < threshold_ ? 1 + (word >> 32) % 8 : 0;
  }

  // Whether a tile is taken at this clock.
  bool ready(std::uint64_t clock) const {
    return threshold_ == 0 || (hash(2 * clock + 1) & 0xffffffffu) >= threshold_;
  }

  // The first clock at or after `clock` at which a tile is taken.
  std::uint64_t next_ready(std::uint64_t clock) const {
    while (!ready(clock)) ++clock;
    return clock;
  }

 private:
  std::uint64_t hash(std::uint64_t index) const {
    return splitmix_mixed(seed_ * 0xd1342543de82ef95u + (index + 1) * kSplitmixStep);
  }

  std::uint64_t threshold_ = 0;
  std::uint64_t seed_ = 0;
};

}  // namespace halfspace
