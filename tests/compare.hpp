// SPDX-License-Identifier: Apache-2.0
//
// The model's masks against the oracle's, tile by tile. A failure names the triangle, the
// configuration, the pixel, the sample and both values.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "config.hpp"
#include "hit_count.hpp"
#include "oracle/oracle.hpp"
#include "rasterizer.hpp"
#include "vectors/generators.hpp"

namespace halfspace {

inline oracle::Corners corners_px(const Triangle& triangle, const Config& config) {
  oracle::Corners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = {std::ldexp(triangle.vertex[i].x, -config.subpixel_bits),
                  std::ldexp(triangle.vertex[i].y, -config.subpixel_bits)};
  }
  return corners;
}

inline std::string describe(const Config& c) {
  std::ostringstream out;
  out << "s=" << c.subpixel_bits << " n=" << c.viewport_bits << " k=" << c.guard_bits
      << " samples=" << c.samples << " g=" << c.grid_log2;
  return out.str();
}

inline std::string describe(const Triangle& triangle, const FrameState& frame, const Config& c) {
  std::ostringstream out;
  for (const Point p : triangle.vertex) out << "(" << p.x << "," << p.y << ") ";
  out << "subpixels, frame " << frame.width << "x" << frame.height << ", " << describe(c);
  return out.str();
}

// What the oracle says of one tile: samples outside the frame belong to nobody.
inline CoverageTile oracle_tile(const oracle::Corners& corners, int x, int y,
                                const FrameState& frame, const Config& config) {
  const auto samples = oracle::standard_samples(config.samples);
  CoverageTile tile{x, y, {}, 0};
  for (int bit = 0; bit < config.lanes(); ++bit) {
    const int px = x + bit % config.grid();
    const int py = y + bit / config.grid();
    if (px >= frame.width || py >= frame.height) continue;
    const std::uint32_t pixel = oracle::pixel_mask(corners, px, py, samples);
    for (std::size_t m = 0; m < samples.size(); ++m) {
      tile.mask[m] |= GridMask{pixel >> m & 1u} << bit;
    }
  }
  return tile;
}

// The leaf node at (x, y), reached down the pyramid from the root; nothing when a node on the way
// is not live. No other node is computed.
inline std::optional<Node> model_leaf(const SetupTriangle& setup, int x, int y,
                                      const Config& config) {
  Node node = root_node(setup);
  for (int level = 0; level + 1 < config.levels(); ++level) {
    const int child_log2 = config.node_log2(level + 1);
    const int i = (x - node.x) >> child_log2;
    const int j = (y - node.y) >> child_log2;
    const int bit = j * config.grid() + i;
    if ((live_children(node, level, setup, config) >> bit & 1u) == 0) return std::nullopt;
    node = child_node(node, level, bit, setup, config);
  }
  return node;
}

// The model's masks of that tile, without its tag; empty when it is not reached.
inline CoverageTile model_tile(const SetupTriangle& setup, int x, int y, const Config& config) {
  const std::optional<Node> leaf = model_leaf(setup, x, y, config);
  const CoverageTile none{x, y, {}, 0};
  CoverageTile tile = leaf ? coverage(*leaf, setup, config).value_or(none) : none;
  tile.tag = 0;
  return tile;
}

inline ::testing::AssertionResult same_masks(const CoverageTile& model, const CoverageTile& truth,
                                             const Config& config) {
  for (std::size_t m = 0; m < model.mask.size(); ++m) {
    const GridMask wrong = model.mask[m] ^ truth.mask[m];
    if (wrong == 0) continue;
    const int bit = std::countr_zero(wrong);
    return ::testing::AssertionFailure()
           << "pixel (" << truth.x + bit % config.grid() << "," << truth.y + bit / config.grid()
           << ") sample " << m << ": model " << (model.mask[m] >> bit & 1u) << ", oracle "
           << (truth.mask[m] >> bit & 1u) << "; masks " << std::hex << model.mask[m] << " and "
           << truth.mask[m];
  }
  return ::testing::AssertionSuccess();
}

// Every sample of the frame against the oracle: tiles within two pixels of the vertices' bounding
// box one by one, and no tile anywhere else.
inline ::testing::AssertionResult exact(const Triangle& triangle, const FrameState& frame,
                                        const Config& config) {
  std::map<std::pair<int, int>, CoverageTile> drawn;
  RasterStats stats;
  bool again = false;
  rasterize(triangle, frame, config, stats, [&](const CoverageTile& tile) {
    CoverageTile untagged = tile;
    untagged.tag = 0;
    again = !drawn.emplace(std::pair{tile.x, tile.y}, untagged).second || again;
  });
  const std::string what = describe(triangle, frame, config);
  if (again) return ::testing::AssertionFailure() << "a tile came twice: " << what;
  const oracle::Corners corners = corners_px(triangle, config);
  const auto [x_min, x_max] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
  const auto [y_min, y_max] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
  const int grid = config.grid();
  const auto first = [grid](double v) {
    return std::max(0, static_cast<int>(v) - 2) / grid * grid;
  };
  const auto last = [](double v, int size) { return std::min(static_cast<int>(v) + 2, size - 1); };
  for (int y = first(y_min); y <= last(y_max, frame.height); y += grid) {
    for (int x = first(x_min); x <= last(x_max, frame.width); x += grid) {
      const auto found = drawn.find({x, y});
      const CoverageTile model = found == drawn.end() ? CoverageTile{x, y, {}, 0} : found->second;
      const auto same = same_masks(model, oracle_tile(corners, x, y, frame, config), config);
      if (!same) return ::testing::AssertionFailure() << same.message() << ": " << what;
      if (found != drawn.end()) drawn.erase(found);
    }
  }
  if (!drawn.empty()) return ::testing::AssertionFailure() << "a tile far outside: " << what;
  return ::testing::AssertionSuccess();
}

// Tiles that a mistake would show in: on and beside the edges, at the vertices, in the box, and
// anywhere in the frame.
inline std::vector<std::pair<int, int>> telling_tiles(Random& random, const Triangle& triangle,
                                                      const FrameState& frame, const Config& config,
                                                      int count) {
  const oracle::Corners corners = corners_px(triangle, config);
  std::vector<std::pair<int, int>> tiles;
  for (int i = 0; i < 8 * count && static_cast<int>(tiles.size()) < count; ++i) {
    const oracle::Vec a = corners[static_cast<std::size_t>(i % 3)];
    const oracle::Vec b = corners[static_cast<std::size_t>((i + 1) % 3)];
    // Towards a with every doubling of the denominator: long edges cross the frame near an end.
    const double part = std::ldexp(static_cast<double>(random.in(0, 1 << 20)), -20 - i % 4 * 4);
    const double x = a.x + (b.x - a.x) * part + static_cast<double>(random.in(-3, 3));
    const double y = a.y + (b.y - a.y) * part + static_cast<double>(random.in(-3, 3));
    const bool inside = x >= 0 && y >= 0 && x < frame.width && y < frame.height;
    const int mask = -config.grid();
    if (inside) tiles.emplace_back(static_cast<int>(x) & mask, static_cast<int>(y) & mask);
    if (i % 8 == 7) {
      const auto row = static_cast<int>(random.in(0, frame.height - 1));
      const auto column = static_cast<int>(random.in(0, frame.width - 1));
      tiles.emplace_back(column & mask, row & mask);
    }
  }
  return tiles;
}

// The same as exact(), at `count` telling tiles only: for frames too large to test whole.
inline ::testing::AssertionResult exact_at_telling_tiles(Random& random, const Triangle& triangle,
                                                         const FrameState& frame,
                                                         const Config& config, int count) {
  const oracle::Corners corners = corners_px(triangle, config);
  const auto setup = triangle_setup(triangle, frame, config);
  for (const auto& [x, y] : telling_tiles(random, triangle, frame, config, count)) {
    const CoverageTile model = setup ? model_tile(*setup, x, y, config) : CoverageTile{x, y, {}, 0};
    const auto same = same_masks(model, oracle_tile(corners, x, y, frame, config), config);
    if (!same) {
      return ::testing::AssertionFailure()
             << same.message() << ": " << describe(triangle, frame, config);
    }
  }
  return ::testing::AssertionSuccess();
}

// The model's picture of how many triangles cover each pixel.
inline HitCount model_hits(const std::vector<Triangle>& triangles, const FrameState& frame,
                           const Config& config) {
  HitCount hits(frame.width, frame.height);
  RasterStats stats;
  for (const Triangle& triangle : triangles) {
    rasterize(triangle, frame, config, stats,
              [&](const CoverageTile& tile) { hits.add(tile, config); });
  }
  return hits;
}

// The oracle's.
inline std::vector<std::uint8_t> oracle_hits(const std::vector<Triangle>& triangles,
                                             const FrameState& frame, const Config& config) {
  std::vector<oracle::Corners> corners;
  for (const Triangle& triangle : triangles) corners.push_back(corners_px(triangle, config));
  return oracle::hit_count(corners, frame.width, frame.height,
                           oracle::standard_samples(config.samples));
}

// Both pictures are equal; the first pixel that differs otherwise.
inline ::testing::AssertionResult same_hits(const HitCount& model,
                                            const std::vector<std::uint8_t>& truth) {
  const auto [mine, other] =
      std::mismatch(model.count().begin(), model.count().end(), truth.begin(), truth.end());
  if (mine == model.count().end()) return ::testing::AssertionSuccess();
  const auto index = mine - model.count().begin();
  return ::testing::AssertionFailure()
         << "pixel (" << index % model.width() << "," << index / model.width() << "): model "
         << int{*mine} << ", oracle " << int{*other};
}

}  // namespace halfspace
