// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The functions of GLX, EGL and OSMesa that this library wraps and exports. Types are declared by their size only, so
// that no header of X11 or EGL is needed.
#pragma once

#include <cstdint>

#include "glark/gl/types.h"

extern "C" {
// GLX. Display, configurations and contexts are pointers; a drawable is an XID.
using GlxDrawable = unsigned long;
using GlxProc = void (*)();
GlxProc glXGetProcAddress(const GLubyte* name);
GlxProc glXGetProcAddressARB(const GLubyte* name);
void* glXCreateContext(void* display, void* visual, void* share, int direct);
void* glXCreateNewContext(void* display, void* config, int type, void* share, int direct);
void* glXCreateContextAttribsARB(void* display, void* config, void* share, int direct, const int* attributes);
void* glXCreateContextWithConfigSGIX(void* display, void* config, int type, void* share, int direct);
void glXDestroyContext(void* display, void* context);
void glXFreeContextEXT(void* display, void* context);
void glXCopyContext(void* display, void* source, void* destination, unsigned long mask);
int glXMakeCurrent(void* display, GlxDrawable drawable, void* context);
int glXMakeContextCurrent(void* display, GlxDrawable draw, GlxDrawable read, void* context);
int glXMakeCurrentReadSGI(void* display, GlxDrawable draw, GlxDrawable read, void* context);
GlxDrawable glXCreateWindow(void* display, void* config, GlxDrawable window, const int* attributes);
void glXSwapBuffers(void* display, GlxDrawable drawable);
std::int64_t glXSwapBuffersMscOML(void* display, GlxDrawable drawable, std::int64_t target, std::int64_t divisor,
                                  std::int64_t remainder);

// EGL.
using EglBoolean = unsigned;
using EglInt = std::int32_t;
using EglProc = void (*)();
EglProc eglGetProcAddress(const char* name);
void* eglGetDisplay(void* native);
void* eglGetPlatformDisplay(unsigned platform, void* native, const std::intptr_t* attributes);
void* eglGetPlatformDisplayEXT(unsigned platform, void* native, const EglInt* attributes);
void* eglCreateWindowSurface(void* display, void* config, void* native, const EglInt* attributes);
void* eglCreatePlatformWindowSurface(void* display, void* config, void* native, const std::intptr_t* attributes);
void* eglCreatePlatformWindowSurfaceEXT(void* display, void* config, void* native, const EglInt* attributes);
void* eglCreateContext(void* display, void* config, void* share, const EglInt* attributes);
EglBoolean eglDestroyContext(void* display, void* context);
EglBoolean eglMakeCurrent(void* display, void* draw, void* read, void* context);
EglBoolean eglReleaseThread();
EglBoolean eglSwapBuffers(void* display, void* surface);
EglBoolean eglSwapBuffersWithDamageKHR(void* display, void* surface, const EglInt* rectangles, EglInt count);
EglBoolean eglSwapBuffersWithDamageEXT(void* display, void* surface, const EglInt* rectangles, EglInt count);

// OSMesa.
using OSMesaProc = void (*)();
OSMesaProc OSMesaGetProcAddress(const char* name);
void* OSMesaCreateContext(GLenum format, void* share);
void* OSMesaCreateContextExt(GLenum format, GLint depth_bits, GLint stencil_bits, GLint accumulation_bits, void* share);
void* OSMesaCreateContextAttribs(const int* attributes, void* share);
void OSMesaDestroyContext(void* context);
GLboolean OSMesaMakeCurrent(void* context, void* buffer, GLenum type, GLsizei width, GLsizei height);
}
