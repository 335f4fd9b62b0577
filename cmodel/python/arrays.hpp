// SPDX-License-Identifier: Apache-2.0
//
// What goes from NumPy to halfspace.h: arrays of known shape, and statuses as exceptions.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <limits>
#include <string>

#include "halfspace.h"

namespace halfspace_python {

namespace py = pybind11;

using Integers = py::array_t<std::int64_t, py::array::c_style>;
using Reals = py::array_t<double, py::array::c_style | py::array::forcecast>;

[[noreturn]] inline void refuse(PyObject* kind, const std::string& text) {
  PyErr_SetString(kind, text.c_str());
  throw py::error_already_set();
}

// Bad values are ValueError, files OSError, the wrong order RuntimeError. where: in front of what
// is wrong with a value.
inline void check(hs_status status, const std::string& where = "") {
  switch (status) {
    case HS_OK:
    case HS_EMPTY: return;
    case HS_ERROR_FILE: refuse(PyExc_OSError, hs_last_error());
    case HS_ERROR_MEMORY: refuse(PyExc_MemoryError, hs_last_error());
    case HS_ERROR_ORDER:
    case HS_ERROR_UNSUPPORTED:
    case HS_ERROR_INTERNAL: refuse(PyExc_RuntimeError, hs_last_error());
    default: refuse(PyExc_ValueError, where + hs_last_error());
  }
}

inline std::string triangle_text(std::size_t index) {
  return "triangle " + std::to_string(index) + ": ";
}

// How many triangles an array of shape (N, 3, width) or (3, width) holds, (N, 3) or (3) for no
// width.
inline std::size_t triangle_count(const py::array& array, const char* name, py::ssize_t width) {
  const py::ssize_t inner = width == 0 ? 0 : 1;
  const py::ssize_t first = array.ndim() - 1 - inner;  // the dimension of the three vertices
  const bool good = (first == 0 || first == 1) && array.shape(first) == 3 &&
                    (inner == 0 || array.shape(first + 1) == width);
  if (!good) {
    const std::string tail = width == 0 ? "" : ", " + std::to_string(width);
    refuse(PyExc_ValueError, std::string(name) + " must have the shape (N, 3" + tail + ") or (3" +
                                 (width == 0 ? "," : tail) + ")");
  }
  return first == 0 ? 1 : static_cast<std::size_t>(array.shape(0));
}

// Attributes a vertex has in an array of shape (N, 3, K) or (3, K), for as many triangles.
inline std::size_t value_count(const py::array& values, std::size_t triangles) {
  const py::ssize_t width = values.ndim() == 0 ? 0 : values.shape(values.ndim() - 1);
  if (width < 1 || width > 8) refuse(PyExc_ValueError, "values must have 1 to 8 of each vertex");
  if (triangle_count(values, "values", width) != triangles) {
    refuse(PyExc_ValueError, "values are of another number of triangles");
  }
  return static_cast<std::size_t>(width);
}

// A whole number that a C type holds.
template <class Target>
Target narrowed(std::int64_t value, std::size_t triangle, const char* name) {
  if (value < static_cast<std::int64_t>(std::numeric_limits<Target>::min()) ||
      value > static_cast<std::int64_t>(std::numeric_limits<Target>::max())) {
    refuse(PyExc_ValueError,
           triangle_text(triangle) + name + " " + std::to_string(value) + " is out of range");
  }
  return static_cast<Target>(value);
}

// Integers of any width; real numbers are none.
inline Integers integers(const py::array& array, const char* name) {
  if (array.dtype().kind() != 'i' && array.dtype().kind() != 'u') {
    refuse(PyExc_TypeError, std::string(name) + " must be integers");
  }
  return Integers::ensure(array);
}

}  // namespace halfspace_python
