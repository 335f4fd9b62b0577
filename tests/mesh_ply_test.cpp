// SPDX-License-Identifier: Apache-2.0
//
// PLY by its rules: every type, order and layout that a header may announce gives the same mesh,
// and what is not part of a mesh is read over.
#include "ply_fixture.hpp"

namespace halfspace {
namespace {

TEST_F(Ply, EveryTypeHoldsCoordinatesAndIndices) {
  for (const char* format : kFormats) {
    for (const Type& type : kTypes) {
      SCOPED_TRACE(std::string(format) + " " + type.name);
      const std::string name(type.name);
      Data data(format);
      for (const auto& corner : kSquare) {
        for (const int value : corner) data.put(name, value);
      }
      data.put("uchar", 4);
      for (const double index : {0, 1, 2, 3}) data.put(name, index);
      expect_square(load("t.ply", header(format, "element vertex 4\nproperty " + name +
                                                     " x\nproperty " + name + " y\nproperty " +
                                                     name + " z\nelement face 1\nproperty list " +
                                                     "uchar " + name + " vertex_indices\n") +
                                      data.bytes));
    }
  }
}

TEST_F(Ply, EveryTypeCountsAList) {
  for (const char* format : kFormats) {
    for (const Type& type : kTypes) {
      SCOPED_TRACE(std::string(format) + " " + type.name);
      const std::string name(type.name);
      Data data(format);
      for (const auto& corner : kSquare) {
        for (const int value : corner) data.put("float", value);
      }
      data.put(name, 2).put("double", 0.5).put("double", 0.25);  // texture coordinates first
      data.put(name, 4);
      for (const double index : {0, 1, 2, 3}) data.put("int", index);
      data.put("short", 7);
      expect_square(
          load("t.ply", header(format,
                               "element vertex 4\nproperty float x\nproperty float y\nproperty "
                               "float z\nelement face 1\nproperty list " +
                                   name + " double texcoord\nproperty list " + name +
                                   " int vertex_index\nproperty short flags\n") +
                            data.bytes));
    }
  }
}

// Elements that are not known, before, between and after; the face before the vertex.
TEST_F(Ply, ElementsComeInAnyOrder) {
  const std::vector<std::string> orders{"vfu", "vuf", "uvf", "ufv", "fuv", "fvu"};
  for (const char* format : kFormats) {
    for (const std::string& order : orders) {
      SCOPED_TRACE(std::string(format) + " " + order);
      std::string elements;
      Data data(format);
      for (const char element : order) {
        if (element == 'v') {
          elements +=
              "element vertex 4\nproperty uchar quality\nproperty float z\nproperty float "
              "x\nproperty float y\n";
          for (const auto& c : kSquare) {
            data.put("uchar", 9).put("float", c[2]).put("float", c[0]).put("float", c[1]);
          }
        } else if (element == 'f') {
          elements += "element face 1\nproperty list uchar uint vertex_indexes\n";
          data.put("uchar", 4).put("uint", 0).put("uint", 1).put("uint", 2).put("uint", 3);
        } else {
          elements +=
              "element camera 2\nproperty double fov\nproperty list ushort float view\n"
              "element nothing 1000000000000\n";
          for (int i = 0; i < 2; ++i) {
            data.put("double", 1.5)
                .put("ushort", 3)
                .put("float", 1)
                .put("float", 2)
                .put("float", 3);
          }
        }
      }
      expect_square(load("t.ply", header(format, elements) + data.bytes));
    }
  }
}

TEST_F(Ply, StripsTurnEveryOtherTriangleAndStartAgainAtMinusOne) {
  for (const char* format : kFormats) {
    for (const char* type : {"int", "uint", "short", "ushort", "char", "uchar"}) {
      SCOPED_TRACE(std::string(format) + " " + type);
      Data data(format);
      for (const auto& c : kSquare) data.put("float", c[0]).put("float", c[1]).put("float", c[2]);
      const Type as = type_of(type);
      const double end =
          as.is_signed ? -1.0 : std::pow(2.0, 8.0 * static_cast<double>(as.size)) - 1;
      data.put("int", 13);
      for (const double i : {0., 1., 3., 2., end, 1., 2., 3., end, end, 0., 1., 2.})
        data.put(type, i);
      const Mesh mesh = load(
          "t.ply", header(format, std::string("element vertex 4\nproperty float x\nproperty float "
                                              "y\nproperty float z\nelement tristrips 1\nproperty "
                                              "list int ") +
                                      type + " vertex_indices\n") +
                       data.bytes);
      ASSERT_EQ(mesh.triangles.size(), 4U);  // 2, 1 and 1
      for (std::size_t t = 0; t < 4; ++t) {
        EXPECT_GT(glm::cross(corner(mesh, t, 1) - corner(mesh, t, 0),
                             corner(mesh, t, 2) - corner(mesh, t, 0))
                      .z,
                  0.0)
            << t;
      }
    }
  }
}

}  // namespace
}  // namespace halfspace
