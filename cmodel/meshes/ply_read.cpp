// SPDX-License-Identifier: Apache-2.0
//
// PLY by its own rules: the header says what the data are, whatever their names and order; what is
// not part of a mesh is read over.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "../io/error.hpp"
#include "../io/scan.hpp"
#include "ply_values.hpp"
#include "polygons.hpp"

namespace halfspace {
namespace {

// A colour's value as it is in 0..1, or, of a float, for scale_colors().
float color_value(double value, const PlyType& type) {
  if (type.is_float) return static_cast<float>(value);
  return static_cast<float>(value / (type.size == 2 ? 65535.0 : 255.0));
}

class PlyReader {
 public:
  explicit PlyReader(const MeshSource& source)
      : source_(source),
        header_(read_ply_header(source.path, source.bytes)),
        values_(source.path, source.bytes.substr(header_.size), header_),
        sink_(mesh_, source) {}

  RawMesh read() {
    vertices_ = header_.find(PlyKind::kVertex)->count;
    if (vertices_ >= kNoIndex) values_.fail("has more than 2^32 - 2 vertices");
    for (const PlyElement& element : header_.elements) read_element(element);
    for (const Waiting& polygon : waiting_) add_polygon(polygon);
    note_rest();
    if (float_colors_) {
      scale_colors(mesh_.colors);
      scale_colors(mesh_.palette);
    }
    if (!mesh_.palette.empty()) {
      mesh_.palette[0] = glm::vec3(1.0F);  // of faces without a colour
      mesh_.triangle_colors.resize(mesh_.triangles.size(), 0);
    }
    return std::move(mesh_);
  }

 private:
  // A face or a strip, its corners in corners_.
  struct Waiting {
    std::size_t first, count, line;
    glm::vec3 color;
    bool is_strip;
  };
  using Record = std::array<double, 9>;  // x y z, normal, colour

  void read_element(const PlyElement& element) {
    values_.begin(element);
    if (element.properties.empty()) return;  // takes no data, however many there are
    has_normals_ = element.has(PlyRole::kNormalX) && element.has(PlyRole::kNormalY) &&
                   element.has(PlyRole::kNormalZ);
    has_colors_ =
        element.has(PlyRole::kRed) || element.has(PlyRole::kGreen) || element.has(PlyRole::kBlue);
    if (element.kind == PlyKind::kVertex) reserve(element);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      switch (element.kind) {
        case PlyKind::kVertex: read_vertex(element); break;
        case PlyKind::kOther: skip_all(element); break;
        default: read_face(element); break;
      }
      if (i % kReportEvery == 0) source_.report(values_.rest().size());
    }
    has_vertices_ = has_vertices_ || element.kind == PlyKind::kVertex;
  }

  // No more than the file can hold.
  void reserve(const PlyElement& element) {
    const std::size_t most = values_.rest().size() / (2 * element.properties.size());
    mesh_.positions.reserve(std::min(most, static_cast<std::size_t>(element.count)));
  }

  void skip_list(const PlyProperty& property) {
    const double length = values_.whole(property.count);
    if (!(length >= 0)) values_.fail("a list of negative length");
    for (double i = 0; i < length; ++i) values_.skip(property.type);
  }

  void skip_all(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) {
      if (property.count.size == 0) {
        values_.skip(property.type);
      } else {
        skip_list(property);
      }
    }
  }

  void read_value(const PlyProperty& property, Record& record) {
    const auto role = static_cast<std::size_t>(property.role);
    if (property.role == PlyRole::kNone) {
      values_.skip(property.type);
    } else if (property.role <= PlyRole::kZ) {
      record[role - 1] = values_.number(property.type);
    } else if (property.role <= PlyRole::kNormalZ) {
      record[role - 1] = values_.any_number(property.type);
    } else {
      record[role - 1] =
          static_cast<double>(color_value(values_.any_number(property.type), property.type));
      float_colors_ = float_colors_ || property.type.is_float;
    }
  }

  static glm::vec3 color_of(const Record& record) {
    return {static_cast<float>(record[6]), static_cast<float>(record[7]),
            static_cast<float>(record[8])};
  }

  void read_vertex(const PlyElement& element) {
    Record record{};
    for (const PlyProperty& property : element.properties) {
      if (property.count.size == 0) {
        read_value(property, record);
      } else {
        skip_list(property);
      }
    }
    const auto [x, y, z, nx, ny, nz, red, green, blue] = record;
    if (!is_finite_float(x) || !is_finite_float(y) || !is_finite_float(z)) {
      mesh_.not_finite.push_back(
          {static_cast<std::uint32_t>(mesh_.positions.size()), values_.line()});
    }
    mesh_.positions.emplace_back(x, y, z);
    if (has_normals_) mesh_.normals.emplace_back(nx, ny, nz);
    if (has_colors_) mesh_.colors.push_back(color_of(record));
  }

  void read_face(const PlyElement& element) {
    Record record{};
    const std::size_t first = corners_.size();
    for (const PlyProperty& property : element.properties) {
      if (property.role == PlyRole::kIndices) {
        read_indices(property, element.kind == PlyKind::kStrips);
      } else if (property.count.size == 0) {
        read_value(property, record);
      } else {
        skip_list(property);
      }
    }
    has_face_colors_ = has_face_colors_ || has_colors_;
    const glm::vec3 color = has_colors_ ? color_of(record) : glm::vec3(1.0F);
    const Waiting polygon{first, corners_.size() - first, values_.line(), color,
                          element.kind == PlyKind::kStrips};
    if (!has_vertices_) {
      waiting_.push_back(polygon);
      return;
    }
    add_polygon(polygon);
    corners_.clear();
  }

  void read_indices(const PlyProperty& property, bool is_strip) {
    const double length = values_.whole(property.count);
    if (!(length >= 0)) values_.fail("a list of negative length");
    // What an unsigned type has for -1.
    const double most = std::ldexp(1.0, static_cast<int>(8 * property.type.size)) - 1;
    for (double i = 0; i < length; ++i) {
      const double index = values_.whole(property.type);
      const bool is_end = index == -1 || (!property.type.is_signed && index == most);
      if (is_strip && is_end) {
        corners_.push_back(kNoIndex);
      } else if (index >= 0 && index < static_cast<double>(vertices_)) {
        corners_.push_back(static_cast<std::uint32_t>(index));
      } else {
        fail_index(index);
      }
    }
  }

  [[noreturn]] void fail_index(double index) const {
    const std::size_t line = values_.line();
    const double shown = std::clamp(index, -1e15, 1e15);
    throw Error(ErrorCode::kMeshIndex,
                line == 0 ? source_.path : source_.path + ":" + std::to_string(line),
                "a face names vertex " + std::to_string(static_cast<std::int64_t>(shown)) +
                    ", but there are " + std::to_string(vertices_) + " (counted from 0)");
  }

  void add_polygon(const Waiting& polygon) {
    const std::size_t before = mesh_.triangles.size();
    const auto corners =
        std::span<const std::uint32_t>(corners_).subspan(polygon.first, polygon.count);
    if (polygon.is_strip) {
      add_strips(corners);
    } else {
      sink_.add(corners, polygon.line);
    }
    if (!has_face_colors_ || !mesh_.colors.empty()) return;
    mesh_.triangle_colors.resize(before, 0);
    if (mesh_.palette.empty()) mesh_.palette.emplace_back(1.0F);
    if (mesh_.palette.back() != polygon.color) mesh_.palette.push_back(polygon.color);
    mesh_.triangle_colors.resize(mesh_.triangles.size(),
                                 static_cast<std::uint32_t>(mesh_.palette.size() - 1));
  }

  // Each new corner makes a triangle with the two before it, every other one turned around; -1
  // starts a new strip.
  void add_strips(std::span<const std::uint32_t> corners) {
    std::size_t start = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (corners[i] == kNoIndex) {
        start = i + 1;
      } else if (i >= start + 2) {
        const bool turned = (i - start) % 2 == 1;
        mesh_.triangles.push_back(
            {corners[turned ? i - 1 : i - 2], corners[turned ? i - 2 : i - 1], corners[i]});
      }
    }
  }

  void note_rest() {
    const std::string_view rest = values_.rest();
    const bool is_text = header_.format == PlyFormat::kAscii;
    if (is_text && std::all_of(rest.begin(), rest.end(), is_blank)) return;
    // One line end after binary data is no data either.
    if (!is_text && (rest == "\n" || rest == "\r\n")) return;
    source_.left_out.add("bytes_after_the_data", "byte after the data", "bytes after the data",
                         rest.size());
  }

  const MeshSource& source_;
  PlyHeader header_;
  PlyValues values_;
  RawMesh mesh_;
  PolygonSink sink_;
  std::uint64_t vertices_ = 0;
  bool has_vertices_ = false;                      // all are read
  bool has_normals_ = false, has_colors_ = false;  // of the element
  bool has_face_colors_ = false;
  bool float_colors_ = false;
  std::vector<std::uint32_t> corners_;
  std::vector<Waiting> waiting_;
};

}  // namespace

RawMesh read_ply(const MeshSource& source) { return PlyReader(source).read(); }

}  // namespace halfspace
