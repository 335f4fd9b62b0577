// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// How many triangles cover each pixel: the picture that TCOV files and coverage CRCs speak of. With
// several samples a triangle counts once for a pixel when it covers any of them.
class HitCount {
 public:
  HitCount(int width, int height)
      : width_(width),
        height_(height),
        count_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  // Adds one tile, saturating at 255. The tile's covered pixels must be inside the frame, which
  // coverage() ensures.
  void add(const CoverageTile& tile, const Config& config);

  int width() const { return width_; }
  int height() const { return height_; }
  const std::vector<std::uint8_t>& count() const { return count_; }  // row by row from the top
  std::uint8_t at(int x, int y) const {
    return count_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                  static_cast<std::size_t>(x)];
  }

 private:
  int width_;
  int height_;
  std::vector<std::uint8_t> count_;
};

}  // namespace halfspace
