// SPDX-License-Identifier: Apache-2.0
//
// Rows 16 and 17: the notes' formulas against GLM's, and clipping against geometry.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "methods/clipping.hpp"
#include "methods/projection.hpp"
#include "methods_support.hpp"
#include "vectors/generators.hpp"

namespace halfspace::methods {
namespace {

double unit(Random& random) { return static_cast<double>(random.in(-1000, 1000)) / 1000; }

void expect_near(const glm::dmat4& a, const glm::dmat4& b, double tolerance, const char* what) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) EXPECT_NEAR(a[c][r], b[c][r], tolerance) << what << c << r;
  }
}

TEST(Projection, FormulasOfTheNotesAreGlms) {
  Random random(41);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 eye{unit(random), unit(random), unit(random) + 3};
    const glm::dvec3 target{unit(random), unit(random), unit(random)};
    const glm::dvec3 up{unit(random) / 2, 1, unit(random) / 2};
    expect_near(look_at_matrix(eye, target, up), glm::lookAt(eye, target, up), 1e-12, "look-at");
    const double near = 0.1 + std::abs(unit(random)), far = near + 5;
    const double aspect = 1.5 + unit(random), fovy = 0.9 + unit(random) / 2;
    expect_near(perspective_matrix(fovy, aspect, near, far),
                glm::perspective(fovy, aspect, near, far), 1e-12, "perspective");
    const double l = -1 + unit(random) / 4, r = 2, b = -2, t = 1 + unit(random) / 4;
    expect_near(frustum_matrix(l, r, b, t, near, far), glm::frustum(l, r, b, t, near, far), 1e-12,
                "frustum");
    expect_near(ortho_matrix(l, r, b, t, near, far), glm::ortho(l, r, b, t, near, far), 1e-12,
                "ortho");
    const double top = near * std::tan(fovy / 2);
    expect_near(frustum_matrix(-top * aspect, top * aspect, -top, top, near, far),
                perspective_matrix(fovy, aspect, near, far), 1e-12, "symmetric frustum");
  }
}

TEST(Projection, ViewportIsGlmsWithYDown) {
  Random random(42);
  View view;
  view.width = 640, view.height = 480;
  const glm::dmat4 projection = perspective_matrix(0.8, 4.0 / 3, 0.5, 20.0);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 p{unit(random), unit(random), -2 + unit(random)};
    const Vertex v = window_vertex({projection * glm::dvec4(p, 1), {}}, view);
    const glm::dvec3 window =
        glm::project(p, glm::dmat4(1), projection, glm::dvec4(0, 0, 640, 480));
    EXPECT_NEAR(v.x, window.x, 1e-9);
    EXPECT_NEAR(v.y, 480 - window.y, 1e-9);
    EXPECT_NEAR(v.z, window.z, 1e-12);
  }
}

// A little scene in perspective, part of it behind the eye.
Drawing room() {
  Random random(43);
  Drawing d;
  d.view.width = d.view.height = 128;
  d.view.camera.eye = {0, 0.4, 2};
  d.view.camera.near = 0.05;
  d.view.camera.far = 50;
  for (int i = 0; i < 60; ++i) {
    WorldFacet f;
    for (WorldPoint& p : f) p.position = {2 * unit(random), unit(random), 3 * unit(random)};
    d.world.push_back(f);
  }
  return d;
}

TEST(Projection, FormulasAndLibraryDrawTheSamePicture) {
  const Drawing scene = room();
  const auto hits = [&](const char* name, bool orthographic) {
    Drawing d = scene;
    d.view.camera.orthographic = orthographic;
    Canvas canvas(128, 128);
    draw(method(name), d, canvas);
    return canvas.hits();
  };
  for (const bool orthographic : {false, true}) {
    const auto library = hits("project_glm", orthographic);
    EXPECT_GT(std::count_if(library.begin(), library.end(), [](auto h) { return h > 0; }), 4000);
    for (const char* name : {"project_fovy", "project_frustum"}) {
      const auto e = oracle::compare_hits(hits(name, orthographic), library);
      EXPECT_LT(e.ppm(), 200) << name;  // a vertex may round to another 1/256 px
    }
    EXPECT_LT(oracle::compare_hits(hits("project_float", orthographic), library).ppm(), 20000);
  }
}

ClipFacet random_clip(Random& random) {
  ClipFacet f;
  for (ClipPoint& p : f) {
    p.position = {3 * unit(random), 3 * unit(random), 3 * unit(random), 2 * unit(random)};
    p.color = {100 + 100 * unit(random), 0, 0};
  }
  return f;
}

TEST(Clipping, PiecesLieInsideAndTheirCutsOnThePlane) {
  Random random(44);
  int cut = 0;
  for (int i = 0; i < 2000; ++i) {
    const ClipFacet f = random_clip(random);
    for (const Plane4& plane : view_volume()) {
      const auto polygon = clip_polygon(f, plane);
      for (const ClipPoint& p : polygon) {
        const double side = glm::dot(plane.normal, p.position);
        EXPECT_GT(side, -1e-12);
        const bool corner = std::any_of(
            f.begin(), f.end(), [&](const ClipPoint& q) { return q.position == p.position; });
        if (corner) continue;
        EXPECT_NEAR(side, 0, 1e-12);
        ++cut;
        // A cut point's colour is as far along its edge as its position.
        EXPECT_GE(p.color[0], std::min({f[0].color[0], f[1].color[0], f[2].color[0]}) - 1e-9);
        EXPECT_LE(p.color[0], std::max({f[0].color[0], f[1].color[0], f[2].color[0]}) + 1e-9);
      }
    }
  }
  EXPECT_GT(cut, 1000);
}

// The signed area of the pieces is that of the part inside: clip against a plane and its opposite.
TEST(Clipping, BothSidesOfAPlaneAddUpToTheTriangle) {
  Random random(45);
  const auto area = [](std::span<const ClipFacet> facets) {
    double sum = 0;
    for (const ClipFacet& f : facets) {
      const glm::dvec4 u = f[1].position - f[0].position, v = f[2].position - f[0].position;
      sum += u.x * v.y - u.y * v.x;
    }
    return sum;
  };
  for (int i = 0; i < 500; ++i) {
    const ClipFacet f = random_clip(random);
    const Plane4 plane{{unit(random), unit(random), unit(random), unit(random)}};
    const Plane4 opposite{-plane.normal};
    const auto one = clip_facet(f, std::span(&plane, 1));
    const auto other = clip_facet(f, std::span(&opposite, 1));
    EXPECT_NEAR(area(one) + area(other), area(std::span(&f, 1)), 1e-9);
  }
}

TEST(Clipping, SixPlanesAndGuardBandDrawTheSameButForRounding) {
  Random random(46);
  View view;
  view.width = view.height = 128;
  Canvas six(128, 128), band(128, 128), near(128, 128);
  for (int i = 0; i < 300; ++i) {
    ClipFacet f = random_clip(random);
    for (ClipPoint& p : f) p.position.w = 0.5 + std::abs(p.position.w);
    std::get<DrawClip>(method("clip_six").draw)(f, view, six);
    std::get<DrawClip>(method("clip_guard_band").draw)(f, view, band);
  }
  const auto e = oracle::compare_hits(six.hits(), band.hits());
  EXPECT_GT(e.covered, 10000u);
  EXPECT_LT(e.ppm(), 30000);  // clipping at the frame moves vertices by a rounding
  EXPECT_GT(e.wrong, 0u);     // which is why the guard band exists
}

}  // namespace
}  // namespace halfspace::methods
