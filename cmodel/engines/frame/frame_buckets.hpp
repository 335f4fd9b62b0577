// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "frame_records.hpp"

namespace halfspace {

// The records of a piece sorted by tile, in triangle order within a tile, with what the depth test
// needs of their triangles. One sample only.
class FrameBuckets {
 public:
  // How many records each tile of a frame has; all 0 between uses.
  using Scratch = std::vector<std::uint32_t>;

  // How tiles make up a frame: rows of `columns` tiles, `band` of them a band. More records than
  // `most`, a run counted by its length, are not sorted: they would leave the caches.
  struct Grid {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::uint32_t band = 1;
    std::size_t most = 0;

    std::uint32_t bands() const { return (rows + band - 1) / band; }
  };

  // Sorts them; false, and nothing is kept, when there are too many.
  //
  //   tiles    with their depth planes
  //   scratch  one entry per tile of the frame
  bool fill(const FrameTiles& tiles, const FrameConstants& constants, const Grid& grid,
            Scratch& scratch);
  void clear() { band_.clear(); }
  bool filled() const { return !band_.empty(); }

  // Those of one band: tiles in the order of their first record.
  BinRange range(std::uint32_t band) const;

 private:
  std::size_t count(const FrameTiles& tiles, const Grid& grid, Scratch& scratch);
  void sort_by_band(const Grid& grid);

  std::vector<BinTile> tile_;  // `tiles_` of them
  std::vector<BinTile> sorted_;
  std::size_t tiles_ = 0;
  std::vector<std::uint32_t> band_;  // where each begins in tile_, and the end
  std::vector<BinRecord> record_;
};

}  // namespace halfspace
