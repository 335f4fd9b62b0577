// SPDX-License-Identifier: Apache-2.0
//
// PLY: headers and text as their many writers lay them out, colours, and what is left out.
#include "ply_fixture.hpp"

namespace halfspace {
namespace {

const std::string kVertex =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFace = "element face 1\nproperty list uchar int vertex_indices\n";

TEST_F(Ply, CommentsAndLineEndsStandAnywhere) {
  const std::vector<std::string> lines{"format ascii 1.0",
                                       "element vertex 3",
                                       "property float x",
                                       "property float y",
                                       "property float z",
                                       "element face 1",
                                       "property list uchar int vertex_indices",
                                       "end_header"};
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    for (std::size_t at = 0; at < lines.size(); ++at) {
      for (const std::string comment :
           {"comment property float w", "obj_info end_header", "comment"}) {
        std::string text = "ply" + end;
        for (std::size_t i = 0; i < lines.size(); ++i) {
          if (i == at) text += comment + end;
          text += lines[i] + end;
        }
        text += "0 0 0" + end + "1 0 0" + end + "0 1 0" + end + "3 0 1 2" + end;
        EXPECT_EQ(load("t.ply", text).triangles.size(), 1U) << comment << " before " << lines[at];
      }
    }
  }
}

// Data may start with any byte, whatever the header's line ends.
TEST_F(Ply, BinaryDataStartsRightAfterTheHeader) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    for (int first = 0; first < 256; ++first) {
      std::string text =
          header("binary_little_endian", "element u 1\nproperty uchar first\n" + kVertex + kFace);
      std::string with_ends;
      for (const char c : text) with_ends += c == '\n' ? end : std::string(1, c);
      Data data("binary_little_endian");
      data.put("uchar", first);
      for (const double v : {0, 0, 0, 1, 0, 0, 0, 1, 0}) data.put("float", v);
      data.put("uchar", 3).put("int", 0).put("int", 1).put("int", 2);
      const Mesh mesh = load("t.ply", with_ends + data.bytes);
      ASSERT_EQ(corner(mesh, 0, 1), glm::dvec3(1, 0, 0)) << first;
    }
  }
}

TEST_F(Ply, ValuesAreTokensWhereverLinesEnd) {
  const std::string head = header("ascii", kVertex + kFace);
  for (const char* data :
       {"0 0 0 1 0 0 0 1 0 3 0 1 2", "0\n0\n0\n1\n0\n0\n0\n1\n0\n3\n0\n1\n2\n",
        "0 0 0 1 0\n0 0 1 0 3\n0 1 2\n", "\n\n0 0\t0\n\n1 0 0\n0 1 0\n3 0 1 2\n\n",
        "0 0 0\n1 0 0\n0 1 0\n3.0 0.0 1e0 2\n"}) {
    EXPECT_EQ(corner(load("t.ply", head + data), 0, 2), glm::dvec3(0, 1, 0)) << data;
  }
}

TEST_F(Ply, ColoursAreOfVerticesOrFacesInEveryType) {
  struct Scale {
    const char* type;
    const char* full;
  };
  for (const Scale& scale : {Scale{"uchar", "255"},
                             {"ushort", "65535"},
                             {"int", "255"},
                             {"uint", "255"},
                             {"float", "1"},
                             {"double", "255"},
                             {"uchar", "255.0"}}) {
    for (const std::string prefix : {"", "diffuse_"}) {
      for (const bool of_face : {false, true}) {
        std::string colour;
        for (const char* name : {"red", "green", "blue"}) {
          colour += std::string("property ") + scale.type + " " + prefix + name + "\n";
        }
        const std::string value = std::string(" ") + scale.full + " 0 " + scale.full;
        const std::string v = of_face ? "" : value;
        const Mesh mesh = load("t.ply", header("ascii", kVertex + (of_face ? "" : colour) + kFace +
                                                            (of_face ? colour : "")) +
                                            "0 0 0" + v + "\n1 0 0" + v + "\n0 1 0" + v +
                                            "\n3 0 1 2" + (of_face ? value : "") + "\n");
        EXPECT_EQ(color(mesh, 0, 1), glm::vec3(1, 0, 1)) << scale.type << prefix << of_face;
      }
    }
  }
}

TEST_F(Ply, WhatIsNotUsedRefusesNothing) {
  const std::string head =
      header("ascii",
             "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty "
             "float nx\nproperty float ny\nproperty float nz\nproperty float quality\n" +
                 kFace);
  for (const char* odd : {"nan nan nan nan", "0 0 0 -1.#IND", "inf 0 0 inf", "-nan(ind) 0 0 ?"}) {
    const std::string o(odd);
    const Mesh mesh = load("t.ply", head + "0 0 0 " + o + "\n1 0 0 " + o + "\n0 1 0 " + o +
                                        "\nnan inf 1e99 0 0 0 0\n3 0 1 2\n");
    EXPECT_EQ(normal(mesh, 0, 0), glm::vec3(0, 0, 1)) << odd;
    EXPECT_EQ(mesh.positions.size(), 3U);
  }
  std::string what;
  const std::string used = write("t.ply", head +
                                              "0 0 0 0 0 0 0\nnan 0 0 0 0 0 0\n0 1 0 0 0 0 0\n"
                                              "0 0 0 0 0 0 0\n3 0 1 2\n");
  EXPECT_EQ(error_of(used, &what), 13);
  EXPECT_EQ(what.rfind(used + ":15: vertex 1 ", 0), 0U) << what;
}

TEST_F(Ply, WhatIsLeftOutIsCounted) {
  const Mesh mesh =
      load("t.ply", header("ascii", kVertex + "element face 5\nproperty list uchar int "
                                              "vertex_indices\n") +
                        "0 0 0\n1 0 0\n0 1 0\n0\n1 2\n3 0 1 2\n2 0 1\n3 2 1 0\nmore 1 2");
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(left_out(mesh, "faces_of_fewer_than_3_corners"), 3U);
  EXPECT_EQ(left_out(mesh, "bytes_after_the_data"), 9U);
  EXPECT_EQ(
      mesh.left_out.note(),
      "left out: 3 faces of fewer than 3 corners (the first in line 13), 9 bytes after the data");
}

}  // namespace
}  // namespace halfspace
