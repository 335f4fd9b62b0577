// SPDX-License-Identifier: Apache-2.0
//
// Every file of tests/meshes is what its line in expected.txt says: triangles, vertices, colours
// and what was left out, or the code of its refusal.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <sstream>

#include "mesh_fixture.hpp"

namespace halfspace {
namespace {

const std::string kMeshes = HALFSPACE_TEST_DIR "/meshes/";

std::string hex(const glm::vec3& color) {
  char text[8];
  std::snprintf(text, sizeof text, "%02x%02x%02x",
                static_cast<unsigned>(std::lround(255 * color.x)),
                static_cast<unsigned>(std::lround(255 * color.y)),
                static_cast<unsigned>(std::lround(255 * color.z)));
  return text;
}

// Up to four colours by name, else how many.
std::string colors_of(const Mesh& mesh) {
  std::set<std::string> seen;
  for (const glm::vec3& color : mesh.colors) seen.insert(hex(color));
  if (seen.size() > 4) return std::to_string(seen.size()) + "_colours";
  std::string text;
  for (const std::string& color : seen) text += (text.empty() ? "" : ",") + color;
  return text;
}

std::string what_is(const std::string& path) {
  std::ostringstream out;
  try {
    const Mesh mesh = load_mesh(path);
    out << mesh.triangles.size() << ' ' << mesh.positions.size() << ' ' << colors_of(mesh);
    for (const LeftOut::Kind& kind : mesh.left_out.kinds()) {
      out << ' ' << kind.key << '=' << kind.count;
    }
  } catch (const Error& error) {
    out << "refused " << static_cast<int>(error.code());
  }
  return out.str();
}

TEST(MeshFiles, EachIsWhatItsLineSays) {
  std::ifstream list(kMeshes + "expected.txt");
  std::set<std::string> named;
  for (std::string line; std::getline(list, line);) {
    const std::string name = line.substr(0, line.find(' '));
    EXPECT_EQ(name + ' ' + what_is(kMeshes + name), line);
    named.insert(name);
  }
  EXPECT_GE(named.size(), 170U);
  for (const auto& entry : std::filesystem::directory_iterator(kMeshes)) {
    const std::string extension = entry.path().extension().string();
    if (extension.empty() || extension == ".txt" || extension == ".md" || extension == ".mtl" ||
        extension == ".bin") {
      continue;
    }
    EXPECT_EQ(named.count(entry.path().filename().string()), 1U) << entry.path();
  }
}

}  // namespace
}  // namespace halfspace
