// SPDX-License-Identifier: Apache-2.0
//
// The Python module `halfspace`: halfspace.h with NumPy arrays. Page: docs/02_use/python.md.
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

#include "halfspace.h"

namespace py = pybind11;
using py::literals::operator""_a;

namespace {

using Integers = py::array_t<std::int64_t, py::array::c_style>;
using Reals = py::array_t<double, py::array::c_style | py::array::forcecast>;

[[noreturn]] void refuse(PyObject* kind, const std::string& text) {
  PyErr_SetString(kind, text.c_str());
  throw py::error_already_set();
}

// Bad values are ValueError, files OSError, the wrong order RuntimeError.
void check(hs_status status) {
  switch (status) {
    case HS_OK:
    case HS_EMPTY: return;
    case HS_ERROR_FILE: refuse(PyExc_OSError, hs_last_error());
    case HS_ERROR_MEMORY: refuse(PyExc_MemoryError, hs_last_error());
    case HS_ERROR_ORDER:
    case HS_ERROR_UNSUPPORTED:
    case HS_ERROR_INTERNAL: refuse(PyExc_RuntimeError, hs_last_error());
    default: refuse(PyExc_ValueError, hs_last_error());
  }
}

// N triangles from an array of shape (N, 3, 2) or (3, 2).
template <class Array>
py::ssize_t triangle_count(const Array& array) {
  const bool one = array.ndim() == 2 && array.shape(0) == 3 && array.shape(1) == 2;
  const bool many = array.ndim() == 3 && array.shape(1) == 3 && array.shape(2) == 2;
  if (!one && !many) refuse(PyExc_ValueError, "triangles must have the shape (N, 3, 2) or (3, 2)");
  return one ? 1 : array.shape(0);
}

template <class Value>
py::array_t<Value> picture(const std::vector<py::ssize_t>& shape) {
  return py::array_t<Value>(shape);
}

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
                   const std::string& depth_test, bool tiles, bool picture, double stall,
                   std::uint64_t seed, std::array<std::uint8_t, 3> background,
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
    frame.outputs = HS_COUNTS | HS_CLOCKS | (tiles ? HS_TILES : 0u) | (picture ? HS_PICTURE : 0u);
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

  // Integers are subpixels, real numbers pixels.
  void push(const py::array& triangles, std::uint32_t tag) {
    if (triangles.dtype().kind() == 'f') return push_pixels(Reals::ensure(triangles), tag);
    if (triangles.dtype().kind() != 'i' && triangles.dtype().kind() != 'u') {
      refuse(PyExc_TypeError, "triangles must be integers (subpixels) or real numbers (pixels)");
    }
    const Integers wide = Integers::ensure(triangles);
    const auto count = static_cast<std::size_t>(triangle_count(wide));
    std::vector<std::int32_t> xy(6 * count);
    for (std::size_t i = 0; i < xy.size(); ++i) {
      const std::int64_t value = wide.data()[i];
      if (value < INT32_MIN || value > INT32_MAX) {
        refuse(PyExc_ValueError, "triangle " + std::to_string(i / 6) + ": coordinate " +
                                     std::to_string(value) + " is out of range");
      }
      xy[i] = static_cast<std::int32_t>(value);
    }
    check(hs_push_triangles(model_.get(), xy.data(), count, tag, nullptr));
  }

  void draw_scene(const std::string& path) {
    check(hs_draw_scene(model_.get(), path.c_str(), nullptr));
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

  // A structured array; its fields are those of hs_tile.
  py::array_t<hs_tile> pull_tiles() {
    std::vector<hs_tile> all;
    std::vector<hs_tile> part(4096);
    std::size_t count = 0;
    do {
      check(hs_pull_tiles(model_.get(), part.data(), part.size(), &count));
      all.insert(all.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(count));
    } while (count != 0);
    return py::array_t<hs_tile>(static_cast<py::ssize_t>(all.size()), all.data());
  }

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
    const auto count = static_cast<std::size_t>(triangle_count(triangles));
    const std::uint32_t mask = 0xffffffffu >> (32 - tag_bits());
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t own = i == 0 ? tag : (tag + static_cast<std::uint32_t>(i)) & mask;
      const hs_status status = hs_push_triangle_px(model_.get(), triangles.data() + 6 * i, own);
      if (status == HS_ERROR_RANGE) {
        refuse(PyExc_ValueError, "triangle " + std::to_string(i) + ": " + hs_last_error());
      }
      check(status);
    }
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

}  // namespace

PYBIND11_MODULE(halfspace, module) {
  module.doc() = "The Halfspace rasterizer model: triangles in, coverage, depth and clocks out.";
  module.attr("__version__") = hs_version();
  PYBIND11_NUMPY_DTYPE(hs_tile, x, y, tag, samples, clock, triangle, mask);
  PYBIND11_NUMPY_DTYPE(hs_triangle_clocks, accepted, setup);
  module.attr("NEVER") = py::int_(HS_NEVER);
  py::class_<Model>(module, "Model", "A rasterizer of one configuration.")
      .def(py::init<std::string>(), "config"_a = "full",
           "A preset (tiny, full, d3d, msaa4) or a configuration in JSON.")
      .def_property_readonly("config", &Model::config, "Free values and derived widths.")
      .def("begin_frame", &Model::begin_frame, "width"_a, "height"_a, py::kw_only(),
           "cull"_a = "none", "depth_test"_a = "less", "tiles"_a = true, "picture"_a = true,
           "stall"_a = 0.0, "seed"_a = 0, "background"_a = std::array<std::uint8_t, 3>{},
           "depth_clear"_a = py::none(), "scissor"_a = py::none(),
           "Start an empty frame at clock 0. tiles, picture: what to keep for reading.")
      .def("push", &Model::push, "triangles"_a, "tag"_a = 0,
           "Draw triangles, shape (N, 3, 2): integers in subpixels, real numbers in pixels.")
      .def("draw_scene", &Model::draw_scene, "path"_a, "Draw a mesh file as `halfspace render`.")
      .def("hits", &Model::hits, "Triangles per pixel, (height, width), at most 255.")
      .def("depth", &Model::depth, "Depth of sample 0, (height, width).")
      .def("color", &Model::color, "Red, green, blue, (height, width, 3).")
      .def("pull_tiles", &Model::pull_tiles,
           "Tiles since the last call, in hardware order: a structured array with the fields x, y, "
           "tag, samples, clock, triangle, mask.")
      .def("triangle_clocks", &Model::triangle_clocks,
           "The clocks at which each triangle was accepted and left setup (NEVER: dropped).")
      .def("stats", &Model::stats, "Counts of the frame so far.");
}
