// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Several attributes share one vertex buffer binding (GL 4.6, 10.3.2). A change of the binding concerns all of them, and
// VertexAttribPointer and its relatives change the binding that has the attribute's number.
#include <fmt/core.h>

#include <map>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/expect_change.h"
#include "conformance/support/counted.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

constexpr std::size_t shared_contents = 3;  // in a buffer
constexpr GLsizei shared_bytes = 16;
constexpr GLsizei shared_vertices = 6;
constexpr GLuint sharing_attributes[] = {2, 4, 7};  // all of them have the format of a colour
constexpr GLuint shared_tag = 9;                    // its tag is the fourth component

struct Shared {
  GLuint array = 0;
  GLuint binding = 0;
  GLuint first = 0;
  GLuint second = 0;          // the colours and tags of another buffer
  bool is_elsewhere = false;  // another vertex array is bound
};

struct SharedChange {
  const char* leaf;
  void (*make)(const Shared& s);
  Apis apis = every_api;
  int version = 0;                 // of desktop GL
  bool has_own_attribute = false;  // the command takes the attribute with the number of the binding
};

const void* offset_at(GLintptr offset) { return reinterpret_cast<const void*>(offset); }

void point_at_second(const Shared& s) { gl.BindBuffer(GL_ARRAY_BUFFER, s.second); }

void bind_several(const Shared& s, bool is_named) {
  const GLuint buffers[] = {s.second, s.second};
  const GLintptr offsets[] = {0, shared_bytes};
  const GLsizei strides[] = {shared_bytes, shared_bytes};
  if (is_named)
    gl.VertexArrayVertexBuffers(s.array, s.binding, 2, buffers, offsets, strides);
  else
    gl.BindVertexBuffers(s.binding, 2, buffers, offsets, strides);
}

constexpr SharedChange shared_changes[] = {
    {"bind_vertex_buffer", [](const Shared& s) { gl.BindVertexBuffer(s.binding, s.second, 0, shared_bytes); }},
    {"offset",
     [](const Shared& s) { gl.BindVertexBuffer(s.binding, s.first, shared_vertices * shared_bytes, shared_bytes); }},
    {"stride", [](const Shared& s) { gl.BindVertexBuffer(s.binding, s.first, 0, 2 * shared_bytes); }},
    {"stride_zero", [](const Shared& s) { gl.BindVertexBuffer(s.binding, s.second, 0, 0); }},
    {"bind_vertex_buffers", [](const Shared& s) { bind_several(s, false); }, desktop_apis, 44},
    {"vertex_array_vertex_buffer",
     [](const Shared& s) { gl.VertexArrayVertexBuffer(s.array, s.binding, s.second, 0, shared_bytes); }, desktop_apis,
     45},
    {"vertex_array_vertex_buffers", [](const Shared& s) { bind_several(s, true); }, desktop_apis, 45},
    {"vertex_binding_divisor", [](const Shared& s) { gl.VertexBindingDivisor(s.binding, 1); }},
    {"vertex_array_binding_divisor", [](const Shared& s) { gl.VertexArrayBindingDivisor(s.array, s.binding, 1); },
     desktop_apis, 45},
    {.leaf = "vertex_attrib_divisor",
     .make = [](const Shared& s) { gl.VertexAttribDivisor(s.binding, 1); },
     .has_own_attribute = true},
    {.leaf = "vertex_attrib_pointer",
     .make =
         [](const Shared& s) {
           point_at_second(s);
           gl.VertexAttribPointer(s.binding, 4, GL_FLOAT, GL_FALSE, shared_bytes, nullptr);
         },
     .has_own_attribute = true},
    {.leaf = "vertex_attrib_pointer_offset",
     .make =
         [](const Shared& s) {
           gl.BindBuffer(GL_ARRAY_BUFFER, s.first);
           gl.VertexAttribPointer(s.binding, 2, GL_FLOAT, GL_FALSE, shared_bytes,
                                  offset_at(shared_vertices * shared_bytes));
         },
     .has_own_attribute = true},
    {.leaf = "vertex_attrib_i_pointer",
     .make =
         [](const Shared& s) {
           point_at_second(s);
           gl.VertexAttribIPointer(s.binding, 4, GL_INT, shared_bytes, nullptr);
         },
     .has_own_attribute = true},
    {.leaf = "vertex_attrib_l_pointer",
     .make =
         [](const Shared& s) {
           point_at_second(s);
           gl.VertexAttribLPointer(s.binding, 2, GL_DOUBLE, shared_bytes, nullptr);
         },
     .apis = desktop_apis,
     .has_own_attribute = true},
    {.leaf = "tag_pointer",
     .make =
         [](const Shared& s) {
           const GLint before = integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK);
           gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, static_cast<GLint>(s.binding));
           point_at_second(s);
           gl.DepthTagPointerARK(GL_FLOAT, shared_bytes, nullptr);
           gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, before);
         },
     .has_own_attribute = true},
};

GLuint make_shared_colours(unsigned salt) {
  std::vector<Vec4> values;
  for (unsigned i = 0; i < shared_contents * shared_vertices; ++i) {
    const auto part = [&](unsigned k) { return 0.25F + 0.75F * static_cast<float>((7 * i + k * salt) % 11) / 10; };
    values.push_back({part(1), part(3), part(5), static_cast<float>((i / shared_vertices + salt) % 3)});
  }
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(Vec4)), values.data(), GL_STATIC_DRAW);
  return buffer;
}

Mesh two_large_triangles() {
  Mesh mesh;
  for (int i = 0; i < 2; ++i)
    for (MeshVertex vertex : one_triangle()) {
      vertex.position[0] = 0.5F * vertex.position[0] + (i == 0 ? -0.5F : 0.5F);
      mesh.push_back(vertex);
    }
  return mesh;
}

// One program for each attribute: it reads no other one of those that share the binding.
GLuint program_that_reads(Test& t, GLuint attribute) {
  return build_program(t, {.vertex = fmt::format("layout(location = 0) in vec4 position;\n"
                                                 "layout(location = {}) in vec4 shared_colour; out vec4 colour;\n"
                                                 "void main() {{ colour = vec4(shared_colour.rgb, 1.0);\n"
                                                 "  gl_Position = position; }}\n",
                                                 attribute)});
}

void share_binding(const Shared& s) {
  for (const GLuint attribute : {sharing_attributes[0], sharing_attributes[1], sharing_attributes[2], shared_tag}) {
    gl.EnableVertexAttribArray(attribute);
    const bool is_tag = attribute == shared_tag;
    gl.VertexAttribFormat(attribute, is_tag ? 1 : 4, GL_FLOAT, GL_FALSE, is_tag ? 12 : 0);
    gl.VertexAttribBinding(attribute, s.binding);
  }
  gl.BindVertexBuffer(s.binding, s.first, 0, shared_bytes);
  gl.VertexBindingDivisor(s.binding, 0);
}

// With its own attribute, the binding has the number of one that the program does not read.
std::vector<GLuint> bindings_for(GLuint reader, bool has_own_attribute) {
  std::vector<GLuint> all;
  for (const GLuint binding : sharing_attributes)
    if (!has_own_attribute || binding != reader) all.push_back(binding);
  if (!has_own_attribute) all.push_back(12);
  if (has_own_attribute) all.push_back(5);  // an attribute that nobody reads and that used another binding
  return all;
}

void require_shared_version(Test& t, const SharedChange& change) {
  if (!t.is_gles() && t.version() < change.version) t.not_supported("the command is of a later version");
}

void check_shared(Test& t, const SharedChange& change) {
  require_shared_version(t, change);
  const Draw draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, shared_vertices); };
  std::map<GLuint, GLuint> programs;
  for (const GLuint reader : sharing_attributes) programs[reader] = program_that_reads(t, reader);
  for (const GLuint reader : sharing_attributes) {
    for (const GLuint binding : bindings_for(reader, change.has_own_attribute)) {
      const bool is_uniform = (reader + binding) % 4 != 0;
      Shared s{.array = upload(two_large_triangles(), false).array, .binding = binding};
      s.first = make_shared_colours(3);
      s.second = make_shared_colours(8);
      share_binding(s);
      gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, shared_tag);
      is_uniform ? refine_uniformly(2) : refine_by_tags(3);
      // An implementation has seen draws that read each of the attributes.
      for (const auto& each : programs) {
        gl.UseProgram(each.second);
        draw();
      }
      gl.UseProgram(programs[reader]);
      expect_change(
          t, draw, [&] { change.make(s); }, fmt::format("binding {} of attribute {}", binding, reader));
    }
  }
}

// The array of tags shares the binding with arrays of colours. All tags of a buffer's content are the same.
void check_shared_tags(Test& t) {
  gl.UseProgram(program_that_reads(t, sharing_attributes[1]));
  gl.ARKParameteriARK(GL_DEPTH_TAG_ATTRIBUTE_ARK, shared_tag);
  const Draw draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, shared_vertices); };
  const auto expect_tag = [&](GLuint tag, const std::string& what) {
    for (int again = 0; again < 3; ++again) t.expect_equal(count_generated(draw), GLuint{2} << (2 * tag), what);
    repeat_often(draw);
    t.expect_equal(count_generated(draw), GLuint{2} << (2 * tag), what + ", again");
  };
  for (const GLuint binding : sharing_attributes) {
    Shared s{.array = upload(two_large_triangles(), false).array, .binding = binding};
    s.first = make_shared_colours(3);   // tags 0, 1, 2
    s.second = make_shared_colours(8);  // tags 2, 0, 1
    share_binding(s);
    refine_by_tags(3);
    expect_tag(0, "the first tags");
    gl.BindVertexBuffer(binding, s.second, 0, shared_bytes);
    expect_tag(2, "another buffer");
    gl.BindVertexBuffer(binding, s.first, shared_vertices * shared_bytes, shared_bytes);
    expect_tag(1, "another offset");
    gl.BindBuffer(GL_ARRAY_BUFFER, s.second);
    gl.VertexAttribPointer(binding, 4, GL_FLOAT, GL_FALSE, shared_bytes, nullptr);
    expect_tag(2, "VertexAttribPointer of the attribute with the binding's number");
    gl.BindVertexBuffer(binding, s.second, shared_vertices * shared_bytes, shared_bytes);
    expect_tag(0, "another offset again");
    t.expect_no_error("the changes");
  }
}

}  // namespace

Cases shared_bindings_cases() {
  Cases cases;
  for (const SharedChange& change : shared_changes)
    cases.push_back({.name = std::string("ark.draw.again.shared_binding.") + change.leaf,
                     .clauses = {"10.R.2-1", "11.R.13-1"},
                     .plan = "Repeat a draw that reads one of four attributes with the same vertex buffer binding. "
                             "Change the binding, and repeat it.",
                     .wrong = "Only the first attribute of the binding changes, or the one that the command names.",
                     .apis = change.apis,
                     .is_optional = change.version != 0,
                     .check = [&change](Test& t) { check_shared(t, change); }});
  cases.push_back({.name = "ark.draw.again.shared_binding.tags",
                   .clauses = {"10.R.1-2", "11.R.13-1"},
                   .plan = "The tag array shares its vertex buffer binding with other arrays. Change the binding.",
                   .wrong = "The tags of the earlier buffer.",
                   .check = check_shared_tags});
  return cases;
}

}  // namespace glark::conformance
