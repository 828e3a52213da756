#pragma once
/// Pictures of shaders without a window: EGL without a surface and OpenGL ES 3, which Mesa draws by software
/// (llvmpipe).

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/camera.hpp"
#include "durero/shader/fragment.hpp"

#ifdef DURERO_EGL
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#endif

namespace durero::test {

#ifdef DURERO_EGL

/// A context for drawing. Only one may be alive.
class Offscreen {
 public:
  /// Makes the context. Throws std::runtime_error where there is none.
  Offscreen() {
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (platform_display == nullptr) throw std::runtime_error("EGL knows no platforms");
    display_ = platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE)
      throw std::runtime_error("EGL has no display without a surface");
    eglBindAPI(EGL_OPENGL_ES_API);
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config{};
    EGLint count = 0;
    if (eglChooseConfig(display_, wanted, &config, 1, &count) == EGL_FALSE || count == 0)
      throw std::runtime_error("EGL has no configuration for OpenGL ES 3");
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT || eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
      throw std::runtime_error("EGL makes no context for OpenGL ES 3");
  }
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;
  ~Offscreen() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
  }

  /// The name of what draws.
  std::string renderer() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

 private:
  EGLDisplay display_{};
  EGLContext context_{};
};

/// A shader that is compiled, and draws into a picture of its own. Precondition of all members: the context is alive.
class DrawnShader {
 public:
  /// Compiles a text. Throws std::runtime_error, with what the compiler says.
  DrawnShader(const std::string& fragment, bool answers) : answers_(answers), program_(glCreateProgram()) {
    add(GL_VERTEX_SHADER, std::string(shader::vertex_shader()));
    add(GL_FRAGMENT_SHADER, fragment);
    glLinkProgram(program_);
    GLint linked = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (linked == 0) throw std::runtime_error("the shader does not link");
  }
  DrawnShader(const DrawnShader&) = delete;
  DrawnShader& operator=(const DrawnShader&) = delete;
  ~DrawnShader() {
    glDeleteProgram(program_);
    glDeleteFramebuffers(1, &frame_);
    glDeleteRenderbuffers(1, &picture_);
  }

  /// Draws the picture of these rays, and waits until it is there.
  void draw(const scene::PrimaryRays& rays) {
    const scene::Resolution size = rays.resolution();
    if (size != size_) make_picture(size);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glViewport(0, 0, static_cast<GLsizei>(size.width), static_cast<GLsizei>(size.height));
    glUseProgram(program_);
    const shader::ShaderView view(rays);
    const auto set = [&](const char* name, const std::array<float, 3>& x) {
      glUniform3fv(glGetUniformLocation(program_, name), 1, x.data());
    };
    set("eye", view.eye);
    set("forward", view.forward);
    set("step_x", view.step_x);
    set("step_y", view.step_y);
    glUniform2fv(glGetUniformLocation(program_, "size"), 1, view.size.data());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glFinish();
    if (glGetError() != GL_NO_ERROR) throw std::runtime_error("the shader was not drawn");
  }

  /// The red, green, blue and alpha of each pixel, rows from above.
  std::vector<std::array<std::uint8_t, 4>> colors() const {
    return read<std::array<std::uint8_t, 4>>(GL_RGBA, GL_UNSIGNED_BYTE);
  }
  /// The answer of each pixel, rows from above.
  std::vector<std::array<std::uint32_t, 4>> answers() const {
    return read<std::array<std::uint32_t, 4>>(GL_RGBA_INTEGER, GL_UNSIGNED_INT);
  }

 private:
  void add(GLenum kind, const std::string& text) {
    const GLuint shader = glCreateShader(kind);
    const char* const begin = text.c_str();
    glShaderSource(shader, 1, &begin, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == 0) {
      std::string log(4096, '\0');
      glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
      throw std::runtime_error(log.c_str());
    }
    glAttachShader(program_, shader);
    glDeleteShader(shader);
  }

  void make_picture(scene::Resolution size) {
    size_ = size;
    if (frame_ == 0) {
      glGenFramebuffers(1, &frame_);
      glGenRenderbuffers(1, &picture_);
    }
    glBindRenderbuffer(GL_RENDERBUFFER, picture_);
    glRenderbufferStorage(GL_RENDERBUFFER, answers_ ? GL_RGBA32UI : GL_RGBA8, static_cast<GLsizei>(size.width),
                          static_cast<GLsizei>(size.height));
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, picture_);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw std::runtime_error("there is no picture to draw into");
  }

  template <class Pixel>
  std::vector<Pixel> read(GLenum format, GLenum type) const {
    std::vector<Pixel> below(std::size_t{size_.width} * size_.height), above;
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glReadPixels(0, 0, static_cast<GLsizei>(size_.width), static_cast<GLsizei>(size_.height), format, type,
                 below.data());
    above.reserve(below.size());
    for (std::uint32_t y = size_.height; y-- > 0;)
      above.insert(above.end(), below.begin() + std::ptrdiff_t(y) * size_.width,
                   below.begin() + std::ptrdiff_t(y + 1) * size_.width);
    return above;
  }

  bool answers_;
  GLuint program_, frame_ = 0, picture_ = 0;
  scene::Resolution size_{0, 0};
};

#endif

}  // namespace durero::test
