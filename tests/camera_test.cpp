// SPDX-License-Identifier: Apache-2.0
//
// The matrices against the formulas of the lecture notes, written out by hand, and the automatic
// camera.
#include "camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace halfspace {
namespace {

// Rows as they are printed on paper; GLM stores columns.
using Rows = std::array<std::array<double, 4>, 4>;

double greatest_difference(const glm::dmat4& matrix, const Rows& rows) {
  double greatest = 0.0;
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c) {
      const double expected = rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
      greatest = std::max(greatest, std::abs(matrix[c][r] - expected));
    }
  }
  return greatest;
}

// glFrustum(-right, right, -top, top, near, far) as the notes print it.
Rows symmetric_frustum(double right, double top, double near, double far) {
  return {{{near / right, 0, 0, 0},
           {0, near / top, 0, 0},
           {0, 0, -(far + near) / (far - near), -2 * far * near / (far - near)},
           {0, 0, -1, 0}}};
}

TEST(Camera, PerspectiveIsTheNotesMatrixWithTheTopAtTheHalfAngle) {
  const double near = 0.5, far = 20.0, aspect = 1.6;
  for (const double fov : {10.0, 45.0, 90.0, 140.0}) {
    const double top = near * std::tan(glm::radians(fov) / 2.0);
    EXPECT_LT(greatest_difference(perspective(fov, aspect, near, far),
                                  symmetric_frustum(top * aspect, top, near, far)),
              1e-12)
        << fov;
  }
}

// The notes' text has top = near * tan(fovy); their code, and we, halve the angle.
TEST(Camera, TopAtTheFullAngleIsAnotherMatrix) {
  const double near = 0.5, far = 20.0;
  const double wrong_top = near * std::tan(glm::radians(45.0));
  EXPECT_GT(greatest_difference(perspective(45.0, 1.0, near, far),
                                symmetric_frustum(wrong_top, wrong_top, near, far)),
            1.0);
  // By the definition of the angle: a point on the ray 22.5 degrees up is at the picture's top.
  const glm::dvec4 p = perspective(45.0, 1.0, near, far) *
                       glm::dvec4(0.0, 3.0 * std::tan(glm::radians(22.5)), -3.0, 1.0);
  EXPECT_NEAR(p.y / p.w, 1.0, 1e-12);
}

TEST(Camera, OrthographicIsGlOrtho) {
  const double height = 6.0, aspect = 1.5, near = -2.0, far = 10.0;
  const double top = 3.0, right = 4.5;
  const Rows expected{{{1 / right, 0, 0, 0},
                       {0, 1 / top, 0, 0},
                       {0, 0, -2 / (far - near), -(far + near) / (far - near)},
                       {0, 0, 0, 1}}};
  EXPECT_LT(greatest_difference(orthographic(height, aspect, near, far), expected), 1e-15);
}

TEST(Camera, LookAtIsTheNotesRotationTimesTheTranslation) {
  Camera camera;
  camera.eye = {3.0, -2.0, 5.0};
  camera.target = {-1.0, 4.0, 0.5};
  camera.up = {0.2, 2.0, 0.1};
  const glm::dvec3 v = glm::normalize(camera.target - camera.eye);
  const glm::dvec3 r = glm::normalize(glm::cross(v, camera.up));
  const glm::dvec3 u = glm::cross(r, v);
  const glm::dvec3 e = camera.eye;
  const Rows expected{{{r.x, r.y, r.z, -glm::dot(r, e)},
                       {u.x, u.y, u.z, -glm::dot(u, e)},
                       {-v.x, -v.y, -v.z, glm::dot(v, e)},
                       {0, 0, 0, 1}}};
  EXPECT_LT(greatest_difference(look_at(camera), expected), 1e-12);
}

TEST(Camera, LookingAlongUpIsStillARotation) {
  Camera camera;
  camera.eye = {0.0, 5.0, 0.0};
  const glm::dvec4 target = look_at(camera) * glm::dvec4(0.0, 0.0, 0.0, 1.0);
  EXPECT_NEAR(target.z, -5.0, 1e-12);
  EXPECT_NEAR(target.x, 0.0, 1e-12);
}

TEST(Camera, NearAndFarAreTheEndsOfNdc) {
  for (const bool is_orthographic : {false, true}) {
    Camera camera;
    camera.orthographic = is_orthographic;
    const glm::dmat4 matrix = world_to_clip(camera, 1.0);
    const glm::dvec4 near = matrix * glm::dvec4(0.0, 0.0, camera.eye.z - camera.near, 1.0);
    const glm::dvec4 far = matrix * glm::dvec4(0.0, 0.0, camera.eye.z - camera.far, 1.0);
    EXPECT_NEAR(near.z / near.w, -1.0, 1e-9);
    EXPECT_NEAR(far.z / far.w, 1.0, 1e-9);
  }
}

// Every point of the bounding sphere, sampled, lands inside the clip volume.
void expect_sphere_in_frame(const Bounds& bounds, double aspect, const CameraOptions& options) {
  const glm::dmat4 matrix = world_to_clip(frame_camera(bounds, aspect, options), aspect);
  const glm::dvec3 centre = (bounds.min + bounds.max) / 2.0;
  const double radius = glm::length(bounds.max - bounds.min) / 2.0;
  double widest = 0.0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j <= 32; ++j) {
      const double a = i * 6.283185307 / 64, b = j * 3.141592654 / 32;
      const glm::dvec3 normal{std::cos(a) * std::sin(b), std::cos(b), std::sin(a) * std::sin(b)};
      const glm::dvec4 p = matrix * glm::dvec4(centre + radius * normal, 1.0);
      EXPECT_GT(p.w, 0.0);
      for (int axis = 0; axis < 3; ++axis) EXPECT_LE(std::abs(p[axis]), p.w * (1 + 1e-9));
      widest = std::max({widest, std::abs(p.x / p.w), std::abs(p.y / p.w)});
    }
  }
  EXPECT_GT(widest, 0.9) << "the sphere should nearly fill the frame";
}

TEST(FrameCamera, ShowsTheWholeSphereAtEveryAspect) {
  const Bounds bounds{{-3.0, 0.0, -2.0}, {3.4, 3.15, 2.0}};
  for (const double aspect : {0.25, 1.0, 16.0 / 9.0, 4.0}) {
    CameraOptions options;
    expect_sphere_in_frame(bounds, aspect, options);
    options.fov_y_degrees = 100.0;
    expect_sphere_in_frame(bounds, aspect, options);
    options.orthographic = true;
    expect_sphere_in_frame(bounds, aspect, options);
  }
}

TEST(FrameCamera, LooksFromSlightlyAbove) {
  const Camera camera = frame_camera({{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}, 1.0);
  const glm::dvec3 from = glm::normalize(camera.eye - camera.target);
  EXPECT_GT(from.y, 0.2);
  EXPECT_LT(from.y, 0.6);
}

TEST(FrameCamera, EyeInsideTheSceneKeepsAPositiveNear) {
  CameraOptions options;
  options.eye = glm::dvec3{0.1, 0.2, 0.3};
  const Camera camera = frame_camera({{-9.0, -9.0, -9.0}, {9.0, 9.0, 9.0}}, 1.0, options);
  EXPECT_GT(camera.near, 0.0);
  EXPECT_GT(camera.far, 15.0);
  EXPECT_LE(camera.far / camera.near, 1000.0 + 1e-9);
}

TEST(FrameCamera, DegenerateRequestsGiveAFiniteMatrix) {
  CameraOptions on_target;
  on_target.eye = on_target.target = glm::dvec3{1.0, 2.0, 3.0};
  CameraOptions behind;
  behind.eye = glm::dvec3{0.0, 0.0, 50.0};
  behind.target = glm::dvec3{0.0, 0.0, 99.0};
  for (const CameraOptions& options : {CameraOptions{}, on_target, behind}) {
    const Camera camera = frame_camera({{1e3, 2.0, 3.0}, {1e3, 2.0, 3.0}}, 1.0, options);
    EXPECT_LT(camera.near, camera.far);
    const glm::dmat4 matrix = world_to_clip(camera, 1.0);
    for (int i = 0; i < 16; ++i) EXPECT_TRUE(std::isfinite(matrix[i / 4][i % 4])) << i;
  }
}

}  // namespace
}  // namespace halfspace
