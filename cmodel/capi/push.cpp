// SPDX-License-Identifier: Apache-2.0
//
// Triangles in: checked here, so that no stage ever sees one beyond its contract.
#include <algorithm>
#include <bit>
#include <cmath>

#include "files.hpp"

namespace halfspace::capi {
namespace {

// Triangles that the engine takes together.
constexpr std::size_t kBatch = 1024;

[[noreturn]] void out_of_range(const std::string& what, const std::string& value, std::int64_t low,
                               std::int64_t high) {
  throw Refusal(HS_ERROR_RANGE, what + " = " + value + " is out of range (" + std::to_string(low) +
                                    ".." + std::to_string(high) + ")");
}

std::int64_t tag_max(const Config& config) { return (std::int64_t{1} << config.tag_bits) - 1; }

void check_tag(std::uint32_t tag, const Config& config) {
  if (tag > tag_max(config)) out_of_range("tag", std::to_string(tag), 0, tag_max(config));
}

std::int32_t checked(std::int64_t value, int index, const Config& config) {
  if (value < config.coordinate_min() || value > config.coordinate_max()) {
    const std::string name =
        std::string(index % 2 == 0 ? "x" : "y") + std::to_string(index / 2) + " (subpixels)";
    out_of_range(name, std::to_string(value), config.coordinate_min(), config.coordinate_max());
  }
  return static_cast<std::int32_t>(value);
}

// White, at half depth.
ShadedTriangle plain(const std::array<std::int64_t, 6>& xy, std::uint32_t tag,
                     const Config& config) {
  ShadedTriangle out;
  out.triangle.tag = tag;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(2 * i);
    out.triangle.vertex[at / 2] = {checked(xy[at], 2 * i, config),
                                   checked(xy[at + 1], 2 * i + 1, config)};
  }
  check_extent(out.triangle, config);
  VertexAttributes vertex;
  vertex.depth = 1 << (kPlaneBits - 1);
  vertex.inverse_w = 1u << (config.inverse_w_bits - 1);
  for (int i = 0; i < config.attributes; ++i) {
    vertex.value[static_cast<std::size_t>(i)] = 255 << kAttributeFractionBits;
  }
  out.attributes.fill(vertex);
  return out;
}

ShadedTriangle plain(const std::int32_t* xy, std::uint32_t tag, const Config& config) {
  std::array<std::int64_t, 6> wide{};
  std::copy(xy, xy + 6, wide.begin());
  return plain(wide, tag, config);
}

// Bits of hs_vertex::depth.
int depth_bits(const Config& config) { return std::min(config.depth_bits + 6, 32); }

VertexAttributes checked(const hs_vertex& vertex, const Config& config) {
  const int bits = depth_bits(config);
  const std::int64_t depth_max = (std::int64_t{1} << bits) - 1;
  const std::int64_t w_max = (std::int64_t{1} << config.inverse_w_bits) - 1;
  constexpr int kValueMax = 255 << kAttributeFractionBits;
  if (vertex.depth > depth_max) out_of_range("depth", std::to_string(vertex.depth), 0, depth_max);
  if (vertex.inverse_w < 1 || vertex.inverse_w > w_max) {
    out_of_range("inverse_w", std::to_string(vertex.inverse_w), 1, w_max);
  }
  VertexAttributes out;
  const std::int64_t depth = vertex.depth;
  out.depth = static_cast<std::int32_t>(
      bits <= kPlaneBits ? depth << (kPlaneBits - bits)
                         : (depth + (1 << (bits - kPlaneBits - 1))) >> (bits - kPlaneBits));
  out.inverse_w = vertex.inverse_w;
  for (std::size_t i = 0; i < static_cast<std::size_t>(config.attributes); ++i) {
    if (vertex.value[i] > kValueMax) {
      out_of_range("value[" + std::to_string(i) + "]", std::to_string(vertex.value[i]), 0,
                   kValueMax);
    }
    out.value[i] = vertex.value[i];
  }
  return out;
}

// 1/w counts only by its ratios, and planes have a fixed precision: the greatest gets its top bit.
void normalize_inverse_w(ShadedTriangle& triangle, const Config& config) {
  std::uint32_t any = 0;
  for (const VertexAttributes& vertex : triangle.attributes) any |= vertex.inverse_w;
  const int up = std::countl_zero(any) - (32 - config.inverse_w_bits);
  for (VertexAttributes& vertex : triangle.attributes) vertex.inverse_w <<= up;
}

// Counts and draws, and forgets what it drew.
void flush(Frame& frame, std::vector<ShadedTriangle>& batch, std::size_t* pushed) {
  GeometryStats in;
  in.triangles_in = batch.size();
  frame.draw(batch);
  frame.count_in(in);
  if (pushed != nullptr) *pushed += batch.size();
  batch.clear();
}

void draw_one(Frame& frame, const ShadedTriangle& triangle) {
  std::vector<ShadedTriangle> one{triangle};
  flush(frame, one, nullptr);
}

}  // namespace
}  // namespace halfspace::capi

using namespace halfspace;
using namespace halfspace::capi;

hs_status hs_push_triangle(hs_model* model, const int32_t xy[6], uint32_t tag) {
  return call([&] {
    Frame& frame = frame_of(model);
    require_pointer(xy, "xy");
    check_tag(tag, model->config);
    draw_one(frame, plain(xy, tag, model->config));
    return HS_OK;
  });
}

hs_status hs_push_triangles(hs_model* model, const int32_t* xy, size_t count, uint32_t first_tag,
                            size_t* pushed) {
  if (pushed != nullptr) *pushed = 0;
  return call([&] {
    Frame& frame = frame_of(model);
    if (count != 0) require_pointer(xy, "xy");
    check_tag(first_tag, model->config);
    const auto mask = static_cast<std::uint32_t>(tag_max(model->config));
    std::vector<ShadedTriangle> batch;
    batch.reserve(std::min(count, kBatch));
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t tag = (first_tag + static_cast<std::uint32_t>(i)) & mask;
      try {
        batch.push_back(plain(xy + 6 * i, tag, model->config));
      } catch (const Refusal& refusal) {
        flush(frame, batch, pushed);
        throw Refusal(refusal.status(), "triangle " + std::to_string(i) + ": " + refusal.what());
      }
      if (batch.size() == kBatch) flush(frame, batch, pushed);
    }
    flush(frame, batch, pushed);
    return HS_OK;
  });
}

hs_status hs_push_triangle_px(hs_model* model, const double xy[6], uint32_t tag) {
  return call([&] {
    Frame& frame = frame_of(model);
    require_pointer(xy, "xy");
    check_tag(tag, model->config);
    std::array<std::int64_t, 6> snapped{};
    for (std::size_t i = 0; i < 6; ++i) {
      require(std::isfinite(xy[i]), HS_ERROR_RANGE, "a coordinate is not finite");
      snapped[i] = snap(xy[i], model->config);
    }
    draw_one(frame, plain(snapped, tag, model->config));
    return HS_OK;
  });
}

hs_status hs_push_shaded(hs_model* model, const hs_vertex vertex[3], uint32_t tag) {
  return call([&] {
    Frame& frame = frame_of(model);
    require_pointer(vertex, "vertex");
    check_tag(tag, model->config);
    std::array<std::int64_t, 6> xy{};
    for (std::size_t i = 0; i < 3; ++i) {
      xy[2 * i] = vertex[i].x;
      xy[2 * i + 1] = vertex[i].y;
    }
    ShadedTriangle triangle = plain(xy, tag, model->config);
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.attributes[i] = checked(vertex[i], model->config);
    }
    normalize_inverse_w(triangle, model->config);
    draw_one(frame, triangle);
    return HS_OK;
  });
}

hs_status hs_push_clip(hs_model* model, const hs_clip_vertex vertex[3], uint32_t tag) {
  return call([&] {
    Frame& frame = frame_of(model);
    require_pointer(vertex, "vertex");
    check_tag(tag, model->config);
    std::array<ClipVertex, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      const double* p = vertex[i].position;
      triangle[i].position = {p[0], p[1], p[2], p[3]};
      std::copy(vertex[i].value, vertex[i].value + kMaxAttributes, triangle[i].attribute.begin());
    }
    frame.draw_clip(triangle, tag);
    return HS_OK;
  });
}

hs_status hs_draw_scene(hs_model* model, const char* path, const hs_camera* camera) {
  return call([&] {
    Frame& frame = frame_of(model);
    require_pointer(path, "path");
    if constexpr (kHasFiles) {
      draw_scene(frame, model->config, path, camera);
      return HS_OK;
    } else {
      return failed(HS_ERROR_UNSUPPORTED, "this build reads no scenes (HALFSPACE_CLI=OFF)");
    }
  });
}
