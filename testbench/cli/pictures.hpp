// SPDX-License-Identifier: Apache-2.0
//
// Pictures of things that are not colours: for people who look rather than read.
#pragma once

#include <vector>

#include "framebuffer.hpp"
#include "hit_count.hpp"
#include "tile_traversal.hpp"

namespace halfspace {

inline constexpr Rgb kBackground{24, 26, 33};

// Hit counts: background, then cool to hot from 1 to 8 triangles and more.
Image picture_of_hits(const HitCount& hits);
// The same from counts, row by row.
Image picture_of_counts(const std::vector<std::uint8_t>& counts, int width, int height);

// Depth buffer values: near bright, far dark, over the range that occurs; `far` where nothing is.
Image picture_of_depth(const std::vector<std::uint32_t>& depth, int width, int height,
                       std::uint32_t far);

// Which nodes of the pyramid were tested. Leaf tiles: green where a triangle covered samples, red
// where it did not, brighter the more often; upper levels as outlines, yellow near the leaves to
// white at the root.
class TilePicture {
 public:
  TilePicture(int width, int height, const Config& config);
  void visit(const Node& node, int level, bool covered);
  Image image() const;

 private:
  struct Leaf {
    std::uint32_t covered = 0;
    std::uint32_t empty = 0;
  };
  Config config_;
  int width_;
  int height_;
  int columns_;
  std::vector<Leaf> leaves_;
  // [level][column of the node + row * columns]: the node was tested
  std::vector<std::vector<bool>> nodes_;
};

// Pictures side by side in a near-square sheet, on the background.
Image contact_sheet(const std::vector<Image>& images);

}  // namespace halfspace
