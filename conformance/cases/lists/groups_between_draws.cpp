// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// PushAttrib, a change and PopAttrib between draws that repeat: for every attribute group, directly and by lists.
#include <fmt/core.h>

#include <cstddef>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/expect_change.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

constexpr GLfloat group_black[] = {0, 0, 0, 1};
constexpr GLfloat group_blue[] = {0.1F, 0.3F, 1, 1};
constexpr GLuint push_list = 21;
constexpr GLuint pop_list = 22;

struct GroupChange {
  const char* leaf;
  GLbitfield group;
  void (*change)();
  void (*prepare)() = [] {};  // before the first draw
};

GLuint group_texture(std::uint32_t salt) {
  std::array<GLubyte, 64> texels{};
  for (std::uint32_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<GLubyte>(64 + (i * 37 + salt * 91) % 190);
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  return name;
}

constexpr GLuint first_group_texture = 1, second_group_texture = 2;  // the names that GenTextures gives first

constexpr GroupChange group_changes[] = {
    {"current_color", GL_CURRENT_BIT, [] { gl.Color4f(0.1F, 0.3F, 1, 1); }, [] { gl.Disable(GL_LIGHTING); }},
    {"current_normal", GL_CURRENT_BIT, [] { gl.Normal3f(0.9F, 0, 0.1F); }},
    {"current_texture", GL_CURRENT_BIT, [] { gl.TexCoord2f(0.6F, 0.9F); }},
    {"enable_lighting", GL_ENABLE_BIT, [] { gl.Disable(GL_LIGHTING); }},
    {"enable_texture", GL_ENABLE_BIT, [] { gl.Disable(GL_TEXTURE_2D); }},
    {"enable_fog", GL_ENABLE_BIT, [] { gl.Enable(GL_FOG); }},
    {"enable_cull", GL_ENABLE_BIT, [] { gl.Enable(GL_CULL_FACE); }},
    {"enable_clip", GL_ENABLE_BIT, [] { gl.Enable(GL_CLIP_PLANE0); }},
    {"enable_scissor", GL_ENABLE_BIT, [] { gl.Enable(GL_SCISSOR_TEST); }},
    {"enable_generated", GL_ENABLE_BIT, [] { gl.Enable(GL_TEXTURE_GEN_S); }},
    {"enable_normalize", GL_ENABLE_BIT, [] { gl.Enable(GL_NORMALIZE); }},
    {"lighting_material", GL_LIGHTING_BIT,
     [] { gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, group_blue); }},
    {"lighting_shininess", GL_LIGHTING_BIT, [] { gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 90); }},
    {"lighting_light", GL_LIGHTING_BIT, [] { gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, group_blue); }},
    {"lighting_position", GL_LIGHTING_BIT,
     [] {
       const GLfloat side[] = {1, 0.1F, 0.1F, 0};
       gl.Lightfv(GL_LIGHT0, GL_POSITION, side);
     }},
    {"lighting_model", GL_LIGHTING_BIT, [] { gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, group_blue); }},
    {"lighting_enable", GL_LIGHTING_BIT, [] { gl.Disable(GL_LIGHTING); }},
    // Not with ENABLE_BIT: Mesa 22.3 does not restore LIGHTi then, without the extension, too.
    {"lighting_light0", GL_LIGHTING_BIT, [] { gl.Disable(GL_LIGHT0); }},
    {"lighting_color_material", GL_LIGHTING_BIT,
     [] {
       gl.ColorMaterial(GL_FRONT_AND_BACK, GL_EMISSION);
       gl.Enable(GL_COLOR_MATERIAL);
     }},
    {"transform_clip", GL_TRANSFORM_BIT,
     [] {
       const GLdouble plane[] = {0, 1, 0, 0};
       gl.ClipPlane(GL_CLIP_PLANE0, plane);
       gl.Enable(GL_CLIP_PLANE0);
     }},
    {"transform_normalize", GL_TRANSFORM_BIT, [] { gl.Enable(GL_NORMALIZE); }},
    {"fog", GL_FOG_BIT,
     [] {
       gl.Fogfv(GL_FOG_COLOR, group_blue);
       gl.Fogi(GL_FOG_MODE, GL_EXP);
       gl.Enable(GL_FOG);
     }},
    {"polygon_cull", GL_POLYGON_BIT,
     [] {
       gl.CullFace(GL_FRONT);
       gl.Enable(GL_CULL_FACE);
     }},
    {"polygon_front", GL_POLYGON_BIT,
     [] {
       gl.CullFace(GL_BACK);
       gl.FrontFace(GL_CW);
       gl.Enable(GL_CULL_FACE);
     }},
    {"polygon_mode", GL_POLYGON_BIT, [] { gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT); }},
    {"viewport", GL_VIEWPORT_BIT, [] { gl.Viewport(10, 20, 40, 50); }},
    {"texture_binding", GL_TEXTURE_BIT, [] { gl.BindTexture(GL_TEXTURE_2D, second_group_texture); }},
    {"texture_environment", GL_TEXTURE_BIT, [] { gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE); }},
    {"texture_wrap", GL_TEXTURE_BIT,
     [] {
       gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, group_black);
       gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
     }},
    {"texture_generated", GL_TEXTURE_BIT,
     [] {
       const GLfloat plane[] = {0.2F, 0.9F, 0.4F, 0.1F};
       gl.TexGenfv(GL_S, GL_OBJECT_PLANE, plane);
       gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
       gl.Enable(GL_TEXTURE_GEN_S);
     }},
    {"scissor", GL_SCISSOR_BIT,
     [] {
       gl.Scissor(0, 0, 50, 70);
       gl.Enable(GL_SCISSOR_TEST);
     }},
    {"depth", GL_DEPTH_BUFFER_BIT,
     [] {
       gl.DepthFunc(GL_NEVER);
       gl.Enable(GL_DEPTH_TEST);
     }},
    {"stencil", GL_STENCIL_BUFFER_BIT,
     [] {
       gl.StencilFunc(GL_NEVER, 1, 1);
       gl.Enable(GL_STENCIL_TEST);
     }},
    {"color_mask", GL_COLOR_BUFFER_BIT, [] { gl.ColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE); }},
    {"color_blend", GL_COLOR_BUFFER_BIT,
     [] {
       gl.BlendFunc(GL_DST_COLOR, GL_ZERO);
       gl.Enable(GL_BLEND);
     }},
};

// A lit, textured triangle with an array of positions and of tags. All its other values are current ones.
void set_up_group_draw() {
  for (std::uint32_t salt = 2; salt > 0; --salt) group_texture(3 - salt);
  gl.BindTexture(GL_TEXTURE_2D, first_group_texture);
  for (const GLenum capability : {GL_LIGHTING, GL_LIGHT0, GL_TEXTURE_2D, GL_COLOR_MATERIAL})
    gl.Enable(static_cast<GLenum>(capability));
  const GLfloat towards[] = {0.2F, 0.3F, 1, 0};
  const GLfloat specular[] = {0.4F, 0.4F, 0.4F, 1};
  const GLdouble plane[] = {1, 0.25, 0, 0};
  gl.Lightfv(GL_LIGHT0, GL_POSITION, towards);
  gl.Lightfv(GL_LIGHT0, GL_SPECULAR, specular);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 3);
  gl.Disable(GL_COLOR_MATERIAL);
  gl.ClipPlane(GL_CLIP_PLANE0, plane);
  gl.CullFace(GL_FRONT);
  gl.Scissor(0, 0, 60, 64);
  gl.Fogi(GL_FOG_MODE, GL_EXP);
  gl.Color4f(1, 0.75F, 0.25F, 1);
  gl.Normal3f(0.1F, 0.2F, 0.6F);
  gl.TexCoord2f(1.1F, 0.1F);
  gl.PointSize(1);
  gl.Viewport(0, 0, surface_size, surface_size);
}

void point_at_group_mesh(bool has_tags) {
  const Mesh mesh = one_triangle({2, 2, 2});
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.size() * sizeof(MeshVertex)), mesh.data(),
                GL_STATIC_DRAW);
  gl.VertexPointer(4, GL_FLOAT, sizeof(MeshVertex), reinterpret_cast<const void*>(offsetof(MeshVertex, position)));
  gl.EnableClientState(GL_VERTEX_ARRAY);
  if (!has_tags) return;
  gl.DepthTagPointerARK(GL_FLOAT, sizeof(MeshVertex), reinterpret_cast<const void*>(offsetof(MeshVertex, tag)));
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
}

void draw_group() {
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.Begin(GL_TRIANGLES);
  gl.Vertex3f(0.6F, 0.2F, 0.1F);  // all z are positive: fog depends on their absolute value
  gl.Vertex3f(0.95F, 0.3F, 0.2F);
  gl.Vertex3f(0.7F, 0.9F, 0.3F);
  gl.End();
}

// Not picture_of(), which sets the viewport. Nor do this by an attribute group: the case is about these.
Picture picture_of_group() {
  GLboolean mask[4] = {};
  gl.GetBooleanv(GL_COLOR_WRITEMASK, mask);
  const bool has_scissor = gl.IsEnabled(GL_SCISSOR_TEST) == GL_TRUE;
  if (has_scissor) gl.Disable(GL_SCISSOR_TEST);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.ColorMask(mask[0], mask[1], mask[2], mask[3]);
  if (has_scissor) gl.Enable(GL_SCISSOR_TEST);
  draw_group();
  return read_picture(surface_size, surface_size);
}

// The unrefined picture, which several refined draws have to give.
Picture expect_group(Test& t, const std::string& what) {
  std::vector<Picture> refined;
  refined.push_back(picture_of_group());
  repeat_often(draw_group);
  for (int again = 0; again < 2; ++again) refined.push_back(picture_of_group());
  gl.Disable(GL_ARK);
  Picture plain = picture_of_group();
  gl.Enable(GL_ARK);
  for (int again = 0; again < 2; ++again) draw_group();
  for (const Picture& picture : refined) t.expect_same_picture(picture, plain, what, 4, 80);
  return plain;
}

enum class GroupWay { direct, listed, all_groups };

GLbitfield group_of(const GroupChange& change, GroupWay way) {
  return way == GroupWay::all_groups ? GLbitfield{GL_ALL_ATTRIB_BITS} : change.group;
}

// Without the extension, PopAttrib restores what the change has changed.
void control_group(Test& t, const GroupChange& change, GroupWay way) {
  set_up_group_draw();
  change.prepare();
  point_at_group_mesh(false);
  const Picture before = picture_of_group();
  gl.PushAttrib(group_of(change, way));
  change.change();
  t.expect(count_different(before, picture_of_group(), 6) > 100, "the change shows");
  gl.PopAttrib();
  t.expect_same_picture(picture_of_group(), before, "PopAttrib restores the picture");
}

void check_group(Test& t, const GroupChange& change, GroupWay way, GLenum source) {
  set_up_group_draw();
  change.prepare();
  point_at_group_mesh(true);
  refine_by_tags(3);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, static_cast<GLint>(source));
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 2);
  gl.ARKParameteriARK(GL_EDGE_PIXELS_ARK, 10);
  const auto push_and_change = [&] {
    gl.PushAttrib(group_of(change, way));
    change.change();
  };
  gl.NewList(push_list, GL_COMPILE);
  push_and_change();
  gl.EndList();
  gl.NewList(pop_list, GL_COMPILE);
  gl.PopAttrib();
  gl.EndList();
  const Picture before = expect_group(t, "before PushAttrib");
  const GLuint triangles = count_generated(draw_group);
  for (int round = 0; round < 2; ++round) {
    way == GroupWay::listed ? gl.CallList(push_list) : push_and_change();
    const Picture between = expect_group(t, "between PushAttrib and PopAttrib");
    t.expect(count_different(before, between, 6) > 100, "the change shows");
    way == GroupWay::listed ? gl.CallList(pop_list) : gl.PopAttrib();
    const Picture after = expect_group(t, "after PopAttrib");
    t.expect_same_picture(after, before, "without refinement, PopAttrib restores the picture");
    t.expect_equal(count_generated(draw_group), triangles, "refined triangles after PopAttrib");
  }
  t.expect_no_error("the groups");
}

}  // namespace

Cases groups_between_draws_cases() {
  Cases cases;
  for (const GroupChange& change : group_changes)
    for (const auto& [leaf, way, source] :
         {std::tuple<const char*, GroupWay, GLenum>{"direct", GroupWay::direct, GL_DEPTH_TAG_ARK},
          {"listed", GroupWay::listed, GL_UNIFORM_DEPTH_ARK},
          {"all", GroupWay::all_groups, GL_MEASURED_DEPTH_ARK}})
      cases.push_back(
          {.name = fmt::format("ark.group.again.{}.{}", change.leaf, leaf),
           .clauses = {"10.R.2-1", "11.R.10-1"},
           .plan = "Repeat draws, push a group, change a state of it, repeat them, pop and repeat them.",
           .wrong = "After PopAttrib, draws have the state in between.",
           .apis = compat_only,
           .control = [&change, way = way](Test& t) { control_group(t, change, way); },
           .check = [&change, way = way, source = source](Test& t) { check_group(t, change, way, source); }});
  return cases;
}

}  // namespace glark::conformance
