// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/support/state.h"

#include <fmt/core.h>
#include <algorithm>
#include <cstring>

namespace glark::conformance {

const std::vector<StateName>& extension_state() {
  using enum StateKind;
  static const std::vector<StateName> all{
      {"ark", GL_ARK, boolean, "state-1", "tokens-2"},
      {"max_depth", GL_MAX_DEPTH_ARK, integer, "limits-1", "tokens-4"},
      {"pool_level", GL_POOL_LEVEL_ARK, integer, "state-2", "tokens-5"},
      {"current_depth_tag", GL_CURRENT_DEPTH_TAG_ARK, integer, "state-3", "tokens-6"},
      {"depth_tag_attribute", GL_DEPTH_TAG_ATTRIBUTE_ARK, integer, "state-4", "tokens-15"},
      {"refinement", GL_REFINEMENT_ARK, integer, "state-5", "tokens-16"},
      {"depth_source", GL_DEPTH_SOURCE_ARK, integer, "state-6", "tokens-17"},
      {"uniform_depth_level", GL_UNIFORM_DEPTH_LEVEL_ARK, integer, "state-7", "tokens-18"},
      {"polygon_split", GL_POLYGON_SPLIT_ARK, integer, "state-8", "tokens-19"},
      {"pattern_interior", GL_PATTERN_INTERIOR_ARK, integer, "state-9", "tokens-20"},
      {"edge_pixels", GL_EDGE_PIXELS_ARK, integer, "state-10", "tokens-21"},
      {"edge_degrees", GL_EDGE_DEGREES_ARK, integer, "state-11", "tokens-22"},
      {"triangle_budget", GL_TRIANGLE_BUDGET_ARK, integer, "state-12", "tokens-23"},
      {"discontinuity_attribute", GL_DISCONTINUITY_ATTRIBUTE_ARK, integer, "state-13", "tokens-24"},
      {"scalar_tag_attribute", GL_SCALAR_TAG_ATTRIBUTE_ARK, integer, "state-14", "tokens-25"},
      {"displacement_unit", GL_DISPLACEMENT_UNIT_ARK, integer, "state-15", "tokens-26"},
      {"displacement_channel", GL_DISPLACEMENT_CHANNEL_ARK, integer, "state-16", "tokens-27"},
      {"displacement_coordinate", GL_DISPLACEMENT_COORDINATE_ARK, integer, "state-17", "tokens-28"},
      {"displacement_scale", GL_DISPLACEMENT_SCALE_ARK, number, "state-18", "tokens-30"},
      {"displacement_bias", GL_DISPLACEMENT_BIAS_ARK, number, "state-19", "tokens-31"},
      {"geomorph", GL_GEOMORPH_ARK, boolean, "state-20", "tokens-32"},
      {"weld", GL_WELD_ARK, boolean, "state-21", "tokens-33"},
      {"phong_shape", GL_PHONG_SHAPE_ARK, number, "state-32", "tokens-53"},
      {"screen_error", GL_SCREEN_ERROR_ARK, number, "state-33", "tokens-55"},
      {"depth_tag_array", GL_DEPTH_TAG_ARRAY_ARK, boolean, "state-23", "tokens-11"},
      {"depth_tag_array_type", GL_DEPTH_TAG_ARRAY_TYPE_ARK, integer, "state-24", "tokens-7"},
      {"depth_tag_array_stride", GL_DEPTH_TAG_ARRAY_STRIDE_ARK, integer, "state-25", "tokens-8"},
      {"depth_tag_array_buffer_binding", GL_DEPTH_TAG_ARRAY_BUFFER_BINDING_ARK, integer, "state-26", "tokens-9"},
  };
  return all;
}

GLint integer_of(GLenum name) {
  GLint value = -77777;
  gl.GetIntegerv(name, &value);
  return value;
}

GLfloat number_of(GLenum name) {
  GLfloat value = -77777;
  gl.GetFloatv(name, &value);
  return value;
}

const void* pointer_of(GLenum name) {
  void* value = &value;
  gl.GetPointerv(name, &value);
  return value;
}

std::vector<float> current_value(GLuint attribute) {
  std::vector<float> value(4, -77777.0F);
  gl.GetVertexAttribfv(attribute, GL_CURRENT_VERTEX_ATTRIB, value.data());
  return value;
}

GLint array_state(GLuint attribute, GLenum name) {
  GLint value = -77777;
  gl.GetVertexAttribiv(attribute, name, &value);
  return value;
}

EverythingSet set_everything(Test& t) {
  EverythingSet objects;
  gl.ARKinit(5);
  for (const auto& [name, value] : std::initializer_list<std::pair<GLenum, GLint>>{
           {GL_DEPTH_TAG_ATTRIBUTE_ARK, 7},
           {GL_REFINEMENT_ARK, GL_CURVED_PN_ARK},
           {GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK},
           {GL_UNIFORM_DEPTH_LEVEL_ARK, 4},
           {GL_POLYGON_SPLIT_ARK, GL_POLYGON_CENTROID_ARK},
           {GL_PATTERN_INTERIOR_ARK, GL_SMOOTH_INTERIOR_ARK},
           {GL_EDGE_PIXELS_ARK, 12},
           {GL_EDGE_DEGREES_ARK, 30},
           {GL_TRIANGLE_BUDGET_ARK, 1000},
           {GL_DISCONTINUITY_ATTRIBUTE_ARK, 6},
           {GL_SCALAR_TAG_ATTRIBUTE_ARK, 5},
           {GL_DISPLACEMENT_UNIT_ARK, 2},
           {GL_DISPLACEMENT_CHANNEL_ARK, GL_BLUE},
           {GL_DISPLACEMENT_COORDINATE_ARK, 4},
           {GL_GEOMORPH_ARK, GL_TRUE},
           {GL_WELD_ARK, GL_TRUE},
       })
    gl.ARKParameteriARK(name, value);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 2.625F);
  gl.ARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, -0.75F);
  gl.ARKParameterfARK(GL_PHONG_SHAPE_ARK, 0.25F);
  gl.ARKParameterfARK(GL_SCREEN_ERROR_ARK, 1.625F);
  gl.DepthTag1i(3);
  gl.Enable(GL_ARK);
  gl.GenVertexArrays(1, &objects.array);
  gl.BindVertexArray(objects.array);
  gl.GenBuffers(1, &objects.buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, objects.buffer);
  const std::vector<unsigned char> zeros(256);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(zeros.size()), zeros.data(), GL_STATIC_DRAW);
  gl.DepthTagPointerARK(GL_UNSIGNED_SHORT, 6, reinterpret_cast<const void*>(std::size_t{4}));
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  t.expect_no_error("setting every state");
  return objects;
}

namespace {

void add_attributes(Snapshot& snapshot) {
  const auto attributes = static_cast<GLuint>(integer_of(GL_MAX_VERTEX_ATTRIBS));
  GLint profile = 0;
  gl.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  while (gl.GetError() != GL_NO_ERROR) {
  }
  for (GLuint i = (profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0 ? 1 : 0; i < attributes; ++i) {
    const std::string attribute = fmt::format("attribute {}", i);
    for (const float component : current_value(i)) snapshot[attribute + " value"] += as_text(component) + " ";
    for (const GLenum name :
         {GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_SIZE, GL_VERTEX_ATTRIB_ARRAY_STRIDE,
          GL_VERTEX_ATTRIB_ARRAY_TYPE, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, GL_VERTEX_ATTRIB_ARRAY_INTEGER,
          GL_VERTEX_ATTRIB_ARRAY_DIVISOR, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, GL_VERTEX_ATTRIB_BINDING,
          GL_VERTEX_ATTRIB_RELATIVE_OFFSET})
      snapshot[attribute + " array"] += as_text(array_state(i, static_cast<GLenum>(name))) + " ";
    void* pointer = nullptr;
    gl.GetVertexAttribPointerv(i, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
    snapshot[attribute + " pointer"] = as_text(static_cast<const void*>(pointer));
  }
}

void add_refinement_shader(Snapshot& snapshot, GLuint program) {
  GLint length = -1;
  gl.GetRefinementivARK(program, GL_REFINEMENT_SOURCE_LENGTH_ARK, &length);
  snapshot["source length"] = as_text(length);
  gl.GetRefinementivARK(program, GL_REFINEMENT_LOG_LENGTH_ARK, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  gl.GetRefinementInfoLogARK(program, length, nullptr, log.data());
  log.resize(std::strlen(log.data()));
  snapshot["log"] = log;
}

}  // namespace

Snapshot take_snapshot(Test& t, GLuint program) {
  Snapshot snapshot;
  for (const StateName& state : extension_state())
    snapshot[state.leaf] =
        state.kind == StateKind::number ? as_text(number_of(state.name)) : as_text(integer_of(state.name));
  snapshot["IsEnabled(ARK)"] = as_text(gl.IsEnabled(GL_ARK) == GL_TRUE);
  snapshot["IsEnabled(DEPTH_TAG_ARRAY_ARK)"] = as_text(gl.IsEnabled(GL_DEPTH_TAG_ARRAY_ARK) == GL_TRUE);
  snapshot["depth_tag_array_pointer"] = as_text(pointer_of(GL_DEPTH_TAG_ARRAY_POINTER_ARK));
  for (const GLenum name : {GL_ARRAY_BUFFER_BINDING, GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING,
                            GL_CURRENT_PROGRAM, GL_ACTIVE_TEXTURE})
    snapshot[fmt::format("binding {}", name)] = as_text(integer_of(static_cast<GLenum>(name)));
  add_attributes(snapshot);
  if (program != 0 || t.is_compat()) add_refinement_shader(snapshot, program);
  t.expect_no_error("reading every state");
  return snapshot;
}

bool expect_unchanged(Test& t, const Snapshot& after, const Snapshot& before, const std::string& what) {
  std::string differences;
  for (const auto& [name, value] : before)
    if (after.at(name) != value) differences += "; " + name + " was " + value + ", is " + after.at(name);
  return t.expect(differences.empty(), what + ": state has changed" + differences);
}

void expect_refused(Test& t, GLenum error, const std::string& what, const std::function<void()>& call, GLuint program) {
  const Snapshot before = take_snapshot(t, program);
  call();
  t.expect_error(error, what);
  t.expect_no_error(what + ": one error only");
  expect_unchanged(t, take_snapshot(t, program), before, what);
}

}  // namespace glark::conformance
