// SPDX-License-Identifier: Apache-2.0
//
// The Python module `halfspace`: halfspace.h with NumPy arrays. Page: docs/02_use/python.md.
#include "model.hpp"

using halfspace_python::Model;
namespace py = pybind11;
using py::literals::operator""_a;

PYBIND11_MODULE(halfspace, module) {
  module.doc() = "The Halfspace rasterizer model: triangles in, coverage, depth and clocks out.";
  module.attr("__version__") = hs_version();
  PYBIND11_NUMPY_DTYPE(hs_tile, x, y, tag, samples, clock, triangle, mask);
  PYBIND11_NUMPY_DTYPE(hs_fragment, x, y, tag, covered, passed, color, depth);
  PYBIND11_NUMPY_DTYPE(hs_triangle_clocks, accepted, setup);
  module.def("stall_gap", hs_stall_gap, "probability"_a, "seed"_a, "triangle"_a,
             "Clocks that the source waits before it offers a triangle.");
  module.def(
      "stall_ready",
      [](double p, std::uint64_t seed, std::uint64_t clock) {
        return hs_stall_ready(p, seed, clock) != 0;
      },
      "probability"_a, "seed"_a, "clock"_a, "Whether a tile is taken at a clock.");
  module.attr("NEVER") = py::int_(HS_NEVER);
  py::class_<Model>(module, "Model", "A rasterizer of one configuration.")
      .def(py::init<std::string>(), "config"_a = "full",
           "A preset (tiny, full, d3d, msaa4) or a configuration in JSON.")
      .def_property_readonly("config", &Model::config, "Free values and derived widths.")
      .def("begin_frame", &Model::begin_frame, "width"_a, "height"_a, py::kw_only(),
           "cull"_a = "none", "depth_test"_a = "less", "tiles"_a = true, "fragments"_a = false,
           "picture"_a = true, "stall"_a = 0.0, "seed"_a = 0,
           "background"_a = std::array<std::uint8_t, 3>{}, "depth_clear"_a = py::none(),
           "scissor"_a = py::none(),
           "Start an empty frame at clock 0. tiles, fragments, picture: what to keep for reading.")
      .def("reset", &Model::reset, "Start the same frame again.")
      .def("push", &Model::push, "triangles"_a, "tag"_a = 0,
           "Draw triangles, shape (N, 3, 2): integers in subpixels, real numbers in pixels.")
      .def("push_clip", &Model::push_clip, "positions"_a, "values"_a = py::none(), "tag"_a = 0,
           "Clip, project and draw triangles: positions (N, 3, 4), x y z w; values (N, 3, K), 0 to "
           "255, white when there are none.")
      .def("push_shaded", &Model::push_shaded, "xy"_a, "depth"_a, "inverse_w"_a, "values"_a,
           "tag"_a = 0,
           "Draw triangles as the hardware gets them, all integers: xy (N, 3, 2) in subpixels, "
           "depth and inverse_w (N, 3), values (N, 3, K) in 1/256; halfspace.h has the units.")
      .def("draw_scene", &Model::draw_scene, "path"_a, py::kw_only(), "eye"_a = py::none(),
           "target"_a = py::none(), "up"_a = py::none(), "fov"_a = py::none(),
           "ortho"_a = py::none(), "flat"_a = false, "Draw a mesh file as `halfspace render`.")
      .def("hits", &Model::hits, "Triangles per pixel, (height, width), at most 255.")
      .def("depth", &Model::depth, "Depth of sample 0, (height, width).")
      .def("color", &Model::color, "Red, green, blue, (height, width, 3).")
      .def("pull_tiles", &Model::pull_tiles,
           "Tiles since the last call, in hardware order: a structured array with the fields x, y, "
           "tag, samples, clock, triangle, mask.")
      .def(
          "pull_fragments", &Model::pull_fragments,
          "Fragments since the last call, in hardware order: a structured array with the fields x, "
          "y, tag, covered, passed, color, depth.")
      .def("triangle_clocks", &Model::triangle_clocks,
           "The clocks at which each triangle was accepted and left setup (NEVER: dropped).")
      .def("stats", &Model::stats, "Counts of the frame so far.");
}
