// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Transform feedback of the application's own draw into a buffer: its coarse triangles with all their attributes.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/state/bindings.h"
#include "glark/gl/dispatch.h"

namespace glark::capture {

// How the number of captured triangles is known.
enum class Count {
  known,     // the caller knows it
  checked,   // the caller gives a count, and GL's count is read back: the lesser one holds
  by_query,  // GL alone knows it; the number stays on the GPU where it can
};

// Reads the result of a query into client memory; waits for the GPU.
std::uint64_t query_result(const gl::Dispatch& gl, GLuint query, const core::Bindings& bindings);

class CaptureStage {
 public:
  CaptureStage(const gl::Dispatch& gl, Language language, bool query_buffer)
      : gl_(gl), language_(language), query_buffer_(query_buffer) {}

  // The program that captures `layout`, built on first use; 0 if it cannot be built. Wrap in an ErrorScope.
  GLuint program_for(const Layout& layout, GLuint tag_attribute);

  // Makes room for `triangles` records in the ring; false without memory. Wrap in an ErrorScope.
  bool reserve(const Layout& layout, std::uint64_t triangles);
  // The application's draws from here to end() are captured. With another `primitive` than GL_TRIANGLES, the records
  // and triangles of end() are those primitives.
  void begin(GLuint program, const core::Bindings& bindings, Count count, const core::GpuBuffer* own_buffer,
             GLenum primitive = GL_TRIANGLES);
  // Mesa 22 has one mode of transform feedback for a context: the mode of the last feedback that began. This sets it.
  void set_feedback_mode(GLuint program, GLenum mode, const core::Bindings& bindings) const;
  CoarseTriangles end(const Layout& layout, std::uint64_t triangles, const core::Bindings& bindings);

  // Triangles of the last capture that had a query; waits for the GPU.
  std::uint64_t counted(const core::Bindings& bindings) const;

  GLuint feedback();  // our transform feedback object, made on first use
  GLuint count_buffer() const { return count_command_.name(); }
  const core::GpuBuffer& count_command() const { return count_command_; }
  bool can_reserve(const Layout& layout, std::uint64_t triangles) const;
  bool has_room(const Layout& layout, std::uint64_t triangles) const;
  void release();

 private:
  GLuint build(const CaptureSources& sources) const;
  void bind_target(GLuint buffer, GLintptr offset, std::int64_t size, const core::Bindings& bindings) const;

  const gl::Dispatch& gl_;
  Language language_;
  bool query_buffer_;
  std::map<std::string, GLuint> programs_;  // by vertex source
  GLuint feedback_ = 0;
  std::array<GLuint, 2>
      queries_{};  // primitives written; primitives generated, if the application uses a query of the former
  core::GpuBuffer ring_;
  core::GpuBuffer count_command_;
  GLintptr cursor_ = 0;
  struct Current {
    GLuint buffer = 0;
    GLintptr offset = 0;
    Count count = Count::known;
    std::size_t query = 0;  // which of queries_
  };
  Current current_;  // the capture between begin() and end(), or the last one
};

}  // namespace glark::capture
