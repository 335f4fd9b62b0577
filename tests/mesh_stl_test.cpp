// SPDX-License-Identifier: Apache-2.0
//
// STL as its many writers make it.
#include <bit>

#include "mesh_fixture.hpp"

namespace halfspace {
namespace {

void put(std::string& bytes, std::uint32_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    bytes += static_cast<char>(static_cast<std::uint8_t>(value >> (8 * i)));
  }
}

// Facets like stairs; attributes: one each.
std::string binary(std::string header, const std::vector<unsigned>& attributes,
                   float normal = 0.0F) {
  header.resize(80, '\0');
  put(header, static_cast<std::uint32_t>(attributes.size()), 4);
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    const auto z = static_cast<float>(i);
    for (const float value : {normal, normal, normal, 0.F, 0.F, z, 1.F, 0.F, z, 0.F, 1.F, z}) {
      put(header, std::bit_cast<std::uint32_t>(value), 4);
    }
    put(header, attributes[i], 2);
  }
  return header;
}

const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

class Stl : public MeshFile {};

TEST_F(Stl, EveryDialectOfTheTextIsRead) {
  const std::string solid = "solid a\n" + kFacet + "endsolid a\n";
  std::string capitals;
  for (const char c : solid)
    capitals += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  for (const std::string& text :
       {solid, capitals, "\xef\xbb\xbf" + solid, "\n \t\r\n" + solid, "# made\n// by\n" + solid,
        replaced(solid, "endsolid", "end solid"), replaced(solid, "endloop", "end loop"),
        replaced(solid, "endfacet", "EndFacet"), replaced(solid, "\n", "\r"),
        replaced(solid, "\n", "\r\n"), "solid a\n" + replaced(kFacet, "\n", " ") + "\nendsolid",
        replaced(solid, "facet normal", "facet"), replaced(solid, " normal 0 0 1", ""),
        replaced(solid, "0 0 1", "nan nan nan"), replaced(solid, "0 0 1", "-1.#IND 1.#QNAN inf"),
        replaced(solid, "solid a", "solid facet endsolid vertex"),
        replaced(solid, "solid a", "solid " + std::string(100000, 'x')),
        replaced(solid, "solid a\n", "solid a" + std::string(7, '\0') + "\n"),
        "solid empty\nendsolid\n" + solid}) {
    const Mesh mesh = load("t.stl", text);
    ASSERT_EQ(mesh.triangles.size(), 1U) << text.substr(0, 90);
    EXPECT_EQ(normal(mesh, 0, 0), glm::vec3(0, 0, 1));
    EXPECT_TRUE(mesh.left_out.empty()) << text.substr(0, 90);
  }
}

TEST_F(Stl, AMissingEndIsSaidAndAHalfFacetRefused) {
  const std::string solid = "solid a\n" + kFacet + kFacet;
  EXPECT_EQ(left_out(load("t.stl", solid), "missing_endsolid"), 1U);
  EXPECT_EQ(error_of(write("t.stl", solid.substr(0, solid.size() - 30))), 11);
}

TEST_F(Stl, BinaryFilesThatStartWithSolidAndHaveMoreBytesAreRead) {
  for (const std::string header : {"", "solid", "solid part of something", "  solid"}) {
    for (const std::string more : {"", "\n", "more bytes", "solid"}) {
      const Mesh mesh = load("t.stl", binary(header, {0, 0, 0}) + more);
      EXPECT_EQ(mesh.triangles.size(), 3U) << header;
      EXPECT_EQ(left_out(mesh, "bytes_after_the_data"), more.size());
    }
  }
  const float nan = std::bit_cast<float>(0x7fc00000U);
  EXPECT_EQ(load("t.stl", binary("", {0}, nan)).triangles.size(), 1U);
}

TEST_F(Stl, AttributesAreColours) {
  const glm::vec3 red(1, 0, 0), blue(0, 0, 1), white(1);
  const Mesh viscam = load("t.stl", binary("", {0x801f, 0xfc00, 0x001f, 0x7c00}));
  EXPECT_EQ(color(viscam, 0, 0), blue);
  EXPECT_EQ(color(viscam, 1, 0), red);
  EXPECT_EQ(color(viscam, 2, 0), white);
  EXPECT_EQ(color(viscam, 3, 0), white);
  const Mesh magics =
      load("t.stl", binary("x COLOR=\xff\x33\xcc\xff,MATERIAL=", {0x801f, 0xfc00, 0x001f, 0x7c00}));
  EXPECT_EQ(color(magics, 0, 0), glm::vec3(1, 0.2F, 0.8F));
  EXPECT_EQ(color(magics, 1, 0), glm::vec3(1, 0.2F, 0.8F));
  EXPECT_EQ(color(magics, 2, 0), red);
  EXPECT_EQ(color(magics, 3, 0), blue);
}

TEST_F(Stl, CornersAtOnePointAreOne) {
  const Mesh mesh =
      load("t.stl",
           "solid\n" + kFacet + replaced(kFacet, "vertex 0 0 0", "vertex 1 1 -0") + "endsolid\n");
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(mesh.positions.size(), 6U);  // the second lies upside down
  EXPECT_EQ(load("t.stl", "solid\n" + kFacet + kFacet + "endsolid\n").positions.size(), 3U);
}

}  // namespace
}  // namespace halfspace
