// SPDX-License-Identifier: Apache-2.0
//
// The way from the world to the window, by formulas and by GLM; drawn clipped and exactly.
#include "projection.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include "catalogue.hpp"
#include "clipping.hpp"

namespace halfspace::methods {
namespace {

template <class Real>
using Projector = Matrix<Real> (*)(const Camera&, double aspect);

constexpr double kRadians = 3.14159265358979323846 / 180;

template <class Real>
Matrix<Real> ortho_of(const Camera& c, double aspect) {
  const auto half = static_cast<Real>(c.ortho_height / 2), wide = half * static_cast<Real>(aspect);
  return ortho_matrix<Real>(-wide, wide, -half, half, static_cast<Real>(c.near),
                            static_cast<Real>(c.far));
}

template <class Real>
Matrix<Real> by_fovy(const Camera& c, double aspect) {
  if (c.orthographic) return ortho_of<Real>(c, aspect);
  return perspective_matrix<Real>(static_cast<Real>(c.fov_y_degrees * kRadians),
                                  static_cast<Real>(aspect), static_cast<Real>(c.near),
                                  static_cast<Real>(c.far));
}

Matrix<double> by_frustum(const Camera& c, double aspect) {
  if (c.orthographic) return ortho_of<double>(c, aspect);
  const double top = c.near * std::tan(c.fov_y_degrees * kRadians / 2), right = top * aspect;
  return frustum_matrix(-right, right, -top, top, c.near, c.far);
}

template <class Real>
Matrix<Real> view_of(const Camera& c) {
  return look_at_matrix<Real>(Vector<Real>(c.eye), Vector<Real>(c.target), Vector<Real>(c.up));
}

Matrix<double> by_glm(const Camera& c, double aspect) {
  const double half = c.ortho_height / 2;
  const glm::dmat4 projection =
      c.orthographic ? glm::ortho(-half * aspect, half * aspect, -half, half, c.near, c.far)
                     : glm::perspective(c.fov_y_degrees * kRadians, aspect, c.near, c.far);
  return projection * glm::lookAt(c.eye, c.target, c.up);
}

void draw(const WorldFacet& facet, const View& view, Canvas& canvas, const glm::dmat4& matrix) {
  ClipFacet clip;
  for (std::size_t i = 0; i < 3; ++i) {
    clip[i] = {matrix * glm::dvec4(facet[i].position, 1.0), facet[i].color};
  }
  const auto* clipped = find("clip_guard_band");
  std::get<DrawClip>(clipped->draw)(clip, view, canvas);
}

double aspect_of(const View& view) { return static_cast<double>(view.width) / view.height; }

Method base(const char* name, const char* title, const char* precision) {
  Method m;
  m.name = std::string("project_") + name;
  m.row = 16;
  m.family = "projection";
  m.title = std::string("From the world to the window: ") + title;
  m.source = std::string(kDrawing) + "; " + kShinar;
  m.complexity = "16 products per vertex and a division by w";
  m.use = "every mesh seen by a camera";
  m.fails = "a camera at its target, or one that looks along its up vector";
  m.rule = Rule::kTopLeft;
  m.precision = precision;
  m.attributes = true;
  return m;
}

}  // namespace

void add_projection(std::vector<Method>& list) {
  Method m = base("fovy", "look-at, then perspective by the field of view or glOrtho", "double");
  m.draw = DrawWorld([](const WorldFacet& f, const View& v, Canvas& c) {
    draw(f, v, c, by_fovy<double>(v.camera, aspect_of(v)) * view_of<double>(v.camera));
  });
  list.push_back(m);
  m = base("frustum", "look-at, then glFrustum or glOrtho", "double");
  m.draw = DrawWorld([](const WorldFacet& f, const View& v, Canvas& c) {
    draw(f, v, c, by_frustum(v.camera, aspect_of(v)) * view_of<double>(v.camera));
  });
  list.push_back(m);
  m = base("float", "as project_fovy, with matrices in float", "float");
  m.fails = "positions round to 24 bits: vertices move by fractions of a pixel";
  m.draw = DrawWorld([](const WorldFacet& f, const View& v, Canvas& c) {
    const glm::mat4 matrix = by_fovy<float>(v.camera, aspect_of(v)) * view_of<float>(v.camera);
    draw(f, v, c, glm::dmat4(matrix));
  });
  list.push_back(m);
  m = base("glm", "GLM's lookAt, perspective and ortho", "double");
  m.draw = DrawWorld([](const WorldFacet& f, const View& v, Canvas& c) {
    draw(f, v, c, by_glm(v.camera, aspect_of(v)));
  });
  list.push_back(m);
}

}  // namespace halfspace::methods
