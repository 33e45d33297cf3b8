// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A refined draw only draws (10.R.2): afterwards all state is the application's again.
#include <fmt/core.h>
#include <cstddef>
#include <map>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

using Values = std::map<std::string, std::vector<GLint>>;

struct Name {
  GLenum name;
  int version = 0;  // of the desktop GL; 0: every version
  bool is_compat_only = false;
};

constexpr Name names[] = {
    {GL_CURRENT_PROGRAM},
    {GL_PROGRAM_PIPELINE_BINDING},
    {GL_VERTEX_ARRAY_BINDING},
    {GL_ARRAY_BUFFER_BINDING},
    {GL_ELEMENT_ARRAY_BUFFER_BINDING},
    {GL_DRAW_INDIRECT_BUFFER_BINDING},
    {GL_DISPATCH_INDIRECT_BUFFER_BINDING},
    {GL_UNIFORM_BUFFER_BINDING},
    {GL_SHADER_STORAGE_BUFFER_BINDING},
    {GL_ATOMIC_COUNTER_BUFFER_BINDING},
    {GL_COPY_READ_BUFFER_BINDING},
    {GL_COPY_WRITE_BUFFER_BINDING},
    {GL_PIXEL_PACK_BUFFER_BINDING},
    {GL_PIXEL_UNPACK_BUFFER_BINDING},
    {GL_TRANSFORM_FEEDBACK_BUFFER_BINDING},
    {GL_TRANSFORM_FEEDBACK_BINDING},
    {GL_TRANSFORM_FEEDBACK_ACTIVE},
    {GL_TRANSFORM_FEEDBACK_PAUSED},
    {GL_ACTIVE_TEXTURE},
    {GL_DRAW_FRAMEBUFFER_BINDING},
    {GL_READ_FRAMEBUFFER_BINDING},
    {GL_RASTERIZER_DISCARD},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX},
    {GL_DEBUG_OUTPUT},
    {GL_DEBUG_OUTPUT_SYNCHRONOUS},
    {GL_CULL_FACE},
    {GL_CULL_FACE_MODE},
    {GL_FRONT_FACE},
    {GL_DEPTH_TEST},
    {GL_DEPTH_FUNC},
    {GL_VIEWPORT},
    {GL_SCISSOR_BOX},
    {GL_PATCH_VERTICES},
    {GL_PACK_ALIGNMENT},
    {GL_UNPACK_ALIGNMENT},
    {GL_ARK},
    {GL_CURRENT_DEPTH_TAG_ARK},
    {GL_DEPTH_TAG_ARRAY_ARK},
    {GL_DEPTH_SOURCE_ARK},
    {GL_PRIMITIVE_RESTART, 31},
    {GL_PRIMITIVE_RESTART_INDEX, 31},
    {GL_PROVOKING_VERTEX, 32},
    {GL_POLYGON_MODE, 30},
    {GL_PROGRAM_POINT_SIZE, 32},
    {GL_QUERY_BUFFER_BINDING, 44},
    {GL_COLOR_SUM, 0, true},
    {GL_EDGE_FLAG, 0, true},
    {GL_VERTEX_PROGRAM_TWO_SIDE, 0, true},
    {GL_MATRIX_MODE, 0, true},
    {GL_CLIENT_ACTIVE_TEXTURE, 0, true},
    {GL_SHADE_MODEL, 0, true},
    {GL_LIGHTING, 0, true},
    {GL_ATTRIB_STACK_DEPTH, 0, true},
    {GL_CLIENT_ATTRIB_STACK_DEPTH, 0, true},
};

// What has several binding points, and which of their values are read. An implementation may borrow any of them.
struct IndexedState {
  const char* what;
  GLenum limit;
  std::vector<GLenum> values;
};

const std::vector<IndexedState>& indexed_states() {
  static const std::vector<IndexedState> all = {
      {"uniform",
       GL_MAX_UNIFORM_BUFFER_BINDINGS,
       {GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE}},
      {"storage",
       GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS,
       {GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START, GL_SHADER_STORAGE_BUFFER_SIZE}},
      {"atomic counter",
       GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS,
       {GL_ATOMIC_COUNTER_BUFFER_BINDING, GL_ATOMIC_COUNTER_BUFFER_START, GL_ATOMIC_COUNTER_BUFFER_SIZE}},
      {"feedback",
       GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS,  // ES has no other limit
       {GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, GL_TRANSFORM_FEEDBACK_BUFFER_START, GL_TRANSFORM_FEEDBACK_BUFFER_SIZE}},
      {"image",
       GL_MAX_IMAGE_UNITS,
       {GL_IMAGE_BINDING_NAME, GL_IMAGE_BINDING_LEVEL, GL_IMAGE_BINDING_LAYER, GL_IMAGE_BINDING_ACCESS,
        GL_IMAGE_BINDING_FORMAT}},
      {"vertex buffer",
       GL_MAX_VERTEX_ATTRIB_BINDINGS,
       {GL_VERTEX_BINDING_BUFFER, GL_VERTEX_BINDING_OFFSET, GL_VERTEX_BINDING_STRIDE, GL_VERTEX_BINDING_DIVISOR}}};
  return all;
}

GLuint limit_of(GLenum name) {
  GLint limit = 0;
  gl.GetIntegerv(name, &limit);
  return static_cast<GLuint>(limit);
}

// Textures and samplers of all units, the active unit being left as it is.
void add_units(Values& values) {
  GLint active = 0;
  gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
  for (GLuint unit = 0; unit < limit_of(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS); ++unit) {
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    for (const GLenum name :
         {GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_2D_ARRAY, GL_TEXTURE_BINDING_BUFFER, GL_SAMPLER_BINDING}) {
      GLint value = -12345;
      gl.GetIntegerv(name, &value);
      values[fmt::format("texture unit {}", unit)].push_back(value);
    }
  }
  gl.ActiveTexture(static_cast<GLenum>(active));
}

Values state(const Test& t) {
  Values values;
  for (const Name& each : names) {
    if (each.version > (t.is_gles() ? 0 : t.version()) || (each.is_compat_only && !t.is_compat())) continue;
    std::vector<GLint> found(4, -12345);
    gl.GetIntegerv(each.name, found.data());
    values[std::to_string(each.name)] = found;
  }
  for (const IndexedState& each : indexed_states())
    for (GLuint i = 0; i < limit_of(each.limit); ++i)
      for (const GLenum query : each.values) {
        GLint value = -12345;
        gl.GetIntegeri_v(query, i, &value);
        values[fmt::format("{} binding {}", each.what, i)].push_back(value);
      }
  add_units(values);
  return values;
}

void expect_kept(Test& t, const Values& before, const std::string& what) {
  const Values after = state(t);
  for (const auto& [name, values] : before) {
    std::string text = what + ": state " + name;
    for (const GLint value : values) text += fmt::format(" {}", value);
    for (const GLint value : after.at(name)) text += fmt::format(", {}", value);
    t.expect(after.at(name) == values, text);
  }
  t.expect_no_error(what);
}

GLuint buffer_at(GLenum target) {
  const std::vector<unsigned char> zeros(4096);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, static_cast<GLsizeiptr>(zeros.size()), zeros.data(), GL_STATIC_DRAW);
  return buffer;
}

// Every texture unit has a texture and a sampler, and every image unit an image.
void occupy_units() {
  std::array<GLuint, 2> textures{};
  gl.GenTextures(2, textures.data());
  for (const GLuint texture : textures) {
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexStorage2D(GL_TEXTURE_2D, 2, GL_RGBA8, 4, 4);
  }
  for (GLuint unit = 0; unit < limit_of(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS); ++unit) {
    GLuint sampler = 0;
    gl.GenSamplers(1, &sampler);
    gl.BindSampler(unit, sampler);
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.BindTexture(GL_TEXTURE_2D, textures[unit % 2]);
  }
  for (GLuint unit = 0; unit < limit_of(GL_MAX_IMAGE_UNITS); ++unit)
    gl.BindImageTexture(unit, textures[unit % 2], static_cast<GLint>(unit % 2), GL_FALSE, 0, GL_READ_ONLY, GL_RGBA8);
}

// No value is an initial one, and no value has an effect on the draw.
void occupy(const Test& t) {
  for (const GLenum target :
       {GL_DRAW_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER, GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER})
    buffer_at(target);
  for (const auto& [target, limit] : {std::pair<GLenum, GLenum>{GL_UNIFORM_BUFFER, GL_MAX_UNIFORM_BUFFER_BINDINGS},
                                      {GL_SHADER_STORAGE_BUFFER, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS},
                                      {GL_ATOMIC_COUNTER_BUFFER, GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS}}) {
    for (GLuint i = 0; i < limit_of(limit); ++i) {
      const GLuint buffer = buffer_at(target);
      if (i % 2 == 0)
        gl.BindBufferRange(target, i, buffer, 256 * (i + 1), 512);
      else
        gl.BindBufferBase(target, i, buffer);
    }
    buffer_at(target);
  }
  occupy_units();
  GLuint feedback = 0;
  gl.GenTransformFeedbacks(1, &feedback);
  gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer_at(GL_TRANSFORM_FEEDBACK_BUFFER));
  buffer_at(GL_TRANSFORM_FEEDBACK_BUFFER);
  if (!t.is_gles() && t.version() >= 44) buffer_at(GL_QUERY_BUFFER);
  gl.Enable(GL_DEBUG_OUTPUT);
  gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_FRONT);
  gl.FrontFace(GL_CW);
  gl.ActiveTexture(GL_TEXTURE2);
  gl.Viewport(3, 5, 90, 80);
  gl.Enable(t.is_gles() ? GL_PRIMITIVE_RESTART_FIXED_INDEX : GL_PRIMITIVE_RESTART);
  if (t.is_gles()) return;
  gl.PrimitiveRestartIndex(7);
  gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
}

struct Way {
  const char* leaf;
  GLenum refinement;
  GLenum source;
  bool is_welded = false;
  GLenum capability = 0;  // enabled while it draws
  bool is_counted = false;
};

constexpr Way ways[] = {
    {"tags", GL_LINEAR_INPUTS_ARK, GL_DEPTH_TAG_ARK},
    {"uniform", GL_LINEAR_INPUTS_ARK, GL_UNIFORM_DEPTH_ARK},
    {"measured", GL_LINEAR_INPUTS_ARK, GL_MEASURED_DEPTH_ARK},
    {"outputs", GL_LINEAR_OUTPUTS_ARK, GL_DEPTH_TAG_ARK},
    {"welded", GL_CURVED_PN_ARK, GL_DEPTH_TAG_ARK, true},
    {"tagged_pn", GL_SCALAR_TAGGED_PN_ARK, GL_DEPTH_TAG_ARK},
    {"discarded", GL_LINEAR_INPUTS_ARK, GL_DEPTH_TAG_ARK, false, GL_RASTERIZER_DISCARD},
    {"discarded_counted", GL_LINEAR_INPUTS_ARK, GL_DEPTH_TAG_ARK, false, GL_RASTERIZER_DISCARD, true},
    {"discarded_counted_uniform", GL_LINEAR_INPUTS_ARK, GL_UNIFORM_DEPTH_ARK, false, GL_RASTERIZER_DISCARD, true},
};

void set_way(const Way& way) {
  refine_by_tags(3, way.refinement);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(way.source));
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 6);
  gl.ARKParameteriARK(GL_WELD_ARK, way.is_welded ? GL_TRUE : GL_FALSE);
  gl.Disable(GL_ARK);
  if (way.capability != 0) gl.Enable(way.capability);
}

// The first draw builds its programs and buffers, later draws find them, and a draw that repeats often may find its
// vertices. Each draw has to leave state alone.
void expect_draws_keep(Test& t, const Way& way, const std::function<void()>& draw) {
  const Values before = state(t);
  t.expect_equal(before.at(std::to_string(GL_DEBUG_OUTPUT))[0], 1, "DEBUG_OUTPUT, which the set-up enables");
  for (const char* const which : {"the first draw", "the second draw", "the third draw", "a draw that repeats"}) {
    if (which == std::string("a draw that repeats")) repeat_often(draw);
    GLuint query = 0;
    if (way.is_counted) {
      gl.GenQueries(1, &query);
      gl.BeginQuery(GL_PRIMITIVES_GENERATED, query);
    }
    draw();
    if (way.is_counted) gl.EndQuery(GL_PRIMITIVES_GENERATED);
    expect_kept(t, before, which);
  }
}

Mesh tagged_mesh() {
  Mesh mesh = bent_mesh();
  for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i].tag = static_cast<float>((2 * i + 1) % 4);
  return mesh;
}

void check_way(Test& t, const Way& way, bool has_elements) {
  gl.UseProgram(surface_program(t));
  upload(tagged_mesh());
  const GLubyte indices[] = {0, 1, 2, 7, 5, 3, 4};
  buffer_at(GL_ELEMENT_ARRAY_BUFFER);
  gl.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, sizeof(indices), indices);
  set_way(way);
  occupy(t);
  t.expect_no_error("set-up");
  expect_draws_keep(t, way, [has_elements] {
    if (has_elements)
      gl.DrawARPElementsARK(GL_TRIANGLE_STRIP, 7, GL_UNSIGNED_BYTE, nullptr);
    else
      gl.DrawARP(GL_TRIANGLES, 0, 6);
  });
}

// Two-sided lighting with a separate specular colour. The colour sum has what the program asked for: nothing.
void check_fixed_function(Test& t, GLenum source, GLenum mode) {
  const GLfloat specular[] = {0.6F, 0.5F, 0.4F, 1};
  for (const GLenum capability : {GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE}) gl.Enable(static_cast<GLenum>(capability));
  gl.Lightfv(GL_LIGHT0, GL_SPECULAR, specular);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 12);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  const Mesh mesh = tagged_mesh();
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);
  gl.VertexPointer(4, GL_FLOAT, sizeof(MeshVertex), &mesh[0].position);
  gl.NormalPointer(GL_FLOAT, sizeof(MeshVertex), &mesh[0].normal);
  const Way way{.leaf = "", .refinement = GL_LINEAR_INPUTS_ARK, .source = source};
  set_way(way);
  gl.ARKParameteriARK(GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK);
  gl.DepthTag1i(2);
  occupy(t);
  t.expect_no_error("set-up");
  expect_draws_keep(t, way, [mode] { gl.DrawARP(mode, 0, 4); });
}

// Faces in different modes, edge flags, attenuated points, and texture coordinates of a unit that is not the active
// one.
void check_drawn_modes(Test& t, GLenum source, bool is_front_lines) {
  const GLfloat attenuation[] = {1, 0.5F, 0};
  const Mesh mesh = tagged_mesh();
  buffer_at(GL_ARRAY_BUFFER);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.size() * sizeof(MeshVertex)), mesh.data(),
                GL_STATIC_DRAW);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(4, GL_FLOAT, sizeof(MeshVertex), nullptr);
  for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE1}) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.ActiveTexture(unit);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.Enable(GL_TEXTURE_2D);
    gl.ClientActiveTexture(unit);
    gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.TexCoordPointer(2, GL_FLOAT, sizeof(MeshVertex), reinterpret_cast<const void*>(offsetof(MeshVertex, texture)));
  }
  gl.ClientActiveTexture(GL_TEXTURE2);
  gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  gl.PolygonMode(GL_FRONT, is_front_lines ? GL_LINE : GL_POINT);
  gl.PolygonMode(GL_BACK, is_front_lines ? GL_FILL : GL_LINE);
  gl.EdgeFlag(GL_FALSE);
  const Way way{.leaf = "", .refinement = GL_LINEAR_INPUTS_ARK, .source = source};
  set_way(way);
  gl.DepthTag1i(2);
  occupy(t);
  gl.Disable(GL_PRIMITIVE_RESTART);  // an implementation may look less closely at such a draw
  t.expect_no_error("set-up");
  expect_draws_keep(t, way, [] { gl.DrawARP(GL_TRIANGLE_STRIP, 0, 5); });
}

}  // namespace

Cases restored_state_cases() {
  Cases cases;
  const char* const wrong =
      "A program, a buffer, a range of a binding, a transform feedback object or a capability keeps the value that the "
      "refinement needed.";
  for (const Way& way : ways)
    for (const bool has_elements : {false, true})
      cases.push_back({.name = std::string("ark.draw.keeps.") + (has_elements ? "elements." : "arrays.") + way.leaf,
                       .clauses = {has_elements ? "10.R.2-8" : "10.R.2-6", "11.R.10-2"},
                       .plan = "Give bindings and capabilities values other than the initial ones, draw many times in "
                               "this way, and read all of them after the first draws and the last.",
                       .wrong = wrong,
                       .check = [way, has_elements](Test& t) { check_way(t, way, has_elements); }});
  for (const auto& [leaf, source, mode] :
       {std::tuple<const char*, GLenum, GLenum>{"uniform", GL_UNIFORM_DEPTH_ARK, GL_TRIANGLE_STRIP},
        {"tags", GL_DEPTH_TAG_ARK, GL_TRIANGLE_STRIP},
        {"quads", GL_UNIFORM_DEPTH_ARK, GL_QUADS}})
    cases.push_back({.name = std::string("ark.draw.keeps.fixed_function.") + leaf,
                     .clauses = {"10.R.2-6", "11.R.10-2"},
                     .plan = "The same with two-sided lighting and a separate specular colour.",
                     .wrong = wrong,
                     .apis = compat_only,
                     .check = [source = source, mode = mode](Test& t) { check_fixed_function(t, source, mode); }});
  for (const bool is_front_lines : {true, false})
    cases.push_back({.name = std::string("ark.draw.keeps.fixed_function.") + (is_front_lines ? "lines" : "points"),
                     .clauses = {"10.R.2-6", "11.R.10-2"},
                     .plan = "The same with polygon modes that differ by face, an edge flag of FALSE, attenuated "
                             "points and arrays of texture coordinates.",
                     .wrong = "Both faces have one mode; the edge flag is TRUE; another unit is active.",
                     .apis = compat_only,
                     .check = [is_front_lines](Test& t) {
                       check_drawn_modes(t, is_front_lines ? GL_UNIFORM_DEPTH_ARK : GL_DEPTH_TAG_ARK, is_front_lines);
                     }});
  return cases;
}

}  // namespace glark::conformance
