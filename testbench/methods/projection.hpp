// SPDX-License-Identifier: Apache-2.0
//
// From the world to the window by the formulas of the notes, written out and not taken from a
// library; tests/methods_projection_test.cpp holds them to GLM's. Matrices are GLM's type, column
// by column, as OpenGL's. Any floating-point type.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "method.hpp"

namespace halfspace::methods {

template <class Real>
using Matrix = glm::mat<4, 4, Real>;
template <class Real>
using Vector = glm::vec<3, Real>;

// The inverse of the camera's frame (e, r, u, -v): its transpose after moving the eye to 0. up need
// not be normal to the view; it must not be along it.
template <class Real>
Matrix<Real> look_at_matrix(Vector<Real> eye, Vector<Real> target, Vector<Real> up) {
  const Vector<Real> v = glm::normalize(target - eye);
  const Vector<Real> r = glm::normalize(glm::cross(v, up));
  const Vector<Real> u = glm::cross(r, v);
  Matrix<Real> m(1);
  for (int i = 0; i < 3; ++i) {
    m[i][0] = r[i];
    m[i][1] = u[i];
    m[i][2] = -v[i];
  }
  m[3][0] = -glm::dot(r, eye);
  m[3][1] = -glm::dot(u, eye);
  m[3][2] = glm::dot(v, eye);
  return m;
}

// glFrustum: the near rectangle l..r, b..t at distance n, the far plane at f; 0 < n < f.
template <class Real>
Matrix<Real> frustum_matrix(Real l, Real r, Real b, Real t, Real n, Real f) {
  Matrix<Real> m(0);
  m[0][0] = 2 * n / (r - l);
  m[1][1] = 2 * n / (t - b);
  m[2][0] = (r + l) / (r - l);
  m[2][1] = (t + b) / (t - b);
  m[2][2] = -(f + n) / (f - n);
  m[2][3] = -1;
  m[3][2] = -2 * f * n / (f - n);
  return m;
}

// Full vertical angle in radians; top = n tan(fovy / 2), the right form: half the angle.
template <class Real>
Matrix<Real> perspective_matrix(Real fovy, Real aspect, Real n, Real f) {
  const Real top = n * std::tan(fovy / 2), right = top * aspect;
  Matrix<Real> m(0);
  m[0][0] = n / right;
  m[1][1] = n / top;
  m[2][2] = -(f + n) / (f - n);
  m[2][3] = -1;
  m[3][2] = -2 * f * n / (f - n);
  return m;
}

// glOrtho: the box l..r, b..t, and n..f along the view.
template <class Real>
Matrix<Real> ortho_matrix(Real l, Real r, Real b, Real t, Real n, Real f) {
  Matrix<Real> m(1);
  m[0][0] = 2 / (r - l);
  m[1][1] = 2 / (t - b);
  m[2][2] = -2 / (f - n);
  m[3][0] = -(r + l) / (r - l);
  m[3][1] = -(t + b) / (t - b);
  m[3][2] = -(f + n) / (f - n);
  return m;
}

// After the division by w: -1..1 to the window, y down, depth 0..1. Not truncated to pixels.
inline Vertex window_vertex(const ClipPoint& p, const View& view) {
  const double w = p.position.w;
  return {(p.position.x / w + 1) / 2 * view.width, (1 - p.position.y / w) / 2 * view.height,
          (p.position.z / w + 1) / 2, w, p.color};
}

}  // namespace halfspace::methods
