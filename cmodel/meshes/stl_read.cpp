// SPDX-License-Identifier: Apache-2.0
//
// STL, binary and ASCII. Facets share no vertices in the file; those at one point are one here.
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "../io/error.hpp"
#include "position_set.hpp"
#include "stl_text.hpp"

namespace halfspace {
namespace {

constexpr std::size_t kHeaderSize = 84;  // 80 bytes of text, the number of triangles
constexpr std::size_t kFacetSize = 50;   // 12 floats, 2 bytes of attributes

std::uint32_t little_endian(std::string_view bytes, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = size; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[i]);
  return value;
}

// The colour in a facet's attribute: VisCAM's where bit 15 is set; with a default colour in the
// header Magics', whose channels are the other way round, where bit 15 is not.
class StlColors {
 public:
  explicit StlColors(std::string_view header) {
    const std::size_t at = header.find("COLOR=");
    if (at == std::string_view::npos || at + 9 > 80) return;
    const auto channel = [&](std::size_t i) {
      return static_cast<float>(static_cast<std::uint8_t>(header[at + 6 + i])) / 255.0F;
    };
    default_ = glm::vec3(channel(0), channel(1), channel(2));
  }

  // Nothing where the facet has none.
  std::optional<glm::vec3> of(std::uint32_t attribute) const {
    const bool bit = (attribute & 0x8000U) != 0;
    const auto channel = [attribute](unsigned shift) {
      return static_cast<float>(attribute >> shift & 31U) / 31.0F;
    };
    if (default_ && bit) return default_;
    if (default_) return glm::vec3(channel(0), channel(5), channel(10));
    if (!bit) return {};
    return glm::vec3(channel(10), channel(5), channel(0));
  }

 private:
  std::optional<glm::vec3> default_;
};

class StlReader {
 public:
  explicit StlReader(const MeshSource& source) : source_(source) {}

  RawMesh read() {
    const std::size_t size = source_.bytes.size();
    const std::size_t count = size < kHeaderSize ? 0 : little_endian(source_.bytes.substr(80), 4);
    const std::size_t end = kHeaderSize + kFacetSize * count;
    if (size != end && is_stl_text(source_.bytes)) {
      read_stl_text(source_, [this](const auto& corners, std::size_t) { add(corners); });
      return std::move(mesh_);
    }
    if (size < end) fail_short(count);
    if (count > kNoIndex / 3) fail("has more than 2^32 / 3 triangles");
    read_binary(count);
    source_.left_out.add("bytes_after_the_data", "byte after the data", "bytes after the data",
                         size - end);
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& text) const {
    throw Error(ErrorCode::kMeshBroken, source_.path, text);
  }

  [[noreturn]] void fail_short(std::size_t count) const {
    const std::size_t size = source_.bytes.size();
    fail(size < kHeaderSize
             ? "neither ASCII STL nor as long as the 84-byte header of binary STL"
             : "the header says " + std::to_string(count) + " triangles of 50 bytes, but " +
                   std::to_string(size - kHeaderSize) + " bytes follow it");
  }

  void read_binary(std::size_t count) {
    const StlColors colors(source_.bytes.substr(0, 80));
    mesh_.triangles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string_view facet = source_.bytes.substr(kHeaderSize + i * kFacetSize, kFacetSize);
      std::array<glm::dvec3, 3> corners;
      for (std::size_t k = 0; k < 9; ++k) {
        const float value = std::bit_cast<float>(little_endian(facet.substr(12 + 4 * k), 4));
        if (!std::isfinite(value)) fail_not_finite(i);
        corners[k / 3][static_cast<int>(k % 3)] = static_cast<double>(value);
      }
      add(corners);
      add_color(colors.of(little_endian(facet.substr(48), 2)));
      if (i % kReportEvery == 0) source_.report(source_.bytes.size() - i * kFacetSize);
    }
    if (!mesh_.palette.empty()) mesh_.triangle_colors.resize(count, 0);
  }

  [[noreturn]] void fail_not_finite(std::size_t facet) const {
    throw Error(
        ErrorCode::kMeshNotFinite, source_.path,
        "facet " + std::to_string(facet) + " (counted from 0) has a vertex that is not finite");
  }

  void add(const std::array<glm::dvec3, 3>& corners) {
    TriangleIndices& triangle = mesh_.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto index = static_cast<std::uint32_t>(mesh_.positions.size());
      mesh_.positions.push_back(corners[i]);
      triangle[i] = points_.first_equal(mesh_.positions, index);
      if (triangle[i] != index) mesh_.positions.pop_back();
    }
  }

  // Of the last triangle. Those without one are white, the palette's first.
  void add_color(const std::optional<glm::vec3>& color) {
    if (!color) return;
    if (mesh_.palette.empty()) mesh_.palette.emplace_back(1.0F);
    if (mesh_.palette.back() != *color) mesh_.palette.push_back(*color);
    mesh_.triangle_colors.resize(mesh_.triangles.size() - 1, 0);
    mesh_.triangle_colors.push_back(static_cast<std::uint32_t>(mesh_.palette.size() - 1));
  }

  const MeshSource& source_;
  RawMesh mesh_;
  PositionSet points_;
};

}  // namespace

RawMesh read_stl(const MeshSource& source) { return StlReader(source).read(); }

}  // namespace halfspace
