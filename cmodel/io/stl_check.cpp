// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "error.hpp"
#include "mesh_checks.hpp"
#include "scan.hpp"

namespace halfspace {
namespace {

constexpr std::size_t kHeaderSize = 84;  // 80 bytes of text, the number of triangles
constexpr std::size_t kFacetSize = 50;   // 12 floats, 2 bytes of attributes

std::uint32_t little_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[i]);
  return value;
}

// One keyword a line, as every writer makes it.
class StlText {
 public:
  StlText(const std::string& path, std::string_view bytes) : path_(path), rest_(bytes) {}

  std::size_t check() {
    while (!rest_.empty()) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      std::string_view line = rest_.substr(0, end);
      rest_.remove_prefix(std::min(rest_.size(), end + 1));
      ++line_;
      check_line(line);
    }
    if (!closed_) fail("the file ends before endsolid");
    return facets_;
  }

 private:
  [[noreturn]] void fail(const std::string& text, ErrorCode code = ErrorCode::kMeshBroken) const {
    throw Error(code, path_ + ":" + std::to_string(line_), text);
  }

  void check_line(std::string_view line) {
    const std::string_view keyword = next_token(line);
    if (keyword == "solid") {
      closed_ = false;
    } else if (keyword == "endsolid") {
      if (in_facet_) fail("endsolid inside a facet");
      closed_ = true;
    } else if (keyword == "facet") {
      if (in_facet_) fail("a facet inside a facet");
      in_facet_ = true;
      vertices_ = 0;
      next_token(line);  // "normal"
      numbers(line);
    } else if (keyword == "vertex") {
      ++vertices_;
      numbers(line);
    } else if (keyword == "endfacet") {
      if (!in_facet_ || vertices_ != 3) {
        fail("a facet needs 3 vertices, here are " + std::to_string(vertices_));
      }
      in_facet_ = false;
      ++facets_;
    } else if (!keyword.empty() && keyword != "outer" && keyword != "endloop") {
      fail(shown(keyword) + " is not an STL keyword");
    }
  }

  void numbers(std::string_view line) const {
    for (int i = 0; i < 3; ++i) {
      const std::string_view token = next_token(line);
      const std::optional<double> value = parse_number(token);
      if (!value) fail(token.empty() ? "a number is missing" : shown(token) + " is not a number");
      if (!is_finite_float(*value)) {
        fail(shown(token) + " is not a finite single-precision number", ErrorCode::kMeshNotFinite);
      }
    }
  }

  const std::string& path_;
  std::string_view rest_;
  std::size_t line_ = 0;
  std::size_t facets_ = 0;
  int vertices_ = 0;
  bool in_facet_ = false;
  bool closed_ = false;
};

}  // namespace

std::size_t check_stl(const std::string& path, std::string_view bytes) {
  const std::size_t count = bytes.size() < kHeaderSize ? 0 : little_endian(bytes.substr(80, 4));
  const bool is_binary = bytes.size() == kHeaderSize + kFacetSize * count;
  std::string_view start = bytes;
  const bool is_text =
      !is_binary && next_token(start) == "solid" && bytes.find('\0') == std::string_view::npos;
  if (!is_binary && !is_text) {
    const std::string text =
        bytes.size() < kHeaderSize
            ? "neither ASCII STL nor as long as the 84-byte header of binary STL"
            : "the header says " + std::to_string(count) + " triangles of 50 bytes, but " +
                  std::to_string(bytes.size() - kHeaderSize) + " bytes follow it";
    throw Error(ErrorCode::kMeshBroken, path, text);
  }
  const std::size_t facets = is_binary ? count : StlText(path, bytes).check();
  if (facets == 0) throw Error(ErrorCode::kMeshEmpty, path, "has no triangles");
  return facets;
}

}  // namespace halfspace
