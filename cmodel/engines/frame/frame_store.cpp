// SPDX-License-Identifier: Apache-2.0
#include "frame_store.hpp"

#include <algorithm>
#include <new>

#include "../../fixed.hpp"

namespace halfspace {
namespace {

constexpr std::align_val_t kLine{64};
constexpr std::size_t kLinePixels = 16;

// px from line to line of a picture of whole tiles: so many cache lines that those of a tile, one
// below the other, are not all in the same few sets of a cache.
std::size_t picture_stride(std::size_t width) {
  const std::size_t lines = (width + kLinePixels - 1) / kLinePixels;
  return kLinePixels * (lines + (lines % 16 == 0 ? 1 : 0));
}

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

FrameStore::Words FrameStore::allocate(std::size_t words) {
  return Words(static_cast<std::uint32_t*>(::operator new[](words * sizeof(std::uint32_t), kLine)));
}

FrameStore::FrameStore(const FrameState& frame, const Config& config, Rgb background,
                       std::uint32_t clear)
    : config_(config),
      width_(frame.width),
      height_(frame.height),
      columns_(static_cast<std::uint32_t>((frame.width + config.grid() - 1) >> config.grid_log2)),
      lanes_(static_cast<std::size_t>(config.lanes())),
      tile_words_(lanes_ * static_cast<std::size_t>(config.samples == 1 ? 1 : 2 * config.samples)),
      stride_(picture_stride(std::size_t{columns_} << config.grid_log2)),
      clear_(clear),
      background_(pack(background)),
      rows_(static_cast<std::size_t>((frame.height + config.grid() - 1) >> config.grid_log2)) {
  state_.resize(columns_ * rows_.size(), kStale);
  row_.resize(rows_.size());
  if (config_.samples == 1) make_picture();
}

void FrameStore::make_picture() {
  if (!picture_) picture_ = allocate(stride_ * (rows_.size() << config_.grid_log2));
}

void FrameStore::clear() {
  for (std::uint8_t& state : state_) state = state == kBackground ? kBackground : kStale;
}

void FrameStore::make_row(std::uint32_t row) {
  rows_[row] = allocate(columns_ * tile_words_);
  row_[row] = rows_[row].get();
}

void FrameStore::make_tile(std::uint32_t column, std::uint32_t row) {
  if (!rows_[row]) make_row(row);
  state_[std::size_t{row} * columns_ + column] = kDrawn;
  std::uint32_t* words = rows_[row].get() + column * tile_words_;
  const std::size_t depths = lanes_ * static_cast<std::size_t>(config_.samples);
  std::fill_n(words, depths, clear_);
  std::fill_n(words + depths, tile_words_ - depths, background_);
  if (config_.samples == 1) clear_pixels(column, row);
}

std::size_t FrameStore::tiles_touched() const {
  return static_cast<std::size_t>(std::count(state_.begin(), state_.end(), kDrawn));
}

// Background in tiles column .. end - 1 of the picture.
void FrameStore::fill_pixels(std::uint32_t column, std::uint32_t end, std::uint32_t row) {
  const std::size_t grid = std::size_t{1} << config_.grid_log2;
  std::uint32_t* to = picture_.get() + (row * stride_ + column) * grid;
  for (std::size_t y = 0; y < grid; ++y, to += stride_) {
    std::fill_n(to, (end - column) * grid, background_);
  }
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

// What the picture has at one lane of a tile.
std::uint32_t FrameStore::pixel(std::uint32_t column, std::uint32_t row, std::size_t lane) const {
  const std::uint32_t* tile = find_tile(column, row);
  if (tile == nullptr) return background_;
  if (config_.samples > 1) return averaged(tile, lane);
  const std::size_t grid = std::size_t{1} << config_.grid_log2;
  return picture_[(row * stride_ + column) * grid + lane / grid * stride_ + lane % grid];
}

// Runs of tiles at once: most of a large frame is background.
void FrameStore::finish_row(std::uint32_t row) {
  const auto begin = state_.begin() + static_cast<std::ptrdiff_t>(std::size_t{row} * columns_);
  const auto end = begin + columns_;
  const auto column = [&](auto at) { return static_cast<std::uint32_t>(at - begin); };
  for (auto first = std::find(begin, end, kStale); first != end;) {
    const auto last = std::find_if(first, end, [](std::uint8_t state) { return state != kStale; });
    fill_pixels(column(first), column(last), row);
    std::fill(first, last, kBackground);
    first = std::find(last, end, kStale);
  }
  if (config_.samples == 1) return;
  const std::size_t grid = std::size_t{1} << config_.grid_log2;
  for (auto at = begin; at != end; ++at) {
    if (*at != kDrawn) continue;
    std::uint32_t* const to = picture_.get() + (row * stride_ + column(at)) * grid;
    for (std::size_t lane = 0; lane < lanes_; ++lane) {
      to[lane / grid * stride_ + lane % grid] = pixel(column(at), row, lane);
    }
  }
}

std::size_t FrameStore::tiles_unfinished() const {
  const auto stale = std::count(state_.begin(), state_.end(), kStale);
  return static_cast<std::size_t>(stale) + (config_.samples == 1 ? 0 : tiles_touched());
}

PictureView FrameStore::picture() const {
  return {picture_.get(), stride_, static_cast<std::size_t>(width_),
          static_cast<std::size_t>(height_)};
}

Image FrameStore::resolve() const {
  Image image{width_, height_, {}};
  image.pixel.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  const auto g = static_cast<unsigned>(config_.grid_log2);
  const unsigned last = (1u << g) - 1;
  for (unsigned y = 0; y < static_cast<unsigned>(height_); ++y) {
    for (unsigned x = 0; x < static_cast<unsigned>(width_); ++x) {
      const std::size_t lane = (y & last) << g | (x & last);
      image.pixel.push_back(unpack(pixel(x >> g, y >> g, lane)));
    }
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
  const auto column = static_cast<std::uint32_t>(x) >> g;
  const auto row = static_cast<std::uint32_t>(y) >> g;
  const auto lane = static_cast<std::size_t>((y & last) << g | (x & last));
  if (config_.samples == 1) return unpack(pixel(column, row, lane));
  const std::uint32_t* tile = find_tile(column, row);
  const auto plane = static_cast<std::size_t>(config_.samples + sample);
  return unpack(tile == nullptr ? background_ : tile[plane * lanes_ + lane]);
}

}  // namespace halfspace
