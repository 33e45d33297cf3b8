// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Calls that GL refuses change nothing: neither the next refined draw, nor the state after it. An implementation may keep
// a copy of the application's state. It must not write the refused values there.
#include <array>
#include <functional>

#include "conformance/cases/cases.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

constexpr int level = 2;
constexpr GLuint refined_triangles = 16;

void draw_one() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

GLuint make_buffer(GLenum target, GLsizeiptr size = 64) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, size, nullptr, GL_STATIC_DRAW);
  return buffer;
}

// Fixed function. Each corner has another colour, and the clip planes of check_between() cut the triangle.
void coloured_triangle() {
  gl.Begin(GL_TRIANGLES);
  for (const MeshVertex& vertex : one_triangle()) {
    gl.Color3f(0.5F + 0.5F * vertex.position[0], 0.5F - 0.5F * vertex.position[1], vertex.colour[2]);
    gl.Vertex2f(vertex.position[0], vertex.position[1]);
  }
  gl.End();
}

std::array<GLint, 4> values_of(GLenum state) {
  std::array<GLint, 4> values{};
  gl.GetIntegerv(state, values.data());
  return values;
}

struct RefusedCall {
  const char* name;
  std::function<void()> call;
  GLenum state;  // of up to four integers
};

// Names that are not bound.
struct OtherObjects {
  GLuint buffer = 0, array = 0, program = 0;

  explicit OtherObjects(Test& t) : buffer(make_buffer(GL_COPY_READ_BUFFER)), program(colour_program(t)) {
    gl.GenVertexArrays(1, &array);
  }
};

std::vector<RefusedCall> calls_between_begin_and_end(const OtherObjects& other) {
  std::vector<RefusedCall> calls = {
      {"ShadeModel", [] { gl.ShadeModel(GL_FLAT); }, GL_SHADE_MODEL},
      {"ProvokingVertex", [] { gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION); }, GL_PROVOKING_VERTEX},
      {"CullFace", [] { gl.CullFace(GL_FRONT); }, GL_CULL_FACE_MODE},
      {"FrontFace", [] { gl.FrontFace(GL_CW); }, GL_FRONT_FACE},
      {"PolygonMode", [] { gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE); }, GL_POLYGON_MODE},
      {"DepthFunc", [] { gl.DepthFunc(GL_NEVER); }, GL_DEPTH_FUNC},
      {"DepthMask", [] { gl.DepthMask(GL_FALSE); }, GL_DEPTH_WRITEMASK},
      {"Viewport", [] { gl.Viewport(0, 0, 3, 3); }, GL_VIEWPORT},
      {"MatrixMode", [] { gl.MatrixMode(GL_PROJECTION); }, GL_MATRIX_MODE},
      {"BindVertexArray", [=] { gl.BindVertexArray(other.array); }, GL_VERTEX_ARRAY_BINDING},
      {"UseProgram", [=] { gl.UseProgram(other.program); }, GL_CURRENT_PROGRAM},
      {"ListBase", [] { gl.ListBase(7); }, GL_LIST_BASE}};
  for (const auto& [name, binding] :
       {std::pair<GLenum, GLenum>{GL_DRAW_INDIRECT_BUFFER, GL_DRAW_INDIRECT_BUFFER_BINDING},
        {GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING},
        {GL_TRANSFORM_FEEDBACK_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING}}) {
    calls.push_back({"BindBuffer", [=, target = name] { gl.BindBuffer(target, other.buffer); }, binding});
    if (name != GL_DRAW_INDIRECT_BUFFER)
      calls.push_back({"BindBufferBase", [=, target = name] { gl.BindBufferBase(target, 0, other.buffer); }, binding});
  }
  for (const GLenum capability :
       {GL_CLIP_PLANE0, GL_CLIP_PLANE5, GL_PRIMITIVE_RESTART, GL_PRIMITIVE_RESTART_FIXED_INDEX, GL_RASTERIZER_DISCARD,
        GL_CULL_FACE, GL_LIGHTING, GL_FOG, GL_COLOR_MATERIAL, GL_BLEND, GL_VERTEX_PROGRAM_TWO_SIDE,
        GL_PROGRAM_POINT_SIZE, GL_DEBUG_OUTPUT_SYNCHRONOUS})
    calls.push_back({"Enable", [capability] { gl.Enable(capability); }, capability});
  return calls;
}

// Each call lies between Begin and End of a draw of its own, refined or not.
void check_between(Test& t, bool is_refined) {
  const OtherObjects other(t);
  const GLdouble plane[] = {1, 0.3, 0, 0};
  gl.ClipPlane(GL_CLIP_PLANE0, plane);
  gl.ClipPlane(GL_CLIP_PLANE5, plane);
  refine_uniformly(level, GL_LINEAR_OUTPUTS_ARK);
  const Picture expected = picture_of(coloured_triangle);
  for (const RefusedCall& refused : calls_between_begin_and_end(other)) {
    const std::array<GLint, 4> before = values_of(refused.state);
    is_refined ? gl.Enable(GL_ARK) : gl.Disable(GL_ARK);
    gl.Begin(GL_TRIANGLES);
    refused.call();
    gl.End();
    gl.Enable(GL_ARK);
    const std::string what = std::string(refused.name) + " between Begin and End";
    t.expect_equal(gl.GetError(), GLenum{GL_INVALID_OPERATION}, what);
    t.expect_same_picture(picture_of(coloured_triangle), expected, "after " + what);
    t.expect(values_of(refused.state) == before, "the state is unchanged after " + what);
    t.expect_no_error("the draw after " + what);
  }
}

// Plain GL refuses each call between Begin and End.
void control_between(Test& t) {
  const OtherObjects other(t);
  for (const RefusedCall& refused : calls_between_begin_and_end(other)) {
    gl.Begin(GL_TRIANGLES);
    refused.call();
    gl.End();
    t.expect_equal(gl.GetError(), GLenum{GL_INVALID_OPERATION}, refused.name);
  }
}

// Between Begin and End, GL refuses to delete an object, to end a count and to draw.
void check_objects(Test& t) {
  const GLuint program = colour_program(t);
  gl.UseProgram(program);
  upload(one_triangle());
  refine_uniformly(level);
  gl.NewList(1, GL_COMPILE);
  coloured_triangle();
  gl.EndList();
  GLuint query = 0;
  gl.GenQueries(1, &query);
  const GLuint feedback = make_buffer(GL_TRANSFORM_FEEDBACK_BUFFER, 65536);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, feedback);
  const RefusedCall calls[] = {
      {"DeleteProgram", [=] { gl.DeleteProgram(program); }, GL_CURRENT_PROGRAM},
      {"LinkProgram", [=] { gl.LinkProgram(program); }, GL_CURRENT_PROGRAM},
      {"DeleteLists", [] { gl.DeleteLists(1, 1); }, GL_LIST_BASE},
      {"EndQuery", [] { gl.EndQuery(GL_PRIMITIVES_GENERATED); }, GL_CURRENT_PROGRAM},
      {"DeleteQueries", [=] { gl.DeleteQueries(1, &query); }, GL_CURRENT_PROGRAM},
      {"BeginTransformFeedback", [] { gl.BeginTransformFeedback(GL_TRIANGLES); }, GL_TRANSFORM_FEEDBACK_ACTIVE},
      {"EndTransformFeedback", [] { gl.EndTransformFeedback(); }, GL_TRANSFORM_FEEDBACK_ACTIVE},
      {"DeleteBuffers", [=] { gl.DeleteBuffers(1, &feedback); }, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING},
      {"DrawArrays", draw_one, GL_CURRENT_PROGRAM},
      {"PopAttrib", [] { gl.PopAttrib(); }, GL_ATTRIB_STACK_DEPTH},
      {"PushAttrib", [] { gl.PushAttrib(GL_ENABLE_BIT); }, GL_ATTRIB_STACK_DEPTH},
  };
  for (const RefusedCall& refused : calls) {
    const std::string what = std::string(refused.name) + " between Begin and End";
    const std::array<GLint, 4> before = values_of(refused.state);
    gl.BeginQuery(GL_PRIMITIVES_GENERATED, query);
    gl.Begin(GL_TRIANGLES);
    for (const MeshVertex& vertex : one_triangle()) gl.Vertex4fv(vertex.position.data());
    refused.call();
    gl.End();
    t.expect_equal(gl.GetError(), GLenum{GL_INVALID_OPERATION}, what);
    draw_one();
    gl.CallList(1);
    gl.EndQuery(GL_PRIMITIVES_GENERATED);
    GLuint count = 0;
    gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
    t.expect_equal(count, 3 * refined_triangles, "triangles of three draws, after " + what);
    t.expect(values_of(refused.state) == before, "the state is unchanged after " + what);
    t.expect_no_error("the draws after " + what);
  }
}

// A call of a list between Begin and End may leave the state unknown. The refused draw must not look at it there.
void check_draw_after_list(Test& t) {
  const GLuint program = colour_program(t);
  gl.UseProgram(program);
  upload(one_triangle());
  refine_uniformly(level);
  gl.NewList(1, GL_COMPILE);
  gl.VertexAttrib4f(at_colour, 1, 0.5F, 0.25F, 1);
  gl.EndList();
  const GLubyte indices[] = {0, 1, 2};
  for (int again = 0; again < 2; ++again) {
    gl.Begin(GL_TRIANGLES);
    gl.CallList(1);
    gl.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, indices);
    for (const MeshVertex& vertex : one_triangle()) gl.Vertex4fv(vertex.position.data());
    gl.End();
    t.expect_error(GL_INVALID_OPERATION, "the draw");
    t.expect_equal(values_of(GL_CURRENT_PROGRAM)[0], static_cast<GLint>(program), "the program in use");
  }
}

// The name of a vertex array that was deleted while another one was bound.
void check_deleted_array(Test& t) {
  gl.UseProgram(colour_program(t));
  const GLuint deleted = upload(one_triangle()).array;
  refine_uniformly(level);
  draw_one();
  const GLuint bound = upload(one_triangle()).array;
  draw_one();
  gl.DeleteVertexArrays(1, &deleted);
  draw_one();
  gl.BindVertexArray(deleted);
  t.expect_error(GL_INVALID_OPERATION, "BindVertexArray of a deleted name");
  for (int again = 0; again < 3; ++again) {
    t.expect_equal(count_generated(draw_one), refined_triangles, "triangles after it");
    t.expect_equal(values_of(GL_VERTEX_ARRAY_BINDING)[0], static_cast<GLint>(bound), "the array after it");
    t.expect_no_error("the draw after it");
  }
}

// A query of samples gets the name of a deleted one that counted triangles.
void check_reused_query(Test& t) {
  gl.UseProgram(colour_program(t));
  upload(one_triangle());
  refine_uniformly(level);
  GLuint query = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_PRIMITIVES_GENERATED, query);
  for (int i = 0; i < 50; ++i) {
    upload(one_triangle());
    draw_one();
  }
  gl.EndQuery(GL_PRIMITIVES_GENERATED);
  gl.DeleteQueries(1, &query);
  gl.Disable(GL_ARK);
  GLuint counts[2] = {};
  GLuint names[2] = {query, 0};
  gl.GenQueries(1, &names[1]);
  for (int i = 0; i < 2; ++i) {
    gl.BeginQuery(GL_SAMPLES_PASSED, names[i]);
    draw_one();
    gl.EndQuery(GL_SAMPLES_PASSED);
    gl.GetQueryObjectuiv(names[i], GL_QUERY_RESULT, &counts[i]);
  }
  t.expect(counts[1] > 0, "samples are counted");
  t.expect_equal(counts[0], counts[1], "samples by the query with the name of the deleted one");
}

// GL refuses indices beyond its limits, and in core profiles names that it did not give out.
void check_bindings(Test& t) {
  gl.UseProgram(colour_program(t));
  upload(one_triangle());
  struct Target {
    GLenum target, binding, limit;  // limit: of the index; 0: no indexed bindings
  };
  for (const Target& each :
       {Target{GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS},
        {GL_TRANSFORM_FEEDBACK_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
         t.is_gles() ? GLenum{GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS} : GLenum{GL_MAX_TRANSFORM_FEEDBACK_BUFFERS}},
        {GL_DRAW_INDIRECT_BUFFER, GL_DRAW_INDIRECT_BUFFER_BINDING, 0}}) {
    const GLuint other = make_buffer(each.target);
    const GLuint bound = make_buffer(each.target);
    const auto expect_kept = [&](const std::string& what) {
      if (gl.GetError() == GL_NO_ERROR) {
        gl.BindBuffer(each.target, bound);
        return;  // this GL does not refuse it
      }
      draw_one();
      t.expect_no_error("a draw after " + what);
      t.expect_equal(integer_of(each.binding), static_cast<GLint>(bound), "the binding after " + what);
    };
    refine_by_tags(4);
    gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
    gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 8);
    gl.BindBuffer(each.target, other + bound + 1000);
    expect_kept("BindBuffer of an unknown name");
    if (each.limit == 0) continue;
    gl.BindBufferBase(each.target, static_cast<GLuint>(integer_of(each.limit)), other);
    expect_kept("BindBufferBase beyond the limit");
    gl.BindBufferBase(each.target, 0, other + bound + 1000);
    expect_kept("BindBufferBase of an unknown name");
    gl.BindBufferRange(each.target, 0, other, 1, 16);
    expect_kept("BindBufferRange with an odd offset");
    gl.BindBufferRange(each.target, static_cast<GLuint>(integer_of(each.limit)), other, 0, 16);
    expect_kept("BindBufferRange beyond the limit");
  }
}

GLuint triangles_of_draw() { return count_generated(draw_one); }

struct WrongValue {
  const char* name;
  std::function<void()> call;
  GLenum state;  // of up to four integers
  Apis apis = every_api;
};

// Each call has a value that the command does not know, beside one that it knows.
void check_values(Test& t) {
  const WrongValue calls[] = {
      {"CullFace", [] { gl.CullFace(GL_LEFT); }, GL_CULL_FACE_MODE},
      {"FrontFace", [] { gl.FrontFace(GL_FRONT); }, GL_FRONT_FACE},
      {"PolygonMode of an unknown face", [] { gl.PolygonMode(GL_LEFT, GL_LINE); }, GL_POLYGON_MODE, desktop_apis},
      {"PolygonMode of an unknown mode", [] { gl.PolygonMode(GL_FRONT_AND_BACK, GL_FLAT); }, GL_POLYGON_MODE,
       desktop_apis},
      {"PolygonMode of one face", [] { gl.PolygonMode(GL_FRONT, GL_LINE); }, GL_POLYGON_MODE, {Api::gl_core}},
      {"DepthFunc", [] { gl.DepthFunc(GL_ONE); }, GL_DEPTH_FUNC},
      {"ProvokingVertex", [] { gl.ProvokingVertex(GL_FRONT); }, GL_PROVOKING_VERTEX, desktop_apis},
      {"ShadeModel", [] { gl.ShadeModel(GL_FILL); }, GL_SHADE_MODEL, compat_only},
      {"MatrixMode", [] { gl.MatrixMode(GL_MODELVIEW_MATRIX); }, GL_MATRIX_MODE, compat_only},
      {"Viewport", [] { gl.Viewport(0, 0, -1, 8); }, GL_VIEWPORT},
      {"Enable", [] { gl.Enable(GL_FRONT); }, GL_BLEND},
      {"UseProgram", [] { gl.UseProgram(99999); }, GL_CURRENT_PROGRAM},
      {"BindVertexArray", [] { gl.BindVertexArray(99999); }, GL_VERTEX_ARRAY_BINDING},
      {"BindFramebuffer", [] { gl.BindFramebuffer(GL_TEXTURE_2D, 0); }, GL_DRAW_FRAMEBUFFER_BINDING},
  };
  gl.UseProgram(colour_program(t));
  upload(one_triangle({level, level, level}));
  const Picture plain = picture_of(draw_one);
  for (const bool by_tags : {false, true}) {
    by_tags ? refine_by_tags(4) : refine_uniformly(level);
    for (const WrongValue& wrong : calls) {
      if (!wrong.apis.contains(t.api())) continue;
      const std::string what = std::string(wrong.name) + (by_tags ? ", by tags" : "");
      const auto before = values_of(wrong.state);
      wrong.call();
      t.expect(gl.GetError() != GL_NO_ERROR, what + " raises an error");
      t.expect_same_picture(picture_of(draw_one), plain, "after " + what, 2, 20);
      t.expect_equal(triangles_of_draw(), refined_triangles, "triangles after " + what);
      t.expect(values_of(wrong.state) == before, what + " changes no state");
      t.expect_no_error("the draws after " + what);
    }
  }
}

// A mesh that no draw has captured before.
GLuint triangles_of_new_mesh() {
  upload(one_triangle());
  return triangles_of_draw();
}

void check_queries(Test& t) {
  gl.UseProgram(colour_program(t));
  upload(one_triangle());
  refine_uniformly(level);
  GLuint queries[3] = {};
  gl.GenQueries(3, queries);
  gl.BeginQuery(GL_ANY_SAMPLES_PASSED, queries[0]);
  gl.EndQuery(GL_ANY_SAMPLES_PASSED);
  for (const GLenum target : {GL_PRIMITIVES_GENERATED, GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN}) {
    gl.BeginQuery(target, queries[0]);
    t.expect_equal(gl.GetError(), GLenum{GL_INVALID_OPERATION}, "a query of another target");
    for (int again = 0; again < 3; ++again)
      t.expect_equal(triangles_of_new_mesh(), refined_triangles, "after a refusal");
    gl.BeginQuery(target, queries[1]);
    gl.BeginQuery(target, queries[2]);
    t.expect_equal(gl.GetError(), GLenum{GL_INVALID_OPERATION}, "a second query");
    upload(one_triangle());
    draw_one();
    gl.EndQuery(target);
    GLuint count = 0;
    gl.GetQueryObjectuiv(queries[1], GL_QUERY_RESULT, &count);
    if (target == GL_PRIMITIVES_GENERATED) t.expect_equal(count, refined_triangles, "the first query");
    for (int again = 0; again < 3; ++again)
      t.expect_equal(triangles_of_new_mesh(), refined_triangles, "after two begins");
    GLuint deleted = 0;
    gl.GenQueries(1, &deleted);
    gl.BeginQuery(target, deleted);
    gl.DeleteQueries(1, &deleted);
    if (gl.GetError() != GL_NO_ERROR) gl.EndQuery(target);
    for (int again = 0; again < 3; ++again)
      t.expect_equal(triangles_of_new_mesh(), refined_triangles, "after an active query was deleted");
  }
}

// GL clamps the size.
void check_viewport(Test& t) {
  gl.UseProgram(colour_program(t));
  upload(one_triangle());
  GLint most[2] = {};
  gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, most);
  refine_by_tags(6);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, most[0] / 4);
  gl.Viewport(0, 0, most[0], most[1]);
  const GLuint expected = triangles_of_draw();
  t.expect(expected > 1, "the triangle is refined");
  gl.Viewport(0, 0, 4 * most[0], 4 * most[1]);
  t.expect_equal(triangles_of_draw(), expected, "triangles in a viewport beyond the limits");
  gl.Viewport(0, 0, most[0] / 16, most[1] / 16);
  t.expect(triangles_of_draw() < expected, "a smaller viewport needs fewer triangles");
}

constexpr Area refused_case{"ark.refused."};

}  // namespace

Cases refused_calls_cases() {
  Cases cases = {
      refused_case("bindings", {"10.R.2-6", "10.R.2-13"},
                   "Bind buffers with indices, offsets and names that GL refuses, draw, and read the binding.",
                   "The refused binding is there after the draw, or the draw raises an error.", check_bindings),
      refused_case("queries", {"chapter-14-8", "chapter-14-9"},
                   "Begin queries that GL refuses, and delete an active one. Then count the triangles of draws.",
                   "Later queries count what the implementation captures.", check_queries),
      refused_case("values", {"10.R.2-6", "10.R.2-13"},
                   "Call commands with values that GL refuses, draw, and read the state.",
                   "The draw has the refused state, or the state has it after the draw.", check_values),
      refused_case("objects", {"10.R.2-6", "10.R.2-13", "chapter-14-8"},
                   "Delete objects and end counts between Begin and End, where GL refuses it. Then draw.",
                   "The object is no longer refined, or the count goes on without the implementation.", check_objects,
                   compat_only),
      refused_case("draw_after_list", {"10.R.2-6"},
                   "Between Begin and End, call a list and then DrawElements. Then read the program in use.",
                   "No program is in use.", check_draw_after_list, compat_only),
      refused_case("deleted_array", {"10.R.2-6", "10.R.2-13"},
                   "Bind the name of a deleted vertex array, which GL refuses. Draw, and read the binding.",
                   "The draw raises an error, or binds an array of the implementation.", check_deleted_array),
      refused_case("reused_query", {"chapter-14-9"},
                   "Count triangles, delete the query, and count samples by a query with its name.",
                   "What the implementation captured is subtracted from the samples.", check_reused_query, compat_only),
      refused_case("viewport", {"11.R.4-4"}, "A viewport of four times the size that GL has, with depths by pixels.",
                   "The size before GL clamps it.", check_viewport)};
  for (const bool is_refined : {true, false})
    cases.push_back({.name = std::string("ark.refused.between.") + (is_refined ? "refined" : "unrefined"),
                     .clauses = {"10.R.2-6", "10.R.2-13"},
                     .plan = "Change states between Begin and End, where GL refuses it. Draw, and read the states.",
                     .wrong = "The draw has the refused state, or sets it.",
                     .apis = compat_only,
                     .control = control_between,
                     .check = [is_refined](Test& t) { check_between(t, is_refined); }});
  return cases;
}

}  // namespace glark::conformance
