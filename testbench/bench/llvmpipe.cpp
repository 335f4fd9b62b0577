// SPDX-License-Identifier: Apache-2.0
//
// llvmpipe on the very triangles that the engines get: every vertex reaches its rasterizer at the
// same multiple of 1/256 px.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "entry.hpp"
#include "osmesa.hpp"

namespace halfspace {
namespace {

static_assert(kBenchConfig.subpixel_bits == 8, "what llvmpipe snaps to");
constexpr double kSubpixels = 256;

BenchRow llvmpipe_row(const char* work) {
  BenchRow row;
  row.work = work;
  row.engine = "llvmpipe";
  return row;
}

// Triangles in pixels, each adding one to the hits of the pixels it covers. The viewport is wide
// enough for all vertices, because llvmpipe would clip at it; the framebuffer cuts.
class CoverageScene {
 public:
  explicit CoverageScene(const Workload& work)
      : frame_(work.frame), context_(work.frame.width, work.frame.height) {
    const int x = frame_.width / 2, y = frame_.height / 2;  // the viewport's middle
    std::vector<float> vertices;
    for (const Triangle& triangle : work.triangles) {
      for (const Point& p : triangle.vertex) append(p, x, y, vertices);
    }
    // It drops a draw of exactly nine vertices whose third triangle is flat: one more that is not
    // flat, and covers nothing.
    for (const Point p : {Point{0, 0}, Point{0, 256}, Point{0, 0}}) append(p, x, y, vertices);
    count_ = static_cast<int>(vertices.size() / 2);

    const Gl& gl = context_.gl();
    context_.use_program(
        "#version 120\nattribute vec2 p; void main() { gl_Position = vec4(p, 0.0, 1.0); }",
        "#version 120\nvoid main() { gl_FragColor = vec4(1.0 / 255.0); }",
        std::array<const char*, 1>{"p"});
    context_.buffer(GL_ARRAY_BUFFER, vertices);
    context_.attribute(0, 2, 2, 0);
    hits_texture();
    gl.viewport(x - kHalf, y - kHalf, 2 * kHalf, 2 * kHalf);
    gl.enable(GL_BLEND);
    gl.blend_func(GL_ONE, GL_ONE);
    context_.check("preparing");
  }

  void run() {
    context_.make_current();
    draw();
    context_.gl().finish();
  }

  BenchOutput count() {
    const Gl& gl = context_.gl();
    context_.make_current();
    gl.clear(GL_COLOR_BUFFER_BIT);
    BenchOutput out;
    out.samples = context_.samples_passed([this] { draw(); });
    out.hits.emplace(static_cast<std::size_t>(frame_.width) *
                     static_cast<std::size_t>(frame_.height));
    gl.pixel_store(GL_PACK_ALIGNMENT, 1);
    gl.read_pixels(0, 0, frame_.width, frame_.height, GL_RED, GL_UNSIGNED_BYTE, out.hits->data());
    context_.check("drawing");
    return out;
  }

 private:
  static constexpr int kHalf = 4096;  // of the viewport, px; a power of two: divisions are exact

  void draw() { context_.gl().draw_arrays(GL_TRIANGLES, 0, count_); }

  // Exact in float: 21 bits of subpixels.
  static void append(const Point& p, int x, int y, std::vector<float>& to) {
    const std::array<double, 2> at{(p.x / kSubpixels - x) / kHalf, (p.y / kSubpixels - y) / kHalf};
    for (const double v : at) {
      if (std::abs(v) > 1) throw std::runtime_error("a vertex is too far out for llvmpipe");
      to.push_back(static_cast<float>(v));
    }
  }

  // One byte a pixel, the cheapest target there is.
  void hits_texture() {
    const Gl& gl = context_.gl();
    GLuint texture = 0, framebuffer = 0;
    gl.gen_textures(1, &texture);
    gl.bind_texture(GL_TEXTURE_2D, texture);
    gl.tex_image(GL_TEXTURE_2D, 0, GL_R8, frame_.width, frame_.height, 0, GL_RED, GL_UNSIGNED_BYTE,
                 nullptr);
    gl.gen_framebuffers(1, &framebuffer);
    gl.bind_framebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.framebuffer_texture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    if (gl.framebuffer_status(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw std::runtime_error("llvmpipe does not draw into one byte a pixel");
    }
  }

  FrameState frame_;
  GlContext context_;
  int count_ = 0;
};

// A mesh with depth test and perspective-correct colours, into memory of the caller.
class FrameScene {
 public:
  explicit FrameScene(const Workload& work)
      : frame_(work.frame),
        context_(work.frame.width, work.frame.height),
        count_(static_cast<int>(3 * work.mesh->triangles.size())) {
    const Gl& gl = context_.gl();
    std::vector<float> vertices;
    vertices.reserve(kFloats * work.mesh->positions.size());
    for (std::uint32_t i = 0; i < work.mesh->positions.size(); ++i) {
      append(work.mesh->vertex(i), vertices);
    }
    context_.use_program(
        "#version 120\nuniform mat4 m; attribute vec4 p; attribute vec3 c; varying vec3 color;\n"
        "void main() { gl_Position = m * p; color = c; }",
        "#version 120\nvarying vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }",
        std::array<const char*, 2>{"p", "c"});
    context_.buffer(GL_ARRAY_BUFFER, vertices);
    context_.attribute(0, 4, kFloats, 0);
    context_.attribute(1, 3, kFloats, 4);
    context_.buffer(GL_ELEMENT_ARRAY_BUFFER, work.mesh->triangles);
    context_.uniform_identity("m");
    gl.viewport(0, 0, frame_.width, frame_.height);
    gl.depth_func(GL_LESS);
    gl.clear_color(kBenchBackground[0] / 255.0F, kBenchBackground[1] / 255.0F,
                   kBenchBackground[2] / 255.0F, 1);
    context_.check("preparing");
  }

  void run() {
    context_.make_current();
    draw();
  }

  BenchOutput count() {
    const Gl& gl = context_.gl();
    context_.make_current();
    BenchOutput out;
    gl.disable(GL_DEPTH_TEST);
    out.samples = context_.samples_passed(
        [&] { gl.draw_elements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr); });
    gl.enable(GL_DEPTH_TEST);
    draw();
    context_.check("drawing");
    Image picture{frame_.width, frame_.height, {}};
    const std::vector<std::uint8_t>& rgba = context_.pixels();
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
      picture.pixel.push_back({rgba[i], rgba[i + 1], rgba[i + 2]});
    }
    out.picture = std::move(picture);
    return out;
  }

 private:
  static constexpr int kFloats = 7;  // x, y, z, w, red, green, blue

  void draw() {
    const Gl& gl = context_.gl();
    gl.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.draw_elements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
    gl.finish();  // copies the picture to the caller's memory
  }

  // Clip space, from where the geometry stage snaps the vertex to: the driver's floats then end
  // within a tenth of a subpixel of it and snap to the same. So the driver's matrix is the
  // identity, which it multiplies by like by any other. y down is fed as y up.
  void append(const ClipVertex& vertex, std::vector<float>& to) const {
    const glm::dvec4& p = vertex.position;
    const double half_width = frame_.width / 2.0, half_height = frame_.height / 2.0;
    const auto x = static_cast<double>(snap((p.x / p.w + 1.0) * half_width, kBenchConfig));
    const auto y = static_cast<double>(snap((1.0 - p.y / p.w) * half_height, kBenchConfig));
    const double ndc_x = x / kSubpixels / half_width - 1.0;
    const double ndc_y = y / kSubpixels / half_height - 1.0;
    if (std::max(std::abs(ndc_x), std::abs(ndc_y)) > 1 || std::abs(p.z) > p.w) {
      throw std::runtime_error("a vertex is outside the picture: llvmpipe would clip there");
    }
    for (const double v : {ndc_x * p.w, ndc_y * p.w, p.z, p.w}) to.push_back(static_cast<float>(v));
    for (std::size_t c = 0; c < 3; ++c) {
      to.push_back(static_cast<float>(vertex.attribute[c] / 255.0));
    }
  }

  FrameState frame_;
  GlContext context_;
  int count_;
};

template <class Scene>
std::vector<BenchEntry> entries(const Workload& work, const char* name) {
  if (!llvmpipe_absent().empty()) return {};
  const auto scene = std::make_shared<Scene>(work);
  return {{llvmpipe_row(name), [scene] { scene->run(); }, [scene] { return scene->count(); }}};
}

}  // namespace

std::string llvmpipe_absent() {
  std::string why;
  osmesa(why);
  return why;
}

std::vector<BenchEntry> llvmpipe_coverage_entries(const Workload& work) {
  return entries<CoverageScene>(work, "coverage");
}

std::vector<BenchEntry> llvmpipe_frame_entries(const Workload& work) {
  return entries<FrameScene>(work, "frame");
}

}  // namespace halfspace
