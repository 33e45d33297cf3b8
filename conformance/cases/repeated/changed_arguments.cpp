// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that are repeated, and then drawn with one other argument of the drawing command.
#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/expect_change.h"

namespace glark::conformance {
namespace {

constexpr GLsizei triangles = 6;

// Where the instances are, relative to the vertices.
constexpr GLuint at_shift = 7;
constexpr Vec2 shifts[] = {{0, 0}, {0.1F, -0.25F}, {-0.15F, 0.1F}, {0.2F, 0.2F}, {-0.1F, -0.1F}, {0.05F, 0.3F}};

struct Arguments {
  GLenum mode = GL_TRIANGLES;
  GLint first = 6;  // a vertex or an index
  GLsizei count = 6;
  GLint base_vertex = 0;
  GLsizei instances = 1;
  GLuint base_instance = 0;

  // Where the second of several draws begins. It repeats the end of the first draw.
  GLsizei second() const { return count - 3; }
  const void* indices(GLsizei behind = 0) const {
    return reinterpret_cast<const void*>(std::uintptr_t{2} * static_cast<std::uintptr_t>(first + behind));
  }
};

struct DrawnCommand {
  const char* leaf;
  void (*draw)(const Arguments& a);
  bool has_base_vertex = false;
  bool has_instances = false;
  bool has_base_instance = false;
  Apis apis = every_api;
};

constexpr GLuint last = 3 * triangles - 1;
constexpr GLenum type = GL_UNSIGNED_SHORT;

void multi_draw_elements(const Arguments& a) {
  const void* const indices[] = {a.indices(), a.indices(a.second())};
  const GLsizei counts[] = {a.count, 3};
  gl.MultiDrawElements(a.mode, counts, type, indices, 2);
}

void multi_draw_elements_base_vertex(const Arguments& a) {
  const void* const indices[] = {a.indices(), a.indices(a.second())};
  const GLsizei counts[] = {a.count, 3};
  const GLint bases[] = {a.base_vertex, a.base_vertex};
  gl.MultiDrawElementsBaseVertex(a.mode, counts, type, indices, 2, bases);
}

void multi_draw_arrays(const Arguments& a) {
  const GLint firsts[] = {a.first, a.first + a.second()};
  const GLsizei counts[] = {a.count, 3};
  gl.MultiDrawArrays(a.mode, firsts, counts, 2);
}

constexpr DrawnCommand drawn_commands[] = {
    {"draw_arrays", [](const Arguments& a) { gl.DrawArrays(a.mode, a.first, a.count); }},
    {.leaf = "draw_arrays_instanced",
     .draw = [](const Arguments& a) { gl.DrawArraysInstanced(a.mode, a.first, a.count, a.instances); },
     .has_instances = true},
    {.leaf = "draw_arrays_instanced_base_instance",
     .draw =
         [](const Arguments& a) {
           gl.DrawArraysInstancedBaseInstance(a.mode, a.first, a.count, a.instances, a.base_instance);
         },
     .has_instances = true,
     .has_base_instance = true,
     .apis = desktop_apis},
    {.leaf = "multi_draw_arrays", .draw = multi_draw_arrays, .apis = desktop_apis},
    {"draw_elements", [](const Arguments& a) { gl.DrawElements(a.mode, a.count, type, a.indices()); }},
    {"draw_range_elements",
     [](const Arguments& a) { gl.DrawRangeElements(a.mode, 0, last, a.count, type, a.indices()); }},
    {.leaf = "draw_elements_instanced",
     .draw = [](const Arguments& a) { gl.DrawElementsInstanced(a.mode, a.count, type, a.indices(), a.instances); },
     .has_instances = true},
    {.leaf = "draw_elements_instanced_base_instance",
     .draw =
         [](const Arguments& a) {
           gl.DrawElementsInstancedBaseInstance(a.mode, a.count, type, a.indices(), a.instances, a.base_instance);
         },
     .has_instances = true,
     .has_base_instance = true,
     .apis = desktop_apis},
    {.leaf = "draw_elements_base_vertex",
     .draw = [](const Arguments& a) { gl.DrawElementsBaseVertex(a.mode, a.count, type, a.indices(), a.base_vertex); },
     .has_base_vertex = true},
    {.leaf = "draw_range_elements_base_vertex",
     .draw =
         [](const Arguments& a) {
           gl.DrawRangeElementsBaseVertex(a.mode, 0, last, a.count, type, a.indices(), a.base_vertex);
         },
     .has_base_vertex = true},
    {.leaf = "draw_elements_instanced_base_vertex",
     .draw =
         [](const Arguments& a) {
           gl.DrawElementsInstancedBaseVertex(a.mode, a.count, type, a.indices(), a.instances, a.base_vertex);
         },
     .has_base_vertex = true,
     .has_instances = true},
    {.leaf = "draw_elements_instanced_base_vertex_base_instance",
     .draw =
         [](const Arguments& a) {
           gl.DrawElementsInstancedBaseVertexBaseInstance(a.mode, a.count, type, a.indices(), a.instances,
                                                          a.base_vertex, a.base_instance);
         },
     .has_base_vertex = true,
     .has_instances = true,
     .has_base_instance = true,
     .apis = desktop_apis},
    {.leaf = "multi_draw_elements", .draw = multi_draw_elements, .apis = desktop_apis},
    {.leaf = "multi_draw_elements_base_vertex",
     .draw = multi_draw_elements_base_vertex,
     .has_base_vertex = true,
     .apis = desktop_apis},
};

// Six triangles in two rows. The indices name the triangles in another order: 2, 3, 0, 1, 4, 5.
void make_six_triangles(Test& t) {
  gl.UseProgram(build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
                    "layout(location = 7) in vec2 shift; out vec4 colour;\n"
                    "void main() { colour = vertex_colour; gl_Position = position + vec4(shift, 0.0, 0.0); }\n"}));
  Mesh mesh;
  for (int i = 0; i < triangles; ++i)
    for (MeshVertex vertex : one_triangle({1, 3, 2})) {
      const auto n = static_cast<float>(i);
      vertex.position = {0.35F * vertex.position[0] - 0.6F + 0.6F * static_cast<float>(i % 3),
                         0.5F * vertex.position[1] + (i < 3 ? -0.4F : 0.4F), 0, 1};
      vertex.colour[static_cast<std::size_t>(i % 3)] += 0.2F + 0.1F * n;
      mesh.push_back(vertex);
    }
  upload(mesh);
  const GLushort indices[] = {6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 4, 5, 12, 13, 14, 15, 16, 17};
  GLuint names[2] = {0, 0};
  gl.GenBuffers(2, names);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[0]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof(indices), indices, GL_STATIC_DRAW);
  gl.BindBuffer(GL_ARRAY_BUFFER, names[1]);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(shifts), shifts, GL_STATIC_DRAW);
  gl.VertexAttribPointer(at_shift, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.VertexAttribDivisor(at_shift, 1);
  gl.EnableVertexAttribArray(at_shift);
}

struct Next {
  const char* what;
  Arguments arguments;  // other ones than those before it in one argument only
};

std::vector<Next> next_arguments(const DrawnCommand& command) {
  Arguments a;
  std::vector<Next> all;
  const auto add = [&](const char* what) { all.push_back({what, a}); };
  for (const GLenum mode : {GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_TRIANGLES}) {
    a.mode = mode;
    add("another mode");
  }
  for (const GLint first : {0, 6}) {
    a.first = first;
    add("another first vertex or index");
  }
  for (const GLsizei count : {3, 12, 6}) {
    a.count = count;
    add("another count");
  }
  for (const GLint base : {3, 6, 0, -6, -9, 0}) {
    if (!command.has_base_vertex) break;
    if (base == -6) {  // the first indices that are not below 9
      a.first = 12;
      add("another first index");
    }
    a.base_vertex = base;
    add("another base vertex");
  }
  for (const GLsizei instances : {2, 3, 1}) {
    if (!command.has_instances) break;
    a.instances = instances;
    add("another number of instances");
  }
  for (const GLuint base : {1U, 3U, 0U}) {
    if (!command.has_base_instance) break;
    a.base_instance = base;
    add("another base instance");
  }
  return all;
}

void check_arguments(Test& t, const DrawnCommand& command, bool is_uniform) {
  make_six_triangles(t);
  is_uniform ? refine_uniformly(2) : refine_by_tags(3);
  Arguments current;
  for (const Next& next : next_arguments(command))
    expect_change(
        t, [&] { command.draw(current); }, [&] { current = next.arguments; }, next.what, 150);
}

void control_arguments(Test& t, const DrawnCommand& command) {
  make_six_triangles(t);
  Picture before = picture_of([&] { command.draw({}); });
  for (const Next& next : next_arguments(command)) {
    Picture after = picture_of([&] { command.draw(next.arguments); });
    t.expect(count_different(before, after, 8) > 150, std::string(next.what) + " shows");
    before = std::move(after);
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases changed_arguments_cases() {
  Cases cases;
  for (const DrawnCommand& command : drawn_commands)
    for (const bool is_uniform : {true, false})
      cases.push_back(
          {.name = std::string("ark.draw.again.argument.") + command.leaf + (is_uniform ? ".uniform" : ".tags"),
           .clauses = {"10.R.2-1", "10.R.2-2"},
           .plan = "Repeat a draw often, change one argument of the command, and repeat it: each argument "
                   "in turn.",
           .wrong = "The triangles of the earlier argument.",
           .apis = command.apis,
           .control = [&command](Test& t) { control_arguments(t, command); },
           .check = [&command, is_uniform](Test& t) { check_arguments(t, command, is_uniform); }});
  return cases;
}

}  // namespace glark::conformance
