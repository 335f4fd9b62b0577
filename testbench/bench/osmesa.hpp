// SPDX-License-Identifier: Apache-2.0
//
// Mesa's llvmpipe without a window: OSMesa, opened at run time so that the program needs it only
// where it is asked for.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace halfspace {

// The functions of the library that the bench calls.
struct Gl {
  decltype(&::OSMesaCreateContextAttribs) create_context;
  decltype(&::OSMesaMakeCurrent) make_current;
  decltype(&::OSMesaDestroyContext) destroy_context;
  decltype(&::glBlendFunc) blend_func;
  decltype(&::glClear) clear;
  decltype(&::glClearColor) clear_color;
  decltype(&::glDepthFunc) depth_func;
  decltype(&::glDisable) disable;
  decltype(&::glDrawArrays) draw_arrays;
  decltype(&::glDrawElements) draw_elements;
  decltype(&::glEnable) enable;
  decltype(&::glFinish) finish;
  decltype(&::glGenTextures) gen_textures;
  decltype(&::glBindTexture) bind_texture;
  decltype(&::glTexImage2D) tex_image;
  decltype(&::glGetError) get_error;
  decltype(&::glGetString) get_string;
  decltype(&::glPixelStorei) pixel_store;
  decltype(&::glReadPixels) read_pixels;
  decltype(&::glViewport) viewport;
  PFNGLATTACHSHADERPROC attach_shader;
  PFNGLBEGINQUERYPROC begin_query;
  PFNGLBINDATTRIBLOCATIONPROC bind_attribute;
  PFNGLBINDBUFFERPROC bind_buffer;
  PFNGLBINDFRAMEBUFFERPROC bind_framebuffer;
  PFNGLBUFFERDATAPROC buffer_data;
  PFNGLCHECKFRAMEBUFFERSTATUSPROC framebuffer_status;
  PFNGLCOMPILESHADERPROC compile_shader;
  PFNGLCREATEPROGRAMPROC create_program;
  PFNGLCREATESHADERPROC create_shader;
  PFNGLENABLEVERTEXATTRIBARRAYPROC enable_attribute;
  PFNGLENDQUERYPROC end_query;
  PFNGLFRAMEBUFFERTEXTURE2DPROC framebuffer_texture;
  PFNGLGENBUFFERSPROC gen_buffers;
  PFNGLGENFRAMEBUFFERSPROC gen_framebuffers;
  PFNGLGENQUERIESPROC gen_queries;
  PFNGLGETPROGRAMIVPROC get_program;
  PFNGLGETQUERYOBJECTUI64VPROC get_query;
  PFNGLGETUNIFORMLOCATIONPROC uniform_location;
  PFNGLUNIFORMMATRIX4FVPROC uniform_matrix;
  PFNGLLINKPROGRAMPROC link_program;
  PFNGLSHADERSOURCEPROC shader_source;
  PFNGLUSEPROGRAMPROC use_program;
  PFNGLVERTEXATTRIBPOINTERPROC attribute_pointer;
};

// The library, opened once; null when it cannot be: why is then in `why`. Sets LP_NUM_THREADS=0
// first, so that all work is done, and can be timed, in the calling thread.
const Gl* osmesa(std::string& why);

// A context that draws into memory of its own: RGBA, 8 bits each, row 0 first, and 24 bits of
// depth. Row 0 of GL, the lowest, is taken for the highest: then the rule of edges is top-left.
// Throws std::runtime_error when the library says no, or is not llvmpipe.
class GlContext {
 public:
  GlContext(int width, int height);
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  // To be called before anything else is, when there are several contexts.
  void make_current();
  const Gl& gl() const { return *gl_; }
  const std::vector<std::uint8_t>& pixels() const { return pixels_; }

  // A program of GLSL 1.20; attribute i of the vertex shader is attributes[i].
  void use_program(const char* vertex, const char* fragment,
                   std::span<const char* const> attributes);
  // A buffer that stays bound to GL_ARRAY_BUFFER or GL_ELEMENT_ARRAY_BUFFER.
  template <class Value>
  void buffer(GLenum target, const std::vector<Value>& values) {
    buffer(target, values.data(), values.size() * sizeof(Value));
  }
  // Floats first .. first + count - 1 of each group of `stride` in the bound buffer.
  void attribute(unsigned index, int count, int stride, int first);
  // The mat4 of that name in the program in use.
  void uniform_identity(const char* name);

  // Samples that pass while draw() runs.
  template <class Draw>
  std::uint64_t samples_passed(const Draw& draw) {
    GLuint query = 0;
    gl_->gen_queries(1, &query);
    gl_->begin_query(GL_SAMPLES_PASSED, query);
    draw();
    gl_->end_query(GL_SAMPLES_PASSED);
    GLuint64 passed = 0;
    gl_->get_query(query, GL_QUERY_RESULT, &passed);
    return passed;
  }

  // Throws when GL has reported an error.
  void check(const char* doing) const;

 private:
  void buffer(GLenum target, const void* data, std::size_t bytes);

  const Gl* gl_;
  int width_;
  int height_;
  GLuint program_ = 0;
  OSMesaContext context_ = nullptr;
  std::vector<std::uint8_t> pixels_;
};

}  // namespace halfspace
