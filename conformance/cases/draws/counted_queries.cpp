// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Every kind of query that counts primitives, and every way to get its result.
#include <array>
#include <cstring>

#include "conformance/cases/cases.h"
#include "conformance/cases/draws/four_triangles.h"

namespace glark::conformance {
namespace {

using Draw = std::function<void()>;

// Repeats the four triangles, with tags of 1.
Mesh many_triangles() {
  Mesh mesh;
  for (int i = 0; i < 100; ++i)
    for (MeshVertex vertex : four_triangles()) {
      vertex.tag = 1;
      mesh.push_back(vertex);
    }
  return mesh;
}

struct Counting {
  const char* leaf;
  GLuint (*count)(GLenum target, GLuint query, const Draw& draw);
  Apis apis = every_api;
  int version = 0;  // of OpenGL
};

void draw_in(GLenum target, GLuint query, const Draw& draw) {
  gl.BeginQuery(target, query);
  draw();
  gl.EndQuery(target);
}

template <typename Result, void (*GladGLContext::*get)(GLuint, GLenum, Result*)>
GLuint count_by(GLenum target, GLuint query, const Draw& draw) {
  Result result = 0;
  draw_in(target, query, draw);
  (gl.*get)(query, GL_QUERY_RESULT, &result);
  return static_cast<GLuint>(result);
}

// A buffer for results that GL writes itself. glBufferSubData may not write to it.
class ResultBuffer {
 public:
  static constexpr GLintptr offset = 16;

  ResultBuffer() {
    gl.GenBuffers(1, &name_);
    gl.BindBuffer(GL_COPY_READ_BUFFER, name_);
    gl.BufferStorage(GL_COPY_READ_BUFFER, sizeof(before), before.data(), GL_MAP_READ_BIT);
  }
  ~ResultBuffer() { gl.DeleteBuffers(1, &name_); }
  ResultBuffer(const ResultBuffer&) = delete;
  ResultBuffer& operator=(const ResultBuffer&) = delete;

  GLuint name() const { return name_; }

  // No possible result if GL has also changed what lies beside the result.
  template <typename Result>
  GLuint result() const {
    std::array<GLuint, 10> words{};
    gl.GetBufferSubData(GL_COPY_READ_BUFFER, 0, sizeof(words), words.data());
    Result result = 0;
    std::memcpy(&result, reinterpret_cast<const char*>(words.data()) + offset, sizeof(result));
    auto expected = before;
    std::memcpy(reinterpret_cast<char*>(expected.data()) + offset, &result, sizeof(result));
    return words == expected ? static_cast<GLuint>(result) : no_result;
  }

  static constexpr GLuint no_result = 0xFFFF0000;

 private:
  static constexpr std::array<GLuint, 10> before{91, 92, 93, 94, 95, 96, 97, 98, 99, 100};
  GLuint name_ = 0;
};

template <typename Result, void (*GladGLContext::*get)(GLuint, GLenum, Result*), GLenum name = GL_QUERY_RESULT>
GLuint count_to_bound_buffer(GLenum target, GLuint query, const Draw& draw) {
  const ResultBuffer buffer;
  draw_in(target, query, draw);
  if (name == GL_QUERY_RESULT_NO_WAIT) gl.Finish();
  gl.BindBuffer(GL_QUERY_BUFFER, buffer.name());
  (gl.*get)(query, name, reinterpret_cast<Result*>(ResultBuffer::offset));
  GLint bound = 0;
  gl.GetIntegerv(GL_QUERY_BUFFER_BINDING, &bound);
  gl.BindBuffer(GL_QUERY_BUFFER, 0);
  return static_cast<GLuint>(bound) == buffer.name() ? buffer.result<Result>() : ResultBuffer::no_result;
}

template <typename Result, void (*GladGLContext::*get)(GLuint, GLuint, GLenum, GLintptr)>
GLuint count_to_named_buffer(GLenum target, GLuint query, const Draw& draw) {
  const ResultBuffer buffer;
  draw_in(target, query, draw);
  (gl.*get)(query, buffer.name(), GL_QUERY_RESULT, ResultBuffer::offset);
  GLint bound = 0;
  gl.GetIntegerv(GL_QUERY_BUFFER_BINDING, &bound);
  return bound == 0 ? buffer.result<Result>() : ResultBuffer::no_result;
}

const std::vector<Counting>& countings() {
  static const std::vector<Counting> all = {
      {"unsigned", count_by<GLuint, &GladGLContext::GetQueryObjectuiv>},
      {"signed", count_by<GLint, &GladGLContext::GetQueryObjectiv>, desktop_apis},
      {"unsigned_64", count_by<GLuint64, &GladGLContext::GetQueryObjectui64v>, desktop_apis},
      {"signed_64", count_by<GLint64, &GladGLContext::GetQueryObjecti64v>, desktop_apis},
      {"no_wait",
       [](GLenum target, GLuint query, const Draw& draw) {
         GLuint result = 0;
         draw_in(target, query, draw);
         gl.Finish();
         for (GLuint is_there = 0; is_there == 0;) gl.GetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &is_there);
         gl.GetQueryObjectuiv(query, GL_QUERY_RESULT_NO_WAIT, &result);
         return result;
       },
       desktop_apis},
      {"indexed",
       [](GLenum target, GLuint query, const Draw& draw) {
         GLuint result = 0;
         gl.BeginQueryIndexed(target, 0, query);
         draw();
         gl.EndQueryIndexed(target, 0);
         gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &result);
         return result;
       },
       desktop_apis},
      {"to_buffer_unsigned", count_to_bound_buffer<GLuint, &GladGLContext::GetQueryObjectuiv>, desktop_apis, 44},
      {"to_buffer_signed", count_to_bound_buffer<GLint, &GladGLContext::GetQueryObjectiv>, desktop_apis, 44},
      {"to_buffer_unsigned_64", count_to_bound_buffer<GLuint64, &GladGLContext::GetQueryObjectui64v>, desktop_apis, 44},
      {"to_buffer_signed_64", count_to_bound_buffer<GLint64, &GladGLContext::GetQueryObjecti64v>, desktop_apis, 44},
      {"to_buffer_no_wait", count_to_bound_buffer<GLuint, &GladGLContext::GetQueryObjectuiv, GL_QUERY_RESULT_NO_WAIT>,
       desktop_apis, 44},
      {"to_named_unsigned", count_to_named_buffer<GLuint, &GladGLContext::GetQueryBufferObjectuiv>, desktop_apis, 45},
      {"to_named_signed", count_to_named_buffer<GLint, &GladGLContext::GetQueryBufferObjectiv>, desktop_apis, 45},
      {"to_named_unsigned_64", count_to_named_buffer<GLuint64, &GladGLContext::GetQueryBufferObjectui64v>, desktop_apis,
       45},
      {"to_named_signed_64", count_to_named_buffer<GLint64, &GladGLContext::GetQueryBufferObjecti64v>, desktop_apis,
       45},
  };
  return all;
}

void require_version(Test& t, int version) {
  if (!t.is_gles() && t.version() < version) t.not_supported("results of queries cannot go to a buffer");
}

// The context's first refined draws run within the queries, and so do draws of other depths. One query object serves
// all of them.
void check_counting(Test& t, const Counting& counting, bool is_discarded) {
  require_version(t, counting.version);
  set_up_four_triangles(t);
  GLuint query = 0;
  gl.GenQueries(1, &query);
  if (is_discarded) gl.Enable(GL_RASTERIZER_DISCARD);
  gl.ARKinit(4);
  gl.Enable(GL_ARK);
  const auto draw = [] { gl.DrawArrays(GL_TRIANGLES, 0, all_vertices); };
  for (const GLenum source : {GL_DEPTH_TAG_ARK, GL_UNIFORM_DEPTH_ARK})
    for (const GLuint level : {3U, 1U, 4U, 0U}) {
      gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
      gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, static_cast<GLint>(level));
      gl.DepthTag1i(level);
      for (int again = 0; again < 3; ++again)
        t.expect_equal(counting.count(GL_PRIMITIVES_GENERATED, query, draw), GLuint{4} << (2 * level),
                       "triangles of depth " + as_text(level));
    }
  // Edges of many pixels, so that all have the depth of the pool.
  gl.ARKinit(2);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 1);
  for (int again = 0; again < 3; ++again)
    t.expect_equal(counting.count(GL_PRIMITIVES_GENERATED, query, draw), 64U, "triangles of measured depths");
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
  const Mesh many = many_triangles();
  upload(many);
  for (int again = 0; again < 3; ++again)
    t.expect_equal(counting.count(GL_PRIMITIVES_GENERATED, query,
                                  [&] { gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(many.size())); }),
                   static_cast<GLuint>(4 * many.size() / 3), "triangles of many with tags");
  gl.Disable(GL_ARK);
  t.expect_equal(counting.count(GL_PRIMITIVES_GENERATED, query, draw), 4U, "triangles that are not refined");
  t.expect_no_error("the queries");
}

void control_counting(Test& t, const Counting& counting) {
  require_version(t, counting.version);
  set_up_four_triangles(t);
  GLuint query = 0;
  gl.GenQueries(1, &query);
  for (int again = 0; again < 2; ++again)
    t.expect_equal(counting.count(GL_PRIMITIVES_GENERATED, query, [] { gl.DrawArrays(GL_TRIANGLES, 0, all_vertices); }),
                   4U, "triangles");
  t.expect_no_error("the queries");
}

}  // namespace

Cases counted_queries_cases() {
  Cases cases;
  for (const Counting& counting : countings())
    for (const bool is_discarded : {false, true})
      cases.push_back(
          {.name = std::string("ark.after_vertex.queries.") + counting.leaf + (is_discarded ? ".discarded" : ".drawn"),
           .clauses = {"chapter-14-8", "chapter-14-9"},
           .plan = "One query object for draws of several depths, starting with the context's first draw.",
           .wrong = "Coarse triangles are counted too, or subtracted twice.",
           .apis = counting.apis,
           .is_optional = counting.version > 0,
           .control = [&counting](Test& t) { control_counting(t, counting); },
           .check = [&counting, is_discarded](Test& t) { check_counting(t, counting, is_discarded); }});
  return cases;
}

}  // namespace glark::conformance
