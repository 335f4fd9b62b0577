// SPDX-License-Identifier: Apache-2.0
//
// A scene's triangles as real numbers: projected in double precision, not snapped. What the
// accuracy of subpixel bits is measured against.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "../geometry.hpp"

namespace halfspace {

struct RealVertex {
  double x = 0;  // px, right
  double y = 0;  // px, down
  double inverse_w = 1;
  std::array<double, kMaxAttributes> attribute{};  // 0..255
};

struct RealTriangle {
  std::array<RealVertex, 3> vertex;
  std::uint64_t index = 0;  // of the submitted triangle
  bool whole = true;        // not a piece of one that the planes of w, near and far cut
};

using RealSink = std::function<void(const RealTriangle&)>;

// The triangle, or the pieces that near and far leave of it; nothing where GeometryStage drops it
// whatever its configuration: a coordinate is not finite, or it lies beyond one side of the frame.
//
//   guard_bits  0, or the sides cut as well, at the guard band of +-2^guard_bits px
void real_triangles(const std::array<ClipVertex, 3>& triangle, std::uint64_t index,
                    const FrameState& frame, int guard_bits, const RealSink& sink);

}  // namespace halfspace
