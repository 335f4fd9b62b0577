// SPDX-License-Identifier: Apache-2.0
#include "osmesa.hpp"

#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace halfspace {
namespace {

struct Library {
  Gl gl{};
  std::string why;
};

Library load() {
  Library out;
  setenv("LP_NUM_THREADS", "0", 1);
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  void* handle = nullptr;
  for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
    if (handle == nullptr) handle = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
  }
  if (handle == nullptr) {
    out.why = std::string("libOSMesa cannot be opened: ") + dlerror();
    return out;
  }
  using GetProcAddress = decltype(&::OSMesaGetProcAddress);
  const auto lookup = reinterpret_cast<GetProcAddress>(dlsym(handle, "OSMesaGetProcAddress"));
  const auto find = [&](auto& function, const char* name) {
    void* found = dlsym(handle, name);
    if (found == nullptr && lookup != nullptr) found = reinterpret_cast<void*>(lookup(name));
    if (found == nullptr && out.why.empty()) out.why = std::string("libOSMesa has no ") + name;
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(found);
  };
  Gl& gl = out.gl;
  find(gl.create_context, "OSMesaCreateContextAttribs");
  find(gl.make_current, "OSMesaMakeCurrent");
  find(gl.destroy_context, "OSMesaDestroyContext");
  find(gl.blend_func, "glBlendFunc");
  find(gl.clear, "glClear");
  find(gl.clear_color, "glClearColor");
  find(gl.depth_func, "glDepthFunc");
  find(gl.disable, "glDisable");
  find(gl.draw_arrays, "glDrawArrays");
  find(gl.draw_elements, "glDrawElements");
  find(gl.enable, "glEnable");
  find(gl.finish, "glFinish");
  find(gl.gen_textures, "glGenTextures");
  find(gl.bind_texture, "glBindTexture");
  find(gl.tex_image, "glTexImage2D");
  find(gl.get_error, "glGetError");
  find(gl.get_string, "glGetString");
  find(gl.pixel_store, "glPixelStorei");
  find(gl.read_pixels, "glReadPixels");
  find(gl.viewport, "glViewport");
  find(gl.attach_shader, "glAttachShader");
  find(gl.begin_query, "glBeginQuery");
  find(gl.bind_attribute, "glBindAttribLocation");
  find(gl.bind_buffer, "glBindBuffer");
  find(gl.bind_framebuffer, "glBindFramebuffer");
  find(gl.buffer_data, "glBufferData");
  find(gl.framebuffer_status, "glCheckFramebufferStatus");
  find(gl.compile_shader, "glCompileShader");
  find(gl.create_program, "glCreateProgram");
  find(gl.create_shader, "glCreateShader");
  find(gl.enable_attribute, "glEnableVertexAttribArray");
  find(gl.end_query, "glEndQuery");
  find(gl.framebuffer_texture, "glFramebufferTexture2D");
  find(gl.gen_buffers, "glGenBuffers");
  find(gl.gen_framebuffers, "glGenFramebuffers");
  find(gl.gen_queries, "glGenQueries");
  find(gl.get_program, "glGetProgramiv");
  find(gl.get_query, "glGetQueryObjectui64v");
  find(gl.uniform_location, "glGetUniformLocation");
  find(gl.uniform_matrix, "glUniformMatrix4fv");
  find(gl.link_program, "glLinkProgram");
  find(gl.shader_source, "glShaderSource");
  find(gl.use_program, "glUseProgram");
  find(gl.attribute_pointer, "glVertexAttribPointer");
  return out;
}

}  // namespace

const Gl* osmesa(std::string& why) {
  static const Library library = load();
  why = library.why;
  return why.empty() ? &library.gl : nullptr;
}

GlContext::GlContext(int width, int height)
    : width_(width),
      height_(height),
      pixels_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
  std::string why;
  gl_ = osmesa(why);
  if (gl_ == nullptr) throw std::runtime_error(why);
  const std::array<int, 7> attributes{
      OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
  context_ = gl_->create_context(attributes.data(), nullptr);
  if (context_ == nullptr) throw std::runtime_error("OSMesa makes no context");
  make_current();
  const auto* name = reinterpret_cast<const char*>(gl_->get_string(GL_RENDERER));
  if (name == nullptr || !std::string_view(name).starts_with("llvmpipe")) {
    throw std::runtime_error(std::string("OSMesa draws with ") + (name == nullptr ? "?" : name) +
                             ", not with llvmpipe");
  }
}

GlContext::~GlContext() {
  if (context_ != nullptr) gl_->destroy_context(context_);
}

void GlContext::make_current() {
  if (gl_->make_current(context_, pixels_.data(), GL_UNSIGNED_BYTE, width_, height_) == 0) {
    throw std::runtime_error("OSMesa cannot draw into a buffer of this size");
  }
}

void GlContext::use_program(const char* vertex, const char* fragment,
                            std::span<const char* const> attributes) {
  program_ = gl_->create_program();
  const auto attach = [&](GLenum type, const char* text) {
    const GLuint shader = gl_->create_shader(type);
    gl_->shader_source(shader, 1, &text, nullptr);
    gl_->compile_shader(shader);
    gl_->attach_shader(program_, shader);
  };
  attach(GL_VERTEX_SHADER, vertex);
  attach(GL_FRAGMENT_SHADER, fragment);
  for (unsigned i = 0; i < attributes.size(); ++i) {
    gl_->bind_attribute(program_, i, attributes[i]);
  }
  gl_->link_program(program_);
  GLint linked = 0;
  gl_->get_program(program_, GL_LINK_STATUS, &linked);
  if (linked == 0) throw std::runtime_error("llvmpipe does not link the program");
  gl_->use_program(program_);
}

void GlContext::buffer(GLenum target, const void* data, std::size_t bytes) {
  GLuint name = 0;
  gl_->gen_buffers(1, &name);
  gl_->bind_buffer(target, name);
  gl_->buffer_data(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
}

void GlContext::attribute(unsigned index, int count, int stride, int first) {
  const auto bytes = static_cast<std::uintptr_t>(first) * sizeof(float);
  gl_->attribute_pointer(index, count, GL_FLOAT, GL_FALSE, stride * static_cast<int>(sizeof(float)),
                         reinterpret_cast<const void*>(bytes));
  gl_->enable_attribute(index);
}

void GlContext::uniform_identity(const char* name) {
  constexpr std::array<float, 16> kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  gl_->uniform_matrix(gl_->uniform_location(program_, name), 1, GL_FALSE, kIdentity.data());
}

void GlContext::check(const char* doing) const {
  const GLenum error = gl_->get_error();
  if (error == GL_NO_ERROR) return;
  throw std::runtime_error(std::string("llvmpipe: GL error ") + std::to_string(error) + " while " +
                           doing);
}

}  // namespace halfspace
