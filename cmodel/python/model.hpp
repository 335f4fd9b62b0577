// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "halfspace.h"

namespace halfspace_python {

using py::literals::operator""_a;

template <class Value>
py::array_t<Value> picture(const std::vector<py::ssize_t>& shape) {
  return py::array_t<Value>(shape);
}

// One hs_model, with arrays for pointers.
class Model {
 public:
  explicit Model(const std::string& config) {
    hs_model* model = nullptr;
    check(config.starts_with('{') ? hs_create_json(config.c_str(), &model)
                                  : hs_create_preset(config.c_str(), &model));
    model_.reset(model);
  }

  py::dict config() const {
    hs_info i{};
    i.struct_size = sizeof i;
    check(hs_get_info(model_.get(), &i));
    constexpr std::array kSnap{"nearest_even", "half_away", "truncate"};
    py::dict out;
    const std::pair<const char*, std::int32_t> values[] = {{"subpixel_bits", i.subpixel_bits},
                                                           {"viewport_bits", i.viewport_bits},
                                                           {"guard_bits", i.guard_bits},
                                                           {"extent_bits", i.extent_bits},
                                                           {"samples", i.samples},
                                                           {"grid_log2", i.grid_log2},
                                                           {"setup_interval", i.setup_interval},
                                                           {"tag_bits", i.tag_bits},
                                                           {"depth_bits", i.depth_bits},
                                                           {"attributes", i.attributes},
                                                           {"inverse_w_bits", i.inverse_w_bits},
                                                           {"gradient_bits", i.gradient_bits},
                                                           {"reciprocal_bits", i.reciprocal_bits},
                                                           {"grid", i.grid},
                                                           {"levels", i.levels},
                                                           {"max_size", i.max_size},
                                                           {"vertex_bits", i.vertex_bits},
                                                           {"delta_bits", i.delta_bits},
                                                           {"area_bits", i.area_bits},
                                                           {"edge_bits", i.edge_bits},
                                                           {"lane_bits", i.lane_bits},
                                                           {"root_bits", i.root_bits},
                                                           {"coordinate_min", i.coordinate_min},
                                                           {"coordinate_max", i.coordinate_max}};
    for (const auto& [name, value] : values) out[name] = value;
    out["snap"] = kSnap.at(static_cast<std::size_t>(i.snap));
    return out;
  }

  void begin_frame(std::int32_t width, std::int32_t height, const std::string& cull,
                   const std::string& depth_test, bool tiles, bool fragments, bool picture,
                   double stall, std::uint64_t seed, std::array<std::uint8_t, 3> background,
                   std::optional<std::uint32_t> depth_clear,
                   std::optional<std::array<std::int32_t, 4>> scissor) {
    hs_frame frame{};
    frame.struct_size = sizeof frame;
    frame.width = width;
    frame.height = height;
    frame.cull = choice("cull", cull, {"none", "back", "front"});
    frame.depth_function = choice("depth_test", depth_test,
                                  {"less", "less_equal", "always", "never", "equal", "greater",
                                   "greater_equal", "not_equal"});
    frame.outputs = HS_COUNTS | HS_CLOCKS | (tiles ? HS_TILES : 0u) |
                    (fragments ? HS_FRAGMENTS : 0u) | (picture ? HS_PICTURE : 0u);
    frame.stall_probability = stall;
    frame.stall_seed = seed;
    std::memcpy(frame.background, background.data(), 3);
    if (depth_clear) {
      frame.flags |= HS_DEPTH_CLEAR;
      frame.depth_clear = *depth_clear;
    }
    if (scissor) {
      frame.flags |= HS_SCISSOR;
      std::copy(scissor->begin(), scissor->end(), frame.scissor);
    }
    check(hs_begin_frame(model_.get(), &frame));
    frame_ = frame;
  }

  // The same frame from its start.
  void reset() { check(hs_reset(model_.get())); }

  // Integers are subpixels, real numbers pixels.
  void push(const py::array& triangles, std::uint32_t tag) {
    if (triangles.dtype().kind() == 'f') return push_pixels(Reals::ensure(triangles), tag);
    const Integers wide = integers(triangles, "triangles that are not real numbers (pixels)");
    const std::size_t count = triangle_count(wide, "triangles", 2);
    std::vector<std::int32_t> xy(6 * count);
    for (std::size_t i = 0; i < xy.size(); ++i) {
      xy[i] = narrowed<std::int32_t>(wide.data()[i], i / 6, "coordinate");
    }
    check(hs_push_triangles(model_.get(), xy.data(), count, tag, nullptr));
  }

  // positions: x, y, z, w; values: 0..255, white when there are none.
  void push_clip(const Reals& positions, const std::optional<Reals>& values, std::uint32_t tag) {
    const std::size_t count = triangle_count(positions, "positions", 4);
    const std::size_t width = values ? value_count(*values, count) : 0;
    for (std::size_t i = 0; i < count; ++i) {
      std::array<hs_clip_vertex, 3> vertex{};
      for (std::size_t v = 0; v < 3; ++v) {
        std::memcpy(vertex[v].position, positions.data() + 4 * (3 * i + v), 4 * sizeof(double));
        for (std::size_t k = 0; k < 8; ++k) {
          vertex[v].value[k] = !values     ? 255.0
                               : k < width ? values->data()[width * (3 * i + v) + k]
                                           : 0.0;
        }
      }
      check(hs_push_clip(model_.get(), vertex.data(), tag_of(tag, i)), triangle_text(i));
    }
  }

  // Vertices as the hardware gets them: halfspace.h, hs_vertex.
  void push_shaded(const py::array& xy, const py::array& depth, const py::array& inverse_w,
                   const py::array& values, std::uint32_t tag) {
    const Integers p = integers(xy, "xy"), d = integers(depth, "depth");
    const Integers w = integers(inverse_w, "inverse_w"), a = integers(values, "values");
    const std::size_t count = triangle_count(p, "xy", 2);
    const std::size_t width = value_count(a, count);
    if (triangle_count(d, "depth", 0) != count || triangle_count(w, "inverse_w", 0) != count) {
      refuse(PyExc_ValueError, "depth and inverse_w are of another number of triangles");
    }
    for (std::size_t i = 0; i < count; ++i) {
      std::array<hs_vertex, 3> vertex{};
      for (std::size_t v = 0; v < 3; ++v) {
        const std::size_t at = 3 * i + v;
        vertex[v].x = narrowed<std::int32_t>(p.data()[2 * at], i, "x");
        vertex[v].y = narrowed<std::int32_t>(p.data()[2 * at + 1], i, "y");
        vertex[v].depth = narrowed<std::uint32_t>(d.data()[at], i, "depth");
        vertex[v].inverse_w = narrowed<std::uint32_t>(w.data()[at], i, "inverse_w");
        for (std::size_t k = 0; k < width; ++k) {
          vertex[v].value[k] = narrowed<std::uint16_t>(a.data()[width * at + k], i, "value");
        }
      }
      check(hs_push_shaded(model_.get(), vertex.data(), tag_of(tag, i)), triangle_text(i));
    }
  }

  using Vector = std::optional<std::array<double, 3>>;
  void draw_scene(const std::string& path, const Vector& eye, const Vector& target,
                  const Vector& up, std::optional<double> fov, std::optional<double> ortho,
                  bool flat) {
    hs_camera camera{};
    camera.struct_size = sizeof camera;
    const auto take = [&camera](const Vector& from, double(&to)[3], std::uint32_t flag) {
      if (!from) return;
      std::copy(from->begin(), from->end(), to);
      camera.flags |= flag;
    };
    take(eye, camera.eye, HS_CAMERA_EYE);
    take(target, camera.target, HS_CAMERA_TARGET);
    take(up, camera.up, HS_CAMERA_UP);
    camera.fov_y_degrees = fov.value_or(0);
    camera.ortho_height = ortho.value_or(0);
    camera.flags |= (fov ? HS_CAMERA_FOV : 0u) | (ortho ? HS_CAMERA_ORTHO : 0u) |
                    (flat ? HS_CAMERA_FLAT_LIGHT : 0u);
    check(hs_draw_scene(model_.get(), path.c_str(), &camera));
  }

  py::array_t<std::uint8_t> hits() const {
    auto out = picture<std::uint8_t>({frame_.height, frame_.width});
    check(hs_read_hits(model_.get(), out.mutable_data(), static_cast<std::size_t>(out.size())));
    return out;
  }
  py::array_t<std::uint32_t> depth() const {
    auto out = picture<std::uint32_t>({frame_.height, frame_.width});
    check(hs_read_depth(model_.get(), out.mutable_data(), static_cast<std::size_t>(out.size())));
    return out;
  }
  py::array_t<std::uint8_t> color() const {
    auto out = picture<std::uint8_t>({frame_.height, frame_.width, 3});
    check(hs_read_color(model_.get(), out.mutable_data(), static_cast<std::size_t>(out.size())));
    return out;
  }

  // Structured arrays; their fields are those of hs_tile and hs_fragment.
  py::array_t<hs_tile> pull_tiles() { return pull_all<hs_tile>(hs_pull_tiles); }
  py::array_t<hs_fragment> pull_fragments() { return pull_all<hs_fragment>(hs_pull_fragments); }

  py::array_t<hs_triangle_clocks> triangle_clocks() const {
    const hs_stats counts = raw_stats();
    py::array_t<hs_triangle_clocks> out(static_cast<py::ssize_t>(counts.triangles));
    check(hs_read_triangle_clocks(model_.get(), 0, counts.triangles, out.mutable_data()));
    return out;
  }

  py::dict stats() const {
    const hs_stats s = raw_stats();
    return py::dict(
        "triangles"_a = s.triangles_in, "triangles_not_finite"_a = s.triangles_not_finite,
        "triangles_outside"_a = s.triangles_outside, "triangles_clipped"_a = s.triangles_clipped,
        "triangles_to_setup"_a = s.triangles, "triangles_zero_area"_a = s.triangles_zero_area,
        "triangles_face_culled"_a = s.triangles_culled,
        "triangles_no_sample"_a = s.triangles_no_sample, "tiles_visited"_a = s.tiles_visited,
        "tiles_covered"_a = s.tiles_covered, "samples_tested"_a = s.samples_tested,
        "samples_covered"_a = s.samples_covered, "fragments"_a = s.fragments,
        "fragments_shaded"_a = s.fragments_shaded, "cycles"_a = s.cycles,
        "coverage_crc32"_a = s.coverage_crc32);
  }

 private:
  struct Destroy {
    void operator()(hs_model* model) const { hs_destroy(model); }
  };

  static std::int32_t choice(const char* what, const std::string& name,
                             const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) return static_cast<std::int32_t>(i);
    }
    refuse(PyExc_ValueError, std::string(what) + " = '" + name + "' is unknown");
  }

  void push_pixels(const Reals& triangles, std::uint32_t tag) {
    const std::size_t count = triangle_count(triangles, "triangles", 2);
    for (std::size_t i = 0; i < count; ++i) {
      check(hs_push_triangle_px(model_.get(), triangles.data() + 6 * i, tag_of(tag, i)),
            triangle_text(i));
    }
  }

  template <class Item>
  py::array_t<Item> pull_all(hs_status (*pull)(hs_model*, Item*, std::size_t, std::size_t*)) {
    std::vector<Item> all;
    std::vector<Item> part(4096);
    std::size_t count = 0;
    do {
      check(pull(model_.get(), part.data(), part.size(), &count));
      all.insert(all.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(count));
    } while (count != 0);
    return py::array_t<Item>(static_cast<py::ssize_t>(all.size()), all.data());
  }

  // Of the triangle with that index; the first keeps what was asked for, to be refused if need be.
  std::uint32_t tag_of(std::uint32_t tag, std::size_t index) const {
    if (index == 0) return tag;
    return (tag + static_cast<std::uint32_t>(index)) & (0xffffffffu >> (32 - tag_bits()));
  }

  int tag_bits() const {
    hs_info info{};
    info.struct_size = sizeof info;
    check(hs_get_info(model_.get(), &info));
    return info.tag_bits;
  }

  hs_stats raw_stats() const {
    hs_stats stats{};
    stats.struct_size = sizeof stats;
    check(hs_get_stats(model_.get(), &stats));
    return stats;
  }

  std::unique_ptr<hs_model, Destroy> model_;
  hs_frame frame_{};
};

}  // namespace halfspace_python
