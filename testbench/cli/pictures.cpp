// SPDX-License-Identifier: Apache-2.0
#include "pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace halfspace {
namespace {

Image blank(int width, int height) {
  return {width, height,
          std::vector<Rgb>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                           kBackground)};
}

// weight 0..256 of `over` on `under`.
Rgb blend(Rgb under, Rgb over, unsigned weight) {
  for (std::size_t c = 0; c < 3; ++c) {
    under[c] = static_cast<std::uint8_t>((under[c] * (256 - weight) + over[c] * weight) / 256);
  }
  return under;
}

}  // namespace

Image picture_of_hits(const HitCount& hits) {
  return picture_of_counts(hits.count(), hits.width(), hits.height());
}

Image picture_of_counts(const std::vector<std::uint8_t>& counts, int width, int height) {
  // One to eight: blue, teal, green, yellow, orange, red, pink, white.
  constexpr std::array<Rgb, 8> kRamp{{{58, 82, 139},
                                      {33, 144, 141},
                                      {93, 201, 99},
                                      {253, 231, 37},
                                      {251, 155, 6},
                                      {227, 47, 39},
                                      {233, 120, 190},
                                      {255, 255, 255}}};
  Image image = blank(width, height);
  for (std::size_t i = 0; i < image.pixel.size(); ++i) {
    const unsigned count = counts[i];
    if (count != 0) image.pixel[i] = kRamp[std::min(count, 8u) - 1];
  }
  return image;
}

Image picture_of_depth(const std::vector<std::uint32_t>& depth, int width, int height,
                       std::uint32_t far) {
  std::uint32_t nearest = far;
  std::uint32_t farthest = 0;
  for (const std::uint32_t d : depth) {
    if (d == far) continue;
    nearest = std::min(nearest, d);
    farthest = std::max(farthest, d);
  }
  Image image = blank(width, height);
  const double range = std::max(1.0, static_cast<double>(farthest) - static_cast<double>(nearest));
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (depth[i] == far) continue;
    const double t = static_cast<double>(depth[i] - nearest) / range;
    const auto grey = static_cast<std::uint8_t>(std::lround(245.0 - 190.0 * t));
    image.pixel[i] = {grey, grey, grey};
  }
  return image;
}

TilePicture::TilePicture(int width, int height, const Config& config)
    : config_(config),
      width_(width),
      height_(height),
      columns_((width + config.grid() - 1) >> config.grid_log2),
      nodes_(static_cast<std::size_t>(config.levels())) {
  const int rows = (height + config.grid() - 1) >> config.grid_log2;
  leaves_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows));
  for (std::size_t level = 0; level < nodes_.size(); ++level) {
    const auto side = static_cast<std::size_t>(1) << (config.grid_log2 * static_cast<int>(level));
    nodes_[level].resize(side * side);
  }
}

void TilePicture::visit(const Node& node, int level, bool covered) {
  const int side = config_.node_log2(level);
  const int columns = config_.grid_log2 * level;
  const auto x = static_cast<std::size_t>(node.x >> side);
  const auto y = static_cast<std::size_t>(node.y >> side);
  if (level != config_.levels() - 1) {
    nodes_[static_cast<std::size_t>(level)][(y << columns) + x] = true;
    return;
  }
  Leaf& leaf = leaves_[y * static_cast<std::size_t>(columns_) + x];
  ++(covered ? leaf.covered : leaf.empty);
}

Image TilePicture::image() const {
  Image image = blank(width_, height_);
  const auto strength = [](std::uint32_t visits) {
    return visits == 0 ? 0u : std::min(230u, 60u + 30u * visits);
  };
  const auto pixels = [&](int x0, int y0, int side, auto&& paint) {
    for (int y = y0; y < std::min(y0 + side, height_); ++y) {
      for (int x = x0; x < std::min(x0 + side, width_); ++x) {
        paint(image.at(x, y), x == x0 || y == y0);
      }
    }
  };
  const int grid = config_.grid();
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    const Leaf& leaf = leaves_[i];
    if (leaf.covered + leaf.empty == 0) continue;
    const int column = static_cast<int>(i) % columns_;
    const int row = static_cast<int>(i) / columns_;
    pixels(column * grid, row * grid, grid, [&](Rgb& pixel, bool border) {
      pixel = blend(pixel, {52, 199, 110}, strength(leaf.covered));
      pixel = blend(pixel, {235, 64, 52}, strength(leaf.empty));
      if (border) pixel = blend(pixel, kBackground, 110);
    });
  }
  // Outlines from the leaves' parents up, so that coarser nodes stay on top.
  for (int level = config_.levels() - 2; level >= 0; --level) {
    const int side = config_.node_log2(level);
    const int columns = config_.grid_log2 * level;
    const unsigned whiten = static_cast<unsigned>(config_.levels() - 2 - level) * 110u;
    const Rgb line = blend({240, 200, 60}, {255, 255, 255}, std::min(whiten, 256u));
    const std::vector<bool>& visited = nodes_[static_cast<std::size_t>(level)];
    for (std::size_t i = 0; i < visited.size(); ++i) {
      if (!visited[i]) continue;
      const int x = static_cast<int>(i & ((std::size_t{1} << columns) - 1)) << side;
      const int y = static_cast<int>(i >> columns) << side;
      const int right = x + (1 << side);
      const int bottom = y + (1 << side);
      for (int p = y; p < std::min(bottom, height_); ++p) {
        for (const int q : {x, right - 1}) {
          if (q < width_) image.at(q, p) = blend(image.at(q, p), line, 170);
        }
      }
      for (int p = x; p < std::min(right, width_); ++p) {
        for (const int q : {y, bottom - 1}) {
          if (q < height_) image.at(p, q) = blend(image.at(p, q), line, 170);
        }
      }
    }
  }
  return image;
}

Image contact_sheet(const std::vector<Image>& images) {
  if (images.size() == 1) return images.front();
  int cell_width = 1;
  int cell_height = 1;
  for (const Image& image : images) {
    cell_width = std::max(cell_width, image.width + 2);
    cell_height = std::max(cell_height, image.height + 2);
  }
  const auto count = static_cast<int>(images.size());
  const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
  const int rows = (count + columns - 1) / columns;
  Image sheet = blank(columns * cell_width, rows * cell_height);
  std::fill(sheet.pixel.begin(), sheet.pixel.end(), Rgb{70, 72, 80});
  for (int i = 0; i < count; ++i) {
    const Image& image = images[static_cast<std::size_t>(i)];
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        sheet.at(i % columns * cell_width + 1 + x, i / columns * cell_height + 1 + y) =
            image.pixel[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(x)];
      }
    }
  }
  return sheet;
}

}  // namespace halfspace
