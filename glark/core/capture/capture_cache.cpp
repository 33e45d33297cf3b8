// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/capture/capture_cache.h"

#include <array>
#include <string_view>

namespace glark::capture {
namespace {

constexpr std::uint64_t frames_to_keep = 120;
constexpr std::size_t most_entries = 4096;
constexpr GLsizeiptr most_bytes = GLsizeiptr{256} << 20;

bool watched(const gl::Dispatch& gl, GLint buffer) {
  if (buffer == 0) {
    return false;
  }
  const core::CopyWriteBinding binding(gl, static_cast<GLuint>(buffer));
  GLint flags = 0;
  gl.GetBufferParameteriv(GL_COPY_WRITE_BUFFER, GL_BUFFER_STORAGE_FLAGS,
                          &flags);  // stays 0 where there is no such storage
  return (flags & GL_MAP_PERSISTENT_BIT) == 0;
}

bool generic_watched(const gl::Dispatch& gl, GLuint location) {
  GLint enabled = 0;
  GLint buffer = 0;
  gl.GetVertexAttribiv(location, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
  gl.GetVertexAttribiv(location, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &buffer);
  return enabled != 0 && watched(gl, buffer);
}

struct ConventionalArray {
  std::string_view name;
  GLenum array;
  GLenum binding;
};

constexpr std::array<ConventionalArray, 5> conventional_arrays{{
    {"gl_Vertex", GL_VERTEX_ARRAY, GL_VERTEX_ARRAY_BUFFER_BINDING},
    {"gl_Normal", GL_NORMAL_ARRAY, GL_NORMAL_ARRAY_BUFFER_BINDING},
    {"gl_Color", GL_COLOR_ARRAY, GL_COLOR_ARRAY_BUFFER_BINDING},
    {"gl_SecondaryColor", GL_SECONDARY_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING},
    {"gl_FogCoord", GL_FOG_COORD_ARRAY, GL_FOG_COORD_ARRAY_BUFFER_BINDING},
}};

bool texture_coordinates_watched(const gl::Dispatch& gl, GLenum unit) {
  GLint active = 0;
  GLint buffer = 0;
  gl.GetIntegerv(GL_CLIENT_ACTIVE_TEXTURE, &active);
  gl.ClientActiveTexture(GL_TEXTURE0 + unit);
  const bool enabled = gl.IsEnabled(GL_TEXTURE_COORD_ARRAY) != GL_FALSE;
  gl.GetIntegerv(GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, &buffer);
  gl.ClientActiveTexture(static_cast<GLenum>(active));
  return enabled && watched(gl, buffer);
}

bool builtin_watched(const gl::Dispatch& gl, const std::string& name) {
  for (const ConventionalArray& row : conventional_arrays) {
    if (name == row.name) {
      GLint buffer = 0;
      gl.GetIntegerv(row.binding, &buffer);
      return gl.IsEnabled(row.array) != GL_FALSE && watched(gl, buffer);
    }
  }
  constexpr std::string_view texture = "gl_MultiTexCoord";
  if (name.rfind(texture, 0) == 0) {
    return texture_coordinates_watched(gl, static_cast<GLenum>(name.back() - '0'));
  }
  return true;  // system values follow from the call
}

}  // namespace

bool reads_only_buffers(const gl::Dispatch& gl, const Layout& layout, bool indexed, GLuint tag_attribute) {
  if (indexed) {
    GLint buffer = 0;
    gl.GetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &buffer);
    if (!watched(gl, buffer)) {
      return false;
    }
  }
  for (const Field& field : layout.fields) {
    if (is_builtin(field)) {
      if (!builtin_watched(gl, field.name)) {
        return false;
      }
      continue;
    }
    for (int i = 0; i < columns_of(field.type) * field.array_size; ++i) {
      if (!generic_watched(gl, static_cast<GLuint>(field.location + i))) {
        return false;
      }
    }
  }
  return !layout.tagged || generic_watched(gl, tag_attribute);
}

// What was not used since the last time.
void CaptureCache::forget_unused(const gl::Dispatch& gl) {
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    if (entry->second.generation < generation_) {
      kept_bytes_ -= entry->second.buffer.size();
      entry->second.buffer.release(gl);
      entry = entries_.erase(entry);
    } else {
      ++entry;
    }
  }
  ++generation_;
}

void CaptureCache::make_room(const gl::Dispatch& gl) {
  if (entries_.size() < most_entries) {
    return;
  }
  forget_unused(gl);
  if (entries_.size() >= most_entries) {
    release(gl);
  }
}

void CaptureCache::frame_finished(const gl::Dispatch& gl) {
  if (++frame_ % frames_to_keep == 0) {
    forget_unused(gl);
  }
}

void CaptureCache::fill(Entry& entry, const CoarseTriangles& triangles) {
  entry.triangles = triangles;
  entry.filled = true;
}

bool CaptureCache::may_keep(GLsizeiptr bytes) const { return kept_bytes_ + bytes <= most_bytes; }

void CaptureCache::release(const gl::Dispatch& gl) {
  for (auto& [key, entry] : entries_) {
    entry.buffer.release(gl);
  }
  entries_.clear();
  kept_bytes_ = 0;
}

}  // namespace glark::capture
