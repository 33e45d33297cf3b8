// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <array>

#include "conformance/cases/lists/compiled_states.h"
#include "conformance/support/program.h"

namespace glark::conformance {
namespace {

constexpr GLfloat state_places[] = {-0.9F, -0.8F, 0, -0.7F, -0.5F, 0.8F, 0.1F, -0.8F, 0.4F, 0.9F, 0.9F, -0.6F};
constexpr GLfloat state_colours[] = {1,    0.2F, 0.1F, 0.1F, 1,    0.3F, 0.4F, 0.1F, 1,
                                     0.9F, 0.9F, 0.1F, 0.1F, 0.8F, 0.9F, 0.9F, 0.2F, 0.9F};
constexpr GLfloat red[] = {0.9F, 0.2F, 0.1F, 1};
constexpr GLfloat blue[] = {0.1F, 0.3F, 0.9F, 1};
constexpr GLfloat dim[] = {0.3F, 0.3F, 0.2F, 1};
constexpr GLuint first_texture = 1, second_texture = 2;  // the names that GenTextures gives first
// A matrix that turns, as OpenGL and as its transpose.
constexpr GLfloat turn[] = {0.6F, 0.5F, 0, 0, -0.5F, 0.6F, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
constexpr GLdouble turn_in_double[] = {0.6, 0.5, 0, 0, -0.5, 0.6, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

GLuint tinted_program = 0;  // reads a uniform and a generic attribute
GLuint other_program = 0;
GLint tint_location = 0;

void make_texture(GLubyte salt) {
  std::array<GLubyte, 16> texels{};
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<GLubyte>(90 + (i * 61 + salt * 83U) % 160);
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void use_tinted() { gl.UseProgram(tinted_program); }
void unlit() { gl.Disable(GL_LIGHTING); }
void coloured() {
  unlit();
  gl.ColorPointer(3, GL_FLOAT, 0, state_colours);
  gl.EnableClientState(GL_COLOR_ARRAY);
}
void cull_none() { gl.CullFace(GL_FRONT); }
void enable_culling() {
  gl.CullFace(GL_FRONT);
  gl.Enable(GL_CULL_FACE);
}
void fogged() {
  gl.Fogfv(GL_FOG_COLOR, blue);
  gl.Fogi(GL_FOG_MODE, GL_LINEAR);
  gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  gl.FogCoordf(0.5F);
  gl.Enable(GL_FOG);
}
void in_depth() { gl.Enable(GL_DEPTH_TEST); }

std::vector<CompiledState> enabled_states() {
  return {
      {"enable_rasterizer_discard", [] { gl.Enable(GL_RASTERIZER_DISCARD); }, [] {}, false},
      {"enable_cull_face", [] { gl.Enable(GL_CULL_FACE); }, cull_none},
      {"disable_cull_face", [] { gl.Disable(GL_CULL_FACE); }, enable_culling},
      {"enable_scissor", [] { gl.Enable(GL_SCISSOR_TEST); }},
      {"enable_clip_plane", [] { gl.Enable(GL_CLIP_PLANE0); }},
      {"enable_blend", [] { gl.Enable(GL_BLEND); }, [] { gl.BlendFunc(GL_DST_COLOR, GL_ZERO); }},
      {"enablei_blend", [] { gl.Enablei(GL_BLEND, 0); }, [] { gl.BlendFunc(GL_DST_COLOR, GL_ZERO); }},
      {"disablei_blend", [] { gl.Disablei(GL_BLEND, 0); },
       [] {
         gl.BlendFunc(GL_DST_COLOR, GL_ZERO);
         gl.Enable(GL_BLEND);
       }},
      {"enable_depth_test", [] { gl.Enable(GL_DEPTH_TEST); }, [] { gl.DepthFunc(GL_GREATER); }},
      {"enable_stencil_test", [] { gl.Enable(GL_STENCIL_TEST); }, [] { gl.StencilFunc(GL_NEVER, 1, 1); }},
      {"enable_alpha_test", [] { gl.Enable(GL_ALPHA_TEST); }, [] { gl.AlphaFunc(GL_NEVER, 0); }},
      {"enable_logic_op", [] { gl.Enable(GL_COLOR_LOGIC_OP); }, [] { gl.LogicOp(GL_INVERT); }},
      {"enable_fog", [] { gl.Enable(GL_FOG); },
       [] {
         fogged();
         gl.Disable(GL_FOG);
       }},
      {"disable_lighting", [] { gl.Disable(GL_LIGHTING); }},
      {"disable_light", [] { gl.Disable(GL_LIGHT0); }},
      {"disable_texture", [] { gl.Disable(GL_TEXTURE_2D); }},
      {"enable_texture_generation", [] { gl.Enable(GL_TEXTURE_GEN_S); }},
      {"enable_normalize", [] { gl.Enable(GL_NORMALIZE); }, [] { gl.Normal3f(0.2F, 0.1F, 0.4F); }},
      {"enable_color_material", [] { gl.Enable(GL_COLOR_MATERIAL); }},
      {"enable_color_sum", [] { gl.Enable(GL_COLOR_SUM); },
       [] {
         unlit();
         gl.SecondaryColor3f(0.5F, 0, 0.2F);
       }},
      {"enable_point_smooth", [] { gl.Enable(GL_POINT_SMOOTH); }, [] {}, false},
      {"enable_polygon_offset", [] { gl.Enable(GL_POLYGON_OFFSET_FILL); },
       [] {
         gl.PolygonOffset(0, 60000);
         gl.DepthFunc(GL_LESS);
         gl.ClearDepth(0.5005);
         in_depth();
       },
       false},
  };
}

std::vector<CompiledState> raster_states() {
  return {
      {"cull_face", [] { gl.CullFace(GL_BACK); }, enable_culling},
      {"cull_face_both", [] { gl.CullFace(GL_FRONT_AND_BACK); }, enable_culling},
      {"front_face", [] { gl.FrontFace(GL_CW); }, enable_culling},
      {"front_face_lit", [] { gl.FrontFace(GL_CW); }},
      {"polygon_mode", [] { gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL); },
       [] {
         gl.PointSize(4);
         gl.PolygonMode(GL_BACK, GL_FILL);
       },
       false},
      {"shade_model", [] { gl.ShadeModel(GL_FLAT); }, coloured},
      {"provoking_vertex", [] { gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION); },
       [] {
         coloured();
         gl.ShadeModel(GL_FLAT);
       }},
      {"viewport", [] { gl.Viewport(10, 20, 60, 70); }},
      {"viewport_indexed", [] { gl.ViewportIndexedf(0, 10, 20, 60, 70); }},
      {"viewport_indexed_vector",
       [] {
         const GLfloat all[] = {5, 10, 70, 60};
         gl.ViewportIndexedfv(0, all);
       }},
      {"viewport_array",
       [] {
         const GLfloat all[] = {5, 10, 70, 60};
         gl.ViewportArrayv(0, 1, all);
       }},
      {"scissor", [] { gl.Scissor(30, 30, 10, 10); },
       [] {
         gl.Scissor(0, 0, 256, 256);  // a context without a window begins with an empty one
         gl.Enable(GL_SCISSOR_TEST);
       }},
      {"depth_func", [] { gl.DepthFunc(GL_NEVER); }, in_depth},
      {"depth_mask", [] { gl.DepthMask(GL_FALSE); }, in_depth, false},
      {"depth_range", [] { gl.DepthRange(1, 1); }, in_depth},
      {"stencil_func", [] { gl.StencilFunc(GL_NEVER, 1, 1); }, [] { gl.Enable(GL_STENCIL_TEST); }},
      {"color_mask",
       [] {
         gl.ColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE);
         gl.Color4fv(blue);
       },
       unlit, true},
      {"color_mask_none",
       [] {
         gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
         gl.Color4fv(blue);
       },
       unlit, false},
      // Mesa 22.3 compiles it, and executes it only when the list is called.
      {"color_mask_indexed",
       [] {
         gl.ColorMaski(0, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
         gl.Color4fv(blue);
       },
       unlit, false, false},
      {"blend_func", [] { gl.BlendFunc(GL_ZERO, GL_ZERO); }, [] { gl.Enable(GL_BLEND); }},
      {"alpha_func", [] { gl.AlphaFunc(GL_NEVER, 0); }, [] { gl.Enable(GL_ALPHA_TEST); }},
      {"clip_plane",
       [] {
         const GLdouble plane[] = {0, 1, 0, 0};
         gl.ClipPlane(GL_CLIP_PLANE0, plane);
       },
       [] { gl.Enable(GL_CLIP_PLANE0); }},
      {"clamp_color", [] { gl.ClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE); }, [] {}, false},
  };
}

std::vector<CompiledState> lit_states() {
  return {
      {"material", [] { gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, blue); }},
      {"material_of_front", [] { gl.Materialfv(GL_FRONT, GL_EMISSION, blue); }},
      {"material_of_back", [] { gl.Materialfv(GL_BACK, GL_EMISSION, red); }},
      {"material_of_integers",
       [] {
         const GLint half[] = {1000000000, 0, 1500000000, 2147483647};
         gl.Materialiv(GL_FRONT_AND_BACK, GL_DIFFUSE, half);
       }},
      {"shininess", [] { gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 70); }},
      {"color_material",
       [] {
         gl.ColorMaterial(GL_FRONT_AND_BACK, GL_EMISSION);
         gl.Color4fv(red);
       },
       [] { gl.Enable(GL_COLOR_MATERIAL); }},
      {"light_colour", [] { gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, blue); }},
      {"light_position",
       [] {
         const GLfloat side[] = {1, 0.1F, 0.1F, 0};
         gl.Lightfv(GL_LIGHT0, GL_POSITION, side);
       }},
      {"light_model", [] { gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, red); }},
      {"two_sides", [] { gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 0); }},
      {"fog_colour", [] { gl.Fogfv(GL_FOG_COLOR, red); }, fogged},
      {"fog_mode", [] { gl.Fogi(GL_FOG_MODE, GL_EXP2); },
       [] {
         fogged();
         gl.FogCoordf(0.9F);
       }},
      {"fog_source", [] { gl.Fogi(GL_FOG_COORD_SRC, GL_FRAGMENT_DEPTH); },
       [] {
         fogged();
         gl.FogCoordf(0.9F);
       }},
      {"bound_texture", [] { gl.BindTexture(GL_TEXTURE_2D, second_texture); }},
      {"texture_environment", [] { gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE); }},
      {"texture_unit",
       [] {
         gl.ActiveTexture(GL_TEXTURE1);
         gl.BindTexture(GL_TEXTURE_2D, second_texture);
         gl.Enable(GL_TEXTURE_2D);
       }},
      {"texture_plane",
       [] {
         const GLfloat plane[] = {0.9F, 0.2F, 0, 0.1F};
         gl.TexGenfv(GL_S, GL_OBJECT_PLANE, plane);
       },
       [] { gl.Enable(GL_TEXTURE_GEN_S); }},
      {"texture_generation", [] { gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR); },
       [] {
         const GLfloat plane[] = {0, 0, 0, 0.1F};
         gl.TexGenfv(GL_S, GL_EYE_PLANE, plane);
         gl.Enable(GL_TEXTURE_GEN_S);
       }},
      {"texture_image",
       [] {
         const GLubyte texel[] = {40, 250, 90, 255};
         gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
       }},
  };
}

std::vector<CompiledState> matrix_states() {
  return {
      {"load_identity", [] { gl.LoadIdentity(); }, [] { gl.Scalef(0.5F, 0.5F, 1); }},
      {"load_matrix", [] { gl.LoadMatrixf(turn); }},
      {"load_matrix_of_doubles", [] { gl.LoadMatrixd(turn_in_double); }},
      {"load_transpose_matrix", [] { gl.LoadTransposeMatrixf(turn); }},
      {"mult_matrix", [] { gl.MultMatrixf(turn); }},
      {"mult_transpose_matrix", [] { gl.MultTransposeMatrixd(turn_in_double); }},
      {"translate", [] { gl.Translatef(0.3F, 0.2F, 0); }},
      {"scale", [] { gl.Scaled(0.5, 0.6, 1); }},
      {"rotate", [] { gl.Rotatef(40, 0, 0, 1); }},
      {"ortho", [] { gl.Ortho(-2, 2, -1.5, 1.5, -1, 1); }},
      {"frustum",
       [] {
         gl.Translatef(0, 0, -2);
         gl.Frustum(-1, 1, -1, 1, 1.5, 3);
         gl.Translatef(0, 0, -2);
       }},
      {"projection",
       [] {
         gl.MatrixMode(GL_PROJECTION);
         gl.Scalef(0.5F, 0.6F, 1);
         gl.MatrixMode(GL_MODELVIEW);
       }},
      {"texture_matrix",
       [] {
         gl.MatrixMode(GL_TEXTURE);
         gl.Translatef(0.5F, 0.5F, 0);
         gl.MatrixMode(GL_MODELVIEW);
       }},
      {"pop_matrix", [] { gl.PopMatrix(); },
       [] {
         gl.PushMatrix();
         gl.Scalef(0.5F, 0.5F, 1);
       }},
      {"push_and_pop_matrix",
       [] {
         gl.PushMatrix();
         gl.LoadMatrixf(turn);
         gl.PopMatrix();
       },
       [] {}, false},
  };
}

std::vector<CompiledState> current_states() {
  return {
      {"depth_tag", [] { gl.DepthTag1i(1); }, [] {}, false},
      {"color", [] { gl.Color4fv(blue); }, unlit},
      {"normal", [] { gl.Normal3f(0.7F, 0.2F, 0.3F); }},
      {"secondary_color", [] { gl.SecondaryColor3f(0.6F, 0, 0.4F); },
       [] {
         unlit();
         gl.Enable(GL_COLOR_SUM);
       }},
      {"fog_coordinate", [] { gl.FogCoordf(0.95F); }, fogged},
      {"texture_coordinate", [] { gl.TexCoord2f(0.8F, 0.2F); }},
      {"texture_coordinate_of_unit", [] { gl.MultiTexCoord2f(GL_TEXTURE1, 0.8F, 0.2F); },
       [] {
         gl.ActiveTexture(GL_TEXTURE1);
         gl.BindTexture(GL_TEXTURE_2D, second_texture);
         gl.Enable(GL_TEXTURE_2D);
         gl.ActiveTexture(GL_TEXTURE0);
       }},
      {"attribute", [] { gl.VertexAttrib4fv(at_extra, red); }, use_tinted},
      {"edge_flag", [] { gl.EdgeFlag(GL_FALSE); }, [] {}, false},
      {"pop_attributes", [] { gl.PopAttrib(); },
       [] {
         gl.PushAttrib(GL_ALL_ATTRIB_BITS);
         gl.Color4fv(blue);
         gl.Disable(GL_LIGHTING);
         gl.CullFace(GL_FRONT);
         gl.Enable(GL_CULL_FACE);
       }},
      {"push_attributes", [] { gl.PushAttrib(GL_ALL_ATTRIB_BITS); }, [] {}, false},
      {"use_program", [] { gl.UseProgram(other_program); }, use_tinted},
      {"use_no_program", [] { gl.UseProgram(0); }, use_tinted},
      {"use_first_program", [] { gl.UseProgram(tinted_program); }},
      {"uniform", [] { gl.Uniform4fv(tint_location, 1, red); }, use_tinted},
      {"program_uniform", [] { gl.ProgramUniform4fv(tinted_program, tint_location, 1, red); }, use_tinted},
  };
}

GLuint tinted(Test& t, const char* colour) {
  return build_program(
      t, {.vertex = std::string("uniform vec4 tint; layout(location = 6) in vec4 extra; out vec4 colour;\nvoid main() "
                                "{ colour = ") +
                    colour + "; gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n"});
}

}  // namespace

const std::vector<CompiledState>& compiled_states() {
  static const std::vector<CompiledState> all = [] {
    std::vector<CompiledState> joined;
    for (const auto& part : {enabled_states(), raster_states(), lit_states(), matrix_states(), current_states()})
      joined.insert(joined.end(), part.begin(), part.end());
    return joined;
  }();
  return all;
}

void set_up_state_triangles(Test& t) {
  tinted_program = tinted(t, "tint * extra");
  other_program = tinted(t, "(tint * extra).bgra");
  tint_location = gl.GetUniformLocation(tinted_program, "tint");
  for (const GLuint program : {other_program, tinted_program}) {
    gl.UseProgram(program);
    gl.Uniform4f(gl.GetUniformLocation(program, "tint"), 0.3F, 0.9F, 0.6F, 1);
  }
  gl.VertexAttrib4f(at_extra, 0.4F, 0.8F, 1, 1);
  gl.UseProgram(0);
  make_texture(1);
  make_texture(2);
  gl.BindTexture(GL_TEXTURE_2D, first_texture);
  gl.Enable(GL_TEXTURE_2D);
  const GLfloat towards[] = {0.2F, 0.3F, 1, 0};
  const GLfloat behind[] = {0.3F, -0.1F, -1, 0};
  const GLfloat object_plane[] = {0, 0, 0, 0.8F};
  const GLdouble clip[] = {1, 0.25, 0, 0};
  gl.Enable(GL_LIGHTING);
  for (const auto& [light, position] :
       {std::pair<GLenum, const GLfloat*>{GL_LIGHT0, towards}, std::pair<GLenum, const GLfloat*>{GL_LIGHT1, behind}}) {
    gl.Enable(light);
    gl.Lightfv(light, GL_POSITION, position);
    gl.Lightfv(light, GL_SPECULAR, dim);
    gl.Lightfv(light, GL_DIFFUSE, dim);
  }
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, dim);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 3);
  gl.Materialfv(GL_BACK, GL_EMISSION, dim);
  gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
  gl.TexGenfv(GL_S, GL_OBJECT_PLANE, object_plane);
  gl.ClipPlane(GL_CLIP_PLANE0, clip);
  gl.Scissor(0, 0, 60, 64);
  gl.Color4f(0.2F, 0.9F, 0.4F, 1);
  gl.Normal3f(0.1F, 0.2F, 0.9F);
  gl.TexCoord2f(0.2F, 0.7F);
  gl.VertexPointer(2, GL_FLOAT, 0, state_places);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.ARKinit(4);
  gl.DepthTag1i(2);
}

void draw_state_triangles() { gl.DrawArrays(GL_TRIANGLES, 0, 6); }

}  // namespace glark::conformance
