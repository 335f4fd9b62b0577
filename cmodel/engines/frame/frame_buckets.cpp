// SPDX-License-Identifier: Apache-2.0
#include "frame_buckets.hpp"

#include <algorithm>

#include "../coverage/coverage_chunk.hpp"

namespace halfspace {
namespace {

constexpr std::size_t tile_index(std::uint32_t place, std::uint32_t columns) {
  return std::size_t{place >> 16} * columns + (place & 0xffff);
}

}  // namespace

// Counts the records of each tile, and lists the tiles; 0 when there are too many records.
std::size_t FrameBuckets::count(const FrameTiles& tiles, const Grid& grid, Scratch& scratch) {
  const std::size_t most = grid.most;
  const std::uint32_t columns = grid.columns;
  tile_.resize(most + 1);
  BinTile* const list = tile_.data();
  std::uint32_t* const of_tile = scratch.data();
  std::size_t found = 0;
  std::size_t total = 0;
  const auto add = [&](std::uint32_t place) {
    std::uint32_t& records = of_tile[tile_index(place, columns)];
    list[found].place = place;
    found += records == 0;
    ++records;
  };
  for (std::size_t r = 0; r < tiles.count && total <= most; ++r) {
    const RecordPlace place{tiles.place[r]};
    if (!place.is_run()) [[likely]] {
      ++total;
      if (total <= most) add(place.word);
      continue;
    }
    const std::uint64_t length = tiles.mask[0][r];
    total += length;
    for (std::uint32_t i = 0; total <= most && i < length; ++i) {
      add((place.word & ~kRunFlag) + i);
    }
  }
  tiles_ = found;
  if (total <= most) return total;
  for (std::size_t i = 0; i < found; ++i) of_tile[tile_index(list[i].place, columns)] = 0;
  return 0;
}

// Keeps the order of tiles within a band.
void FrameBuckets::sort_by_band(const Grid& grid) {
  band_.assign(grid.bands() + 1, 0);
  if (grid.bands() == 1) {
    band_[1] = static_cast<std::uint32_t>(tiles_);
    return;
  }
  const auto band_of = [&grid](const BinTile& tile) { return (tile.place >> 16) / grid.band; };
  for (std::size_t i = 0; i < tiles_; ++i) ++band_[band_of(tile_[i]) + 1];
  for (std::size_t b = 1; b < band_.size(); ++b) band_[b] += band_[b - 1];
  sorted_.resize(tile_.size());
  for (std::size_t i = 0; i < tiles_; ++i) sorted_[band_[band_of(tile_[i])]++] = tile_[i];
  for (std::size_t b = band_.size() - 1; b > 0; --b) band_[b] = band_[b - 1];
  band_[0] = 0;
  tile_.swap(sorted_);
}

bool FrameBuckets::fill(const FrameTiles& tiles, const FrameConstants& constants, const Grid& grid,
                        Scratch& scratch) {
  band_.clear();
  const std::size_t total = count(tiles, grid, scratch);
  if (total == 0) return false;
  sort_by_band(grid);
  std::uint32_t* const next = scratch.data();
  std::uint32_t end = 0;
  for (std::size_t i = 0; i < tiles_; ++i) {
    std::uint32_t& first = next[tile_index(tile_[i].place, grid.columns)];
    end += first;
    first = end - first;
    tile_[i].end = end;
  }
  if (record_.size() < total) record_.resize(std::min(2 * total, grid.most));
  BinRecord* const to = record_.data();
  const int F = constants.gradient_bits;
  const int log2 = constants.config.grid_log2;
  const FrameTiles from = tiles;
  const auto add = [&](std::size_t r, std::uint32_t place, std::uint64_t covered) {
    const std::uint32_t triangle = from.triangle[r];
    const FramePlane& plane = from.depth[triangle];
    const std::uint64_t x = std::uint64_t{place & 0xffff} << log2;
    const std::uint64_t y = std::uint64_t{place >> 16} << log2;
    const auto base = static_cast<std::uint32_t>((plane.origin + plane.dx * x + plane.dy * y) >> F);
    to[next[tile_index(place, grid.columns)]++] = {covered, base, plane.lane_dx, plane.lane_dy,
                                                   triangle};
  };
  const std::uint64_t all = log2 == 3 ? ~std::uint64_t{0} : 0xffff;
  for (std::size_t r = 0; r < from.count; ++r) {
    const RecordPlace place{from.place[r]};
    const std::uint64_t mask = from.mask[0][r];
    if (!place.is_run()) [[likely]] {
      add(r, place.word, mask);
      continue;
    }
    for (std::uint32_t i = 0; i < mask; ++i) add(r, (place.word & ~kRunFlag) + i, all);
  }
  for (std::size_t i = 0; i < tiles_; ++i) next[tile_index(tile_[i].place, grid.columns)] = 0;
  return true;
}

BinRange FrameBuckets::range(std::uint32_t band) const {
  const std::size_t first = band_[band];
  return {tile_.data() + first, band_[band + 1] - first, first == 0 ? 0 : tile_[first - 1].end,
          record_.data()};
}

}  // namespace halfspace
