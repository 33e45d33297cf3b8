// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws that are repeated after a change of the data that they read. An implementation may cache results of a draw
// (11.R.13), but must drop them after such a change. The expected picture is the unrefined one after the change.
#include <cstring>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

constexpr GLsizei vertices = 6;
constexpr int repeats = 4;
using Colours = std::array<GLuint, vertices>;  // RGBA8, red in the lowest byte
constexpr Colours before = {0xff0000ff, 0xff00ff00, 0xffff0000, 0xff00ffff, 0xffffff00, 0xffff00ff};
constexpr Colours after = {0xff404040, 0xff0000ff, 0xffffffff, 0xffff8000, 0xff0080ff, 0xff00ff40};

// Two triangles side by side. Their colours come from a separate buffer.
struct Scene {
  GLuint array = 0;
  GLuint colours = 0;
};

Mesh two_triangles() {
  Mesh mesh = one_triangle({1, 3, 2});
  for (MeshVertex vertex : one_triangle({2, 2, 0})) {
    vertex.position = {0.5F * vertex.position[0] + 0.5F, -vertex.position[1], 0, 1};
    mesh.push_back(vertex);
  }
  for (int i = 0; i < 3; ++i) mesh[static_cast<std::size_t>(i)].position[0] -= 0.25F;
  number_triangles(mesh);
  return mesh;
}

GLuint make_buffer(const Colours& colours, GLenum target = GL_ARRAY_BUFFER) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, 2 * sizeof(Colours), nullptr, GL_DYNAMIC_COPY);
  gl.BufferSubData(target, 0, sizeof(Colours), colours.data());
  gl.BufferSubData(target, sizeof(Colours), sizeof(Colours), after.data());
  return buffer;
}

void point_at(std::size_t offset, GLsizei stride = 4) {
  gl.VertexAttribPointer(at_colour, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, reinterpret_cast<const void*>(offset));
}

Scene make_scene() {
  Scene scene;
  scene.array = upload(two_triangles()).array;
  scene.colours = make_buffer(before);
  point_at(0);
  return scene;
}

// Colours in the buffer, which is bound to GL_ARRAY_BUFFER.
void copy(Test&, Scene& scene) {
  make_buffer(after, GL_COPY_READ_BUFFER);
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, scene.colours);
  gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, sizeof(Colours));
}

void map(Test& t, GLbitfield flags) {
  void* const mapped = gl.MapBufferRange(GL_ARRAY_BUFFER, 0, sizeof(Colours), GL_MAP_WRITE_BIT | flags);
  t.require(mapped != nullptr, "the buffer can be mapped");
  std::memcpy(mapped, after.data(), sizeof(Colours));
  if ((flags & GL_MAP_FLUSH_EXPLICIT_BIT) != 0) gl.FlushMappedBufferRange(GL_ARRAY_BUFFER, 0, sizeof(Colours));
  gl.UnmapBuffer(GL_ARRAY_BUFFER);
}

void specify_again(Test&, Scene&) { gl.BufferData(GL_ARRAY_BUFFER, sizeof(Colours), after.data(), GL_STATIC_DRAW); }

GLuint compute_program(Test& t, const std::string& source) {
  const std::string text = glsl_head(t) + source;
  const char* const texts = text.c_str();
  const GLuint shader = gl.CreateShader(GL_COMPUTE_SHADER);
  gl.ShaderSource(shader, 1, &texts, nullptr);
  gl.CompileShader(shader);
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program, shader);
  gl.LinkProgram(program);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) t.internal_error("the compute shader does not build");
  return program;
}

// Copies the second half of the buffer to the first.
void store(Test& t, Scene& scene) {
  GLint program = 0;
  gl.GetIntegerv(GL_CURRENT_PROGRAM, &program);
  gl.UseProgram(compute_program(t,
                                "layout(local_size_x = 6) in; layout(std430, binding = 1) buffer Colours { uint c[]; };"
                                "void main() { c[gl_LocalInvocationID.x] = c[gl_LocalInvocationID.x + 6u]; }"));
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, scene.colours);
  gl.DispatchCompute(1, 1, 1);
  gl.MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
  gl.UseProgram(static_cast<GLuint>(program));
}

// Writes the buffer by transform feedback of an unrefined draw of points.
void feed_back(Test& t, Scene& scene) {
  GLint program = 0;
  gl.GetIntegerv(GL_CURRENT_PROGRAM, &program);
  gl.UseProgram(
      build_program(t, {.vertex = "flat out uint bits; void main() { bits = 0xff203000u + 40u * uint(gl_VertexID);"
                                  " gl_Position = vec4(0.0); gl_PointSize = 1.0; }",
                        .fragment = "flat in uint bits; out vec4 pixel; void main() { pixel = vec4(float(bits)); }",
                        .captured = {"bits"}}));
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, scene.colours);
  gl.Enable(GL_RASTERIZER_DISCARD);
  gl.BeginTransformFeedback(GL_POINTS);
  gl.DrawArrays(GL_POINTS, 0, vertices);
  gl.EndTransformFeedback();
  gl.Disable(GL_RASTERIZER_DISCARD);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  gl.UseProgram(static_cast<GLuint>(program));
}

void read_pixels(Test&, Scene& scene) {
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, scene.colours);
  gl.ReadPixels(45, 60, vertices, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

void delete_buffer(Test&, Scene& scene) {
  gl.DeleteBuffers(1, &scene.colours);
  scene.colours = make_buffer(after);
  point_at(0);
}

// Most implementations give the new buffer the same name.
void delete_array(Test&, Scene& scene) {
  gl.DeleteVertexArrays(1, &scene.array);
  scene.array = upload(two_triangles()).array;
  gl.BindBuffer(GL_ARRAY_BUFFER, scene.colours);
  point_at(sizeof(Colours));
}

void other_array(Test&, Scene& scene) {
  upload(two_triangles());
  gl.BindBuffer(GL_ARRAY_BUFFER, scene.colours);
  point_at(4, 8);
}

void disable_array(Test&, Scene&) {
  gl.DisableVertexAttribArray(at_colour);
  gl.VertexAttrib4f(at_colour, 0.5F, 0.25F, 1, 1);
}

void set_format(Test&, Scene& scene) {
  gl.BindVertexBuffer(at_colour, scene.colours, 0, 4);
  gl.VertexAttribFormat(at_colour, 2, GL_UNSIGNED_BYTE, GL_TRUE, 1);
}

struct Change {
  const char* leaf;
  void (*change)(Test&, Scene&);
};

constexpr Change changes[] = {
    {"copied", copy},
    {"mapped", [](Test& t, Scene&) { map(t, 0); }},
    {"flushed", [](Test& t, Scene&) { map(t, GL_MAP_FLUSH_EXPLICIT_BIT); }},
    {"invalidated", [](Test& t, Scene&) { map(t, GL_MAP_INVALIDATE_BUFFER_BIT); }},
    {"specified_again", specify_again},
    {"stored", store},
    {"fed_back", feed_back},
    {"read_pixels", read_pixels},
    {"buffer_deleted", delete_buffer},
    {"array_deleted", delete_array},
    {"other_array", other_array},
    {"pointer", [](Test&, Scene&) { point_at(sizeof(Colours)); }},
    {"stride", [](Test&, Scene&) { point_at(0, 8); }},
    {"disabled", disable_array},
    {"divisor", [](Test&, Scene&) { gl.VertexAttribDivisor(at_colour, 1); }},
    {"binding", [](Test&, Scene& scene) { gl.BindVertexBuffer(at_colour, scene.colours, sizeof(Colours), 4); }},
    {"format", set_format},
};

void draw_all() { gl.DrawArrays(GL_TRIANGLES, 0, vertices); }

// Before and after the change, repeated refined draws look like the unrefined one.
void expect_same_again(Test& t, const std::string& when) {
  std::vector<Picture> refined;
  refined.push_back(picture_of(draw_all));
  repeat_often(draw_all);
  for (int again = 1; again < repeats; ++again) refined.push_back(picture_of(draw_all));
  gl.Disable(GL_ARK);
  const Picture plain = picture_of(draw_all);
  gl.Enable(GL_ARK);
  t.expect(count_different(plain, Picture(surface_size, surface_size), 8) > 2000, "something is drawn " + when);
  for (const Picture& picture : refined) t.expect_same_picture(picture, plain, "the draw " + when, 4, 80);
}

void check_change(Test& t, const Change& change, bool is_uniform) {
  gl.UseProgram(colour_program(t));
  Scene scene = make_scene();
  is_uniform ? refine_uniformly(2) : refine_by_tags(3);
  expect_same_again(t, "before the change");
  const Picture old = picture_of(draw_all);
  change.change(t, scene);
  expect_same_again(t, "after the change");
  t.expect(count_different(picture_of(draw_all), old, 8) > 500, "the change shows");
  t.expect_no_error("the draws");
}

void control_change(Test& t, const Change& change) {
  gl.UseProgram(colour_program(t));
  Scene scene = make_scene();
  const Picture old = picture_of(draw_all);
  change.change(t, scene);
  t.expect(count_different(picture_of(draw_all), old, 8) > 500, "the change shows");
  t.expect_no_error("the draws");
}

std::int64_t count_of(const std::array<float, 3>& tags, int pool_level) {
  std::array<int, 3> whole{};
  for (std::size_t i = 0; i < 3; ++i) whole[i] = reference::depth_tag(tags[i], pool_level);
  return reference::minimum_triangles(reference::edge_depths(whole));
}

void expect_count(Test& t, std::int64_t expected, const std::string& when) {
  for (int again = 0; again < repeats; ++again) {
    draw_all();
    t.expect_equal(std::int64_t{count_generated(draw_all)}, expected, "triangles " + when);
  }
}

void check_tag_array(Test& t) {
  gl.UseProgram(colour_program(t));
  make_scene();
  const std::array<std::array<float, 3>, 4> tags = {{{1, 3, 2}, {2, 2, 0}, {0, 4, 4}, {3, 1, 4}}};
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof(tags), tags.data(), GL_STATIC_DRAW);
  gl.DepthTagPointerARK(GL_FLOAT, 0, nullptr);
  refine_by_tags(4);
  gl.DepthTag1i(3);
  const std::int64_t first = count_of(tags[0], 4) + count_of(tags[1], 4);
  expect_count(t, first, "with the first tags");
  gl.DepthTagPointerARK(GL_FLOAT, 0, reinterpret_cast<const void*>(sizeof(tags) / 2));
  expect_count(t, count_of(tags[2], 4) + count_of(tags[3], 4), "with another pointer");
  gl.DepthTagPointerARK(GL_FLOAT, 0, nullptr);
  expect_count(t, first, "with the first tags again");
  gl.Disable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_count(t, 2 * 64, "without the array");
  gl.DepthTag1i(1);
  expect_count(t, 2 * 4, "with another current tag");
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  expect_count(t, first, "with the array again");
}

void check_pool(Test& t) {
  gl.UseProgram(colour_program(t));
  make_scene();
  for (const int level : {3, 1, 4, 2}) {
    refine_by_tags(static_cast<GLuint>(level));
    gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK, GL_SMOOTH_INTERIOR_ARK);
    for (int again = 0; again < repeats; ++again) draw_all();
    gl.ARKParameteriARK(GL_PATTERN_INTERIOR_ARK, GL_MINIMUM_INTERIOR_ARK);
    expect_count(t, count_of({1, 3, 2}, level) + count_of({2, 2, 0}, level), "of pool level " + as_text(level));
  }
}

}  // namespace

Cases changed_buffers_cases() {
  Cases cases = {
      {.name = "ark.draw.again.tag_array",
       .clauses = {"10.R.1-21", "10.R.1-26", "10.R.1-29", "11.R.13-1"},
       .plan = "Repeat a draw with a tag array, move its pointer, disable it, set the current tag, enable it.",
       .wrong = "The earlier depths of the draw.",
       .check = check_tag_array},
      {.name = "ark.draw.again.pool",
       .clauses = {"11.R.1-5", "11.R.5-12", "11.R.13-1"},
       .plan = "Repeat a draw with either interior and four pools: it has the current patterns.",
       .wrong = "The patterns of the earlier interior or pool.",
       .check = check_pool}};
  for (const Change& change : changes)
    for (const bool is_uniform : {true, false})
      cases.push_back(
          {.name = std::string("ark.draw.again.") + change.leaf + (is_uniform ? ".uniform" : ".tags"),
           .clauses = {"10.R.2-1", "11.R.13-1"},
           .plan =
               "Repeat a draw, change what its vertex array reads, and repeat it: it looks like the unrefined draw.",
           .wrong = "The earlier vertices of the draw.",
           .control = [&change](Test& t) { control_change(t, change); },
           .check = [&change, is_uniform](Test& t) { check_change(t, change, is_uniform); }});
  return cases;
}

}  // namespace glark::conformance
