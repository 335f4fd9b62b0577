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
#include <vector>

#include "outline.hpp"

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

std::vector<CameraOptions> projections() {
  CameraOptions standard, wide, narrow, orthographic;
  wide.fov_y_degrees = 100.0;
  narrow.fov_y_degrees = 5.0;
  narrow.up = glm::dvec3{1.0, 1.0, -0.3};
  orthographic.orthographic = true;
  return {standard, wide, narrow, orthographic};
}

constexpr double kAspects[] = {0.25, 1.0, 4.0 / 3.0, 16.0 / 9.0, 4.0};

// One pair of opposite sides is touched but for the margin, and no side is crossed.
TEST(FrameCamera, FillsTheFrame) {
  std::uint64_t random = 42;
  for (int i = 0; i < 300; ++i) {
    const Points points = random_points(random);
    for (const double aspect : kAspects) {
      for (const CameraOptions& options : projections()) {
        const Outline seen = expect_in_frame(points, frame_camera(points, aspect, options), aspect);
        EXPECT_LT(seen.widest(), 0.95 + 1e-4);
        if (!seen.is_close()) {
          EXPECT_GT(seen.pair(), 0.95 - 1e-4) << i << ' ' << aspect;
        }
        if (!options.orthographic) continue;  // there the other pair is centred in the picture too
        EXPECT_NEAR(-seen.low.x, seen.high.x, 1e-4);
        EXPECT_NEAR(-seen.low.y, seen.high.y, 1e-4);
      }
    }
  }
}

// A turntable: all is in every view, from one distance, and some view needs it.
TEST(OrbitCameras, ShowAllFromOneDistance) {
  std::uint64_t random = 44;
  for (int i = 0; i < 60; ++i) {
    const Points points = random_points(random);
    for (const double aspect : kAspects) {
      for (CameraOptions options : projections()) {
        if (i % 3 == 0) options.target = glm::dvec3(random_points(random).front());
        const std::vector<Camera> views = orbit_cameras(points, aspect, options, 7);
        ASSERT_EQ(views.size(), 7u);
        double widest = 0.0;
        bool is_close = false;
        for (const Camera& view : views) {
          const Outline seen = expect_in_frame(points, view, aspect);
          widest = std::max(widest, seen.widest());
          is_close |= seen.is_close();
          const double distance = glm::length(view.eye - view.target);
          EXPECT_NEAR(distance, glm::length(views[0].eye - views[0].target), 1e-9 * distance);
          EXPECT_EQ(view.ortho_height, views[0].ortho_height);
          EXPECT_EQ(view.target, views[0].target);
        }
        EXPECT_LT(widest, 0.95 + 1e-4);
        if (!is_close) {
          EXPECT_GT(widest, 0.95 - 1e-4);
        }
      }
    }
  }
}

TEST(OrbitCameras, TurnCounterClockwiseInEqualSteps) {
  const Points cube{{-1, -1, -1}, {1, 1, 1}};
  const std::vector<Camera> views = orbit_cameras(cube, 1.0, {}, 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3 here = views[i].eye - views[i].target;
    const glm::dvec3 next = views[(i + 1) % 4].eye - views[i].target;
    EXPECT_NEAR(next.x, here.z, 1e-12);
    EXPECT_NEAR(next.y, here.y, 1e-12);
    EXPECT_NEAR(next.z, -here.x, 1e-12);
  }
}

TEST(FrameCamera, ObeysWhatIsGiven) {
  std::uint64_t random = 45;
  for (CameraOptions options : projections()) {
    const Points points = random_points(random);
    options.target = glm::dvec3{500.0, 450.0, 900.0};  // between the viewer and the points
    expect_in_frame(points, frame_camera(points, 1.5, options), 1.5);
    options.target = glm::dvec3{1.0, 2.0, 3.0};
    Camera camera = frame_camera(points, 1.5, options);
    EXPECT_EQ(camera.target, *options.target);
    EXPECT_EQ(camera.up, options.up.value_or(glm::dvec3{0.0, 1.0, 0.0}));
    EXPECT_EQ(camera.fov_y_degrees, options.fov_y_degrees.value_or(40.0));
    expect_in_frame(points, camera, 1.5);
    const glm::dvec3 direction = glm::normalize(camera.eye - camera.target);
    // As far above the middle as by itself, whichever way up is.
    EXPECT_NEAR(glm::dot(direction, glm::normalize(camera.up)),
                0.45 / glm::length(glm::dvec3{0.5, 0.45, 0.9}), 1e-9);
    options.eye = glm::dvec3{-7.0, 60.0, 5.0};
    camera = orbit_cameras(points, 1.5, options, 3).front();
    EXPECT_EQ(camera.eye, *options.eye);
    EXPECT_EQ(camera.target, *options.target);
    options.target.reset();
    EXPECT_EQ(frame_camera(points, 1.5, options).eye, *options.eye);
    if (!options.orthographic) continue;
    EXPECT_NEAR(expect_in_frame(points, frame_camera(points, 1.5, options), 1.5).widest(), 0.95,
                1e-4);
    options.ortho_height = 3.5;
    EXPECT_EQ(frame_camera(points, 1.5, options).ortho_height, 3.5);
  }
}

// The view of a mesh whose up is not y is that of one turned to y.
TEST(FrameCamera, TheDefaultEyeTurnsWithUp) {
  const auto direction = [](const glm::dvec3& up) {
    CameraOptions options;
    options.up = up;
    const Camera camera = frame_camera(Points{{-1, -1, -1}, {1, 1, 1}}, 1.0, options);
    return glm::normalize(camera.eye - camera.target) * glm::length(glm::dvec3{0.5, 0.45, 0.9});
  };
  EXPECT_LT(glm::length(direction({0, 2, 0}) - glm::dvec3(0.5, 0.45, 0.9)), 1e-9);
  EXPECT_LT(glm::length(direction({0, 0, 1}) - glm::dvec3(0.5, -0.9, 0.45)), 1e-9);
  EXPECT_LT(glm::length(direction({0, 0, -1}) - glm::dvec3(0.5, 0.9, -0.45)), 1e-9);
  EXPECT_LT(glm::length(direction({3, 0, 0}) - glm::dvec3(0.45, -0.5, 0.9)), 1e-9);
  EXPECT_LT(glm::length(direction({0, -1, 0}) - glm::dvec3(-0.5, -0.45, 0.9)), 1e-9);
}

TEST(FrameCamera, EyeInsideTheSceneKeepsAPositiveNear) {
  CameraOptions options;
  options.eye = glm::dvec3{0.1, 0.2, 0.3};
  const Camera camera = frame_camera(Points{{-9, -9, -9}, {9, 9, 9}}, 1.0, options);
  EXPECT_GT(camera.near, 0.0);
  EXPECT_GT(camera.far, 8.0);
  EXPECT_LE(camera.far / camera.near, 1000.0 + 1e-9);
}

// The tip of a needle would otherwise be as near to the eye as the needle is thin, and be cut off.
TEST(FrameCamera, StaysBeforeANeedleAlongTheView) {
  const Points needle{{0, 0, 0}, {50, 45, 90}};
  expect_in_frame(needle, frame_camera(needle, 1.0), 1.0);
}

TEST(FrameCamera, DegenerateRequestsGiveAFiniteMatrix) {
  CameraOptions on_target;
  on_target.eye = on_target.target = glm::dvec3{1.0, 2.0, 3.0};
  CameraOptions behind;
  behind.eye = glm::dvec3{0.0, 0.0, 50.0};
  behind.target = glm::dvec3{0.0, 0.0, 99.0};
  CameraOptions beside;  // of what is looked at, so that the points are behind it
  beside.target = glm::dvec3{5e5, 5e5, 9e5};
  CameraOptions along;
  along.up = glm::dvec3{-0.5, -0.45, -0.9};
  along.target = glm::dvec3{0.0, 0.0, 0.0};
  along.eye = glm::dvec3{5.0, 4.5, 9.0};
  CameraOptions away;
  away.target = glm::dvec3{1e90, -1e90, 3.0};
  const Points flat{{1e3F, 2, 3}, {1e3F, 2, 4}, {1e3F, 3, 4}};
  const Points distant{{3e38F, -3e38F, 0}, {-3e38F, 3e38F, 1}};
  for (const Points& points : {Points{}, Points{{0, 0, 0}}, Points{{1e3F, 2, 3}}, flat, distant}) {
    for (CameraOptions options : {CameraOptions{}, on_target, behind, beside, along, away}) {
      for (const bool is_orthographic : {false, true}) {
        options.orthographic = is_orthographic;
        for (const Camera& camera : orbit_cameras(points, 1.0, options, 2)) {
          EXPECT_LT(camera.near, camera.far);
          EXPECT_TRUE(is_orthographic || camera.near > 0.0);
          const glm::dmat4 matrix = world_to_clip(camera, 1.0);
          for (int i = 0; i < 16; ++i) EXPECT_TRUE(std::isfinite(matrix[i / 4][i % 4])) << i;
        }
      }
    }
  }
}

}  // namespace
}  // namespace halfspace
