// SPDX-License-Identifier: Apache-2.0
//
// OBJ, strictly where it is used: a vertex or a face is either understood or reported by its line;
// of a normal or a texture coordinate only whether it is there.
#include <algorithm>
#include <array>
#include <map>

#include "../io/error.hpp"
#include "../io/scan.hpp"
#include "mtl_read.hpp"
#include "obj_lines.hpp"
#include "polygons.hpp"

namespace halfspace {
namespace {

// What has no number of its own in the file, and is not there.
constexpr std::int64_t kAbsent = 0;

// A comment may be glued to what is before it, but 1.#QNAN has none.
std::string_view without_comment(std::string_view text) {
  std::size_t at = text.find('#');
  while (at != std::string_view::npos && at != 0 && text[at - 1] == '.') {
    at = text.find('#', at + 1);
  }
  return text.substr(0, at);
}

class ObjReader {
 public:
  explicit ObjReader(const MeshSource& source)
      : source_(source), lines_(source.bytes), materials_(source.path, source.left_out) {}

  RawMesh read() {
    if (const std::size_t nul = source_.bytes.find('\0'); nul != std::string_view::npos) {
      throw Error(ErrorCode::kMeshBroken, source_.path,
                  "byte " + std::to_string(nul) + " is zero: this is not OBJ text");
    }
    for (std::size_t count = 0; lines_.next(); ++count) {
      read_line(lines_.line());
      if (count % kReportEvery == 0) source_.report(lines_.bytes_left());
    }
    source_.left_out.add("comments_that_end_in_a_backslash",
                         "backslash at the end of a comment: the next line is not a part of it",
                         "backslashes at the end of comments: the next lines are not parts of them",
                         lines_.comments_with_backslash(), lines_.first_with_backslash());
    make_triangles();
    if (lines_.is_cut()) note_cut();
    if (!mesh_.colors.empty()) {
      mesh_.colors.resize(mesh_.positions.size(), glm::vec3(1.0F));
      finish_colors();
    }
    return std::move(mesh_);
  }

 private:
  struct Corner {
    std::int64_t vertex, normal;  // from 1; kAbsent
  };
  struct Face {
    std::size_t first, line;  // its corners end where the next one's begin
    std::uint32_t color;
  };

  [[noreturn]] void fail(ErrorCode code, const std::string& text, std::size_t line) const {
    throw Error(code, source_.path + ":" + std::to_string(line), text);
  }
  [[noreturn]] void broken(const std::string& text) const {
    // What is wrong with the last line of a file that just stops is that the file stops.
    fail(ErrorCode::kMeshBroken,
         lines_.is_cut() ? "the file ends in the middle of a line (" + text + ")" : text,
         lines_.number());
  }

  void read_line(std::string_view line) {
    const std::string_view keyword = next_token(line);
    if (keyword == "v") {
      read_vertex(without_comment(line));
    } else if (keyword == "vn") {
      read_normal(without_comment(line));
    } else if (keyword == "f" || keyword == "fo") {  // fo: an obsolete spelling
      read_face(without_comment(line));
    } else if (keyword == "l" || keyword == "p") {
      source_.left_out.add("lines_and_points", "line or point", "lines and points", 1,
                           lines_.number());
    } else if (keyword == "usemtl") {
      use_material(line);
    } else if (keyword == "mtllib") {
      materials_.add_libraries(line, lines_.number());
    }
  }

  // x y z, then a colour or whatever else.
  void read_vertex(std::string_view text) {
    std::array<double, 6> value{};
    std::size_t count = 0;
    for (; count < value.size(); ++count) {
      const std::string_view token = next_token(text);
      if (token.empty()) break;
      const std::optional<double> number = parse_coordinate(token);
      if (!number && count >= 3) break;
      if (!number) broken(shown(token) + " is not a number");
      value[count] = *number;
    }
    if (count < 3) broken("a vertex needs 3 numbers, here are " + std::to_string(count));
    const bool finite = std::all_of(value.begin(), value.begin() + 3, is_finite_float);
    if (!finite) {
      mesh_.not_finite.push_back(
          {static_cast<std::uint32_t>(mesh_.positions.size()), lines_.number()});
    }
    mesh_.positions.emplace_back(value[0], value[1], value[2]);
    if (mesh_.positions.size() == kNoIndex) broken("has more than 2^32 - 2 vertices");
    if (count < 6) return;
    mesh_.colors.resize(mesh_.positions.size() - 1, glm::vec3(1.0F));
    mesh_.colors.emplace_back(value[3], value[4], value[5]);
    coloured_.push_back(static_cast<std::uint32_t>(mesh_.positions.size() - 1));
  }

  void read_normal(std::string_view text) {
    glm::dvec3 normal(0.0);
    for (int i = 0; i < 3; ++i) {
      normal[i] = parse_coordinate(next_token(text)).value_or(0.0);
    }
    mesh_.normals.emplace_back(normal);
  }

  void use_material(std::string_view name) {
    const auto [found, is_new] =
        colors_.try_emplace(std::string(trimmed_name(name, true)), std::uint32_t{0});
    if (is_new) {
      found->second = static_cast<std::uint32_t>(uses_.size() + 1);
      uses_.push_back({found->first, lines_.number()});
    }
    color_ = found->second;
  }

  void read_face(std::string_view text) {
    faces_.push_back({corners_.size(), lines_.number(), color_});
    for (std::string_view token = next_token(text); !token.empty(); token = next_token(text)) {
      read_corner(token);
    }
    const std::size_t corners = corners_.size() - faces_.back().first;
    if (corners < 3 && lines_.is_cut()) {
      broken("a face needs 3 vertices, here are " + std::to_string(corners));
    }
  }

  // v, v/t, v//n or v/t/n, and slashes with nothing after them.
  void read_corner(std::string_view token) {
    std::array<std::string_view, 3> part;
    std::size_t count = 0;
    for (std::string_view rest = token;;) {
      if (count == part.size()) broken(shown(token) + " has more than two slashes");
      const std::size_t slash = std::min(rest.find('/'), rest.size());
      part[count++] = rest.substr(0, slash);
      if (slash == rest.size()) break;
      rest.remove_prefix(slash + 1);
    }
    const std::optional<std::int64_t> vertex = parse_integer(part[0]);
    if (!vertex) broken(shown(part[0]) + " is not an index");
    if (*vertex == 0) fail(ErrorCode::kMeshIndex, "index 0: OBJ counts from 1", lines_.number());
    const auto defined = static_cast<std::int64_t>(mesh_.positions.size());
    if (*vertex < -defined) {
      fail(ErrorCode::kMeshIndex,
           "index " + std::to_string(*vertex) + ", but only " + std::to_string(defined) +
               " vertices stand before this line",
           lines_.number());
    }
    corners_.push_back({*vertex < 0 ? defined + *vertex + 1 : *vertex, normal_index(part[2])});
  }

  // A normal that is not there is one that is made.
  std::int64_t normal_index(std::string_view text) const {
    const auto defined = static_cast<std::int64_t>(mesh_.normals.size());
    const std::int64_t index = parse_integer(text).value_or(kAbsent);
    return index >= 0 ? index : std::max(defined + index + 1, kAbsent);
  }

  void make_triangles() {
    PolygonSink sink(mesh_, source_);
    std::vector<std::uint32_t> polygon;
    const bool by_material = !uses_.empty();
    if (by_material) make_palette();
    mesh_.triangles.reserve(faces_.size());
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const std::size_t end = i + 1 < faces_.size() ? faces_[i + 1].first : corners_.size();
      const auto face =
          std::span<const Corner>(corners_).subspan(faces_[i].first, end - faces_[i].first);
      polygon.clear();
      for (const Corner& corner : face) polygon.push_back(vertex_of(corner, faces_[i].line));
      sink.add(polygon, faces_[i].line);
      if (by_material) mesh_.triangle_colors.resize(mesh_.triangles.size(), faces_[i].color);
      if (mesh_.normals.empty()) continue;
      for (const Triangulator::Cut& cut : sink.cuts()) {
        mesh_.corner_normals.push_back(
            {normal_of(face[cut.a]), normal_of(face[cut.b]), normal_of(face[cut.c])});
      }
    }
  }

  // A file that stops may have been longer.
  void note_cut() const {
    std::vector<bool> used(mesh_.positions.size());
    for (const TriangleIndices& triangle : mesh_.triangles) {
      for (const std::uint32_t vertex : triangle) used[vertex] = true;
    }
    const auto unused = std::count(used.begin(), used.end(), false);
    source_.left_out.add("vertices_of_a_file_that_may_be_cut",
                         "vertex of no face, and no end of the last line: the file may be cut",
                         "vertices of no face, and no end of the last line: the file may be cut",
                         static_cast<std::uint64_t>(unused));
  }

  std::uint32_t vertex_of(const Corner& corner, std::size_t line) const {
    if (static_cast<std::uint64_t>(corner.vertex) > mesh_.positions.size()) {
      fail(ErrorCode::kMeshIndex,
           "index " + std::to_string(corner.vertex) + ", but the file has " +
               std::to_string(mesh_.positions.size()) + " vertices",
           line);
    }
    return static_cast<std::uint32_t>(corner.vertex - 1);
  }

  std::uint32_t normal_of(const Corner& corner) const {
    const auto index = static_cast<std::uint64_t>(corner.normal);
    return index == 0 || index > mesh_.normals.size() ? kNoIndex
                                                      : static_cast<std::uint32_t>(index - 1);
  }

  // White for faces before the first usemtl.
  void make_palette() {
    mesh_.palette.emplace_back(1.0F);
    for (const auto& [name, line] : uses_) {
      const std::optional<glm::vec3> color = materials_.find(name);
      if (!color) {
        source_.left_out.add("materials", "material that no file defines",
                             "materials that no file defines", 1, line);
      }
      mesh_.palette.push_back(color.value_or(glm::vec3(1.0F)));
    }
  }

  // Those that have none are white, whatever the others' scale.
  void finish_colors() {
    std::vector<glm::vec3> given;
    given.reserve(coloured_.size());
    for (const std::uint32_t vertex : coloured_) given.push_back(mesh_.colors[vertex]);
    scale_colors(given);
    for (std::size_t i = 0; i < given.size(); ++i) mesh_.colors[coloured_[i]] = given[i];
  }

  struct Use {
    std::string name;
    std::size_t line;
  };
  const MeshSource& source_;
  ObjLines lines_;
  MtlColors materials_;
  RawMesh mesh_;
  std::vector<Corner> corners_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> coloured_;                       // vertices
  std::map<std::string, std::uint32_t, std::less<>> colors_;  // by material, into the palette
  std::vector<Use> uses_;
  std::uint32_t color_ = 0;
};

}  // namespace

RawMesh read_obj(const MeshSource& source) { return ObjReader(source).read(); }

}  // namespace halfspace
