// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "../io/error.hpp"
#include "../io/scan.hpp"
#include "crease_normals.hpp"
#include "position_set.hpp"
#include "raw_mesh.hpp"

namespace halfspace {
namespace {

// How often its own size a mesh may be away from the origin before it gets one of its own.
constexpr double kNear = 8.0;
// Vertices at a point that are looked at for an equal one.
constexpr std::size_t kLookBack = 64;

bool is_finite(const glm::dvec3& v) {
  return is_finite_float(v.x) && is_finite_float(v.y) && is_finite_float(v.z);
}

// A colour of the file, which may be anything at all, in 0..1.
glm::vec3 to_unit(const glm::vec3& color) {
  const bool usable = std::isfinite(color.x) && std::isfinite(color.y) && std::isfinite(color.z);
  return usable ? glm::clamp(color, 0.0F, 1.0F) : glm::vec3(1.0F);
}

// Unit length, or zero when there is no direction in it.
glm::vec3 usable_normal(const glm::vec3& normal) {
  const double length = glm::length(glm::dvec3(normal));
  const bool usable = std::isfinite(length) && length > 1e-12;
  return usable ? glm::vec3(glm::dvec3(normal) / length) : glm::vec3(0.0F);
}

class MeshFinisher {
 public:
  MeshFinisher(const std::string& path, RawMesh raw, const MeshProgress& progress)
      : path_(path), raw_(std::move(raw)), progress_(progress) {}

  Mesh run() {
    if (raw_.triangles.empty()) throw Error(ErrorCode::kMeshEmpty, path_, "has no triangles");
    if (raw_.triangles.size() > kNoIndex / 3) {
      throw Error(ErrorCode::kMeshBroken, path_, "has more than 2^32 / 3 triangles");
    }
    report(0);
    check_finite();
    choose_origin();
    find_points();
    list_corners();
    const bool is_whole = vertices_are_whole();
    if (!is_whole) make_face_normals();
    for (std::uint32_t point = 0; point + 1 < first_corner_.size(); ++point) {
      is_whole ? add_whole_vertices(point) : add_vertices(point);
      if (point % kReportEvery == 0) report(first_corner_[point]);
    }
    mesh_.triangles = std::move(raw_.triangles);
    return std::move(mesh_);
  }

 private:
  void report(std::size_t corners) const {
    if (progress_) progress_("making normals", corners, 3 * raw_.triangles.size());
  }

  void check_finite() const {
    for (const TriangleIndices& triangle : raw_.triangles) {
      for (const std::uint32_t vertex : triangle) {
        if (!is_finite(raw_.positions[vertex])) fail_not_finite(vertex);
      }
    }
  }

  [[noreturn]] void fail_not_finite(std::uint32_t vertex) const {
    std::string place = path_;
    for (const RawMesh::NotFinite& known : raw_.not_finite) {
      if (known.vertex == vertex && known.line != 0)
        place.append(":").append(std::to_string(known.line));
    }
    throw Error(ErrorCode::kMeshNotFinite, place,
                "vertex " + std::to_string(vertex) +
                    " (counted from 0) is not finite in single precision, and a face uses it");
  }

  void choose_origin() {
    glm::dvec3 low = raw_.positions[raw_.triangles[0][0]];
    glm::dvec3 high = low;
    for (const TriangleIndices& triangle : raw_.triangles) {
      for (const std::uint32_t vertex : triangle) {
        low = glm::min(low, raw_.positions[vertex]);
        high = glm::max(high, raw_.positions[vertex]);
      }
    }
    const glm::dvec3 middle = 0.5 * low + 0.5 * high;
    if (glm::length(middle) > kNear * glm::length(high - low)) mesh_.origin = middle;
  }

  // Points are numbered in the order of their first use.
  void find_points() {
    point_.assign(raw_.positions.size(), kNoIndex);
    PositionSet set(raw_.positions.size());
    std::uint32_t points = 0;
    for (const TriangleIndices& triangle : raw_.triangles) {
      for (const std::uint32_t vertex : triangle) {
        if (point_[vertex] != kNoIndex) continue;
        const std::uint32_t first = set.first_equal(raw_.positions, vertex);
        if (point_[first] == kNoIndex) point_[first] = points++;
        point_[vertex] = point_[first];
      }
    }
    first_corner_.assign(std::size_t{points} + 1, 0);
  }

  // The corners at each point, in order.
  void list_corners() {
    for (const TriangleIndices& triangle : raw_.triangles) {
      for (const std::uint32_t vertex : triangle) ++first_corner_[point_[vertex]];
    }
    std::exclusive_scan(first_corner_.begin(), first_corner_.end(), first_corner_.begin(), 0U);
    std::vector<std::uint32_t> next(first_corner_.begin(), first_corner_.end() - 1);
    corners_.resize(3 * raw_.triangles.size());
    std::uint32_t corner = 0;
    for (const TriangleIndices& triangle : raw_.triangles) {
      for (const std::uint32_t vertex : triangle) corners_[next[point_[vertex]]++] = corner++;
    }
    const std::size_t points = first_corner_.size() - 1;
    point_ = {};
    mesh_.positions.reserve(points);
    mesh_.normals.reserve(points);
    mesh_.colors.reserve(points);
  }

  void make_face_normals() {
    face_normals_.reserve(raw_.triangles.size());
    for (const auto& [a, b, c] : raw_.triangles) {
      const glm::dvec3& origin = raw_.positions[a];
      glm::dvec3 u = raw_.positions[b] - origin;
      glm::dvec3 v = raw_.positions[c] - origin;
      // Edges near 1, so that no product leaves a double's range.
      const glm::dvec3 size = glm::max(glm::abs(u), glm::abs(v));
      const double scale = std::max({size.x, size.y, size.z});
      if (scale > 0.0) {
        u /= scale;
        v /= scale;
      }
      const glm::dvec3 normal = glm::cross(u, v);
      const double length = glm::length(normal);
      face_normals_.push_back(length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0F));
    }
  }

  std::uint32_t& vertex_of(std::uint32_t corner) { return raw_.triangles[corner / 3][corner % 3]; }

  glm::vec3 given_normal(std::uint32_t corner) {
    if (raw_.normals.empty()) return glm::vec3(0.0F);
    const std::uint32_t index = raw_.corner_normals.empty()
                                    ? vertex_of(corner)
                                    : raw_.corner_normals[corner / 3][corner % 3];
    return index == kNoIndex ? glm::vec3(0.0F) : usable_normal(raw_.normals[index]);
  }

  glm::vec3 color_of(std::uint32_t corner) {
    if (!raw_.colors.empty()) return to_unit(raw_.colors[vertex_of(corner)]);
    if (raw_.triangle_colors.empty()) return glm::vec3(1.0F);
    return to_unit(raw_.palette[raw_.triangle_colors[corner / 3]]);
  }

  // The file's vertices have all that ours have: normal and colour do not depend on the face.
  bool vertices_are_whole() const {
    return !raw_.normals.empty() && raw_.corner_normals.empty() && raw_.triangle_colors.empty() &&
           std::all_of(raw_.normals.begin(), raw_.normals.end(), [](const glm::vec3& normal) {
             return usable_normal(normal) != glm::vec3(0.0F);
           });
  }

  // As add_vertices(), which would do the same work at every corner of a vertex.
  void add_whole_vertices(std::uint32_t point) {
    const std::uint32_t begin = first_corner_[point], end = first_corner_[point + 1];
    const auto position = glm::vec3(raw_.positions[vertex_of(corners_[begin])] - mesh_.origin);
    const std::size_t first = mesh_.positions.size();
    std::uint32_t last = kNoIndex, placed = kNoIndex;
    for (std::uint32_t i = begin; i < end; ++i) {
      std::uint32_t& vertex = vertex_of(corners_[i]);
      if (vertex != last) {
        last = vertex;
        placed = place(first, position, usable_normal(raw_.normals[vertex]), color_of(corners_[i]));
      }
      vertex = placed;
    }
  }

  void add_vertices(std::uint32_t point) {
    const std::uint32_t begin = first_corner_[point], end = first_corner_[point + 1];
    normals_.clear();
    bool all_given = true;
    for (std::uint32_t i = begin; i < end; ++i) {
      normals_.push_back(given_normal(corners_[i]));
      all_given = all_given && normals_.back() != glm::vec3(0.0F);
    }
    if (!all_given) make_normals(begin, end);
    const auto position = glm::vec3(raw_.positions[vertex_of(corners_[begin])] - mesh_.origin);
    const std::size_t first = mesh_.positions.size();
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t corner = corners_[i];
      vertex_of(corner) = place(first, position, normals_[i - begin], color_of(corner));
    }
  }

  void make_normals(std::uint32_t begin, std::uint32_t end) {
    faces_.clear();
    for (std::uint32_t i = begin; i < end; ++i) faces_.push_back(face_normals_[corners_[i] / 3]);
    const std::vector<glm::vec3>& made = crease_.at_point(faces_);
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      if (normals_[i] == glm::vec3(0.0F)) normals_[i] = made[i];
    }
  }

  // The vertex of those from `first` on that is like this, or a new one.
  std::uint32_t place(std::size_t first, const glm::vec3& position, const glm::vec3& normal,
                      const glm::vec3& color) {
    const std::size_t size = mesh_.positions.size();
    for (std::size_t i = std::max(first, size - std::min(size, kLookBack)); i < size; ++i) {
      if (mesh_.normals[i] == normal && mesh_.colors[i] == color) {
        return static_cast<std::uint32_t>(i);
      }
    }
    mesh_.positions.push_back(position);
    mesh_.normals.push_back(normal);
    mesh_.colors.push_back(color);
    return static_cast<std::uint32_t>(size);
  }

  const std::string& path_;
  RawMesh raw_;
  const MeshProgress& progress_;
  Mesh mesh_;
  std::vector<std::uint32_t> point_;         // of each vertex
  std::vector<std::uint32_t> first_corner_;  // of each point, into corners_
  std::vector<std::uint32_t> corners_;
  std::vector<glm::vec3> face_normals_;
  std::vector<glm::vec3> normals_, faces_;  // of the corners at a point
  CreaseNormals crease_;
};

}  // namespace

Mesh finish_mesh(const std::string& path, RawMesh raw, const MeshProgress& progress) {
  return MeshFinisher(path, std::move(raw), progress).run();
}

}  // namespace halfspace
