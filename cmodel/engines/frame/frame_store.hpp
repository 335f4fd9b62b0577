// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "../../config.hpp"
#include "../../framebuffer.hpp"

namespace halfspace {

// Pixels that the engine keeps (red lowest, then green, blue, 255). Valid until the engine draws,
// clears or goes.
struct PictureView {
  const std::uint32_t* pixels = nullptr;  // of the top line
  std::size_t stride = 0;                 // px from line to line
  std::size_t width = 0;                  // px
  std::size_t height = 0;                 // lines

  std::span<const std::uint32_t> line(std::size_t y) const { return {pixels + y * stride, width}; }
};

// What Framebuffer keeps, laid out for vectors: tile by tile every sample's depths, 32 bits each
// (U0.depth_bits). With one sample colours are pixels of the picture; with several they follow the
// tile's depths, every sample's.
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
  std::size_t tiles_total() const { return state_.size(); }
  Image resolve() const;
  std::vector<std::uint32_t> depth() const;

  // The picture, once it was made and every row of tiles is finished, which writes what drawing did
  // not write: background where only an earlier frame was, and with several samples the pixels of
  // every tile drawn to. Different rows may be finished by different threads.
  void make_picture();
  void finish_row(std::uint32_t row);
  std::size_t tiles_unfinished() const;
  PictureView picture() const;

  // Depth and colour of one sample, whatever was drawn there.
  std::uint32_t depth_at(int x, int y, int sample) const;
  Rgb color_at(int x, int y, int sample) const;

  // --- For kernels. ---------------------------------------------------------------------------

  // The memory of tile (column, row), cleared when it is new: depth of sample m at lane l is
  // word m * lanes + l; with several samples its colour is that plus samples * lanes.
  std::uint32_t* tile(std::uint32_t column, std::uint32_t row) {
    const std::size_t at = std::size_t{row} * columns_ + column;
    if (state_[at] != kDrawn) make_tile(column, row);
    return rows_[row].get() + column * tile_words_;
  }
  // The same for a loop: a copy that no store to a tile can change.
  struct Tiles {
    FrameStore* store;
    std::uint8_t* state;
    std::uint32_t* const* rows;
    std::size_t columns;
    std::size_t tile_words;
    std::uint32_t* picture;
    std::size_t stride;  // px
    std::uint32_t grid_log2;

    // Of a tile that is cleared already.
    std::uint32_t* at(std::uint32_t column, std::uint32_t row) const {
      return rows[row] + column * tile_words;
    }
    // Its first pixel in the picture: with one sample, where its colours are.
    std::uint32_t* pixels(std::uint32_t column, std::uint32_t row) const {
      return picture + ((row * stride + column) << grid_log2);
    }
    std::uint32_t* tile(std::uint32_t column, std::uint32_t row) const {
      if (state[row * columns + column] != kDrawn) store->make_tile(column, row);
      return at(column, row);
    }
    // The same, but a new tile is left for the caller to clear.
    std::uint32_t* tile(std::uint32_t column, std::uint32_t row, bool& is_new) const {
      std::uint8_t& here = state[row * columns + column];
      is_new = here != kDrawn;
      here = kDrawn;
      if (rows[row] == nullptr) store->make_row(row);
      return at(column, row);
    }
  };
  Tiles tiles() {
    return {
        this,        state_.data(),  row_.data(), columns_,
        tile_words_, picture_.get(), stride_,     static_cast<std::uint32_t>(config_.grid_log2)};
  }

  // Background in a tile's pixels.
  void clear_pixels(std::uint32_t column, std::uint32_t row) {
    fill_pixels(column, column + 1, row);
  }

  // Null when nothing was drawn there.
  const std::uint32_t* find_tile(std::uint32_t column, std::uint32_t row) const {
    const std::size_t at = std::size_t{row} * columns_ + column;
    return state_[at] != kDrawn ? nullptr : rows_[row].get() + column * tile_words_;
  }
  std::uint32_t background() const { return background_; }
  std::uint32_t columns() const { return columns_; }
  std::uint32_t rows() const { return static_cast<std::uint32_t>(rows_.size()); }

 private:
  // Of a tile. kBackground: nothing but background in the picture, and not drawn to. kStale: not
  // drawn to either, but the picture has something else there.
  enum State : std::uint8_t { kBackground, kDrawn, kStale };
  struct Free {
    void operator()(std::uint32_t* words) const;
  };
  using Words = std::unique_ptr<std::uint32_t[], Free>;
  static Words allocate(std::size_t words);

  void make_row(std::uint32_t row);
  void make_tile(std::uint32_t column, std::uint32_t row);
  void fill_pixels(std::uint32_t column, std::uint32_t end, std::uint32_t row);
  std::uint32_t averaged(const std::uint32_t* tile, std::size_t lane) const;
  std::uint32_t pixel(std::uint32_t column, std::uint32_t row, std::size_t lane) const;

  Config config_;
  int width_;
  int height_;
  std::uint32_t columns_;
  std::size_t lanes_;       // of a tile
  std::size_t tile_words_;  // lanes, times 2 x samples where there are several
  std::size_t stride_;      // of the picture, px; whole tiles, and its lines begin cache lines
  std::uint32_t clear_;
  std::uint32_t background_;  // as a stored colour
  std::vector<std::uint8_t> state_;
  std::vector<Words> rows_;
  std::vector<std::uint32_t*> row_;  // the same pointers
  Words picture_;                    // whole tiles
};

}  // namespace halfspace
