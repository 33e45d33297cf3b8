// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sources of contexts. The suite loads a window system's libraries only when they are asked for, so it runs on machines
// that have only one of them.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "conformance/gl/function_source.h"

namespace glark::conformance {

enum class Api { gl_compat, gl_core, gles };

inline constexpr std::string_view name_of(Api api) {
  return api == Api::gl_compat ? "gl-compat" : api == Api::gl_core ? "gl-core" : "gles";
}

// Width and height of a context's surface, in pixels. The surface has RGBA8, 24 bits of depth and 8 of stencil.
inline constexpr int surface_size = 128;

// A new context is current in the thread that made it.
class Context {
 public:
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  virtual ~Context() = default;  // call it in the thread in which the context is current, or if it is current in none

  virtual bool make_current() = 0;
  virtual void release_current() = 0;
  // Ends a frame where the platform has frames: swaps buffers. Otherwise finishes.
  virtual void end_frame() = 0;
};

class Platform : public FunctionSource {
 public:
  // "osmesa", "egl" or "glx". Throws std::runtime_error that says what is missing.
  static std::unique_ptr<Platform> open(std::string_view name);

  // OpenGL 4.3 or later, or OpenGL ES 3.2; `share` may be null. Throws std::runtime_error.
  virtual std::unique_ptr<Context> create_context(Api api, Context* share) = 0;
};

std::unique_ptr<Platform> open_osmesa();
std::unique_ptr<Platform> open_egl();
std::unique_ptr<Platform> open_glx();

}  // namespace glark::conformance
