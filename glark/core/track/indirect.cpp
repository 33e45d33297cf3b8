// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of the indirect draws. They read the counts back: these are the only draws for which the CPU waits for the GPU.
#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

#include "glark/core/track/track.h"

namespace glark::core {
namespace {

constexpr GLsizei arrays_command_bytes = 16;
constexpr GLsizei elements_command_bytes = 20;
constexpr std::size_t most_kept_words = 320;  // of the key of a kept draw

// The words of the commands of one call. The first two of each command: vertices (or indices) and instances.
struct Commands {
  std::size_t words_each = 0;
  std::vector<std::uint32_t> words;
  bool readable = true;  // false: GL may draw all the same
};

bool read_command(Context& c, GLintptr offset, std::span<std::uint32_t> words) {
  if (c.capabilities().api != Capabilities::Api::es) {
    c.gl().GetBufferSubData(GL_DRAW_INDIRECT_BUFFER, offset, static_cast<GLsizeiptr>(words.size_bytes()), words.data());
    return true;
  }
  const void* mapped = c.gl().MapBufferRange(GL_DRAW_INDIRECT_BUFFER, offset,
                                             static_cast<GLsizeiptr>(words.size_bytes()), GL_MAP_READ_BIT);
  if (mapped == nullptr) {
    return false;
  }
  std::memcpy(words.data(), mapped, words.size_bytes());
  c.gl().UnmapBuffer(GL_DRAW_INDIRECT_BUFFER);
  return true;
}

struct IndirectDraw {
  GLenum mode;
  const void* indirect;
  GLsizei draws = 1;
  GLsizei stride = 0;  // 0: tightly packed
  GLsizei command_bytes;
  bool exact;
  GLenum index_type = 0;
};

// GL refuses draws from a buffer that is mapped, unless the mapping is persistent.
bool is_mapped(Context& c) {
  GLint mapped = 0;
  GLint access = 0;
  c.gl().GetBufferParameteriv(GL_DRAW_INDIRECT_BUFFER, GL_BUFFER_MAPPED, &mapped);
  if (mapped != 0) {
    c.gl().GetBufferParameteriv(GL_DRAW_INDIRECT_BUFFER, GL_BUFFER_ACCESS_FLAGS, &access);
  }
  return mapped != 0 && (access & GL_MAP_PERSISTENT_BIT) == 0;
}

// No words: GL will refuse the call, or draws nothing, or the commands cannot be read.
Commands read_commands(Context& c, const IndirectDraw& call) {
  c.state().refresh();
  Commands commands{.words_each = static_cast<std::size_t>(call.command_bytes) / 4, .words = {}};
  const auto draws = static_cast<std::size_t>(call.draws);
  const GLintptr stride = call.stride != 0 ? call.stride : call.command_bytes;
  const bool in_memory = c.state().bindings().draw_indirect_buffer == 0;
  if (in_memory && (!c.capabilities().is_compatibility() || call.indirect == nullptr)) {
    return commands;
  }
  GLint size = 0;
  if (!in_memory) {
    c.gl().GetBufferParameteriv(GL_DRAW_INDIRECT_BUFFER, GL_BUFFER_SIZE, &size);
    if (is_mapped(c) ||
        (draws > 0 && (draws - 1) * static_cast<std::uint64_t>(stride) > static_cast<std::uint64_t>(size))) {
      return commands;
    }
  }
  commands.words.resize(draws * commands.words_each);
  for (std::size_t i = 0; i < draws; ++i) {
    const std::span<std::uint32_t> words(&commands.words[i * commands.words_each], commands.words_each);
    const GLintptr offset = reinterpret_cast<GLintptr>(call.indirect) + static_cast<GLintptr>(i) * stride;
    if (in_memory) {
      std::memcpy(words.data(), reinterpret_cast<const void*>(offset), words.size_bytes());
    } else if (offset < 0 || offset % 4 != 0 || offset + static_cast<GLintptr>(words.size_bytes()) > size) {
      commands.words.clear();
      return commands;
    } else if (!read_command(c, offset, words)) {
      return {.words_each = commands.words_each, .words = {}, .readable = false};
    }
  }
  return commands;
}

void draw_indirect(Context& c, const IndirectDraw& call, Issue issue) {
  if (call.draws < 0 || call.stride % 4 != 0 || call.mode > GL_PATCHES) {
    track::refused(c, issue);
    return;
  }
  if (!is_triangle_mode(call.mode)) {
    track::draw(c, {.mode = call.mode, .issue = issue});
    return;
  }
  const Commands commands = read_commands(c, call);
  std::uint64_t triangles = 0;
  std::uint64_t primitives = 0;
  std::uint64_t end = 0;
  PolygonSides sides;
  for (std::size_t i = 0; i < commands.words.size(); i += commands.words_each) {
    const std::uint32_t vertices = commands.words[i];
    const std::uint32_t instances = commands.words[i + 1];
    triangles += triangles_of(call.mode, vertices) * instances;
    end = std::max(end, std::uint64_t{commands.words[i + 2]} + vertices);  // of a draw without indices
    primitives += instances;
    if (call.mode == GL_POLYGON && splits_polygons(c.options(), c.ark()) && vertices >= 3) {
      sides.insert(sides.end(), instances, vertices);
    }
  }
  if (commands.words.empty() && commands.readable) {
    track::refused(c, issue);
    return;
  }
  if (!commands.readable) {
    track::leave(c, {.mode = call.mode, .from_arrays = true, .issue = issue}, Cause::indirect_unbounded);
    return;
  }
  c.state().refresh();
  const bool restarts = c.state().bindings().primitive_restart || c.state().bindings().primitive_restart_fixed;
  const bool indexed = call.command_bytes != arrays_command_bytes;
  const bool may_restart = indexed ? restarts : track::restarts_at_vertex(c, end);
  const ArrayDraw arrays{.mode = call.mode, .index_type = call.index_type};
  const bool keeps = call.exact && (indexed || !may_restart) && commands.words.size() <= most_kept_words;
  track::draw(c, {.mode = call.mode,
                  .triangles = triangles,
                  .exact = call.exact && !may_restart,
                  .whole_polygons = tells_polygons_apart(call.mode, primitives),
                  .polygon_sides = may_restart || sides.empty() ? nullptr : &sides,
                  .from_arrays = true,
                  .indexed = indexed,
                  .arrays = keeps ? &arrays : nullptr,
                  .commands = commands.words,
                  .issue = issue});
}

}  // namespace

namespace hook {

void DrawArraysIndirect(Context& c, GLenum mode, const void* indirect) {
  draw_indirect(c, {.mode = mode, .indirect = indirect, .command_bytes = arrays_command_bytes, .exact = true},
                [&] { c.gl().DrawArraysIndirect(mode, indirect); });
}

void DrawElementsIndirect(Context& c, GLenum mode, GLenum type, const void* indirect) {
  draw_indirect(
      c,
      {.mode = mode, .indirect = indirect, .command_bytes = elements_command_bytes, .exact = true, .index_type = type},
      [&] { c.gl().DrawElementsIndirect(mode, type, indirect); });
}

void MultiDrawArraysIndirect(Context& c, GLenum mode, const void* indirect, GLsizei draws, GLsizei stride) {
  draw_indirect(c,
                {.mode = mode,
                 .indirect = indirect,
                 .draws = draws,
                 .stride = stride,
                 .command_bytes = arrays_command_bytes,
                 .exact = true},
                [&] { c.gl().MultiDrawArraysIndirect(mode, indirect, draws, stride); });
}

void MultiDrawElementsIndirect(Context& c, GLenum mode, GLenum type, const void* indirect, GLsizei draws,
                               GLsizei stride) {
  draw_indirect(c,
                {.mode = mode,
                 .indirect = indirect,
                 .draws = draws,
                 .stride = stride,
                 .command_bytes = elements_command_bytes,
                 .exact = true,
                 .index_type = type},
                [&] { c.gl().MultiDrawElementsIndirect(mode, type, indirect, draws, stride); });
}

// Only the GPU knows the number of commands; their greatest number gives a bound.
void MultiDrawArraysIndirectCount(Context& c, GLenum mode, const void* indirect, GLintptr count, GLsizei most,
                                  GLsizei stride) {
  draw_indirect(c,
                {.mode = mode,
                 .indirect = indirect,
                 .draws = most,
                 .stride = stride,
                 .command_bytes = arrays_command_bytes,
                 .exact = false},
                [&] { c.gl().MultiDrawArraysIndirectCount(mode, indirect, count, most, stride); });
}

void MultiDrawElementsIndirectCount(Context& c, GLenum mode, GLenum type, const void* indirect, GLintptr count,
                                    GLsizei most, GLsizei stride) {
  draw_indirect(c,
                {.mode = mode,
                 .indirect = indirect,
                 .draws = most,
                 .stride = stride,
                 .command_bytes = elements_command_bytes,
                 .exact = false},
                [&] { c.gl().MultiDrawElementsIndirectCount(mode, type, indirect, count, most, stride); });
}

}  // namespace hook
}  // namespace glark::core
