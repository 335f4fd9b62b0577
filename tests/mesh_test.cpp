// SPDX-License-Identifier: Apache-2.0
//
// Every mesh of tests/scenes loads as what it is; every one of tests/broken is refused with the
// error code that expected.txt has for it.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <set>

#include "mesh_fixture.hpp"
#include "outline.hpp"

namespace halfspace {
namespace {

const std::string kScenes = HALFSPACE_TEST_DIR "/scenes/";
const std::string kBroken = HALFSPACE_TEST_DIR "/broken/";

void expect_valid(const Mesh& mesh) {
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t index : triangle) ASSERT_LT(index, mesh.positions.size());
  }
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_NEAR(glm::length(mesh.normals[i]), 1.0F, 1e-5F) << i;
    for (int k = 0; k < 3; ++k) {
      EXPECT_TRUE(mesh.colors[i][k] >= 0.0F && mesh.colors[i][k] <= 1.0F) << i;
    }
  }
}

struct SceneFile {
  const char* name;
  std::size_t triangles;
  bool is_closed;  // a surface without border whose faces look outwards
};

TEST(Mesh, EverySceneHasItsTriangles) {
  const SceneFile scenes[] = {{"teapot.obj", 992, false},
                              {"bunny.obj", 3674, false},
                              {"torus.ply", 1024, true},
                              {"icosphere.ply", 1280, true},
                              {"icosphere_big_endian.ply", 80, true},
                              {"knot.stl", 1280, true},
                              {"tetrahedron.stl", 4, true},
                              {"cube.gltf", 12, true},
                              {"gems.glb", 24, true}};
  for (const SceneFile& scene : scenes) {
    SCOPED_TRACE(scene.name);
    const Mesh mesh = load_mesh(kScenes + scene.name);
    EXPECT_EQ(mesh.triangles.size(), scene.triangles);
    expect_valid(mesh);
    EXPECT_TRUE(!scene.is_closed || volume(mesh) > 0.0);
  }
}

// Half the frame's width would be too little already; camera_test.cpp has random points.
TEST(Mesh, FillsTheFrameByItself) {
  for (const char* name : {"teapot.obj", "bunny.obj"}) {
    const Mesh mesh = load_mesh(kScenes + name);
    const double aspect = 640.0 / 480.0;
    const Outline seen =
        expect_in_frame(mesh.positions, frame_camera(mesh.positions, aspect), aspect);
    EXPECT_NEAR(seen.pair(), 0.95, 1e-4) << name;
    EXPECT_GT(seen.high.x - seen.low.x, 2 * 0.5) << name;
    EXPECT_GT(seen.high.y - seen.low.y, 2 * 0.5) << name;
  }
}

TEST(Mesh, NodeTransformsAreApplied) {
  const Mesh cube = load_mesh(kScenes + "cube.gltf");
  // Three times as long in z, a quarter turn around y, two up.
  glm::vec3 low = cube.positions[0], high = low;
  for (const glm::vec3& position : cube.positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  EXPECT_LT(glm::length(low - glm::vec3(-3, 1, -1)), 1e-4F);
  EXPECT_LT(glm::length(high - glm::vec3(3, 3, 1)), 1e-4F);
  EXPECT_NEAR(volume(cube), 6.0 * 24.0, 1e-3);
}

TEST(Mesh, VertexColorsComeBeforeMaterialColorsComeBeforeWhite) {
  std::set<int> corners;
  for (const glm::vec3& c : load_mesh(kScenes + "cube.gltf").colors) {
    corners.insert(static_cast<int>(4 * c.x + 2 * c.y + c.z));
  }
  EXPECT_EQ(corners.size(), 8U);
  std::set<float> reds;
  for (const glm::vec3& c : load_mesh(kScenes + "gems.glb").colors) reds.insert(c.x);
  EXPECT_EQ(reds, (std::set<float>{0.2F, 0.9F}));
  for (const glm::vec3& c : load_mesh(kScenes + "teapot.obj").colors) {
    EXPECT_EQ(c, glm::vec3(1.0F));
  }
}

TEST(Mesh, SphereNormalsPointOutwards) {
  const Mesh sphere = load_mesh(kScenes + "icosphere.ply");
  for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
    EXPECT_GT(glm::dot(sphere.positions[i], sphere.normals[i]), 0.99F);
  }
}

TEST(Mesh, EveryBrokenFileIsRefusedWithItsCode) {
  std::ifstream list(kBroken + "expected.txt");
  std::string name;
  int code = 0, files = 0;
  while (list >> code >> name) {
    std::string what;
    EXPECT_EQ(error_of(kBroken + name, &what), code) << name << ": " << what;
    EXPECT_EQ(what.rfind(kBroken + name, 0), 0U) << "the place comes first: " << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    ++files;
  }
  EXPECT_GE(files, 55);
}

TEST(Mesh, AMissingFileOrADirectoryCannotBeRead) {
  EXPECT_EQ(error_of(kScenes + "no_such.obj"), static_cast<int>(ErrorCode::kFileRead));
  EXPECT_EQ(error_of(kScenes), static_cast<int>(ErrorCode::kFileRead));
}

// They would be what the camera frames. Neither format's reader may keep them.
TEST_F(MeshFile, UnusedVerticesAreLeftOut) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "900 0 0 1 1 1\n0 0 0 255 0 0\n0 900 0 1 1 1\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 4 1 3\n";
  const std::string obj = "v 900 0 0\nv 0 0 0\nv 0 900 0\nv 1 0 0\nv 0 1 0\nf 5 2 4\n";
  for (const std::string& path : {write("unused.ply", ply), write("unused.obj", obj)}) {
    SCOPED_TRACE(path);
    const Mesh mesh = load_mesh(path);
    ASSERT_EQ(mesh.triangles.size(), 1U);
    EXPECT_EQ(mesh.positions.size(), 3U);
    expect_valid(mesh);
    const auto& t = mesh.triangles[0];
    EXPECT_EQ(mesh.positions[t[0]], glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh.positions[t[1]], glm::vec3(0, 0, 0));
    EXPECT_EQ(mesh.positions[t[2]], glm::vec3(1, 0, 0));
    const bool has_colors = path.ends_with(".ply");
    EXPECT_EQ(mesh.colors[t[0]], has_colors ? glm::vec3(0, 0, 1) : glm::vec3(1));
    EXPECT_EQ(mesh.colors[t[1]], has_colors ? glm::vec3(1, 0, 0) : glm::vec3(1));
    EXPECT_EQ(mesh.colors[t[2]], has_colors ? glm::vec3(0, 1, 0) : glm::vec3(1));
  }
}

TEST_F(MeshFile, ErrorsNameTheLine) {
  std::string what;
  const std::string path = write("line.obj", "# one\nv 0 0 \\\n 0\r\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  EXPECT_EQ(error_of(path, &what), static_cast<int>(ErrorCode::kMeshIndex));
  EXPECT_EQ(what, path + ":6: index 9, but the file has 3 vertices");
}

TEST_F(MeshFile, EveryTruncationOfASceneIsRefusedOrIsWhole) {
  for (const char* name :
       {"tetrahedron.stl", "icosphere_big_endian.ply", "cube.gltf", "gems.glb"}) {
    std::ifstream in(kScenes + name, std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(in)), {});
    const std::size_t triangles = load_mesh(kScenes + name).triangles.size();
    for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 400) {
      const std::string path = write(std::string("cut_") + name, whole.substr(0, size));
      try {
        // Only blanks and the name after endsolid may go unnoticed. Whole facets are drawn, and it
        // is said that the end is missing.
        const Mesh mesh = load_mesh(path);
        if (!mesh.left_out.empty()) continue;
        EXPECT_EQ(mesh.triangles.size(), triangles) << name << " cut to " << size;
        EXPECT_GT(size + 16, whole.size()) << name;
      } catch (const Error&) {
      }
    }
  }
}

TEST_F(MeshFile, ObjCutInTheMiddleOfALineIsRefusedOrSaid) {
  std::ifstream in(kScenes + "teapot.obj", std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(in)), {});
  // Between the first face and the last vertex's first use some vertex is always unused.
  for (std::size_t size = 150; size < whole.size() - 200; size += 997) {
    if (whole[size - 1] == '\n') continue;
    const std::string path = write("cut.obj", whole.substr(0, size));
    EXPECT_TRUE(error_of(path) != 0 || !load_mesh(path).left_out.empty()) << size;
  }
}

TEST_F(MeshFile, ObjWithoutAFinalLineEndLoads) {
  EXPECT_EQ(load_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3").triangles.size(), 1U);
  EXPECT_EQ(load_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n# the end").triangles.size(), 1U);
}

TEST_F(MeshFile, ObjDialectsMeanTheSame) {
  const char* const with_all_else =
      "mtllib none.mtl\no a\ng b c\ns off\nfoo 1 2\nvp 1 2\ncstype bezier\n"
      "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1\nl 1 2\nf 1 \\\n 2 \\\n 3\n";
  const char* const texts[] = {
      with_all_else,
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
      "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
      "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
      "\tv +0 0 -0 # comment\n v\t1. .0 0e5\nv 0 1 0 1\n  f 1 2 3 # comment\n",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n",
      "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0\nvt 1 0\nvt 0 1 0\nf 1/1 2/2 3/-1\n"};
  for (const char* text : texts) {
    const Mesh mesh = load_obj(text);
    ASSERT_EQ(mesh.triangles.size(), 1U) << text;
    const auto& t = mesh.triangles[0];
    EXPECT_EQ(mesh.positions[t[0]], glm::vec3(0, 0, 0)) << text;
    EXPECT_EQ(mesh.positions[t[1]], glm::vec3(1, 0, 0)) << text;
    EXPECT_EQ(mesh.positions[t[2]], glm::vec3(0, 1, 0)) << text;
    EXPECT_EQ(mesh.normals[t[0]], glm::vec3(0, 0, 1)) << text;
  }
}

TEST_F(MeshFile, ObjPolygonsColorsAndMaterialsAreRead) {
  const Mesh pentagon =
      load_obj("v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 .5 0\nv 0 2 0\nf 1 2 3 4 5\n");  // one reflex corner
  EXPECT_EQ(pentagon.triangles.size(), 3U);
  double area = 0.0;
  for (const auto& t : pentagon.triangles) {
    area += glm::cross(pentagon.positions[t[1]] - pentagon.positions[t[0]],
                       pentagon.positions[t[2]] - pentagon.positions[t[0]])
                .z /
            2.0;
  }
  EXPECT_NEAR(area, 2.25, 1e-6);

  const Mesh coloured =
      load_obj("v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0 0 1 1.5\nf 1 2 3\n");  // white, and clamped
  const auto& t = coloured.triangles.at(0);
  EXPECT_EQ(coloured.colors[t[0]], glm::vec3(1, 0, 0));
  EXPECT_EQ(coloured.colors[t[1]], glm::vec3(1, 1, 1));
  EXPECT_EQ(coloured.colors[t[2]], glm::vec3(0, 1, 1));

  write("paint.mtl", "newmtl red\nKd 1 0 0.25\n");
  const Mesh painted =
      load_obj("mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
  EXPECT_EQ(painted.colors.at(0), glm::vec3(1, 0, 0.25));
}

TEST_F(MeshFile, GltfWithoutASceneStillHasItsNodes) {
  std::ifstream in(kScenes + "cube.gltf");
  std::string text((std::istreambuf_iterator<char>(in)), {});
  for (const char* key : {"\"scene\"", "\"scenes\""}) {
    const std::size_t at = text.find(key);
    ASSERT_NE(at, std::string::npos);
    text.replace(at + 1, 2, "xx");
  }
  EXPECT_EQ(load_mesh(write("no_scene.gltf", text)).triangles.size(), 12U);
}

}  // namespace
}  // namespace halfspace
