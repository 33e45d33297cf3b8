// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The first draws of a context with quads and polygons. An implementation may have to find out how GL divides them.
#include "conformance/cases/cases.h"
#include "conformance/support/counted.h"
#include "conformance/support/refined_draw.h"
#include "conformance/support/state.h"

namespace glark::conformance {
namespace {

void draw_quad(GLenum mode) {
  gl.Begin(mode);
  gl.Vertex2f(-0.8F, -0.8F);
  gl.Vertex2f(0.8F, -0.8F);
  gl.Vertex2f(mode == GL_QUAD_STRIP ? -0.8F : 0.8F, 0.8F);
  gl.Vertex2f(mode == GL_QUAD_STRIP ? 0.8F : -0.8F, 0.8F);
  gl.End();
}

struct Target {
  GLenum target;
  GLenum binding;
  bool is_indexed = false;
};

constexpr Target targets[] = {{GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING, true},
                              {GL_TRANSFORM_FEEDBACK_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, true},
                              {GL_ATOMIC_COUNTER_BUFFER, GL_ATOMIC_COUNTER_BUFFER_BINDING, true},
                              {GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING, true},
                              {GL_DRAW_INDIRECT_BUFFER, GL_DRAW_INDIRECT_BUFFER_BINDING},
                              {GL_DISPATCH_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER_BINDING},
                              {GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING},
                              {GL_ELEMENT_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER_BINDING},
                              {GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER_BINDING},
                              {GL_COPY_WRITE_BUFFER, GL_COPY_WRITE_BUFFER_BINDING},
                              {GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING},
                              {GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING},
                              {GL_TEXTURE_BUFFER, GL_TEXTURE_BUFFER_BINDING}};

// The buffer that is bound without an index is another one than the one bound to index 0.
void check_bindings(Test& t, GLenum mode, GLenum source) {
  gl.UseProgram(colour_program(t));
  refine_uniformly(2);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
  std::vector<GLuint> bound;
  for (const Target& each : targets) {
    GLuint buffers[2] = {};
    gl.GenBuffers(2, buffers);
    for (const GLuint buffer : buffers) {
      gl.BindBuffer(each.target, buffer);
      gl.BufferData(each.target, 256, nullptr, GL_STATIC_DRAW);
    }
    if (each.is_indexed) gl.BindBufferBase(each.target, 0, buffers[1]);
    gl.BindBuffer(each.target, buffers[0]);
    bound.push_back(buffers[0]);
    bound.push_back(buffers[1]);
  }
  for (int again = 0; again < 3; ++again) {
    draw_quad(mode);
    t.expect_no_error("the draw");
    for (std::size_t i = 0; i < std::size(targets); ++i) {
      t.expect_equal(integer_of(targets[i].binding), static_cast<GLint>(bound[2 * i]), "binding " + as_text(i));
      if (!targets[i].is_indexed) continue;
      GLint indexed = 0;
      gl.GetIntegeri_v(targets[i].binding, 0, &indexed);
      t.expect_equal(indexed, static_cast<GLint>(bound[2 * i + 1]), "index 0 of binding " + as_text(i));
    }
  }
}

// The other face is filled, and its edge flags do not count.
void check_edge_flags(Test& t, bool is_back) {
  gl.UseProgram(colour_program(t));
  gl.FrontFace(is_back ? GL_CW : GL_CCW);
  const auto draw = [] { draw_quad(GL_QUADS); };
  gl.VertexAttrib4f(at_colour, 1, 1, 1, 1);
  gl.EdgeFlag(GL_FALSE);
  gl.PolygonMode(is_back ? GL_BACK : GL_FRONT, GL_LINE);
  const Picture nothing(surface_size, surface_size);
  refine_uniformly(1);
  for (int again = 0; again < 8; ++again)
    t.expect(count_different(picture_of(draw), nothing, 8) > 200, "edges of refined triangles are drawn");
}

// Tags of one half round up.
void check_half_tags(Test& t, GLenum mode) {
  gl.UseProgram(colour_program(t));
  refine_by_tags(3);
  gl.ARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
  const auto attribute = static_cast<GLuint>(integer_of(GL_DEPTH_TAG_ATTRIBUTE_ARK));
  for (const auto& [tag, depth] : {std::pair<float, GLuint>{0.5F, 1}, {0.49F, 0}, {1.5F, 2}, {1.49F, 1}, {2.5F, 3}}) {
    const std::vector<GLfloat> tags(4, tag);
    const GLfloat places[] = {-0.8F, -0.8F, 0.8F, -0.8F, 0.8F, 0.8F, -0.8F, 0.8F};
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, places);
    gl.VertexAttribPointer(attribute, 1, GL_FLOAT, GL_FALSE, 0, tags.data());
    gl.EnableVertexAttribArray(0);
    gl.EnableVertexAttribArray(attribute);
    for (int again = 0; again < 2; ++again)
      t.expect_equal(count_generated([mode = mode] { gl.DrawArrays(mode, 0, 4); }), GLuint{4} << (2 * depth),
                     "triangles of a quad with the tags " + as_text(tag));
  }
}

// An implementation that finds out the diagonals of quads by drawing one sees nothing while a condition is false. The
// corners have other colours, so another diagonal shows.
void check_condition(Test& t, GLenum mode, bool has_array) {
  constexpr GLfloat colours[4][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  constexpr GLfloat quad[4][2] = {{-0.8F, -0.8F}, {0.8F, -0.8F}, {0.8F, 0.8F}, {-0.8F, 0.8F}};
  const std::array<std::size_t, 4> order =
      mode == GL_QUAD_STRIP ? std::array<std::size_t, 4>{0, 1, 3, 2} : std::array<std::size_t, 4>{0, 1, 2, 3};
  std::vector<GLfloat> places;
  std::vector<GLfloat> hues;
  for (std::size_t i = 0; i < 4; ++i) {
    places.insert(places.end(), quad[order[i]], quad[order[i]] + 2);
    hues.insert(hues.end(), colours[i], colours[i] + 3);
  }
  const auto draw = [&] {
    if (has_array) return gl.DrawArrays(mode, 0, 4);
    gl.Begin(mode);
    for (std::size_t i = 0; i < 4; ++i) {
      gl.Color3fv(&hues[3 * i]);
      gl.Vertex2fv(&places[2 * i]);
    }
    gl.End();
  };
  if (has_array) {
    gl.VertexPointer(2, GL_FLOAT, 0, places.data());
    gl.ColorPointer(3, GL_FLOAT, 0, hues.data());
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
  }
  const Picture plain = picture_of(draw);
  GLuint nothing_seen = 0;
  gl.GenQueries(1, &nothing_seen);
  gl.BeginQuery(GL_ANY_SAMPLES_PASSED, nothing_seen);
  gl.EndQuery(GL_ANY_SAMPLES_PASSED);
  refine_uniformly(2);
  for (int again = 0; again < 12; ++again) {
    gl.BeginConditionalRender(nothing_seen, GL_QUERY_WAIT);
    draw();
    gl.EndConditionalRender();
  }
  for (int again = 0; again < 2; ++again)
    t.expect_same_picture(picture_of(draw), plain, "the quad after draws whose condition was false", 3, 40);
  t.expect_no_error("the draws");
}

}  // namespace

Cases first_quads_cases() {
  Cases cases;
  for (const auto& [mode, name] : {std::pair<GLenum, const char*>{GL_QUADS, "quads"}, {GL_QUAD_STRIP, "quad_strip"}})
    for (const bool has_array : {false, true})
      cases.push_back(
          {.name = std::string("ark.draw.first_quads.condition.") + name + (has_array ? ".array" : ".begin"),
           .clauses = {"10.R.2-1", "11.R.3-5"},
           .plan = "The first quads of a context are drawn under a condition that is false, many times. Quads "
                   "after it have the unrefined picture.",
           .wrong = "Quads are divided along the other diagonal.",
           .apis = compat_only,
           .check = [mode = mode, has_array](Test& t) { check_condition(t, mode, has_array); }});
  for (const auto& [mode, name] :
       {std::pair<GLenum, const char*>{GL_QUADS, "quads"}, {GL_QUAD_STRIP, "quad_strip"}, {GL_POLYGON, "polygon"}})
    for (const auto& [source, depths] :
         {std::pair<GLenum, const char*>{GL_UNIFORM_DEPTH_ARK, "uniform"}, {GL_DEPTH_TAG_ARK, "tags"}})
      cases.push_back({.name = std::string("ark.draw.keeps.buffers.") + name + "." + depths,
                       .clauses = {"10.R.2-6"},
                       .plan =
                           "Bind a buffer to each target, draw the context's first primitive of this mode, and read "
                           "the bindings.",
                       .wrong = "Bindings of the implementation's own passes remain.",
                       .apis = compat_only,
                       .check = [mode = mode, source = source](Test& t) { check_bindings(t, mode, source); }});
  for (const bool is_back : {false, true})
    cases.push_back({.name = std::string("ark.after_vertex.edge_flags.") + (is_back ? "back" : "front"),
                     .clauses = {"chapter-14-12"},
                     .plan = "Draw a quad whose edge flags are FALSE, with lines for the face that shows only.",
                     .wrong = "The flags of the coarse vertices count: no line is drawn.",
                     .apis = compat_only,
                     .check = [is_back](Test& t) { check_edge_flags(t, is_back); }});
  for (const GLenum mode : {GL_QUADS, GL_POLYGON})
    cases.push_back({.name = std::string("ark.coarse.split.half_tags.") + (mode == GL_QUADS ? "quads" : "polygon"),
                     .clauses = {"11.R.4-2", "11.R.3-6"},
                     .plan = "Split a quad at its centroid, with tags that lie half way between depths.",
                     .wrong = "Half a level is rounded down.",
                     .apis = compat_only,
                     .check = [mode](Test& t) { check_half_tags(t, mode); }});
  return cases;
}

}  // namespace glark::conformance
