// SPDX-License-Identifier: Apache-2.0
#include "frame_geometry.hpp"

#include <algorithm>
#include <cmath>

#include "../../fixed.hpp"

namespace halfspace {

ProjectConstants project_constants(const FrameState& frame, const Config& config) {
  ProjectConstants out;
  out.volume = clip_volume(frame, config);
  out.half_width = frame.width / 2.0;
  out.half_height = frame.height / 2.0;
  out.depth_scale =
      std::ldexp(std::ldexp(1.0, config.depth_bits) - 1.0, kPlaneBits - config.depth_bits - 1);
  out.subpixels = static_cast<double>(std::int64_t{1} << config.subpixel_bits);
  out.snap = config.snap;
  out.colors = std::min(config.attributes, 3);
  return out;
}

ClipVertex VertexSource::vertex(std::size_t i) const {
  if (!clip.empty()) return clip[i];
  ClipVertex out;
  out.position = matrix * glm::dvec4(glm::dvec3(position[i]), 1.0);
  for (int c = 0; c < 3; ++c) {
    out.attribute[static_cast<std::size_t>(c)] = static_cast<double>(color[i][c]);
  }
  return out;
}

void Assembly::reserve(std::size_t more) {
  if (count + more <= triangle.size()) return;
  const std::size_t size = std::max(count + more, 2 * triangle.size());
  triangle.resize(size);
  corner.resize(size);
}

void Assembly::append(const ShadedTriangle& shaded, int colors) {
  reserve(1);
  const auto at = static_cast<std::uint32_t>(extra.size());
  triangle[count] = shaded.triangle;
  corner[count] = {kExtra | at, kExtra | (at + 1), kExtra | (at + 2)};
  ++count;
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexAttributes& from = shaded.attributes[i];
    VertexRecord& to = extra.emplace_back();
    to.point = shaded.triangle.vertex[i];
    to.inverse_w = static_cast<double>(from.inverse_w);
    to.depth = from.depth;
    for (std::size_t n = 0; n < static_cast<std::size_t>(colors); ++n)
      to.set_value(n, from.value[n]);
  }
}

void assemble(const VertexSource& source, const std::vector<VertexRecord>& records,
              std::span<const TriangleIndices> triangles, int colors, GeometryStage& plain,
              Assembly& out, GeometryStats& stats) {
  out.reserve(triangles.size());
  std::vector<ShadedTriangle> pieces;
  for (const TriangleIndices& t : triangles) {
    const VertexRecord& a = records[t[0]];
    const VertexRecord& b = records[t[1]];
    const VertexRecord& c = records[t[2]];
    const unsigned any = a.outside | b.outside | c.outside;
    if ((any & (kOutsidePlanes | kNotFinite)) != 0) {
      pieces.clear();
      plain.process({source.vertex(t[0]), source.vertex(t[1]), source.vertex(t[2])}, 0, pieces);
      for (const ShadedTriangle& piece : pieces) out.append(piece, colors);
      out.reserve(triangles.size());
      continue;
    }
    const bool outside = (a.outside & b.outside & c.outside) != 0;
    ++stats.triangles_in;
    stats.outside += outside ? 1u : 0u;
    out.triangle[out.count] = {{a.point, b.point, c.point}, 0};
    out.corner[out.count] = t;
    out.count += outside ? 0u : 1u;
    stats.triangles_out += outside ? 0u : 1u;
  }
}

}  // namespace halfspace
