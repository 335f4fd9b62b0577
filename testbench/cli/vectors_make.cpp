// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "io/error.hpp"
#include "io/output_file.hpp"
#include "io/tcov.hpp"
#include "scene/progress.hpp"
#include "scene/scene.hpp"
#include "scene_options.hpp"
#include "vectors/stimulus.hpp"
#include "vectors/vector_builder.hpp"
#include "vectors_command.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t kGenerated = 1000;  // triangles, unless --count says how many
constexpr int kAttempts = 1000;             // to draw one with few enough tiles

// "near horizontal" as it is written on a command line.
std::string option_name(Shape shape) {
  std::string name = shape_name(shape);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

// "all", or names with commas.
std::vector<Shape> parse_shapes(const std::string& text) {
  if (text == "all") return {kShapes.begin(), kShapes.end()};
  std::vector<Shape> shapes;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string name = text.substr(begin, end - begin);
    const auto found = std::find_if(kShapes.begin(), kShapes.end(),
                                    [&](Shape shape) { return option_name(shape) == name; });
    if (found == kShapes.end()) {
      std::string known = "all";
      for (const Shape shape : kShapes) known += ", " + option_name(shape);
      throw Error(ErrorCode::kVectorRequest, "--generate",
                  fmt::format("'{:.40}' is no shape (there are {})", name, known));
    }
    shapes.push_back(*found);
    begin = end + 1;
  }
  return shapes;
}

std::uint32_t tag_of(std::uint64_t number, const Config& config) {
  return static_cast<std::uint32_t>(number & ((std::uint64_t{1} << config.tag_bits) - 1));
}

// Triangles into a set, by way of the stage's stimulus.
class Maker {
 public:
  Maker(const VectorMeta& meta, double stall)
      : stimulus_(meta),
        builder_(meta),
        seed_(meta.seed),
        stall_(static_cast<std::uint32_t>(stall * 0x1p32)) {}

  void begin(const FrameState& frame) {
    stimulus_.begin_frame(frame);
    builder_.run(frame, stall_, seed_ + runs_++);
  }
  void draw(const ShadedTriangle& triangle) {
    stimulus_.draw(triangle, [this](const Values& ports) { builder_.add(ports); });
  }
  VectorSet finish() { return builder_.finish(); }

 private:
  StimulusMaker stimulus_;
  VectorBuilder builder_;
  std::uint64_t seed_;
  std::uint32_t stall_;
  std::uint64_t runs_ = 0;
};

VectorSet from_generator(const VectorsRequest& request, VectorMeta meta, const FrameSize& size) {
  const std::vector<Shape> shapes = parse_shapes(request.generate);
  const Config& config = meta.config;
  meta.source = "generator";
  meta.source_name = request.generate;
  const FrameState frame{size.width, size.height, parse_cull(request.cull)};
  Maker maker(meta, request.stall);
  maker.begin(frame);
  Random random(request.seed);
  const std::uint64_t count = request.count == 0 ? kGenerated : request.count;
  Progress progress("making vectors", count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Shape shape = shapes[i % shapes.size()];
    ShadedTriangle shaded;
    int attempt = 0;
    do {
      if (++attempt > kAttempts) {
        throw Error(ErrorCode::kVectorRequest, "--max-tiles",
                    fmt::format("{} triangles of shape {} in turn have more than {} tiles",
                                kAttempts, option_name(shape), request.max_tiles));
      }
      shaded.triangle = random_triangle(random, shape, frame, config);
    } while (count_leaves(shaded.triangle, frame, config, request.max_tiles) > request.max_tiles);
    shaded.triangle.tag = tag_of(i, config);
    shaded.attributes = random_attributes(random, config);
    maker.draw(shaded);
    progress.advance();
  }
  return maker.finish();
}

VectorSet from_scene(const VectorsRequest& request, VectorMeta meta, const FrameSize& size) {
  const Config& config = meta.config;
  if (is_tcov(request.in)) say_no_camera(request.size, request.camera);
  const std::unique_ptr<Scene> scene = noted(
      open_scene(request.in, request.case_id, size, request.camera.options(), Lighting::kGouraud),
      request.in);
  const std::string bytes = read_file(request.in);
  meta.source = scene->frames() > 0 && scene->case_id(0) >= 0 ? "tcov" : "mesh";
  meta.source_name = std::filesystem::path(request.in).filename().string();
  meta.source_crc = crc32_of(bytes);
  Maker maker(meta, request.stall);
  std::uint64_t left = request.count == 0 ? ~std::uint64_t{0} : request.count;
  for (std::size_t i = 0; i < scene->frames() && left > 0; ++i) {
    FrameState frame = scene->frame(i, config);
    frame.cull = parse_cull(request.cull);
    maker.begin(frame);
    RunStats unused;
    scene->draw(i, frame, config, unused, [&](const ShadedTriangle& triangle) {
      if (left == 0) return;
      --left;
      ShadedTriangle tagged = triangle;
      tagged.triangle.tag = tag_of(tagged.triangle.tag, config);
      maker.draw(tagged);
    });
  }
  return maker.finish();
}

}  // namespace

VectorSet make_vectors(const VectorsRequest& request, const VectorMeta& meta) {
  const FrameSize size = frame_size(request.size, meta.config);
  try {
    return request.in.empty() ? from_generator(request, meta, size)
                              : from_scene(request, meta, size);
  } catch (const std::length_error& error) {
    throw Error(ErrorCode::kVectorsSize, request.in, error.what());
  }
}

}  // namespace halfspace
