// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Generated scenes: disabled refinement changes nothing, linear refinement is invisible, closed meshes stay closed, and
// no state changes.
#include <fmt/core.h>
#include <cmath>
#include <map>

#include "conformance/cases/cases.h"
#include "conformance/reference/raster.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

constexpr int seeds = 6;

Mesh random_mesh(Test& t) {
  Mesh mesh(3 * static_cast<std::size_t>(t.random_int(3, 9)));
  for (MeshVertex& vertex : mesh) {
    vertex.position = {t.random_float(-0.95F, 0.95F), t.random_float(-0.95F, 0.95F), t.random_float(-0.9F, 0.9F), 1};
    const float w = t.random_float(0.7F, 1.6F);
    for (float& component : vertex.position) component *= w;
    vertex.colour = {t.random_float(0, 1), t.random_float(0, 1), t.random_float(0, 1), t.random_float(0.3F, 1)};
    vertex.normal = {t.random_float(-1, 1), t.random_float(-1, 1), t.random_float(-1, 1)};
    vertex.tag = static_cast<float>(t.random_int(0, 5));
  }
  number_triangles(mesh);
  return mesh;
}

void random_state(Test& t) {
  const auto flip = [&](GLenum cap) { t.random_int(0, 1) != 0 ? gl.Enable(cap) : gl.Disable(cap); };
  flip(GL_DEPTH_TEST);
  flip(GL_CULL_FACE);
  flip(GL_SCISSOR_TEST);
  flip(GL_STENCIL_TEST);
  gl.Scissor(t.random_int(0, 30), t.random_int(0, 30), t.random_int(60, 120), t.random_int(60, 120));
  gl.StencilFunc(GL_GEQUAL, 1, 0xff);
  gl.StencilOp(GL_KEEP, GL_REPLACE, GL_REPLACE);
  gl.FrontFace(t.random_int(0, 1) != 0 ? GL_CW : GL_CCW);
  gl.DepthFunc(t.random_int(0, 1) != 0 ? GL_LESS : GL_GREATER);
  gl.ColorMask(GL_TRUE, t.random_int(0, 3) != 0, GL_TRUE, GL_TRUE);
}

Picture picture_of(GLsizei count) {
  gl.Disable(GL_SCISSOR_TEST);
  clear_surface();
  gl.DrawArrays(GL_TRIANGLES, 0, count);
  return read_picture(surface_size, surface_size);
}

// Counts pixels that differ and lie farther than a subpixel step from every edge of the coarse mesh. Where triangles
// overlap at nearly the same depth, either may win. In these scenes, depths differ by more than the rounding.
void expect_same_inside(Test& t, const Mesh& mesh, const Picture& actual, const Picture& expected, const char* what) {
  reference::Raster raster(surface_size, surface_size, 0.25);
  for (std::size_t i = 0; i + 2 < mesh.size(); i += 3)
    raster.triangle({mesh[i].position, {}}, {mesh[i + 1].position, {}}, {mesh[i + 2].position, {}});
  int different = 0;
  for (int y = 0; y < surface_size; ++y)
    for (int x = 0; x < surface_size; ++x) {
      const auto a = actual.at(x, y);
      const auto e = expected.at(x, y);
      bool is_same = true;
      for (std::size_t k = 0; k < 4; ++k) is_same = is_same && std::abs(a[k] - e[k]) <= 2;
      different += is_same || raster.is_uncertain(x, y) ? 0 : 1;
    }
  // Where two triangles pierce each other, depth decides, and rounding may change it.
  if (t.expect(different <= 8, fmt::format("{}: {} pixels differ", what, different))) return;
  t.attach("expected", expected);
  t.attach("actual", actual);
}

struct Scene {
  Mesh mesh;
  Picture unrefined;

  GLsizei count() const { return static_cast<GLsizei>(mesh.size()); }
};

// Leaves ARK disabled.
Scene set_up_random_scene(Test& t) {
  gl.UseProgram(colour_program(t));
  Scene scene{random_mesh(t), {}};
  upload(scene.mesh);
  random_state(t);
  gl.Disable(GL_ARK);
  scene.unrefined = picture_of(scene.count());
  return scene;
}

void check_invisible(Test& t, GLenum refinement, bool is_uniform) {
  for (int round = 0; round < 3; ++round) {
    const Scene scene = set_up_random_scene(t);
    if (is_uniform)
      refine_uniformly(static_cast<GLuint>(t.random_int(1, 4)), refinement);
    else
      refine_by_tags(5, refinement);
    expect_same_inside(t, scene.mesh, picture_of(scene.count()), scene.unrefined, "refined and unrefined");
  }
}

void check_identity(Test& t) {
  for (int round = 0; round < 4; ++round) {
    const Scene scene = set_up_random_scene(t);
    refine_by_tags(5, GL_CURVED_PN_ARK);
    picture_of(scene.count());
    gl.Disable(GL_ARK);
    t.expect_same_picture(picture_of(scene.count()), scene.unrefined, "ARK disabled");
    refine_uniformly(4);
    gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 0);
    t.expect_same_picture(picture_of(scene.count()), scene.unrefined, "a depth of 0");
  }
}

// An octahedron. Each corner has one tag and one normal.
Mesh octahedron() {
  const Vec3 corners[6] = {{0.7F, 0.1F, 0},  {-0.8F, 0, 0.1F}, {0, 0.75F, -0.1F},
                           {0.1F, -0.7F, 0}, {0, 0.1F, 0.8F},  {0.1F, 0, -0.7F}};
  const int faces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  Mesh mesh;
  for (const auto& face : faces)
    for (const int i : face) {
      MeshVertex vertex;
      const auto at = static_cast<std::size_t>(i);
      vertex.position = {corners[at][0], corners[at][1], corners[at][2], 1};
      vertex.normal = corners[at];
      vertex.tag = static_cast<float>((i * 3 + 1) % 6);
      mesh.push_back(vertex);
    }
  number_triangles(mesh);
  return mesh;
}

GLuint turned_program(Test& t, GLint& angle) {
  const GLuint program = build_program(
      t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal; uniform vec2 angle; "
                    "out vec4 colour;\n"
                    "void main() { float c = cos(angle.x); float s = sin(angle.x); float e = cos(angle.y); float f = "
                    "sin(angle.y);\n"
                    "  vec3 p = position.xyz; p = vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);\n"
                    "  p = vec3(p.x, e * p.y - f * p.z, f * p.y + e * p.z);\n"
                    "  colour = vec4(0.0625) + vec4(normal * 1.0e-9, 0.0); gl_Position = vec4(p * 0.9, 1.0); }\n"});
  angle = gl.GetUniformLocation(program, "angle");
  return program;
}

// Every line of sight enters a closed surface as often as it leaves: front and back faces cover each pixel equally
// often.
void check_closed(Test& t, GLenum refinement, bool is_welded) {
  GLint angle = -1;
  gl.UseProgram(turned_program(t, angle));
  Mesh mesh = octahedron();
  // Each face has its own normals: only welding keeps the surface closed.
  for (std::size_t i = 0; is_welded && i < mesh.size(); ++i) mesh[i].normal[i / 3 % 3] += 0.8F;
  upload(mesh);
  refine_by_tags(5, refinement);
  gl.ARKParameteriARK(GL_WELD_ARK, is_welded ? GL_TRUE : GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  gl.Enable(GL_CULL_FACE);
  for (int view = 0; view < 7; ++view) {
    gl.Uniform2f(angle, 0.37F + 0.9F * static_cast<float>(view), 0.21F + 0.55F * static_cast<float>(view));
    gl.CullFace(GL_BACK);
    const Picture front = picture_of(static_cast<GLsizei>(mesh.size()));
    gl.CullFace(GL_FRONT);
    const Picture back = picture_of(static_cast<GLsizei>(mesh.size()));
    t.expect(front.at(surface_size / 2, surface_size / 2)[0] > 0, "the mesh is drawn");
    if (!t.expect_same_picture(back, front, fmt::format("front and back faces, view {}", view))) return;
  }
}

struct Snapshot {
  std::map<GLenum, std::vector<GLint>> values;
};

// State that a refined draw could change. Values of 1 to 4 integers each.
Snapshot snapshot(const Test& t) {
  std::vector<GLenum> names = {GL_CURRENT_PROGRAM,
                               GL_VERTEX_ARRAY_BINDING,
                               GL_ARRAY_BUFFER_BINDING,
                               GL_ELEMENT_ARRAY_BUFFER_BINDING,
                               GL_DRAW_INDIRECT_BUFFER_BINDING,
                               GL_UNIFORM_BUFFER_BINDING,
                               GL_SHADER_STORAGE_BUFFER_BINDING,
                               GL_COPY_READ_BUFFER_BINDING,
                               GL_COPY_WRITE_BUFFER_BINDING,
                               GL_PIXEL_PACK_BUFFER_BINDING,
                               GL_PIXEL_UNPACK_BUFFER_BINDING,
                               GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
                               GL_TRANSFORM_FEEDBACK_BINDING,
                               GL_DISPATCH_INDIRECT_BUFFER_BINDING,
                               GL_ATOMIC_COUNTER_BUFFER_BINDING,
                               GL_ACTIVE_TEXTURE,
                               GL_TEXTURE_BINDING_2D,
                               GL_SAMPLER_BINDING,
                               GL_DRAW_FRAMEBUFFER_BINDING,
                               GL_READ_FRAMEBUFFER_BINDING,
                               GL_RENDERBUFFER_BINDING,
                               GL_PROGRAM_PIPELINE_BINDING,
                               GL_VIEWPORT,
                               GL_SCISSOR_BOX,
                               GL_COLOR_WRITEMASK,
                               GL_DEPTH_WRITEMASK,
                               GL_DEPTH_TEST,
                               GL_BLEND,
                               GL_CULL_FACE,
                               GL_RASTERIZER_DISCARD,
                               GL_STENCIL_TEST,
                               GL_SCISSOR_TEST,
                               GL_POLYGON_OFFSET_FILL,
                               GL_PRIMITIVE_RESTART_FIXED_INDEX,
                               GL_FRONT_FACE,
                               GL_CULL_FACE_MODE,
                               GL_DEPTH_FUNC,
                               GL_UNPACK_ALIGNMENT,
                               GL_PACK_ALIGNMENT,
                               GL_PATCH_VERTICES,
                               GL_ARK,
                               GL_POOL_LEVEL_ARK,
                               GL_REFINEMENT_ARK,
                               GL_DEPTH_SOURCE_ARK,
                               GL_UNIFORM_DEPTH_LEVEL_ARK,
                               GL_DEPTH_TAG_ARRAY_ARK,
                               GL_CURRENT_DEPTH_TAG_ARK};
  if (!t.is_gles())
    for (const GLenum name : {GL_PRIMITIVE_RESTART, GL_PRIMITIVE_RESTART_INDEX, GL_POLYGON_MODE, GL_PROVOKING_VERTEX,
                              GL_PROGRAM_POINT_SIZE, GL_CLIP_DISTANCE0})
      names.push_back(static_cast<GLenum>(name));
  if (t.is_compat())
    for (const GLenum name : {GL_MATRIX_MODE, GL_CLIENT_ACTIVE_TEXTURE, GL_VERTEX_ARRAY, GL_NORMAL_ARRAY,
                              GL_COLOR_ARRAY, GL_EDGE_FLAG, GL_SHADE_MODEL, GL_ATTRIB_STACK_DEPTH,
                              GL_CLIENT_ATTRIB_STACK_DEPTH, GL_VERTEX_PROGRAM_TWO_SIDE, GL_COLOR_SUM})
      names.push_back(static_cast<GLenum>(name));
  Snapshot result;
  for (const GLenum name : names) {
    std::vector<GLint> values(8, -12345);
    gl.GetIntegerv(name, values.data());
    result.values[name] = values;
  }
  for (GLuint i = 0; i < 4; ++i)
    for (const GLenum name :
         {GL_UNIFORM_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_BINDING, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING}) {
      GLint value = -1;
      gl.GetIntegeri_v(name, i, &value);
      result.values[name].push_back(value);
    }
  for (GLuint i = 0; i < 16; ++i)
    for (const GLenum name :
         {GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_SIZE, GL_VERTEX_ATTRIB_ARRAY_STRIDE,
          GL_VERTEX_ATTRIB_ARRAY_TYPE, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, GL_VERTEX_ATTRIB_ARRAY_DIVISOR}) {
      GLint value = -1;
      gl.GetVertexAttribiv(i, name, &value);
      result.values[name].push_back(value);
    }
  while (gl.GetError() != GL_NO_ERROR) {
  }
  return result;
}

struct Kind {
  const char* leaf;
  GLenum refinement;
  bool is_uniform;
  bool is_welded;
  bool is_measured;
  bool is_displaced;
};

void check_state(Test& t, const Kind& kind) {
  const GLuint program = surface_program(t);
  gl.UseProgram(program);
  Mesh mesh = bent_mesh();
  for (std::size_t i = 0; i < mesh.size(); ++i) mesh[i].tag = static_cast<float>(i % 4);
  upload(mesh);
  GLuint buffers[8];
  gl.GenBuffers(8, buffers);
  const GLenum targets[] = {GL_UNIFORM_BUFFER,    GL_SHADER_STORAGE_BUFFER,    GL_COPY_READ_BUFFER,
                            GL_COPY_WRITE_BUFFER, GL_DISPATCH_INDIRECT_BUFFER, GL_ATOMIC_COUNTER_BUFFER};
  for (std::size_t i = 0; i < 6; ++i) {
    gl.BindBuffer(targets[i], buffers[i]);
    gl.BufferData(targets[i], 256, nullptr, GL_STATIC_DRAW);
  }
  for (GLuint i = 0; i < 4; ++i) gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, i, buffers[1]);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, 1, buffers[0]);
  gl.ActiveTexture(GL_TEXTURE2);
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_FRONT);
  gl.Viewport(3, 5, 90, 80);
  if (kind.is_uniform)
    refine_uniformly(3, kind.refinement);
  else
    refine_by_tags(4, kind.refinement);
  if (kind.is_welded) gl.ARKParameteriARK(GL_WELD_ARK, GL_TRUE);
  if (kind.is_measured) gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_MEASURED_DEPTH_ARK);
  if (kind.is_displaced) gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, 4);
  const Snapshot before = snapshot(t);
  gl.DrawArrays(GL_TRIANGLES, 0, 6);
  gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 5, 2);
  t.expect_no_error("refined draws");
  const Snapshot after = snapshot(t);
  for (const auto& [name, values] : before.values)
    t.expect(after.values.at(name) == values, fmt::format("state {:#x} has the value it had before", name));
}

}  // namespace

Cases scenes_cases() {
  Cases cases;
  for (int seed = 0; seed < seeds; ++seed) {
    const std::string end = fmt::format(".{}", seed);
    for (const bool is_uniform : {false, true})
      for (const GLenum refinement : {GL_LINEAR_INPUTS_ARK, GL_LINEAR_OUTPUTS_ARK})
        cases.push_back({.name = std::string("ark.scenes.invisible.") +
                                 (refinement == GL_LINEAR_INPUTS_ARK ? "inputs." : "outputs.") +
                                 (is_uniform ? "uniform" : "tags") + end,
                         .clauses = {"11.R.6-14"},
                         .plan = "Random triangles in random state with a linear vertex stage: the refined picture is "
                                 "the unrefined one, except for pixels within a quarter of a pixel of an edge.",
                         .wrong = "A missing triangle, a wrong corner, no perspective.",
                         .check = [refinement, is_uniform](Test& t) { check_invisible(t, refinement, is_uniform); }});
    cases.push_back(
        {.name = "ark.scenes.identity" + end,
         .clauses = {"11.R.11-8", "11.R.1-12"},
         .plan =
             "Random triangles in random state: with ARK disabled again, or with a depth of 0, the bits are the same.",
         .wrong = "State of a refined draw remains.",
         .check = check_identity});
  }
  const std::pair<const char*, GLenum> refinements[] = {{"inputs", GL_LINEAR_INPUTS_ARK},
                                                        {"outputs", GL_LINEAR_OUTPUTS_ARK},
                                                        {"curved", GL_CURVED_PN_ARK},
                                                        {"tagged", GL_SCALAR_TAGGED_PN_ARK}};
  for (const auto& [leaf, refinement] : refinements)
    cases.push_back(
        {.name = std::string("ark.scenes.closed.") + leaf,
         .clauses = {"11.R.8-3", "overview-4"},
         .plan = "A closed mesh with a tag at each corner, from seven directions: front and back faces "
                 "cover each pixel equally often.",
         .wrong = "A crack of one ulp, a T-junction, a missing triangle, or one with the wrong orientation.",
         .check = [refinement = refinement](Test& t) { check_closed(t, refinement, false); }});
  cases.push_back({.name = "ark.scenes.closed.welded",
                   .clauses = {"11.R.15-3"},
                   .plan = "The same with separate normals for each face, welded.",
                   .wrong = "Seams open.",
                   .check = [](Test& t) { check_closed(t, GL_CURVED_PN_ARK, true); }});
  for (const Kind& kind : {Kind{"inputs_uniform", GL_LINEAR_INPUTS_ARK, true, false, false, false},
                           {"inputs_tags", GL_LINEAR_INPUTS_ARK, false, false, false, false},
                           {"outputs_tags", GL_LINEAR_OUTPUTS_ARK, false, false, false, false},
                           {"curved_welded", GL_CURVED_PN_ARK, false, true, false, false},
                           {"tagged", GL_SCALAR_TAGGED_PN_ARK, true, false, false, false},
                           {"measured", GL_LINEAR_INPUTS_ARK, false, false, true, false},
                           {"displaced", GL_LINEAR_INPUTS_ARK, true, false, false, true}})
    cases.push_back({.name = std::string("ark.scenes.state.") + kind.leaf,
                     .clauses = {"11.R.10-2"},
                     .plan = "Read all state that could change before and after refined draws of this kind.",
                     .wrong = "A binding, an array or a parameter keeps the value that the refined draw needed.",
                     .check = [kind](Test& t) { check_state(t, kind); }});
  return cases;
}

}  // namespace glark::conformance
