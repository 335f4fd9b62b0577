// SPDX-License-Identifier: Apache-2.0
#include "canvas.hpp"

#include "fixed.hpp"

namespace halfspace::methods {

Canvas::Canvas(int width, int height, int x_first, int y_first, std::uint64_t budget)
    : width_(width), height_(height), x_first_(x_first), y_first_(y_first), budget_(budget) {
  HS_CHECK(width >= 1 && height >= 1);
  hits_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

void Canvas::keep_attributes() {
  depth_.assign(hits_.size(), 1.0);
  color_.assign(hits_.size(), Color{});
}

void Canvas::fragment(int x, int y, double depth, const Color& color) {
  if (!contains(x, y)) return;
  const std::size_t i = index(x, y);
  ++hits_[i];
  // The first fragment of a pixel is stored whatever its depth, so that a NaN is seen.
  if (depth_.empty() || (hits_[i] > 1 && !(depth < depth_[i]))) return;
  depth_[i] = depth;
  color_[i] = color;
}

}  // namespace halfspace::methods
