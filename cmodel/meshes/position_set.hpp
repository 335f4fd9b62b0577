// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace halfspace {

// Which of many points are the same, exactly: a hash table of indices into an array of points.
class PositionSet {
 public:
  // expected: how many different points there will be, about.
  explicit PositionSet(std::size_t expected = 0) : slots_(std::bit_ceil(2 * expected + 64)) {}

  // The index of the point that equals points[index] and was given first; `index` if none was.
  std::uint32_t first_equal(const std::vector<glm::dvec3>& points, std::uint32_t index) {
    if (2 * (used_ + 1) > slots_.size()) grow(points);
    const std::uint64_t hash = hash_of(points[index]);
    const auto tag = static_cast<std::uint32_t>(hash);
    for (std::size_t at = hash >> 32;; ++at) {
      Slot& slot = slots_[at & (slots_.size() - 1)];
      if (slot.index == kEmpty) {
        slot = {tag, index};
        ++used_;
        return index;
      }
      if (slot.tag == tag && points[slot.index] == points[index]) return slot.index;
    }
  }

 private:
  static constexpr std::uint32_t kEmpty = UINT32_MAX;
  struct Slot {
    std::uint32_t tag = 0;
    std::uint32_t index = kEmpty;
  };

  static std::uint64_t hash_of(const glm::dvec3& point) {
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i) {
      // Adding 0 makes -0, which equals it, the same bits.
      hash = (hash ^ std::bit_cast<std::uint64_t>(point[i] + 0.0)) * 0x9e3779b97f4a7c15;
      hash ^= hash >> 29;
    }
    return hash * 0xbf58476d1ce4e5b9;
  }

  void grow(const std::vector<glm::dvec3>& points) {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.index == kEmpty) continue;
      std::size_t at = hash_of(points[slot.index]) >> 32;
      while (slots_[at & (slots_.size() - 1)].index != kEmpty) ++at;
      slots_[at & (slots_.size() - 1)] = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t used_ = 0;
};

}  // namespace halfspace
