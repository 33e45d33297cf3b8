// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Buffers that are deleted while an object that is not bound keeps them (GL 4.6, 5.1.2 and 5.1.3), and whose names come
// again for other buffers. Draws that have kept something have to tell both buffers apart.
#include <fmt/core.h>

#include <cstddef>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

constexpr GLsizei held_vertices = 6;

// All that a buffer of these cases may hold. Each draw reads one part of it from the buffer that is deleted.
struct HeldContent {
  std::array<Vec4, held_vertices> colours;
  std::array<Vec4, held_vertices> places;
  std::array<float, held_vertices> tags;
  std::array<std::uint32_t, held_vertices> integers;
  std::array<std::uint16_t, 2 * held_vertices> indices;
  Vec4 texel;
};

// The contents differ in all parts. Places and indices leave out different triangles.
HeldContent content_of(int salt) {
  HeldContent content{};
  for (std::size_t i = 0; i < held_vertices; ++i) {
    const auto part = [&](std::size_t k) {
      return 0.3F + static_cast<float>((5 * i + 3 * k + 4 * static_cast<std::size_t>(salt)) % 9) / 16;
    };
    content.colours[i] = {part(0), part(1), part(2), 1};
    const MeshVertex from = one_triangle()[i % 3];
    content.places[i] = {0.55F * from.position[0] + (i < 3 ? -0.5F : 0.5F),
                         (0.8F - 0.2F * static_cast<float>(salt)) * from.position[1], 0, 1};
    content.tags[i] = static_cast<float>(1 + salt);
    content.integers[i] = static_cast<std::uint32_t>(2 + (i / 3 + 2 * static_cast<std::size_t>(salt)) % 7);
    content.indices[i] = static_cast<std::uint16_t>(salt == 1 ? i % 3 : salt == 2 ? 3 + i % 3 : i);
  }
  content.texel = {salt == 0 ? 1.0F : 0.4F, salt == 1 ? 1.0F : 0.7F, 0.9F, 1};
  return content;
}

const void* at_byte(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

GLuint buffer_with(const HeldContent& content) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  gl.BindBuffer(GL_COPY_READ_BUFFER, name);
  gl.BufferData(GL_COPY_READ_BUFFER, sizeof(content), &content, GL_STATIC_DRAW);
  return name;
}

void point_colours(GLuint buffer) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.VertexAttribPointer(at_colour, 4, GL_FLOAT, GL_FALSE, sizeof(Vec4), at_byte(offsetof(HeldContent, colours)));
}

// Which part the bound array takes from the buffer, and by which command.
struct Holder {
  const char* leaf;
  void (*attach)(GLuint array, GLuint buffer);
  bool holds_tags = false;
  Apis apis = every_api;
  int version = 0;  // of OpenGL
};

constexpr Holder holders[] = {
    {"attribute_pointer", [](GLuint, GLuint buffer) { point_colours(buffer); }},
    {"positions",
     [](GLuint, GLuint buffer) {
       gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
       gl.VertexAttribPointer(at_position, 4, GL_FLOAT, GL_FALSE, sizeof(Vec4), at_byte(offsetof(HeldContent, places)));
     }},
    {"tags",
     [](GLuint, GLuint buffer) {
       gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
       gl.DepthTagPointerARK(GL_FLOAT, sizeof(float), at_byte(offsetof(HeldContent, tags)));
     },
     true},
    {"integers",
     [](GLuint, GLuint buffer) {
       gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
       gl.VertexAttribIPointer(at_extra, 1, GL_UNSIGNED_INT, sizeof(std::uint32_t),
                               at_byte(offsetof(HeldContent, integers)));
       gl.EnableVertexAttribArray(at_extra);
     }},
    {"instances",
     [](GLuint, GLuint buffer) {
       point_colours(buffer);
       gl.VertexAttribDivisor(at_colour, 1);
     }},
    {"bind_vertex_buffer",
     [](GLuint, GLuint buffer) {
       gl.VertexAttribFormat(at_colour, 4, GL_FLOAT, GL_FALSE, 0);
       gl.VertexAttribBinding(at_colour, 9);
       gl.BindVertexBuffer(9, buffer, offsetof(HeldContent, colours), sizeof(Vec4));
     }},
    {"bind_vertex_buffers",
     [](GLuint, GLuint buffer) {
       const GLintptr offset = offsetof(HeldContent, colours);
       const GLsizei stride = sizeof(Vec4);
       gl.VertexAttribFormat(at_colour, 4, GL_FLOAT, GL_FALSE, 0);
       gl.VertexAttribBinding(at_colour, 9);
       gl.BindVertexBuffers(9, 1, &buffer, &offset, &stride);
     },
     false, desktop_apis, 44},
    {"vertex_array_vertex_buffer",
     [](GLuint array, GLuint buffer) {
       gl.VertexArrayAttribFormat(array, at_colour, 4, GL_FLOAT, GL_FALSE, 0);
       gl.VertexArrayAttribBinding(array, at_colour, 9);
       gl.VertexArrayVertexBuffer(array, 9, buffer, offsetof(HeldContent, colours), sizeof(Vec4));
     },
     false, desktop_apis, 45},
    {"elements", [](GLuint, GLuint buffer) { gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer); }},
    {"vertex_array_element_buffer", [](GLuint array, GLuint buffer) { gl.VertexArrayElementBuffer(array, buffer); },
     false, desktop_apis, 45},
    {"color_pointer",
     [](GLuint, GLuint buffer) {
       gl.DisableVertexAttribArray(at_colour);
       gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
       gl.ColorPointer(4, GL_FLOAT, sizeof(Vec4), at_byte(offsetof(HeldContent, colours)));
       gl.EnableClientState(GL_COLOR_ARRAY);
     },
     false, compat_only},
    {"buffer_texture",
     [](GLuint, GLuint buffer) {
       // The texture that the array is drawn with is the one that is bound.
       gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer);
     }},
};

// An array, and the texture that it is drawn with. All parts but one come from a buffer that stays.
struct Held {
  GLuint array = 0;
  GLuint texture = 0;
};

void bind(const Held& held) {
  gl.BindVertexArray(held.array);
  gl.BindTexture(GL_TEXTURE_BUFFER, held.texture);
}

Held make_held(const Holder& holder, GLuint constant, GLuint buffer) {
  Held held;
  gl.GenVertexArrays(1, &held.array);
  gl.GenTextures(1, &held.texture);
  bind(held);
  gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, constant);
  gl.BindBuffer(GL_ARRAY_BUFFER, constant);
  gl.VertexAttribPointer(at_position, 4, GL_FLOAT, GL_FALSE, sizeof(Vec4), at_byte(offsetof(HeldContent, places)));
  gl.DepthTagPointerARK(GL_FLOAT, sizeof(float), at_byte(offsetof(HeldContent, tags)));
  point_colours(constant);
  for (const GLuint attribute : {at_position, at_colour}) gl.EnableVertexAttribArray(attribute);
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, constant);
  holder.attach(held.array, buffer);
  return held;
}

GLuint held_program(Test& t, const Holder& holder) {
  const bool is_conventional = std::string(holder.leaf) == "color_pointer";
  const bool is_integer = std::string(holder.leaf) == "integers";
  const std::string precision = t.is_gles() ? "precision highp samplerBuffer;\n" : "";
  const std::string extra = is_integer ? "layout(location = 6) in uint extra;\n" : "";
  return build_program(
      t, {.vertex = precision + extra +
                    "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
                    "layout(binding = 0) uniform samplerBuffer texels; out vec4 colour;\n"
                    "void main() { colour = " +
                    (is_conventional ? "gl_Color" : "vertex_colour") + (is_integer ? " * float(extra) / 8.0" : "") +
                    " * texelFetch(texels, " +
                    std::to_string(std::string(holder.leaf) == "buffer_texture"
                                       ? offsetof(HeldContent, texel) / sizeof(Vec4)
                                       : offsetof(HeldContent, colours) / sizeof(Vec4)) +
                    "); gl_Position = position; }\n"});
}

void draw_held() {
  gl.DrawElements(GL_TRIANGLES, held_vertices, GL_UNSIGNED_SHORT, at_byte(offsetof(HeldContent, indices)));
}

// Compares several refined draws with the unrefined one, and counts. `salt`: of the content that gives the tags.
Picture expect_held(Test& t, const Held& held, int salt_of_tags, const std::string& what) {
  bind(held);
  std::vector<Picture> refined;
  GLuint triangles = 0;
  for (int again = 0; again < 3; ++again)
    refined.push_back(picture_of([&] { triangles = count_generated(draw_held); }));
  gl.Disable(GL_ARK);
  Picture plain = picture_of(draw_held);
  gl.Enable(GL_ARK);
  t.expect(count_different(plain, Picture(surface_size, surface_size), 8) > 300, what + ": something is drawn");
  for (const Picture& picture : refined) t.expect_same_picture(picture, plain, what, 4, 80);
  t.expect_equal(triangles, GLuint{held_vertices / 3} << (2 * (1 + salt_of_tags)), what + ": triangles");
  return plain;
}

void keep(const Held& held) {
  bind(held);
  repeat_often(draw_held);
}

// When the name is given to another buffer, and which name.
enum class Renaming {
  at_once,        // by GenBuffers, before the old array is drawn
  later,          // by GenBuffers, after the old array was drawn
  never,          // no other buffer has the name
  chosen,         // by BindBuffer, which takes any name in these APIs
  other_context,  // another context of the share group deletes the buffer, while the array is bound here
  deleted_bound,  // while the array is bound, so that it loses the buffer and gets the new one
};

struct RenamingRow {
  const char* leaf;
  Renaming renaming;
  Apis apis = every_api;
};
constexpr RenamingRow renamings[] = {
    {"named_at_once", Renaming::at_once},
    {"named_later", Renaming::later},
    {"not_named", Renaming::never},
    {"name_chosen", Renaming::chosen, {Api::gl_compat, Api::gles}},
    {"other_context", Renaming::other_context},
    {"deleted_bound", Renaming::deleted_bound},
};

Apis common_apis(const Holder& holder, const RenamingRow& row) {
  if (row.apis.contains(Api::gl_core)) return holder.apis;
  return holder.apis.contains(Api::gles) ? row.apis : compat_only;
}

// A buffer with the old name if GL gives it again, with other content.
GLuint new_buffer(GLuint old_name, bool is_chosen) {
  const HeldContent content = content_of(1);
  if (!is_chosen) return buffer_with(content);
  gl.BindBuffer(GL_COPY_READ_BUFFER, old_name);
  gl.BufferData(GL_COPY_READ_BUFFER, sizeof(content), &content, GL_STATIC_DRAW);
  return old_name;
}

void write_again(GLuint buffer) {
  const HeldContent content = content_of(2);
  gl.BindBuffer(GL_COPY_READ_BUFFER, buffer);
  gl.BufferSubData(GL_COPY_READ_BUFFER, 0, sizeof(content), &content);
}

// Both arrays in turns, then again after a write to the new buffer, which concerns the new array only.
void expect_both(Test& t, const Holder& holder, const Held& old, const Held& fresh, GLuint buffer) {
  const auto salt = [&](int of_buffer) { return holder.holds_tags ? of_buffer : 0; };
  for (const int round : {0, 1}) {
    expect_held(t, old, salt(0), fmt::format("the old array, round {}", round));
    expect_held(t, fresh, salt(1), fmt::format("the new array, round {}", round));
    keep(old);
    keep(fresh);
  }
  write_again(buffer);
  const Picture of_old = expect_held(t, old, salt(0), "the old array after the new buffer was written");
  const Picture of_new = expect_held(t, fresh, salt(2), "the new array after its buffer was written");
  if (!holder.holds_tags) t.expect(count_different(of_old, of_new, 8) > 150, "the arrays differ");
}

void delete_elsewhere(Test& t, GLuint buffer) {
  Context& here = t.context();
  {
    const std::unique_ptr<Context> there = t.create_context(&here);
    gl.DeleteBuffers(1, &buffer);
    gl.Finish();
  }
  t.require(here.make_current(), "the first context can be made current");
}

void check_deleted(Test& t, const Holder& holder, Renaming renaming) {
  if (!t.is_gles() && t.version() < holder.version) t.not_supported("these commands are not in this version");
  gl.UseProgram(held_program(t, holder));
  refine_by_tags(4);
  const GLuint constant = buffer_with(content_of(0));
  const GLuint buffer = buffer_with(content_of(0));
  const Held old = make_held(holder, constant, buffer);
  const Held other = make_held(holders[0], constant, constant);  // keeps the buffer of the old array unbound
  expect_held(t, old, 0, "before");
  keep(old);
  const bool stays_bound = renaming == Renaming::other_context || renaming == Renaming::deleted_bound;
  bind(stays_bound ? old : other);
  gl.BindBuffer(GL_COPY_READ_BUFFER, 0);
  if (renaming == Renaming::other_context)
    delete_elsewhere(t, buffer);
  else
    gl.DeleteBuffers(1, &buffer);
  if (renaming == Renaming::later || renaming == Renaming::never || renaming == Renaming::other_context) {
    keep(old);
    expect_held(t, old, 0, "the array that keeps the deleted buffer");
  }
  if (renaming == Renaming::never) return;
  bind(stays_bound ? old : other);
  const GLuint named = new_buffer(buffer, renaming == Renaming::chosen);
  if (named != buffer) t.log("the name does not come again");
  if (renaming == Renaming::deleted_bound) {
    holder.attach(old.array, named);
    expect_held(t, old, holder.holds_tags ? 1 : 0, "the array with the new buffer");
    write_again(named);
    expect_held(t, old, holder.holds_tags ? 2 : 0, "the array after the new buffer was written");
  } else {
    const Held fresh = make_held(holder, constant, named);
    expect_both(t, holder, old, fresh, named);
  }
  t.expect_no_error("the draws");
}

// Names of arrays come again, too, and the new array has another buffer of the same name.
void check_array_named_again(Test& t, const Holder& holder) {
  if (!t.is_gles() && t.version() < holder.version) t.not_supported("these commands are not in this version");
  gl.UseProgram(held_program(t, holder));
  refine_by_tags(4);
  const GLuint constant = buffer_with(content_of(0));
  for (const int salt : {0, 1, 2, 0}) {
    const GLuint buffer = buffer_with(content_of(salt));
    const Held held = make_held(holder, constant, buffer);
    expect_held(t, held, holder.holds_tags ? salt : 0, fmt::format("content {}", salt));
    keep(held);
    gl.BindVertexArray(0);
    gl.BindTexture(GL_TEXTURE_BUFFER, 0);
    gl.BindBuffer(GL_COPY_READ_BUFFER, 0);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.DeleteVertexArrays(1, &held.array);
    gl.DeleteTextures(1, &held.texture);
    gl.DeleteBuffers(1, &buffer);
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases deleted_buffers_cases() {
  Cases cases;
  const char* const wrong = "What was kept of the one buffer is drawn for the other that has, or had, its name.";
  for (const Holder& holder : holders) {
    for (const RenamingRow& row : renamings) {
      // GL detaches no buffer from a texture that is bound, so that nothing is lost there.
      const bool is_texture = std::string(holder.leaf) == "buffer_texture";
      if (is_texture && row.renaming == Renaming::deleted_bound) continue;
      cases.push_back({.name = fmt::format("ark.draw.names.buffer.{}.{}", holder.leaf, row.leaf),
                       .clauses = {"10.R.2-1", "11.R.13-1"},
                       .plan = "Delete a buffer that an array keeps, make another one that may have its name, and draw "
                               "the old array and a new one in turns: all pictures are those of unrefined draws.",
                       .wrong = wrong,
                       .apis = common_apis(holder, row),
                       .is_optional = holder.version != 0,
                       .check = [&holder, &row](Test& t) { check_deleted(t, holder, row.renaming); }});
    }
    cases.push_back({.name = fmt::format("ark.draw.names.array.{}", holder.leaf),
                     .clauses = {"10.R.2-1", "11.R.13-1"},
                     .plan = "Delete an array and its buffer and make others, which may have the same names.",
                     .wrong = wrong,
                     .apis = holder.apis,
                     .is_optional = holder.version != 0,
                     .check = [&holder](Test& t) { check_array_named_again(t, holder); }});
  }
  return cases;
}

}  // namespace glark::conformance
