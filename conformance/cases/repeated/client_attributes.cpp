// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// PushClientAttrib and PopClientAttrib around a change of each client state of the vertex-array group, and commands after
// them that depend on what was restored (GL 4.6 compatibility profile, chapter 21).
#include <fmt/core.h>

#include <cstddef>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/expect_change.h"

namespace glark::conformance {
namespace {

constexpr GLsizei client_vertices = 6;
constexpr GLuint client_generic = 9;

struct ClientVertex {
  Vec4 position;
  Vec4 colour;
  Vec3 secondary;
  Vec3 normal;
  std::array<Vec2, 3> texture;
  float fog;
  Vec4 generic;
};
constexpr GLsizei client_stride = sizeof(ClientVertex);
constexpr std::size_t second_content = client_vertices * sizeof(ClientVertex);

struct ClientScene {
  GLuint array = 0;
  GLuint other_array = 0;
  GLuint buffer = 0;
  GLuint other_buffer = 0;  // the second content comes first
  GLuint elements = 0;
  GLuint other_elements = 0;
};

const void* offset_of(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

void coordinates_at(std::size_t content, std::size_t unit) {
  gl.TexCoordPointer(2, GL_FLOAT, client_stride,
                     offset_of(content + offsetof(ClientVertex, texture) + unit * sizeof(Vec2)));
}

struct ClientArray {
  const char* leaf;
  const char* value;  // in the vertex stage
  void (*point)(std::size_t content);
  void (*disable)();
};

constexpr ClientArray client_arrays[] = {
    {"vertex", "gl_Color.rgb",
     [](std::size_t c) {
       gl.VertexPointer(4, GL_FLOAT, client_stride, offset_of(c + offsetof(ClientVertex, position)));
     },
     nullptr},
    {"colour", "gl_Color.rgb",
     [](std::size_t c) { gl.ColorPointer(4, GL_FLOAT, client_stride, offset_of(c + offsetof(ClientVertex, colour))); },
     [] { gl.DisableClientState(GL_COLOR_ARRAY); }},
    {"secondary", "gl_SecondaryColor.rgb",
     [](std::size_t c) {
       gl.SecondaryColorPointer(3, GL_FLOAT, client_stride, offset_of(c + offsetof(ClientVertex, secondary)));
     },
     [] { gl.DisableClientState(GL_SECONDARY_COLOR_ARRAY); }},
    {"normal", "gl_Normal",
     [](std::size_t c) { gl.NormalPointer(GL_FLOAT, client_stride, offset_of(c + offsetof(ClientVertex, normal))); },
     [] { gl.DisableClientState(GL_NORMAL_ARRAY); }},
    {"fog", "vec3(gl_FogCoord)",
     [](std::size_t c) { gl.FogCoordPointer(GL_FLOAT, client_stride, offset_of(c + offsetof(ClientVertex, fog))); },
     [] { gl.DisableClientState(GL_FOG_COORD_ARRAY); }},
    {"generic", "client_generic.rgb",
     [](std::size_t c) {
       gl.VertexAttribPointer(client_generic, 4, GL_FLOAT, GL_FALSE, client_stride,
                              offset_of(c + offsetof(ClientVertex, generic)));
     },
     [] { gl.DisableVertexAttribArray(client_generic); }},
    {"texture_0", "gl_MultiTexCoord0.xyx",
     [](std::size_t c) {
       gl.ClientActiveTexture(GL_TEXTURE0);
       coordinates_at(c, 0);
     },
     [] {
       gl.ClientActiveTexture(GL_TEXTURE0);
       gl.DisableClientState(GL_TEXTURE_COORD_ARRAY);
     }},
    {"texture_1", "gl_MultiTexCoord1.xyx",
     [](std::size_t c) {
       gl.ClientActiveTexture(GL_TEXTURE1);
       coordinates_at(c, 1);
     },
     [] {
       gl.ClientActiveTexture(GL_TEXTURE1);
       gl.DisableClientState(GL_TEXTURE_COORD_ARRAY);
     }},
    {"texture_2", "gl_MultiTexCoord2.xyx",
     [](std::size_t c) {
       gl.ClientActiveTexture(GL_TEXTURE2);
       coordinates_at(c, 2);
     },
     [] {
       gl.ClientActiveTexture(GL_TEXTURE2);
       gl.DisableClientState(GL_TEXTURE_COORD_ARRAY);
     }},
};

void point_all(std::size_t content) {
  for (const ClientArray& each : client_arrays) each.point(content);
  gl.EnableVertexAttribArray(client_generic);
  for (const GLenum array :
       {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_FOG_COORD_ARRAY})
    gl.EnableClientState(array);
  for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE2, GL_TEXTURE0}) {
    gl.ClientActiveTexture(unit);
    gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
  }
}

// Two triangles. In the second content, the left one is lower, and all colours are others.
std::vector<ClientVertex> client_content_of(int salt) {
  std::vector<ClientVertex> content;
  for (int i = 0; i < client_vertices; ++i) {
    const auto part = [&](int k) { return static_cast<float>((5 * i + 3 * k + 4 * salt) % 9) / 8; };
    const MeshVertex from = one_triangle()[static_cast<std::size_t>(i % 3)];
    ClientVertex vertex{};
    vertex.position = {0.5F * from.position[0] + (i < 3 ? -0.5F : 0.45F),
                       0.7F * from.position[1] - (salt != 0 && i < 3 ? 0.25F : 0.0F), 0, 1};
    vertex.colour = {part(0), part(1), part(2), 1};
    vertex.secondary = {part(2), part(0), part(3)};
    vertex.normal = {part(3), part(2), part(1)};
    vertex.texture = {Vec2{part(4), part(1)}, Vec2{part(5), part(2)}, Vec2{part(6), part(3)}};
    vertex.fog = part(7);
    vertex.generic = {part(5), part(7), part(6), 1};
    content.push_back(vertex);
  }
  return content;
}

GLuint client_buffer_of(GLenum target, const void* data, std::size_t bytes) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  return buffer;
}

// The program reads these values besides the position. One that reads little may be kept for longer.
GLuint client_program(Test& t, const std::string& values) {
  return build_program(t, {.vertex = "layout(location = 9) in vec4 client_generic; out vec4 colour;\n"
                                     "void main() { gl_Position = gl_Vertex; colour = vec4(0.25 * (" +
                                     values + ") + 0.1, 1.0); }\n"});
}

ClientScene make_client_scene(bool has_object) {
  std::vector<ClientVertex> both = client_content_of(0);
  const std::vector<ClientVertex> second = client_content_of(1);
  both.insert(both.end(), second.begin(), second.end());
  std::vector<ClientVertex> other = second;
  other.insert(other.end(), both.begin(), both.begin() + client_vertices);
  const GLushort indices[] = {0, 1, 2, 3, 4, 5};
  const GLushort other_indices[] = {3, 4, 5, 3, 4, 5};
  ClientScene scene;
  gl.GenVertexArrays(1, &scene.other_array);
  if (has_object) gl.GenVertexArrays(1, &scene.array);
  gl.BindVertexArray(scene.array);
  scene.other_buffer = client_buffer_of(GL_ARRAY_BUFFER, other.data(), other.size() * sizeof(ClientVertex));
  scene.buffer = client_buffer_of(GL_ARRAY_BUFFER, both.data(), both.size() * sizeof(ClientVertex));
  scene.other_elements = client_buffer_of(GL_ELEMENT_ARRAY_BUFFER, other_indices, sizeof(other_indices));
  scene.elements = client_buffer_of(GL_ELEMENT_ARRAY_BUFFER, indices, sizeof(indices));
  point_all(0);
  gl.BindVertexArray(scene.other_array);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, scene.elements);
  gl.BindVertexArray(scene.array);
  return scene;
}

// What changes between Push and Pop, and what follows.
struct Stacked {
  std::string what;
  std::string read;  // by the program
  std::function<void()> within;
  std::function<void()> after;  // shows
};

std::vector<Stacked> stacked_changes(const ClientScene& s) {
  std::vector<Stacked> all;
  for (const ClientArray& each : client_arrays) {
    all.push_back({std::string(each.leaf) + " pointer", each.value, [&each] { each.point(second_content); },
                   [&each] { each.point(second_content); }});
    if (each.disable != nullptr)
      all.push_back({std::string(each.leaf) + " disabled", each.value, [&each] { each.disable(); },
                     [&each] { each.point(second_content); }});
  }
  for (const GLuint unit : {0U, 1U, 2U})
    for (const GLuint other : {0U, 1U, 2U}) {
      if (other == unit) continue;
      const std::string coordinate = fmt::format("gl_MultiTexCoord{}.xyx", unit);
      all.push_back({fmt::format("client texture {}, not {}", unit, other), coordinate,
                     [=] { gl.ClientActiveTexture(GL_TEXTURE0 + other); },
                     [=] { coordinates_at(second_content, unit); }});
      all.push_back({fmt::format("client texture {} disabled, not {}", unit, other), coordinate,
                     [=] { gl.ClientActiveTexture(GL_TEXTURE0 + other); },
                     [] { gl.DisableClientState(GL_TEXTURE_COORD_ARRAY); }});
    }
  all.push_back({"array buffer", "gl_Color.rgb", [=] { gl.BindBuffer(GL_ARRAY_BUFFER, s.other_buffer); },
                 [] { client_arrays[1].point(second_content); }});
  all.push_back({"array buffer of a pointer", "gl_Color.rgb",
                 [=] {
                   gl.BindBuffer(GL_ARRAY_BUFFER, s.other_buffer);
                   client_arrays[1].point(0);
                 },
                 [] { client_arrays[1].point(second_content); }});
  all.push_back({"element buffer", "gl_Color.rgb", [=] { gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, s.other_elements); },
                 [] {
                   const GLushort index[] = {4, 3};
                   gl.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, sizeof(index), index);
                 }});
  all.push_back({"vertex array", "gl_Color.rgb", [=] { gl.BindVertexArray(s.other_array); },
                 [] { client_arrays[1].point(second_content); }});
  return all;
}

enum class StackMask { all, group, nested };

// The unit of a change's second half is that of the client texture before PushClientAttrib.
GLuint unit_of(const Stacked& change) {
  const std::string start = "client texture ";
  return change.what.starts_with(start) ? static_cast<GLuint>(change.what[start.size()] - '0') : 0;
}

constexpr char everything[] =
    "0.5 * (gl_Color.rgb + gl_SecondaryColor.rgb + gl_Normal + client_generic.rgb + vec3(gl_MultiTexCoord0.xy, "
    "gl_FogCoord) +"
    " gl_MultiTexCoord1.xyx + gl_MultiTexCoord2.yxy)";

void check_stack(Test& t, StackMask mask, bool draws_within, bool has_object, bool reads_all) {
  for (std::size_t number = 0;; ++number) {
    const ClientScene scene = make_client_scene(has_object);
    const std::vector<Stacked> changes = stacked_changes(scene);
    if (number == changes.size()) break;
    const Stacked& change = changes[number];
    // Every other change is that of a draw that reads everything.
    gl.UseProgram(client_program(t, reads_all ? everything : change.read));
    gl.ClientActiveTexture(GL_TEXTURE0 + unit_of(change));
    number % 2 == 0 ? refine_uniformly(2) : refine_by_tags(3);
    gl.DepthTag1i(2);
    const Draw draw = [] { gl.DrawElements(GL_TRIANGLES, client_vertices, GL_UNSIGNED_SHORT, nullptr); };
    const Picture before = expect_as_unrefined(t, draw, "before " + change.what);
    gl.PushClientAttrib(mask == StackMask::group ? GL_CLIENT_VERTEX_ARRAY_BIT : GL_CLIENT_ALL_ATTRIB_BITS);
    if (mask == StackMask::nested) gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    change.within();
    if (mask == StackMask::nested) gl.PopClientAttrib();
    if (draws_within) repeat_often(draw);
    gl.PopClientAttrib();
    const Picture popped = expect_as_unrefined(t, draw, "popped " + change.what);
    t.expect_same_picture(popped, before, change.what + " is restored", 2, 10);
    change.after();
    const Picture after = expect_as_unrefined(t, draw, "after " + change.what);
    t.expect(count_different(popped, after, 4) > 150, change.what + " shows");
    t.expect_no_error(change.what);
    gl.BindVertexArray(0);
    if (has_object) gl.DeleteVertexArrays(1, &scene.array);
    gl.DeleteVertexArrays(1, &scene.other_array);
  }
}

}  // namespace

Cases client_attributes_cases() {
  Cases cases;
  for (const auto& [leaf, mask] : {std::pair<const char*, StackMask>{"all", StackMask::all},
                                   {"group", StackMask::group},
                                   {"nested", StackMask::nested}})
    for (const bool draws_within : {false, true})
      cases.push_back({.name = std::string("ark.draw.again.client_stack.") + leaf + (draws_within ? ".drawn" : ""),
                       .clauses = {"10.R.2-1", "11.R.13-1"},
                       .plan = "Repeat a draw of conventional arrays. Change each client state between "
                               "PushClientAttrib and PopClientAttrib; then use what was restored.",
                       .wrong = "The state from before PopClientAttrib: another texture unit, buffer or array.",
                       .apis = compat_only,
                       .check = [mask = mask, draws_within](Test& t) {
                         check_stack(t, mask, draws_within, mask == StackMask::group, false);
                         if (mask == StackMask::all) check_stack(t, mask, draws_within, true, true);
                       }});
  return cases;
}

}  // namespace glark::conformance
