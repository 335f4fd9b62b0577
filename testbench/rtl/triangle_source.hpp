// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "packets.hpp"
#include "stalls.hpp"

namespace halfspace {

// Offers triangles to the RTL as the stall pattern says.
class TriangleSource {
 public:
  TriangleSource(std::span<const Triangle> triangles, const Stalls& stalls, int tag_bits)
      : triangles_(triangles), stalls_(stalls), tag_bits_(tag_bits), offer_(stalls.gap(0)) {}

  // The triangle offered at this clock, or null. Tags are positions in the stream.
  const Triangle* at(std::uint64_t clock) {
    if (next_ >= triangles_.size() || clock < offer_) return nullptr;
    offered_ = triangles_[next_];
    const std::uint64_t mask = (std::uint64_t{1} << tag_bits_) - 1;
    offered_.tag = static_cast<std::uint32_t>(next_ & mask);
    return &offered_;
  }
  void accepted(std::uint64_t clock) {
    ++next_;
    offer_ = clock + 1 + stalls_.gap(next_);
  }
  std::uint64_t count() const { return next_; }
  bool done() const { return next_ == triangles_.size(); }

 private:
  std::span<const Triangle> triangles_;
  Stalls stalls_;
  int tag_bits_;
  std::uint64_t next_ = 0;
  std::uint64_t offer_;
  Triangle offered_;
};

}  // namespace halfspace
