// SPDX-License-Identifier: Apache-2.0
//
// Results out.
#include <zlib.h>

#include <algorithm>

#include "model.hpp"

namespace halfspace::capi {
namespace {

// Moves what fits from the front of a queue.
template <class Item>
hs_status pull(std::deque<Item>& from, Item* to, std::size_t capacity, std::size_t* count) {
  const std::size_t moved = std::min(capacity, from.size());
  const auto end = from.begin() + static_cast<std::ptrdiff_t>(moved);
  std::copy(from.begin(), end, to);
  from.erase(from.begin(), end);
  *count = moved;
  return moved == 0 ? HS_EMPTY : HS_OK;
}

void require_size(std::size_t size, std::size_t needed) {
  if (size != needed) {
    throw Refusal(HS_ERROR_ARGUMENT,
                  "size = " + std::to_string(size) + ", not " + std::to_string(needed));
  }
}

std::size_t pixels(const Frame& frame) {
  return static_cast<std::size_t>(frame.state().width) *
         static_cast<std::size_t>(frame.state().height);
}

std::uint32_t coverage_crc(const Frame& frame) {
  const std::vector<std::uint8_t>& hits = frame.hits();
  return static_cast<std::uint32_t>(::crc32_z(0, hits.data(), hits.size()));
}

}  // namespace
}  // namespace halfspace::capi

using namespace halfspace;
using namespace halfspace::capi;

hs_status hs_pull_tiles(hs_model* model, hs_tile* tile, size_t capacity, size_t* count) {
  if (count != nullptr) *count = 0;
  return call([&] {
    Frame& frame = frame_of(model);
    require_pointer(tile, "tile");
    require_pointer(count, "count");
    require(frame.keeps(HS_TILES), HS_ERROR_ORDER, "the frame was begun without HS_TILES");
    return pull(frame.tiles(), tile, capacity, count);
  });
}

hs_status hs_pull_fragments(hs_model* model, hs_fragment* fragment, size_t capacity,
                            size_t* count) {
  if (count != nullptr) *count = 0;
  return call([&] {
    Frame& frame = frame_of(model);
    require_pointer(fragment, "fragment");
    require_pointer(count, "count");
    require(frame.keeps(HS_FRAGMENTS), HS_ERROR_ORDER, "the frame was begun without HS_FRAGMENTS");
    return pull(frame.fragments(), fragment, capacity, count);
  });
}

hs_status hs_get_stats(const hs_model* model, hs_stats* stats) {
  return call([&] {
    const Frame& frame = frame_of(model);
    hs_stats out = frame.stats();
    out.coverage_crc32 = coverage_crc(frame);
    write_struct(out, sizeof(hs_stats), stats, "stats");
    return HS_OK;
  });
}

hs_status hs_read_triangle_clocks(const hs_model* model, uint64_t first, size_t count,
                                  hs_triangle_clocks* clocks) {
  return call([&] {
    const Frame& frame = frame_of(model);
    if (count != 0) require_pointer(clocks, "clocks");
    require(frame.keeps(HS_CLOCKS), HS_ERROR_ORDER, "the frame was begun without HS_CLOCKS");
    const std::vector<hs_triangle_clocks>& all = frame.clocks();
    if (first > all.size() || count > all.size() - first) {
      throw Refusal(HS_ERROR_RANGE, "triangles " + std::to_string(first) + " + " +
                                        std::to_string(count) + " of " +
                                        std::to_string(all.size()));
    }
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
    std::copy(begin, begin + static_cast<std::ptrdiff_t>(count), clocks);
    return HS_OK;
  });
}

hs_status hs_read_hits(const hs_model* model, uint8_t* hits, size_t size) {
  return call([&] {
    const Frame& frame = frame_of(model);
    require_pointer(hits, "hits");
    require_size(size, pixels(frame));
    std::copy(frame.hits().begin(), frame.hits().end(), hits);
    return HS_OK;
  });
}

hs_status hs_read_depth(const hs_model* model, uint32_t* depth, size_t size) {
  return call([&] {
    const Frame& frame = frame_of(model);
    require_pointer(depth, "depth");
    require(frame.keeps(HS_PICTURE), HS_ERROR_ORDER, "the frame was begun without HS_PICTURE");
    require_size(size, pixels(frame));
    const std::vector<std::uint32_t> all = frame.rasterizer()->framebuffer().depth();
    std::copy(all.begin(), all.end(), depth);
    return HS_OK;
  });
}

hs_status hs_read_color(const hs_model* model, uint8_t* color, size_t size) {
  return call([&] {
    const Frame& frame = frame_of(model);
    require_pointer(color, "color");
    require(frame.keeps(HS_PICTURE), HS_ERROR_ORDER, "the frame was begun without HS_PICTURE");
    require_size(size, 3 * pixels(frame));
    const Image image = frame.rasterizer()->framebuffer().resolve();
    for (const Rgb& pixel : image.pixel) color = std::copy(pixel.begin(), pixel.end(), color);
    return HS_OK;
  });
}
