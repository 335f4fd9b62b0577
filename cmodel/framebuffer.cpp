// SPDX-License-Identifier: Apache-2.0
#include "framebuffer.hpp"

namespace halfspace {

Framebuffer::Framebuffer(const FrameState& frame, const Config& config, Rgb background,
                         std::uint32_t clear)
    : config_(config),
      width_(frame.width),
      height_(frame.height),
      columns_((frame.width + config.grid() - 1) >> config.grid_log2),
      background_(background),
      clear_(clear) {
  const int rows = (frame.height + config.grid() - 1) >> config.grid_log2;
  tiles_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows));
}

FrameTile& Framebuffer::tile(std::int32_t x, std::int32_t y) {
  const int g = config_.grid_log2;
  std::unique_ptr<FrameTile>& slot =
      tiles_[static_cast<std::size_t>(y >> g) * static_cast<std::size_t>(columns_) +
             static_cast<std::size_t>(x >> g)];
  if (!slot) {
    ++touched_;
    slot = std::make_unique<FrameTile>();
    const auto samples = static_cast<std::size_t>(config_.samples);
    DepthTile depth{};
    depth.fill(clear_);
    ColorTile color{};
    color.fill(background_);
    slot->depth.assign(samples, depth);
    slot->color.assign(samples, color);
  }
  return *slot;
}

const FrameTile* Framebuffer::find(int x, int y, std::size_t& lane) const {
  const int g = config_.grid_log2;
  const int last = config_.grid() - 1;
  lane = static_cast<std::size_t>(((y & last) << g) | (x & last));
  return tiles_[static_cast<std::size_t>(y >> g) * static_cast<std::size_t>(columns_) +
                static_cast<std::size_t>(x >> g)]
      .get();
}

Image Framebuffer::resolve() const {
  Image image{width_, height_, {}};
  image.pixel.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
                     background_);
  const auto samples = static_cast<unsigned>(config_.samples);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      std::size_t lane = 0;
      const FrameTile* tile = find(x, y, lane);
      if (tile == nullptr) continue;
      std::array<unsigned, 3> sum{};
      for (const ColorTile& color : tile->color) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += color[lane][c];
      }
      for (std::size_t c = 0; c < 3; ++c) {
        image.at(x, y)[c] = static_cast<std::uint8_t>((sum[c] + samples / 2) / samples);
      }
    }
  }
  return image;
}

std::vector<std::uint32_t> Framebuffer::depth() const {
  std::vector<std::uint32_t> out(
      static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), clear_);
  std::size_t at = 0;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x, ++at) {
      std::size_t lane = 0;
      if (const FrameTile* tile = find(x, y, lane)) out[at] = tile->depth[0][lane];
    }
  }
  return out;
}

}  // namespace halfspace
