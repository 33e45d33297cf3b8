// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The OpenGL functions that the viewer calls, from GLFW, EGL or OSMesa, whichever made the context.
#pragma once

#include <GL/gl.h>
#include <GL/glext.h>

namespace glark::tool {

// clang-format off
#define GLARK_VIEW_GL(f) \
  f(BindBuffer) f(BindFramebuffer) f(BindRenderbuffer) f(BufferData) f(BufferSubData) \
  f(CheckFramebufferStatus) f(Clear) f(ClearColor) f(Color3f) f(ColorMaterial) f(ColorPointer) \
  f(DeleteBuffers) f(Disable) f(DrawArrays) f(DrawElements) f(Enable) f(EnableClientState) \
  f(FramebufferRenderbuffer) f(GenBuffers) f(GenFramebuffers) f(GenRenderbuffers) f(LightModeli) \
  f(Lightfv) f(LoadIdentity) f(LoadMatrixf) f(Materialf) f(Materialfv) f(MatrixMode) \
  f(MultiDrawElements) f(NormalPointer) f(PixelStorei) f(PointParameterf) f(PointParameterfv) \
  f(PointSize) f(PolygonMode) f(ReadPixels) f(RenderbufferStorage) f(VertexPointer) f(Viewport)
// clang-format on

struct Gl {
#define GLARK_MEMBER(name) decltype(&::gl##name) name = nullptr;
  GLARK_VIEW_GL(GLARK_MEMBER)
#undef GLARK_MEMBER

  // Loads the functions of the current context. Throws std::runtime_error if one is missing.
  using Loader = void (*(*)(const char* name))();
  void load(Loader loader);
};

extern Gl gl;

}  // namespace glark::tool
