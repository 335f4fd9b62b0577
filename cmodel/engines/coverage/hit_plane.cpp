// SPDX-License-Identifier: Apache-2.0
#include "hit_plane.hpp"

#include <array>
#include <cstring>

#include "../../fixed.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t kEach = 0x0101010101010101u;

// Bit i to byte i, as 0 or 1; byte 0 is the first in memory.
constexpr std::array<std::uint64_t, 256> kSpread = [] {
  std::array<std::uint64_t, 256> spread{};
  for (std::size_t bits = 0; bits < 256; ++bits) {
    for (std::size_t i = 0; i < 8; ++i) spread[bits] |= std::uint64_t{bits >> i & 1} << (8 * i);
  }
  return spread;
}();

// 1 in every byte of `count` that is not 255.
constexpr std::uint64_t below_255(std::uint64_t count) {
  const std::uint64_t room = ~count;
  return ((((room & 0x7f * kEach) + 0x7f * kEach) | room) >> 7) & kEach;
}

std::size_t whole_tiles(std::size_t pixels) { return (pixels + 7) & ~std::size_t{7}; }

}  // namespace

HitPlane::HitPlane(int width, int height)
    : width_(static_cast<std::size_t>(width)),
      height_(static_cast<std::size_t>(height)),
      stride_(whole_tiles(width_) + 8),
      count_(stride_ * whole_tiles(height_)) {}

// Eight bytes of hits, 0 or 1 each.
void HitPlane::add_row(std::size_t at, std::uint64_t hits) {
  std::uint64_t count;
  std::memcpy(&count, count_.data() + at, sizeof count);
  count += hits & below_255(count);
  std::memcpy(count_.data() + at, &count, sizeof count);
}

void HitPlane::add(const CoverageChunk& chunk) {
  const auto log2 = static_cast<unsigned>(chunk.grid_log2);
  const std::size_t grid = std::size_t{1} << log2;
  const std::uint64_t row_bits = (1u << grid) - 1u;
  for (std::size_t r = 0; r < chunk.records(); ++r) {
    const RecordPlace place{chunk.place[r]};
    const std::size_t corner = (std::size_t{place.tile_y()} * stride_ + place.tile_x()) << log2;
    if (place.is_run()) {
      for (std::size_t j = 0; j < grid; ++j) {
        for (std::uint64_t tile = 0; tile < chunk.plane[0][r]; ++tile) {
          add_row(corner + j * stride_ + tile * grid, kSpread[row_bits]);
        }
      }
      continue;
    }
    std::uint64_t any = 0;
    for (std::size_t m = 0; m < static_cast<std::size_t>(chunk.samples); ++m) {
      any |= chunk.plane[m][r];
    }
    for (std::size_t j = 0; j < grid; ++j) {
      add_row(corner + j * stride_, kSpread[any >> (j * grid) & row_bits]);
    }
  }
}

void HitPlane::add(const HitPlane& other) {
  HS_CHECK(width_ == other.width_ && height_ == other.height_);
  for (std::size_t i = 0; i < count_.size(); ++i) {
    const unsigned sum = unsigned{count_[i]} + other.count_[i];
    count_[i] = static_cast<std::uint8_t>(sum > 255 ? 255 : sum);
  }
}

std::vector<std::uint8_t> HitPlane::count() const {
  std::vector<std::uint8_t> out;
  out.reserve(width_ * height_);
  for (std::size_t y = 0; y < height_; ++y) {
    const auto row = count_.begin() + static_cast<std::ptrdiff_t>(y * stride_);
    out.insert(out.end(), row, row + static_cast<std::ptrdiff_t>(width_));
  }
  return out;
}

}  // namespace halfspace
