// SPDX-License-Identifier: Apache-2.0
#include "frame_store.hpp"

#include <algorithm>
#include <cstring>
#include <new>

#include "../../fixed.hpp"

namespace halfspace {
namespace {

constexpr std::align_val_t kLine{64};

constexpr std::uint32_t pack(Rgb color) {
  return std::uint32_t{color[0]} | std::uint32_t{color[1]} << 8 | std::uint32_t{color[2]} << 16 |
         0xff000000u;
}

constexpr Rgb unpack(std::uint32_t color) {
  return {static_cast<std::uint8_t>(color), static_cast<std::uint8_t>(color >> 8),
          static_cast<std::uint8_t>(color >> 16)};
}

}  // namespace

void FrameStore::Free::operator()(std::uint32_t* words) const { ::operator delete[](words, kLine); }

FrameStore::FrameStore(const FrameState& frame, const Config& config, Rgb background,
                       std::uint32_t clear)
    : config_(config),
      width_(frame.width),
      height_(frame.height),
      columns_(static_cast<std::uint32_t>((frame.width + config.grid() - 1) >> config.grid_log2)),
      lanes_(static_cast<std::size_t>(config.lanes())),
      tile_words_(2 * lanes_ * static_cast<std::size_t>(config.samples)),
      clear_(clear),
      background_(pack(background)),
      rows_(static_cast<std::size_t>((frame.height + config.grid() - 1) >> config.grid_log2)) {
  live_.resize(columns_ * rows_.size());
  row_.resize(rows_.size());
}

void FrameStore::clear() { std::fill(live_.begin(), live_.end(), std::uint8_t{0}); }

void FrameStore::make_row(std::uint32_t row) {
  const std::size_t bytes = columns_ * tile_words_ * sizeof(std::uint32_t);
  rows_[row].reset(static_cast<std::uint32_t*>(::operator new[](bytes, kLine)));
  row_[row] = rows_[row].get();
}

void FrameStore::make_tile(std::uint32_t column, std::uint32_t row) {
  if (!rows_[row]) make_row(row);
  live_[std::size_t{row} * columns_ + column] = 1;
  std::uint32_t* words = rows_[row].get() + column * tile_words_;
  std::fill_n(words, tile_words_ / 2, clear_);
  std::fill_n(words + tile_words_ / 2, tile_words_ / 2, background_);
}

std::size_t FrameStore::tiles_touched() const {
  return static_cast<std::size_t>(std::count(live_.begin(), live_.end(), std::uint8_t{1}));
}

std::uint32_t FrameStore::averaged(const std::uint32_t* tile, std::size_t lane) const {
  const auto samples = static_cast<std::uint32_t>(config_.samples);
  std::uint32_t sum[3] = {0, 0, 0};
  for (std::size_t m = 0; m < samples; ++m) {
    const Rgb color = unpack(tile[(samples + m) * lanes_ + lane]);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += color[c];
  }
  Rgb mean{};
  for (std::size_t c = 0; c < 3; ++c) {
    mean[c] = static_cast<std::uint8_t>((sum[c] + samples / 2) / samples);
  }
  return pack(mean);
}

// One line of pixels of a row of tiles, from the first column on: whole runs of untouched tiles at
// once, because most of a large frame is background.
void FrameStore::resolve_line(std::uint32_t row, std::size_t first_lane, std::uint32_t* to) const {
  const std::size_t grid = static_cast<std::size_t>(config_.grid());
  const auto width = static_cast<std::size_t>(width_);
  const std::uint8_t* live = live_.data() + std::size_t{row} * columns_;
  const std::uint32_t* tiles = row_[row];  // null when nothing was drawn
  std::uint32_t column = 0;
  while (column < columns_) {
    const std::uint32_t dead = column;
    while (column < columns_ && live[column] == 0) ++column;
    std::fill(to + dead * grid, to + std::min(column * grid, width), background_);
    for (; column < columns_ && live[column] != 0; ++column) {
      const std::uint32_t* tile = tiles + column * tile_words_;
      const std::uint32_t* color = tile + lanes_ + first_lane;
      const std::size_t count = std::min(grid, width - column * grid);
      if (config_.samples > 1) {
        for (std::size_t i = 0; i < count; ++i) {
          to[column * grid + i] = averaged(tile, first_lane + i);
        }
      } else if (count == 8) {
        std::memcpy(to + column * 8, color, 32);
      } else {
        std::copy_n(color, count, to + column * grid);
      }
    }
  }
}

void FrameStore::resolve_rgba(std::span<std::uint32_t> pixels) const {
  for (std::uint32_t row = 0; row < rows(); ++row) resolve_row(row, pixels);
}

void FrameStore::resolve_row(std::uint32_t row, std::span<std::uint32_t> pixels) const {
  const auto width = static_cast<std::size_t>(width_);
  HS_CHECK(pixels.size() == width * static_cast<std::size_t>(height_));
  const auto grid = static_cast<std::size_t>(config_.grid());
  const std::size_t top = row * grid;
  for (std::size_t y = top; y < std::min(top + grid, static_cast<std::size_t>(height_)); ++y) {
    resolve_line(row, (y - top) * grid, pixels.data() + y * width);
  }
}

StoreRow FrameStore::row(std::uint32_t row) const {
  const auto grid = static_cast<std::size_t>(config_.grid());
  const std::size_t lines = std::min(grid, static_cast<std::size_t>(height_) - row * grid);
  return {live_.data() + std::size_t{row} * columns_,
          row_[row] == nullptr ? nullptr : row_[row] + lanes_,
          tile_words_,
          columns_,
          grid,
          static_cast<std::size_t>(width_),
          lines,
          background_};
}

Image FrameStore::resolve() const {
  Image image{width_, height_, {}};
  const auto width = static_cast<std::size_t>(width_);
  const auto grid = static_cast<std::size_t>(config_.grid());
  std::vector<std::uint32_t> line(width);
  image.pixel.resize(width * static_cast<std::size_t>(height_));
  for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y) {
    resolve_line(static_cast<std::uint32_t>(y >> config_.grid_log2), (y & (grid - 1)) * grid,
                 line.data());
    std::transform(line.begin(), line.end(), image.pixel.data() + y * width, unpack);
  }
  return image;
}

std::vector<std::uint32_t> FrameStore::depth() const {
  std::vector<std::uint32_t> out;
  out.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) out.push_back(depth_at(x, y, 0));
  }
  return out;
}

std::uint32_t FrameStore::depth_at(int x, int y, int sample) const {
  const auto g = static_cast<unsigned>(config_.grid_log2);
  const int last = config_.grid() - 1;
  const std::uint32_t* tile =
      find_tile(static_cast<std::uint32_t>(x) >> g, static_cast<std::uint32_t>(y) >> g);
  const auto lane = static_cast<std::size_t>((y & last) << g | (x & last));
  return tile == nullptr ? clear_ : tile[static_cast<std::size_t>(sample) * lanes_ + lane];
}

Rgb FrameStore::color_at(int x, int y, int sample) const {
  const auto g = static_cast<unsigned>(config_.grid_log2);
  const int last = config_.grid() - 1;
  const std::uint32_t* tile =
      find_tile(static_cast<std::uint32_t>(x) >> g, static_cast<std::uint32_t>(y) >> g);
  const auto lane = static_cast<std::size_t>((y & last) << g | (x & last));
  const auto plane = static_cast<std::size_t>(config_.samples + sample);
  return unpack(tile == nullptr ? background_ : tile[plane * lanes_ + lane]);
}

}  // namespace halfspace
