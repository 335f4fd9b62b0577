// SPDX-License-Identifier: Apache-2.0
#include "ply_header.hpp"

#include <algorithm>
#include <array>

#include "../io/error.hpp"
#include "../io/scan.hpp"

namespace halfspace {
namespace {

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

PlyRole value_role(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, PlyRole>, 15> kNames{{
      {"x", PlyRole::kX},
      {"y", PlyRole::kY},
      {"z", PlyRole::kZ},
      {"nx", PlyRole::kNormalX},
      {"ny", PlyRole::kNormalY},
      {"nz", PlyRole::kNormalZ},
      {"red", PlyRole::kRed},
      {"green", PlyRole::kGreen},
      {"blue", PlyRole::kBlue},
      {"r", PlyRole::kRed},
      {"g", PlyRole::kGreen},
      {"b", PlyRole::kBlue},
      {"diffuse_red", PlyRole::kRed},
      {"diffuse_green", PlyRole::kGreen},
      {"diffuse_blue", PlyRole::kBlue},
  }};
  const auto found = std::find_if(kNames.begin(), kNames.end(),
                                  [name](const auto& known) { return known.first == name; });
  return found == kNames.end() ? PlyRole::kNone : found->second;
}

class PlyHeaderReader {
 public:
  PlyHeaderReader(const std::string& path, std::string_view bytes)
      : path_(path), size_(bytes.size()), rest_(bytes) {}

  PlyHeader read() {
    if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
    std::string_view first = take_line();
    if (next_token(first) != "ply") fail("does not start with ply");
    bool has_format = false;
    for (;;) {
      std::string_view line = take_line();
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
    for (PlyElement& element : header_.elements) give_roles(element);
    const PlyElement* vertex = header_.find(PlyKind::kVertex);
    if (vertex == nullptr || !vertex->has(PlyRole::kX) || !vertex->has(PlyRole::kY) ||
        !vertex->has(PlyRole::kZ)) {
      fail("the header has no element vertex with x, y and z");
    }
    header_.size = size_ - rest_.size();
    return header_;
  }

 private:
  [[noreturn]] void fail(const std::string& text) const {
    throw Error(ErrorCode::kMeshBroken, path_ + ":" + std::to_string(header_.lines), text);
  }

  // The first line tells which end all lines have: a comment may hold a CR, and data start with LF.
  std::string_view take_line() {
    if (header_.lines++ == 0) {
      const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
      end_ = rest_.substr(end, 1) == "\r" && rest_.substr(end, 2) != "\r\n" ? '\r' : '\n';
    }
    const std::size_t end = rest_.find(end_);
    if (end == std::string_view::npos) fail("the file ends inside the header");
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return line;
  }

  void read_format(std::string_view line) {
    const std::string_view name = next_token(line);
    if (name == "ascii") {
      header_.format = PlyFormat::kAscii;
    } else if (name == "binary_little_endian") {
      header_.format = PlyFormat::kLittleEndian;
    } else if (name == "binary_big_endian") {
      header_.format = PlyFormat::kBigEndian;
    } else {
      fail(shown(name) + " is not a PLY format");
    }
  }

  void read_element(std::string_view line) {
    PlyElement& element = header_.elements.emplace_back();
    element.name = next_token(line);
    if (header_.find(PlyKind::kVertex) == nullptr && element.name == "vertex") {
      element.kind = PlyKind::kVertex;
    } else if (element.name == "face") {
      element.kind = PlyKind::kFace;
    } else if (element.name == "tristrips") {
      element.kind = PlyKind::kStrips;
    }
    const std::string_view count = next_token(line);
    const std::optional<std::int64_t> value = parse_integer(count);
    if (!value || *value < 0) fail(shown(count) + " is not a number of elements");
    element.count = static_cast<std::uint64_t>(*value);
  }

  void read_property(std::string_view line) {
    if (header_.elements.empty()) fail("a property before the first element");
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
    }
    property.type = type();
    property.name = next_token(line);
    header_.elements.back().properties.push_back(property);
  }

  // The first property of a role has it.
  static void give_roles(PlyElement& element) {
    const bool is_vertex = element.kind == PlyKind::kVertex;
    const bool has_indices = element.kind == PlyKind::kFace || element.kind == PlyKind::kStrips;
    if (!is_vertex && !has_indices) return;
    for (PlyProperty& property : element.properties) {
      const PlyRole role = value_role(property.name);
      const bool is_value = property.count.size == 0;
      const bool is_used = is_vertex ? role != PlyRole::kNone : role >= PlyRole::kRed;
      if (is_value && is_used && !element.has(role)) property.role = role;
    }
    if (has_indices) find_indices(element);
  }

  // By its usual names, else the first list of whole numbers.
  static void find_indices(PlyElement& element) {
    PlyProperty* found = nullptr;
    for (PlyProperty& property : element.properties) {
      if (property.count.size == 0) continue;
      if (property.name == "vertex_indices" || property.name == "vertex_index" ||
          property.name == "vertex_indexes") {
        found = &property;
        break;
      }
      if (found == nullptr && !property.type.is_float) found = &property;
    }
    if (found != nullptr) found->role = PlyRole::kIndices;
  }

  const std::string& path_;
  std::size_t size_;
  std::string_view rest_;
  char end_ = '\n';
  PlyHeader header_;
};

}  // namespace

bool PlyElement::has(PlyRole role) const {
  return std::any_of(properties.begin(), properties.end(),
                     [role](const PlyProperty& property) { return property.role == role; });
}

const PlyElement* PlyHeader::find(PlyKind kind) const {
  const auto found =
      std::find_if(elements.begin(), elements.end(),
                   [kind](const PlyElement& element) { return element.kind == kind; });
  return found == elements.end() ? nullptr : &*found;
}

PlyHeader read_ply_header(const std::string& path, std::string_view bytes) {
  return PlyHeaderReader(path, bytes).read();
}

}  // namespace halfspace
