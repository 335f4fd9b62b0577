// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include "error.hpp"
#include "mesh_checks.hpp"
#include "scan.hpp"

namespace halfspace {
namespace {

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };

struct PlyType {
  std::size_t size = 0;  // bytes; 0: no such type
  bool is_float = false;
  bool is_signed = false;
};

PlyType ply_type(std::string_view name) {
  if (name == "char" || name == "int8") return {1, false, true};
  if (name == "uchar" || name == "uint8") return {1, false, false};
  if (name == "short" || name == "int16") return {2, false, true};
  if (name == "ushort" || name == "uint16") return {2, false, false};
  if (name == "int" || name == "int32") return {4, false, true};
  if (name == "uint" || name == "uint32") return {4, false, false};
  if (name == "float" || name == "float32") return {4, true, true};
  if (name == "double" || name == "float64") return {8, true, true};
  return {};
}

struct PlyProperty {
  std::string name;
  PlyType type;
  PlyType count;  // of a list; size 0 for a single value
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

class PlyChecker {
 public:
  PlyChecker(const std::string& path, std::string_view bytes) : path_(path), rest_(bytes) {}

  std::size_t check() {
    read_header();
    for (const PlyElement& element : elements_) check_element(element);
    if (std::any_of(rest_.begin(), rest_.end(), [](char c) { return !is_blank(c); })) {
      fail("there is more data than the header announces");
    }
    return faces_;
  }

 private:
  [[noreturn]] void fail(const std::string& text, ErrorCode code = ErrorCode::kMeshBroken) const {
    const bool has_lines = in_header_ || format_ == PlyFormat::kAscii;
    throw Error(code, has_lines ? path_ + ":" + std::to_string(line_) : path_, text);
  }

  std::string_view header_line() {
    const std::size_t end = rest_.find('\n');
    ++line_;
    if (end == std::string_view::npos) fail("the file ends inside the header");
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return line;
  }

  void read_header() {
    std::string_view first = header_line();
    if (next_token(first) != "ply") fail("does not start with ply");
    bool has_format = false;
    for (;;) {
      std::string_view line = header_line();
      const std::string_view keyword = next_token(line);
      if (keyword == "end_header") break;
      if (keyword == "format") {
        read_format(line);
        has_format = true;
      } else if (keyword == "element") {
        read_element(line);
      } else if (keyword == "property") {
        read_property(line);
      } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        fail(shown(keyword) + " is not a PLY header keyword");
      }
    }
    if (!has_format) fail("the header has no format line");
    in_header_ = false;
    require_vertices();
    require_faces();
  }

  void read_format(std::string_view line) {
    const std::string_view name = next_token(line);
    if (name == "ascii") {
      format_ = PlyFormat::kAscii;
    } else if (name == "binary_little_endian") {
      format_ = PlyFormat::kLittleEndian;
    } else if (name == "binary_big_endian") {
      format_ = PlyFormat::kBigEndian;
    } else {
      fail(shown(name) + " is not a PLY format");
    }
  }

  void read_element(std::string_view line) {
    PlyElement& element = elements_.emplace_back();
    element.name = next_token(line);
    const std::string_view count = next_token(line);
    const std::optional<std::int64_t> value = parse_integer(count);
    if (!value || *value < 0) fail(shown(count) + " is not a number of elements");
    element.count = *value;
    if (element.name == "vertex") vertices_ = element.count;
  }

  void read_property(std::string_view line) {
    if (elements_.empty()) fail("a property before the first element");
    const auto type = [&] {
      const std::string_view name = next_token(line);
      const PlyType found = ply_type(name);
      if (found.size == 0) fail(shown(name) + " is not a PLY type");
      return found;
    };
    PlyProperty property;
    std::string_view ahead = line;
    if (next_token(ahead) == "list") {
      line = ahead;
      property.count = type();
      if (property.count.is_float) fail("a list's length cannot be a float");
    }
    property.type = type();
    property.name = next_token(line);
    elements_.back().properties.push_back(property);
  }

  void require_vertices() const {
    for (const PlyElement& element : elements_) {
      if (element.name != "vertex") continue;
      std::size_t found = 0;
      for (const PlyProperty& p : element.properties) {
        found += p.name == "x" || p.name == "y" || p.name == "z" ? 1U : 0U;
      }
      if (found == 3) return;
    }
    fail("the header has no element vertex with x, y and z");
  }

  void require_faces() {
    bool has_strips = false;
    for (const PlyElement& element : elements_) {
      if (element.name == "face") faces_ = static_cast<std::size_t>(element.count);
      has_strips = has_strips || (element.name == "tristrips" && element.count > 0);
    }
    if (faces_ == 0 && !has_strips) fail("has no faces", ErrorCode::kMeshEmpty);
    if (has_strips) faces_ = 0;
  }

  void check_element(const PlyElement& element) {
    if (element.properties.empty()) return;  // takes no data, however many there are
    for (std::int64_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& property : element.properties) {
        if (property.count.size == 0) {
          value(property.type, element.name);
        } else {
          check_list(property, element.name);
        }
      }
    }
  }

  void check_list(const PlyProperty& property, const std::string& element) {
    const double length = value(property.count, element);
    if (length < 0) fail("a list of negative length");
    const bool is_face =
        element == "face" && (property.name == "vertex_indices" || property.name == "vertex_index");
    if (is_face && length < 3) {
      fail("a face needs 3 vertices, here are " + std::to_string(static_cast<int>(length)));
    }
    for (double i = 0; i < length; ++i) {
      const double index = value(property.type, element);
      if (is_face && !(index >= 0 && index < static_cast<double>(vertices_))) {
        fail("a face names vertex " + std::to_string(static_cast<std::int64_t>(index)) +
                 ", but there are " + std::to_string(vertices_) + " (counted from 0)",
             ErrorCode::kMeshIndex);
      }
    }
  }

  // The next value of the data, finite.
  double value(const PlyType& type, const std::string& element) {
    const double result =
        format_ == PlyFormat::kAscii ? text_value(type, element) : binary_value(type, element);
    if (type.is_float && !is_finite_float(result)) {
      fail("a " + element + " has a value that is not a finite single-precision number",
           ErrorCode::kMeshNotFinite);
    }
    return result;
  }

  double text_value(const PlyType& type, const std::string& element) {
    std::size_t blanks = 0;
    for (; blanks < rest_.size() && is_blank(rest_[blanks]); ++blanks) {
      if (rest_[blanks] == '\n') ++line_;
    }
    rest_.remove_prefix(blanks);
    const std::string_view token = next_token(rest_);
    if (token.empty()) fail("the file ends before all its elements (here a " + element + ")");
    const std::optional<double> number = parse_number(token);
    if (!number) fail(shown(token) + " is not a number");
    if (!type.is_float && *number != std::floor(*number)) {
      fail(shown(token) + " is not a whole number");
    }
    return *number;
  }

  double binary_value(const PlyType& type, const std::string& element) {
    if (rest_.size() < type.size) {
      fail("the file ends before all its elements (here a " + element + ")");
    }
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.size; ++i) {
      const std::size_t at = format_ == PlyFormat::kLittleEndian ? type.size - 1 - i : i;
      bits = bits << 8 | static_cast<std::uint8_t>(rest_[at]);
    }
    rest_.remove_prefix(type.size);
    if (type.is_float) {
      return type.size == 4
                 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                 : std::bit_cast<double>(bits);
    }
    if (!type.is_signed) return static_cast<double>(bits);
    const auto unused = static_cast<int>(64 - 8 * type.size);
    return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
  }

  const std::string& path_;
  std::string_view rest_;
  std::size_t line_ = 0;
  bool in_header_ = true;
  PlyFormat format_ = PlyFormat::kAscii;
  std::vector<PlyElement> elements_;
  std::int64_t vertices_ = 0;
  std::size_t faces_ = 0;
};

}  // namespace

std::size_t check_ply(const std::string& path, std::string_view bytes) {
  return PlyChecker(path, bytes).check();
}

}  // namespace halfspace
