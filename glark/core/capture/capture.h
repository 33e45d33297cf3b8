// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's own draw, issued once into a buffer: its coarse triangles with all their attributes.
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

// Who knows how many triangles there are.
enum class Count {
  known,     // the caller
  checked,   // the caller; GL's own count is read back, and the smaller one taken
  by_query,  // GL; the number stays on the GPU where it can
};

class CaptureStage {
 public:
  CaptureStage(const gl::Dispatch& gl, Language language, bool query_buffer)
      : gl_(gl), language_(language), query_buffer_(query_buffer) {}

  // Program that captures `layout`, built on first use; 0 if it cannot be. Rare path: wrap in an ErrorScope.
  GLuint program_for(const Layout& layout, GLuint tag_attribute);

  // Room for `triangles` records in `ring`; false without memory. Rare path inside when the ring must grow.
  bool reserve(const Layout& layout, std::uint64_t triangles);
  // From here to end() the draws of the application are captured.
  void begin(GLuint program, const core::Bindings& bindings, Count count, core::GpuBuffer* own_buffer);
  // Mesa 22 has one mode of transform feedback a context, that of the last one to begin: makes it this one again.
  void set_feedback_mode(GLuint program, GLenum mode, const core::Bindings& bindings) const;
  CoarseTriangles end(const Layout& layout, std::uint64_t triangles, const core::Bindings& bindings);

  // Triangles of the last capture that was not exact; waits for the GPU.
  std::uint64_t counted(const core::Bindings& bindings) const;

  GLuint feedback();  // our transform feedback object, made on first use
  GLuint count_buffer() const { return count_command_.name(); }
  const core::GpuBuffer& count_command() const { return count_command_; }
  bool can_reserve(const Layout& layout, std::uint64_t triangles) const;
  bool has_room(const Layout& layout, std::uint64_t triangles) const;
  void release();

 private:
  GLuint build(const CaptureSources& sources) const;
  void bind_target(GLuint buffer, GLintptr offset, GLsizeiptr size, const core::Bindings& bindings) const;

  const gl::Dispatch& gl_;
  Language language_;
  bool query_buffer_;
  std::map<std::string, GLuint> programs_;  // by vertex source
  GLuint feedback_ = 0;
  std::array<GLuint, 2> queries_{};  // of primitives written, and generated: where the application counts the former
  core::GpuBuffer ring_;
  core::GpuBuffer count_command_;
  GLintptr cursor_ = 0;
  // of the capture under way
  GLuint target_ = 0;
  GLintptr target_offset_ = 0;
  Count count_ = Count::known;
  std::size_t counting_ = 0;  // which of queries_
};

}  // namespace glark::capture
