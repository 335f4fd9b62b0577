// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace halfspace::methods {

using Color = std::array<double, 3>;  // red, green, blue, 0..255; not clamped

inline constexpr std::uint64_t kNoLimit = ~std::uint64_t{0};

// What a method draws on: how often each pixel was hit and, on request, the depth and colour of the
// nearest fragment. Pixel (x, y) has its centre at (x + 1/2, y + 1/2) px. The window may start
// anywhere, so that a mesh far from the origin needs no frame as large as its coordinates.
class Canvas {
 public:
  // Pixels x_first..x_first + width - 1, likewise y; width, height >= 1. budget: steps that spend()
  // grants before it says no; a step is a pixel tested or a span, edge or node handled.
  Canvas(int width, int height, int x_first = 0, int y_first = 0, std::uint64_t budget = kNoLimit);

  // Depth (1 at first) and colour (0) are stored from now on. Costs 32 bytes a pixel.
  void keep_attributes();

  int x_first() const { return x_first_; }
  int y_first() const { return y_first_; }
  int x_last() const { return x_first_ + width_ - 1; }
  int y_last() const { return y_first_ + height_ - 1; }
  int width() const { return width_; }
  int height() const { return height_; }

  bool contains(int x, int y) const {
    return x >= x_first_ && x <= x_last() && y >= y_first_ && y <= y_last();
  }

  // One more hit; outside the window nothing happens.
  void hit(int x, int y) {
    if (contains(x, y)) ++hits_[index(x, y)];
  }

  // A hit with attributes: those of the least depth stay, of equal depths the first (a z-buffer
  // with less). A pixel's first fragment is always stored, even with a depth that is NaN or beyond
  // 1. Plain hit() while attributes are not kept.
  void fragment(int x, int y, double depth, const Color& color);

  // True when a fragment's attributes would be stored at all: methods may skip them otherwise.
  bool wants_attributes() const { return !depth_.empty(); }

  // Takes steps from the budget; false once it is used up, which is for good. A method then returns
  // with its picture unfinished, so that a hang is a result and not an accident.
  bool spend(std::uint64_t steps) {
    if (steps > budget_) {
      budget_ = 0;
      exhausted_ = true;
      return false;
    }
    budget_ -= steps;
    return true;
  }
  bool exhausted() const { return exhausted_; }

  // Row by row from the top of the window.
  const std::vector<std::uint32_t>& hits() const { return hits_; }
  const std::vector<double>& depth() const { return depth_; }
  const std::vector<Color>& color() const { return color_; }

  // (x, y) inside the window.
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - y_first_) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x - x_first_);
  }

 private:
  int width_;
  int height_;
  int x_first_;
  int y_first_;
  std::uint64_t budget_;
  bool exhausted_ = false;
  std::vector<std::uint32_t> hits_;
  std::vector<double> depth_;
  std::vector<Color> color_;
};

}  // namespace halfspace::methods
