// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "../../config.hpp"
#include "../../framebuffer.hpp"

namespace halfspace {

// A row of tiles with one sample on its way to pixels.
struct StoreRow {
  const std::uint8_t* live = nullptr;     // [column]: not 0 when drawn to
  const std::uint32_t* colors = nullptr;  // of the first tile; null when no tile was drawn to
  std::size_t tile_words = 0;             // from tile to tile
  std::size_t columns = 0;
  std::size_t grid = 8;
  std::size_t width = 0;  // px
  std::size_t lines = 0;  // of pixels in this row of tiles
  std::uint32_t background = 0;
};

// What Framebuffer keeps, laid out for vectors: tile by tile, every sample's depths, then every
// sample's colours, 32 bits each (depth U0.depth_bits; colour red lowest, then green, blue, 255).
//
// A row of tiles gets memory when it is first drawn to and keeps it; a tile is cleared when it is
// first drawn to after clear(). Different rows may be drawn to by different threads.
class FrameStore {
 public:
  // frame and config as Framebuffer.
  FrameStore(const FrameState& frame, const Config& config, Rgb background, std::uint32_t clear);

  void clear();

  // As the functions of Framebuffer of the same names.
  std::size_t tiles_touched() const;
  std::size_t tiles_total() const { return live_.size(); }
  Image resolve() const;
  std::vector<std::uint32_t> depth() const;

  // resolve() as 32-bit pixels (red lowest, then green, blue, 255), row by row from the top, into
  // memory of the caller's: width x height of them (checked).
  void resolve_rgba(std::span<std::uint32_t> pixels) const;
  // The same for one row of tiles.
  void resolve_row(std::uint32_t row, std::span<std::uint32_t> pixels) const;

  // Depth and colour of one sample, whatever was drawn there.
  std::uint32_t depth_at(int x, int y, int sample) const;
  Rgb color_at(int x, int y, int sample) const;

  // --- For kernels. ---------------------------------------------------------------------------

  // The memory of tile (column, row), cleared when it is new: depth of sample m at lane l is
  // word m * lanes + l, its colour that plus samples * lanes.
  std::uint32_t* tile(std::uint32_t column, std::uint32_t row) {
    const std::size_t at = std::size_t{row} * columns_ + column;
    if (live_[at] == 0) make_tile(column, row);
    return rows_[row].get() + column * tile_words_;
  }
  // The same for a loop: a copy that no store to a tile can change.
  struct Tiles {
    FrameStore* store;
    std::uint8_t* live;
    std::uint32_t* const* rows;
    std::size_t columns;
    std::size_t tile_words;

    // Of a tile that is cleared already.
    std::uint32_t* at(std::uint32_t column, std::uint32_t row) const {
      return rows[row] + column * tile_words;
    }
    std::uint32_t* tile(std::uint32_t column, std::uint32_t row) const {
      if (live[row * columns + column] == 0) store->make_tile(column, row);
      return at(column, row);
    }
    // The same, but a new tile is left for the caller to clear.
    std::uint32_t* tile(std::uint32_t column, std::uint32_t row, bool& is_new) const {
      std::uint8_t& alive = live[row * columns + column];
      is_new = alive == 0;
      alive = 1;
      if (rows[row] == nullptr) store->make_row(row);
      return at(column, row);
    }
  };
  Tiles tiles() { return {this, live_.data(), row_.data(), columns_, tile_words_}; }

  StoreRow row(std::uint32_t row) const;

  // Null when nothing was drawn there.
  const std::uint32_t* find_tile(std::uint32_t column, std::uint32_t row) const {
    const std::size_t at = std::size_t{row} * columns_ + column;
    return live_[at] == 0 ? nullptr : rows_[row].get() + column * tile_words_;
  }
  std::uint32_t background() const { return background_; }
  std::uint32_t columns() const { return columns_; }
  std::uint32_t rows() const { return static_cast<std::uint32_t>(rows_.size()); }

 private:
  struct Free {
    void operator()(std::uint32_t* words) const;
  };

  void make_row(std::uint32_t row);
  void make_tile(std::uint32_t column, std::uint32_t row);
  void resolve_line(std::uint32_t row, std::size_t first_lane, std::uint32_t* to) const;
  std::uint32_t averaged(const std::uint32_t* tile, std::size_t lane) const;

  Config config_;
  int width_;
  int height_;
  std::uint32_t columns_;
  std::size_t lanes_;       // of a tile
  std::size_t tile_words_;  // 2 x samples x lanes
  std::uint32_t clear_;
  std::uint32_t background_;  // as a stored colour
  std::vector<std::uint8_t> live_;
  std::vector<std::unique_ptr<std::uint32_t[], Free>> rows_;
  std::vector<std::uint32_t*> row_;  // the same pointers
};

}  // namespace halfspace
