// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "config.hpp"
#include "packets.hpp"

namespace halfspace {

// An 8-bit RGB picture, row by row from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Rgb> pixel;
  Rgb& at(int x, int y) {
    return pixel[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(x)];
  }
};

// What the framebuffer keeps of one tile: depth and colour of each sample.
struct FrameTile {
  std::vector<DepthTile> depth;  // [sample]
  std::vector<ColorTile> color;  // [sample]
};

// Depth and colour of a frame, stored by tile; a tile gets storage when it is first touched, so a
// frame costs what its picture covers. Twin: none yet in rtl/.
class Framebuffer {
 public:
  // background, clear: colour and depth of samples that no triangle won.
  Framebuffer(const FrameState& frame, const Config& config, Rgb background, std::uint32_t clear);

  // The tile whose first pixel is (x, y), cleared when new.
  FrameTile& tile(std::int32_t x, std::int32_t y);

  std::size_t tiles_touched() const { return touched_; }
  std::size_t tiles_total() const { return tiles_.size(); }

  // Averages each pixel's samples, rounding to nearest (halves up).
  Image resolve() const;

  // Depth of sample 0 of each pixel, row by row from the top; `clear` where nothing was drawn.
  std::vector<std::uint32_t> depth() const;

 private:
  // The tile and the lane of a pixel; null when it was never touched.
  const FrameTile* find(int x, int y, std::size_t& lane) const;

  Config config_;
  int width_;
  int height_;
  int columns_;
  Rgb background_;
  std::uint32_t clear_;
  std::size_t touched_ = 0;
  std::vector<std::unique_ptr<FrameTile>> tiles_;
};

}  // namespace halfspace
