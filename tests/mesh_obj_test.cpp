// SPDX-License-Identifier: Apache-2.0
//
// OBJ and its materials: what is not used refuses nothing, and a material never does.
#include "mesh_fixture.hpp"

namespace halfspace {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

class Obj : public MeshFile {
 protected:
  // The colour of a face that uses material m of a.mtl.
  glm::vec3 material(const std::string& text, const std::string& library = "mtllib a.mtl",
                     const std::string& use = "usemtl m") const {
    write("a.mtl", text);
    return color(load_obj(library + "\n" + kTriangle + use + "\nf 1 2 3\n"), 0, 0);
  }
};

TEST_F(Obj, WhatIsNotUsedRefusesNothing) {
  for (const char* text : {"\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1// 2// 3//\n",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1/ 2/1/ 3/1/\n",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/ 2/9 3/-7\n",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/a/b 2/0 3/1\n",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//9 2//-7 3//0\n",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn nan 0 1\nf 1//1 2//1 3//1\n",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn -1.#IND 1.#QNAN 0\nf 1//1 2//1 3//1\n",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0\nvt\nf 1//1 2//1 3//1\n",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt nan x # c\nvn # c\nf 1/1 2/1 3/1#c\n",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan inf 1e99\nv -1.#IND 0 0\nf 1 2 3\n",
                           "v 0 0 0 .5 .5\nv 1 0 0 1\nv 0 1 0 1 1 1 1 1\nf 1 2 3\n"}) {
    const Mesh mesh = load_obj(text);
    ASSERT_EQ(mesh.triangles.size(), 1U) << text;
    EXPECT_EQ(mesh.positions.size(), 3U) << text;
    EXPECT_EQ(normal(mesh, 0, 0), glm::vec3(0, 0, 1)) << text;
    EXPECT_EQ(color(mesh, 0, 0), glm::vec3(1)) << text;
  }
}

TEST_F(Obj, GivenNormalsAreUsedCornerByCorner) {
  const Mesh mesh = load_obj(kTriangle + "vn 0 0 5\nvn 3 0 0\nf 1//1 2//-1 3\n");
  EXPECT_EQ(normal(mesh, 0, 0), glm::vec3(0, 0, 1));
  EXPECT_EQ(normal(mesh, 0, 1), glm::vec3(1, 0, 0));
  EXPECT_EQ(normal(mesh, 0, 2), glm::vec3(0, 0, 1));
}

TEST_F(Obj, ABackslashJoinsLinesButNotFromAComment) {
  const Mesh joined = load_obj("v 0 0 \\\n0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\r\n3\n");
  EXPECT_EQ(joined.triangles.size(), 1U);
  EXPECT_TRUE(joined.left_out.empty());
  for (const std::string comment : {"# C:\\dir\\", "  #\\", "g a # C:\\", "vt 0 0 # \\"}) {
    const Mesh mesh = load_obj(comment + "\n" + kTriangle + comment + "\nf 1 2 3\n");
    EXPECT_EQ(corner(mesh, 0, 1), glm::dvec3(1, 0, 0)) << comment;
    EXPECT_EQ(left_out(mesh, "comments_that_end_in_a_backslash"), 2U) << comment;
    EXPECT_EQ(mesh.left_out.kinds()[0].line, 1U);
  }
}

TEST_F(Obj, FacesOfOneOrTwoAreLeftOutAndCounted) {
  const Mesh mesh = load_obj(kTriangle + "f 1 2\nf 1\nf\nf 1 2 3\nl 1 2\np 1\n");
  EXPECT_EQ(mesh.triangles.size(), 1U);
  EXPECT_EQ(left_out(mesh, "faces_of_fewer_than_3_corners"), 3U);
  EXPECT_EQ(left_out(mesh, "lines_and_points"), 2U);
  EXPECT_EQ(mesh.left_out.note(),
            "left out: 2 lines and points (the first in line 8), 3 faces of "
            "fewer than 3 corners (the first in line 4)");
}

TEST_F(Obj, ColoursOfVerticesAreOfEitherScale) {
  const Mesh bytes =
      load_obj("v 0 0 0 255 0 51\nv 1 0 0 0 0 0\nv 0 1 0 102 0 0\nv 9 9 9\nf 1 2 3\nf 2 3 4\n");
  EXPECT_EQ(color(bytes, 0, 0), glm::vec3(1, 0, 0.2F));
  EXPECT_EQ(color(bytes, 1, 2), glm::vec3(1));  // has none
  const Mesh units = load_obj("v 0 0 0 1 0 .5\nv 1 0 0 0 0 0\nv 0 1 0 nan 0 0\nf 1 2 3\n");
  EXPECT_EQ(color(units, 0, 0), glm::vec3(1, 0, 0.5F));
  EXPECT_EQ(color(units, 0, 2), glm::vec3(1));
}

TEST_F(Obj, MaterialsOfEveryWriter) {
  const glm::vec3 red(1, 0, 0), white(1);
  for (const char* text :
       {"newmtl m\nKd 1 0 0\n", "\xef\xbb\xbfnewmtl m\r\n\tKd 1 0 0\r\n", "  newmtl m\n  Kd 1 0 0",
        "newmtl m\naniso 0.7\nanisor 1\nadobe_x 1\nKd 1 0 0\nmap_Kd -s 1 1 a.png\nillum x\n",
        "map_Kd wood.png\nKd 0 1 0\nnewmtl m\nKd 1 0 0\n",
        "newmtl m\nKd 1 0 0\nnewmtl m\nKd 0 1 0\n", "newmtl m\nkd 1 0 0 # red\n",
        "NEWMTL m\nKD 1 0 0\n"}) {
    EXPECT_EQ(material(text), red) << text;
  }
  EXPECT_EQ(material("newmtl m\nKd 0.25\n"), glm::vec3(0.25F));
  for (const char* text :
       {"newmtl m\n", "newmtl m\nKd\n", "newmtl m\nKd spectral a.rfl\n", "newmtl m\nKd nan 0 0\n",
        "newmtl m\nKd 0 0 0\nmap_Kd a.png\n", "", "\n\n", "newmtl\n", "map_Kd a.png\n"}) {
    EXPECT_EQ(material(text), white) << text;
  }
  EXPECT_EQ(material("newmtl m\nKd 0 0 0\n"), glm::vec3(0));
}

TEST_F(Obj, MaterialFilesAreFoundByEveryName) {
  const std::string text = "newmtl m\nKd 1 0 0\n";
  const glm::vec3 red(1, 0, 0);
  write("b.mtl", "newmtl n\nKd 0 0 1\n");
  write("my paint.mtl", text);
  std::filesystem::create_directory(directory_ / "sub");
  write("sub/c.mtl", text);
  for (const char* library :
       {"mtllib a.mtl", "mtllib b.mtl a.mtl", "mtllib a.mtl b.mtl", "mtllib A.MTL",
        "mtllib \"a.mtl\"", "mtllib a.mtl # paint", "mtllib my paint.mtl", "mtllib ./a.mtl",
        "mtllib sub\\c.mtl", "mtllib C:\\work\\a.mtl", "mtllib none.mtl a.mtl",
        "mtllib  a.mtl \r"}) {
    EXPECT_EQ(material(text, library), red) << library;
  }
  EXPECT_EQ(material(text, "mtllib a.mtl", "usemtl m # paint"), red);
  EXPECT_EQ(material("newmtl a b\nKd 1 0 0\n", "mtllib a.mtl", "usemtl  a b "), red);
}

TEST_F(Obj, MissingMaterialsAreSaid) {
  const Mesh mesh = load_obj("mtllib none.mtl\n" + kTriangle +
                             "usemtl m\nf 1 2 3\nusemtl n\nf 1 2 3\nusemtl m\n");
  EXPECT_EQ(color(mesh, 0, 0), glm::vec3(1));
  EXPECT_EQ(left_out(mesh, "material_files"), 1U);
  EXPECT_EQ(left_out(mesh, "materials"), 2U);
  // A device does not end, a directory is no file.
  for (const char* name : {"/dev/zero", "../../../../../../dev/zero", "."}) {
    EXPECT_EQ(left_out(load_obj(std::string("mtllib ") + name + "\n" + kTriangle + "f 1 2 3\n"),
                       "material_files"),
              1U)
        << name;
  }
}

TEST_F(Obj, AFileWithoutALastLineEndIsReadAndSaidWhenItMayBeCut) {
  EXPECT_TRUE(load_obj(kTriangle + "f 1 2 3").left_out.empty());
  const Mesh mesh = load_obj(kTriangle + "v 9 9 9\nf 1 2 3");
  EXPECT_EQ(left_out(mesh, "vertices_of_a_file_that_may_be_cut"), 1U);
  EXPECT_EQ(error_of(write("t.obj", kTriangle + "f 1 2 3\nf 1 2")), 11);
}

}  // namespace
}  // namespace halfspace
