// SPDX-License-Identifier: Apache-2.0
#include "method_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "io/error.hpp"
#include "io/tcov.hpp"
#include "nearest.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t kBudget = std::uint64_t{1} << 40;
constexpr std::uint32_t kFar = (1u << 24) - 1;
constexpr Rgb kNotANumber{255, 0, 255};

std::vector<std::uint8_t> saturated(const std::vector<std::uint32_t>& hits) {
  std::vector<std::uint8_t> out;
  out.reserve(hits.size());
  for (const std::uint32_t h : hits) out.push_back(static_cast<std::uint8_t>(std::min(h, 255u)));
  return out;
}

Image picture_of_colors(const methods::Canvas& canvas) {
  Image image{canvas.width(), canvas.height(), std::vector<Rgb>(canvas.hits().size(), kBackground)};
  for (std::size_t i = 0; i < image.pixel.size(); ++i) {
    if (canvas.hits()[i] != 0) image.pixel[i] = picture_color(canvas.color()[i]);
  }
  return image;
}

Image picture_of_canvas_depth(const methods::Canvas& canvas) {
  std::vector<std::uint32_t> depth(canvas.hits().size(), kFar);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const double d = canvas.depth()[i];
    if (canvas.hits()[i] == 0 || std::isnan(d)) continue;
    depth[i] = static_cast<std::uint32_t>(std::clamp(d, 0.0, 1.0) * (kFar - 1));
  }
  return picture_of_depth(depth, canvas.width(), canvas.height(), kFar);
}

methods::Color color_of(const std::array<double, kMaxAttributes>& attribute) {
  return {attribute[0], attribute[1], attribute[2]};
}

}  // namespace

methods::Drawing scene_drawing(const Scene& scene, std::size_t index, const FrameState& frame) {
  if (scene.camera(index) == nullptr) {
    std::vector<methods::Facet> facets;
    scene.real(index, [&](const RealTriangle& triangle) {
      methods::Facet& facet = facets.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        facet[i].x = triangle.vertex[i].x;
        facet[i].y = triangle.vertex[i].y;
        facet[i].color = color_of(triangle.vertex[i].attribute);
      }
    });
    return methods::drawing_of(facets, frame.width, frame.height);
  }
  std::vector<methods::ClipFacet> clip;
  std::vector<methods::WorldFacet> world;
  scene.faces(index, [&](const MeshFace& face) {
    methods::ClipFacet& clipped = clip.emplace_back();
    methods::WorldFacet& placed = world.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const methods::Color color = color_of(face.clip[i].attribute);
      clipped[i] = {face.clip[i].position, color};
      placed[i] = {face.world[i], color};
    }
  });
  methods::Drawing out = methods::drawing_of(std::move(clip), frame.width, frame.height);
  out.view.camera = *scene.camera(index);
  out.world = std::move(world);
  return out;
}

Rgb picture_color(const methods::Color& color) {
  Rgb out{};
  for (std::size_t c = 0; c < 3; ++c) {
    if (std::isnan(color[c])) return kNotANumber;
    out[c] = static_cast<std::uint8_t>(std::lround(std::clamp(color[c], 0.0, 255.0)));
  }
  return out;
}

methods::Canvas method_canvas(const FrameState& frame) {
  return methods::Canvas(frame.width, frame.height, 0, 0, kBudget);
}

void require_finished(const methods::Method& method, const methods::Canvas& canvas) {
  if (!canvas.exhausted()) return;
  throw Error(ErrorCode::kMethodGaveUp, "--method", fmt::format("{} did not finish", method.name));
}

const methods::Method& find_method(std::string_view name, std::string_view shade) {
  const methods::Method* method = methods::find(name);
  if (method == nullptr) {
    std::vector<std::string> names;
    for (const methods::Method& known : methods::all()) names.emplace_back(known.name);
    throw Error(ErrorCode::kMethod, "--method",
                fmt::format("no method '{:.40}'{} (halfspace methods lists them)", name,
                            suggestion(name, names)));
  }
  const bool attributes = shade == "gouraud" || shade == "flat" || shade == "depth";
  if (attributes && !method->attributes) {
    throw Error(ErrorCode::kMethodOption, "--shade",
                fmt::format("method {} has no depth or colour: only --shade coverage", name));
  }
  if (!attributes && !shade.empty() && shade != "coverage") {
    throw Error(ErrorCode::kMethodOption, "--shade",
                fmt::format("'{:.40}' is not gouraud, flat, depth or coverage", shade));
  }
  return *method;
}

Image method_picture(const Scene& scene, std::size_t index, const FrameState& frame,
                     const methods::Method& method, const std::string& shade, RunStats& stats) {
  const methods::Drawing drawing = scene_drawing(scene, index, frame);
  methods::Canvas canvas = method_canvas(frame);
  const bool attributes = method.attributes && shade != "coverage";
  if (attributes) canvas.keep_attributes();
  using WallClock = std::chrono::steady_clock;
  const WallClock::time_point start = WallClock::now();
  methods::draw(method, drawing, canvas);
  stats.simulate_seconds += std::chrono::duration<double>(WallClock::now() - start).count();
  require_finished(method, canvas);
  const std::vector<std::uint8_t> hits = saturated(canvas.hits());
  stats.crc = crc32_of(hits, stats.crc);
  stats.geometry.triangles_in += methods::primitives(method, drawing);
  ++stats.cases;
  if (!attributes) return picture_of_counts(hits, frame.width, frame.height);
  return shade == "depth" ? picture_of_canvas_depth(canvas) : picture_of_colors(canvas);
}

const MethodDrawing kMethodDrawing{
    [](const std::string& method, const std::string& shade) { find_method(method, shade); },
    [](const Scene& scene, std::size_t index, const FrameState& frame, const std::string& method,
       const std::string& shade, RunStats& stats) {
      return method_picture(scene, index, frame, find_method(method, shade), shade, stats);
    }};

}  // namespace halfspace
