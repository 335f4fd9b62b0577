// SPDX-License-Identifier: Apache-2.0
//
// What all formats share: normals by one crease rule, in linear time; an origin of its own for a
// mesh that is far from the world's; polygons cut into triangles.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <set>

#include "mesh_fixture.hpp"

namespace halfspace {
namespace {

using Triangles = std::vector<std::array<glm::dvec3, 3>>;

std::string stl(const Triangles& triangles) {
  std::string text = "solid\n";
  for (const auto& triangle : triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const glm::dvec3& v : triangle) {
      text += "vertex " + std::to_string(v.x) + ' ' + std::to_string(v.y) + ' ' +
              std::to_string(v.z) + '\n';
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid\n";
}

// Facets around a tip at the origin whose rim is `height` below.
Triangles fan(int facets, double height) {
  Triangles out;
  const auto rim = [&](int i) {
    const double angle = 2.0 * 3.14159265358979 * (i % facets) / facets;
    return glm::dvec3(std::cos(angle), std::sin(angle), -height);
  };
  for (int i = 0; i < facets; ++i) out.push_back({glm::dvec3(0.0), rim(i), rim(i + 1)});
  return out;
}

class FinishMesh : public MeshFile {};

// Two squares that share an edge, folded by an angle.
TEST_F(FinishMesh, EdgesAreHardBeyondTheCrease) {
  for (const double degrees : {30.0, 65.0, 67.0, 90.0, 150.0}) {
    const double angle = degrees * 3.14159265358979 / 180.0;
    const std::string x = std::to_string(1.0 + std::cos(angle));
    const std::string z = std::to_string(std::sin(angle));
    const Mesh mesh = load_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv " + x + " 0 " + z + "\nv " +
                               x + " 1 " + z + "\nf 1 2 3 4\nf 2 5 6 3\n");
    ASSERT_EQ(mesh.triangles.size(), 4U);
    EXPECT_EQ(mesh.positions.size(), degrees < 66.0 ? 6U : 8U) << degrees;
    // One triangle of the first square meets two of the second there.
    const glm::dvec3 mean(-2.0 * std::sin(angle), 0.0, 1.0 + 2.0 * std::cos(angle));
    const glm::dvec3 wanted = degrees < 66.0 ? glm::normalize(mean) : glm::dvec3(0, 0, 1);
    EXPECT_LT(glm::length(glm::dvec3(normal(mesh, 0, 1)) - wanted), 1e-5) << degrees;
  }
}

// Each square is cut in two where it has it; its normal counts once for each triangle.
TEST_F(FinishMesh, ACubeIsTheSameInEveryFormat) {
  for (const char* name : {"o06_face2.obj", "p07_face_of_two.ply", "s01_upper.stl",
                           "g21_no_normals_shared.glb", "g02_colour_u8.glb", "p15_oneline.ply"}) {
    const Mesh mesh = load_mesh(std::string(HALFSPACE_TEST_DIR "/meshes/") + name);
    EXPECT_EQ(mesh.positions.size(), 24U) << name;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const glm::dvec3 flat = glm::normalize(glm::cross(corner(mesh, t, 1) - corner(mesh, t, 0),
                                                        corner(mesh, t, 2) - corner(mesh, t, 0)));
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT(glm::length(glm::dvec3(normal(mesh, t, i)) - flat), 1e-5) << name;
      }
    }
  }
}

// The mean over directions within the crease, whether few, or so many that they are gathered.
TEST_F(FinishMesh, TheTipOfAFlatConeIsSmooth) {
  for (const int facets : {12, 250, 300, 5000}) {
    const Mesh mesh = load("cone.stl", stl(fan(facets, 0.3)));
    ASSERT_EQ(mesh.triangles.size(), static_cast<std::size_t>(facets));
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 7) {
      EXPECT_GT(std::abs(normal(mesh, t, 0).z), 0.999F) << facets;
    }
  }
}

// A steep one's sides differ by more than the crease: each gets a part of them, turned to itself.
TEST_F(FinishMesh, TheTipOfASteepConeIsNot) {
  for (const int facets : {24, 240, 5000}) {
    const Mesh mesh = load("cone.stl", stl(fan(facets, 5.0)));
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 7) {
      glm::dvec3 out = corner(mesh, t, 1) + corner(mesh, t, 2);
      out.z = 0.0;
      EXPECT_GT(glm::dot(glm::dvec3(normal(mesh, t, 0)), glm::normalize(out)), 0.85) << facets;
    }
  }
}

// Of the processor, the least of some runs: the machine does other things too.
double seconds_to_load(const std::string& path) {
  double best = 1e9;
  for (int i = 0; i < 4; ++i) {
    const std::clock_t start = std::clock();
    load_mesh(path);
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

// Quadratic time would be 64 times as much.
TEST_F(FinishMesh, ManyFacetsAtAPointTakeLinearTime) {
  const std::string few = write("few.stl", stl(fan(5000, 1.0)));
  const std::string many = write("many.stl", stl(fan(40000, 1.0)));
  EXPECT_LT(seconds_to_load(many), 30.0 * seconds_to_load(few));
}

TEST_F(FinishMesh, CoincidentTrianglesTakeLinearTime) {
  const auto cubes = [this](int count) {
    std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
    for (int i = 0; i < count; ++i) {
      text += "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    }
    return write("cubes" + std::to_string(count) + ".obj", text);
  };
  EXPECT_LT(seconds_to_load(cubes(16000)), 30.0 * seconds_to_load(cubes(2000)));
}

// In metres of a map's grid a float's steps are 0.5 m north.
TEST_F(FinishMesh, AMeshFarAwayKeepsItsShape) {
  const Mesh mesh = load_obj(
      "v 456789.125 4567890.5 100\nv 456790.125 4567890.5 100\nv 456789.125 4567890.8125 100\nf 1 "
      "2 3\n");
  EXPECT_NE(mesh.origin, glm::dvec3(0.0));
  EXPECT_LT(glm::length(corner(mesh, 0, 0) - glm::dvec3(456789.125, 4567890.5, 100)), 1e-6);
  EXPECT_LT(glm::length(corner(mesh, 0, 2) - glm::dvec3(456789.125, 4567890.8125, 100)), 1e-6);
  EXPECT_EQ(load_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").origin, glm::dvec3(0.0));
}

TEST_F(FinishMesh, MeshesOfEverySizeHaveNormals) {
  for (const char* scale : {"e-30", "e-9", "e0", "e9", "e30"}) {
    const std::string s(scale);
    const Mesh mesh = load_obj("v 0 0 0\nv 1" + s + " 0 0\nv 0 1" + s + " 0\nf 1 2 3\n");
    EXPECT_EQ(normal(mesh, 0, 0), glm::vec3(0, 0, 1)) << scale;
  }
}

// A comb of so many teeth: quadratic time would be 64 times as much.
TEST_F(FinishMesh, LongOutlinesTakeAboutLinearTime) {
  const auto comb = [this](int teeth) {
    std::string text = "v 0 -1 0\n", face = "f 1";
    for (int i = 0; i < 2 * teeth; ++i) {
      text.append("v ").append(std::to_string(teeth - 0.5 * i)).append(i % 2 ? " 0 0\n" : " 9 0\n");
      face.append(" ").append(std::to_string(i + 2));
    }
    return write("comb" + std::to_string(teeth) + ".obj", text + face + "\n");
  };
  EXPECT_LT(seconds_to_load(comb(8000)), 30.0 * seconds_to_load(comb(1000)));
}

// Whole areas, no matter where a polygon starts and which way it faces.
TEST_F(FinishMesh, PolygonsAreCutWithoutOverlap) {
  struct Polygon {
    std::vector<glm::dvec2> corners;
    double area;
  };
  const Polygon polygons[] = {
      {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 16},
      {{{0, 0}, {4, 0}, {1, 1}, {0, 4}}, 4},                                   // an arrow
      {{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}, 16},                          // a corner in a line
      {{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {4, 3}, {4, 4}, {0, 4}}, 10},  // a bracket
      {{{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}}, 32},
      {{{0, 0}, {1, 3}, {2, 0}, {3, 3}, {4, 0}, {5, 3}, {6, 0}, {3, 20}}, 51}};
  for (const Polygon& polygon : polygons) {
    const std::size_t count = polygon.corners.size();
    for (std::size_t start = 0; start < count; ++start) {
      std::string text, face = "f";
      for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2& p = polygon.corners[(start + i) % count];
        text += "v " + std::to_string(p.y) + " 5 " + std::to_string(p.x) + "\n";
        face.append(" ").append(std::to_string(i + 1));
      }
      const Mesh mesh = load_obj(text + face + "\n");
      ASSERT_EQ(mesh.triangles.size(), count - 2);
      double sum = 0, absolute = 0;
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const double y = glm::cross(corner(mesh, t, 1) - corner(mesh, t, 0),
                                    corner(mesh, t, 2) - corner(mesh, t, 0))
                             .y;
        sum += y / 2;
        absolute += std::abs(y) / 2;
      }
      EXPECT_NEAR(std::abs(sum), polygon.area, 1e-5) << count << " from " << start;
      EXPECT_NEAR(absolute, polygon.area, 1e-5) << count << " from " << start;
    }
  }
}

}  // namespace
}  // namespace halfspace
