// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of the indirect draws. They read the counts back: these are the only draws for which the CPU waits for the GPU.
#include <algorithm>
#include <cstring>
#include <vector>

#include "glark/core/track/track.h"

namespace glark::core {
namespace {

constexpr GLsizei arrays_command_bytes = 16;
constexpr GLsizei elements_command_bytes = 20;

// The first two words of every command: vertices (or indices) and instances.
struct Counts {
  std::uint32_t vertices = 0;
  std::uint32_t instances = 0;
};

bool read_counts(Context& c, GLintptr offset, Counts& counts) {
  if (c.capabilities().api != Capabilities::Api::es) {
    c.gl().GetBufferSubData(GL_DRAW_INDIRECT_BUFFER, offset, sizeof counts, &counts);
    return true;
  }
  const void* mapped = c.gl().MapBufferRange(GL_DRAW_INDIRECT_BUFFER, offset, sizeof counts, GL_MAP_READ_BIT);
  if (mapped == nullptr) {
    return false;
  }
  std::memcpy(&counts, mapped, sizeof counts);
  c.gl().UnmapBuffer(GL_DRAW_INDIRECT_BUFFER);
  return true;
}

std::vector<Counts> read_commands(Context& c, const void* indirect, GLsizei draws, GLsizei stride) {
  c.state().refresh();
  std::vector<Counts> result(static_cast<std::size_t>(std::max(draws, 0)));
  if (c.state().bindings().draw_indirect_buffer == 0) {
    if (!c.capabilities().is_compatibility() || indirect == nullptr) {
      return {};
    }
    for (std::size_t i = 0; i < result.size(); ++i) {
      std::memcpy(&result[i], static_cast<const char*>(indirect) + i * static_cast<std::size_t>(stride),
                  sizeof(Counts));
    }
    return result;
  }
  GLint size = 0;
  c.gl().GetBufferParameteriv(GL_DRAW_INDIRECT_BUFFER, GL_BUFFER_SIZE, &size);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const GLintptr offset = reinterpret_cast<GLintptr>(indirect) + static_cast<GLintptr>(i) * stride;
    if (offset < 0 || offset % 4 != 0 || offset + static_cast<GLintptr>(sizeof(Counts)) > size ||
        !read_counts(c, offset, result[i])) {
      return {};
    }
  }
  return result;
}

struct IndirectDraw {
  GLenum mode;
  const void* indirect;
  GLsizei draws = 1;
  GLsizei stride = 0;  // 0: tightly packed
  GLsizei command_bytes;
  bool exact;
};

void draw_indirect(Context& c, const IndirectDraw& call, Issue issue) {
  if (call.draws < 0 || call.stride % 4 != 0 || !is_triangle_mode(call.mode)) {
    track::draw(c, {.mode = GL_POINTS, .issue = issue});
    return;
  }
  const std::vector<Counts> commands =
      read_commands(c, call.indirect, call.draws, call.stride != 0 ? call.stride : call.command_bytes);
  std::uint64_t triangles = 0;
  std::uint64_t primitives = 0;
  PolygonSides sides;
  for (const Counts& command : commands) {
    triangles += triangles_of(call.mode, command.vertices) * command.instances;
    primitives += command.instances;
    if (call.mode == GL_POLYGON && splits_polygons(c.options(), c.ark()) && command.vertices >= 3) {
      sides.insert(sides.end(), command.instances, command.vertices);
    }
  }
  if (commands.empty()) {
    track::leave(c, {.mode = call.mode, .from_arrays = true, .issue = issue}, Cause::indirect_unbounded);
    return;
  }
  c.state().refresh();
  const bool restarts = c.state().bindings().primitive_restart || c.state().bindings().primitive_restart_fixed;
  const bool may_restart = restarts && call.command_bytes != arrays_command_bytes;
  track::draw(c, {.mode = call.mode,
                  .triangles = triangles,
                  .exact = call.exact && !may_restart,
                  .whole_polygons = tells_polygons_apart(call.mode, primitives),
                  .polygon_sides = may_restart || sides.empty() ? nullptr : &sides,
                  .from_arrays = true,
                  .issue = issue});
}

}  // namespace

namespace hook {

void DrawArraysIndirect(Context& c, GLenum mode, const void* indirect) {
  draw_indirect(c, {.mode = mode, .indirect = indirect, .command_bytes = arrays_command_bytes, .exact = true},
                [&] { c.gl().DrawArraysIndirect(mode, indirect); });
}

void DrawElementsIndirect(Context& c, GLenum mode, GLenum type, const void* indirect) {
  draw_indirect(c, {.mode = mode, .indirect = indirect, .command_bytes = elements_command_bytes, .exact = true},
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
                 .exact = true},
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
