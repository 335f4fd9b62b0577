// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "fit.hpp"

namespace halfspace {

// What a mesh with fewer triangles gets wrong, counted in pixels of the pictures.
struct LodError {
  std::uint64_t triangles_before = 0;
  std::uint64_t triangles_after = 0;
  std::uint64_t pixels_covered = 0;  // by the first; a sample of the pixel is enough
  std::uint64_t pixels_wrong = 0;    // covered by one of the two alone: the outline moved
  std::uint64_t counts_wrong = 0;    // another number of triangles covers the pixel's samples
};

// The same views of two scenes, at full's subpixel bits. The vectors are of equal length.
LodError compare_lod(const std::vector<FitView>& before, const std::vector<FitView>& after);

}  // namespace halfspace
