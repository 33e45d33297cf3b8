// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The GLSL of an assembly program computes what the driver computes from the program itself. Each test draws a program
// both ways into a picture of floats.
#include <gtest/gtest.h>

#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
// The prototypes come first.
#include <GL/glext.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "glark/core/refine/assembly/translate.h"

namespace glark::refine::assembly {
namespace {

using Color = std::array<GLfloat, 4>;

template <typename Function>
Function proc(const char* name, Function /*type*/) {
  return reinterpret_cast<Function>(OSMesaGetProcAddress(name));
}
#define GL_CALL(name) proc(#name, &::name)

class AssemblyValues : public testing::Test {
 public:
  AssemblyValues(const AssemblyValues&) = delete;
  AssemblyValues& operator=(const AssemblyValues&) = delete;

 protected:
  AssemblyValues() {
    const std::array<int, 5> attributes{OSMESA_FORMAT, OSMESA_RGBA, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
    window_ = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    OSMesaMakeCurrent(window_, pixels_.data(), GL_UNSIGNED_BYTE, side, side);
    GLuint texture = 0;
    GLuint framebuffer = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, side, side, 0, GL_RGBA, GL_FLOAT, nullptr);
    GL_CALL(glGenFramebuffers)(1, &framebuffer);
    GL_CALL(glBindFramebuffer)(GL_FRAMEBUFFER, framebuffer);
    GL_CALL(glFramebufferTexture2D)(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    GL_CALL(glClampColor)(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
    GL_CALL(glClampColor)(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    glBindTexture(GL_TEXTURE_2D, 0);
  }
  ~AssemblyValues() override { OSMesaDestroyContext(window_); }

  // The result of the fragment program, or the colour.
  static Color draw() {
    glClearColor(-7, -7, -7, -7);
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    for (const std::array<GLfloat, 2> corner : {std::array{-1.0F, -1.0F}, {3.0F, -1.0F}, {-1.0F, 3.0F}}) {
      glVertex2f(corner[0], corner[1]);
    }
    glEnd();
    Color color{};
    glReadPixels(side / 2, side / 2, 1, 1, GL_RGBA, GL_FLOAT, color.data());
    return color;
  }

  // Makes a new program each time: Mesa 25 crashes if the text of a program is replaced (tests/drivers/crashes.c).
  static void load(GLenum target, const std::string& text) {
    GLuint program = 0;
    GL_CALL(glGenProgramsARB)(1, &program);
    GL_CALL(glBindProgramARB)(target, program);
    GL_CALL(glProgramStringARB)(target, GL_PROGRAM_FORMAT_ASCII_ARB, static_cast<GLsizei>(text.size()), text.data());
    ASSERT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << glGetString(GL_PROGRAM_ERROR_STRING_ARB) << "\n" << text;
  }

  static Color draw_translated(const std::string& text) {
    const Translation translation = translate(text, false);
    EXPECT_TRUE(translation.ok) << translation.error << "\n" << text;
    const GLuint shader = GL_CALL(glCreateShader)(GL_VERTEX_SHADER);
    const GLuint program = GL_CALL(glCreateProgram)();
    const char* const source = translation.source.c_str();
    GL_CALL(glShaderSource)(shader, 1, &source, nullptr);
    GL_CALL(glCompileShader)(shader);
    GL_CALL(glAttachShader)(program, shader);
    GL_CALL(glLinkProgram)(program);
    GLint linked = 0;
    GL_CALL(glGetProgramiv)(program, GL_LINK_STATUS, &linked);
    EXPECT_EQ(linked, GL_TRUE) << translation.source;
    GL_CALL(glUseProgram)(program);
    const auto [first, count] = translation.local;
    for (int i = first; i < first + count; ++i) {
      Color value{};
      GL_CALL(glGetProgramLocalParameterfvARB)(GL_VERTEX_PROGRAM_ARB, static_cast<GLuint>(i), value.data());
      const std::string name = std::string(local_uniform) + "[" + std::to_string(i - first) + "]";
      GL_CALL(glUniform4fv)(GL_CALL(glGetUniformLocation)(program, name.c_str()), 1, value.data());
    }
    const Color color = draw();
    GL_CALL(glUseProgram)(0);
    GL_CALL(glDeleteProgram)(program);
    GL_CALL(glDeleteShader)(shader);
    return color;
  }

  static bool close(const Color& a, const Color& b) {
    for (std::size_t i = 0; i < 4; ++i) {
      const bool same = a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])) ||
                        std::abs(a[i] - b[i]) <= 1e-5F * std::max(std::abs(a[i]), std::abs(b[i])) + 1e-6F;
      if (!same) return false;
    }
    return true;
  }

  static void expect_same(const std::string& body) {
    const std::string text = "!!ARBvp1.0\n" + body + "END\n";
    load(GL_VERTEX_PROGRAM_ARB, text);
    glEnable(GL_VERTEX_PROGRAM_ARB);
    const Color plain = draw();
    const Color translated = draw_translated(text);
    glDisable(GL_VERTEX_PROGRAM_ARB);
    EXPECT_NE(plain, (Color{-7, -7, -7, -7})) << "nothing is drawn: " << body;
    EXPECT_TRUE(close(plain, translated)) << body << testing::PrintToString(plain) << "\n"
                                          << testing::PrintToString(translated);
  }
  static void expect_same_color(const std::string& instruction) {
    expect_same("MOV result.position, vertex.position;\nTEMP r, s;\nADDRESS A;\n" + instruction + "\n");
  }

  static constexpr int side = 4;
  std::vector<GLubyte> pixels_ = std::vector<GLubyte>(side * side * 4);
  OSMesaContext window_ = nullptr;
};

constexpr std::array<Color, 7> operands{{{0.5F, -1.25F, 3, 2},
                                         {-2.5F, 0.75F, 0.125F, -1},
                                         {4, 4, -4, 200},
                                         {0, 1, -0.5F, 0},
                                         {1e-3F, 0.3F, -1e3F, -200},
                                         {7.9F, -7.9F, 1, 0.5F},
                                         {-0.25F, 0, 0, 3}}};

TEST_F(AssemblyValues, EveryInstruction) {
  const std::vector<std::string> instructions = {
      "ABS result.color, vertex.attrib[1];",
      "ADD result.color, vertex.attrib[1], vertex.attrib[2];",
      "DP3 result.color, vertex.attrib[1], vertex.attrib[2];",
      "DP4 result.color, vertex.attrib[1], vertex.attrib[2];",
      "DPH result.color, vertex.attrib[1], vertex.attrib[2];",
      "DST result.color, vertex.attrib[1], vertex.attrib[2];",
      "EX2 result.color, vertex.attrib[1].x;",
      "EXP result.color, vertex.attrib[1].x;",
      "FLR result.color, vertex.attrib[1];",
      "FRC result.color, vertex.attrib[1];",
      "ABS r, vertex.attrib[1]; ADD r, r, 0.01; LG2 result.color, r.y;",
      "LOG result.color, -vertex.attrib[2].z;",
      "LIT result.color, vertex.attrib[1];",
      "LIT result.color.yz, vertex.attrib[2].yxzw; MOV result.color.xw, 0;",
      "MAD result.color, vertex.attrib[1], -vertex.attrib[2], vertex.attrib[2].y;",
      "MAX result.color, vertex.attrib[1], vertex.attrib[2];",
      "MIN result.color, vertex.attrib[1], vertex.attrib[2];",
      "MOV result.color, -vertex.attrib[1].wzyx;",
      "MUL result.color, vertex.attrib[1], vertex.attrib[2];",
      "ABS r, vertex.attrib[1]; ADD r, r, 0.01; POW result.color, r.x, vertex.attrib[2].y;",
      "RCP result.color, vertex.attrib[1].x;",
      "RSQ result.color, vertex.attrib[1].x;",
      "SGE result.color, vertex.attrib[1], vertex.attrib[2];",
      "SLT result.color, vertex.attrib[1], vertex.attrib[2];",
      "SUB result.color, vertex.attrib[1], vertex.attrib[2];",
      "SWZ result.color, vertex.attrib[1], -y, 1, 0, z;",
      "XPD result.color, vertex.attrib[1], vertex.attrib[2];",
      "MOV r, vertex.attrib[1]; XPD r, r, vertex.attrib[2]; MOV result.color.xyz, r; MOV result.color.w, 1;"};
  for (const std::string& instruction : instructions) {
    for (std::size_t i = 0; i < operands.size(); ++i) {
      GL_CALL(glVertexAttrib4fv)(1, operands[i].data());
      GL_CALL(glVertexAttrib4fv)(2, operands[(i + 3) % operands.size()].data());
      expect_same_color(instruction);
    }
  }
}

TEST_F(AssemblyValues, RelativeAddresses) {
  for (GLuint i = 0; i < 12; ++i) {
    const auto value = static_cast<GLfloat>(i);
    GL_CALL(glProgramLocalParameter4fARB)(GL_VERTEX_PROGRAM_ARB, i, value, value / 2, -value, 1);
  }
  for (const GLfloat index : {-1.5F, 0.0F, 0.99F, 2.0F}) {
    GL_CALL(glVertexAttrib4f)(1, index, 0, 0, 0);
    expect_same_color(
        "PARAM p[] = { program.local[3..9] };\nARL A.x, vertex.attrib[1].x;\nMOV result.color, p[A.x + 2];");
    expect_same_color(
        "PARAM p[] = { {1}, {2}, {3}, {4}, {5} };\nARL A.x, vertex.attrib[1].x;\nMOV result.color, p[A.x + 2].xxyw;");
    expect_same_color(
        "PARAM p[] = { {1}, program.local[4], state.matrix.mvp, program.local[7], {5} };\n"
        "ARL A.x, vertex.attrib[1].x;\nMOV result.color, p[A.x + 2];");
  }
}

void set_light(GLenum light, GLfloat seed) {
  const auto set = [&](GLenum name, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
    const Color value{x + seed, y + seed, z + seed, w};
    glLightfv(light, name, value.data());
  };
  set(GL_AMBIENT, 0.1F, 0.2F, 0.3F, 0.4F);
  set(GL_DIFFUSE, 0.5F, 0.6F, 0.7F, 0.8F);
  set(GL_SPECULAR, 0.9F, 0.15F, 0.25F, 0.35F);
  set(GL_POSITION, 1, 2, 3, 0);
  set(GL_SPOT_DIRECTION, 0.2F, 0.3F, -1, 0);
  glLightf(light, GL_SPOT_CUTOFF, 30 + seed);
  glLightf(light, GL_SPOT_EXPONENT, 3 + seed);
  glLightf(light, GL_CONSTANT_ATTENUATION, 1 + seed);
  glLightf(light, GL_LINEAR_ATTENUATION, 0.5F + seed);
  glLightf(light, GL_QUADRATIC_ATTENUATION, 0.25F + seed);
}

void set_material(GLenum face, GLfloat seed) {
  for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) {
    seed += 0.05F;
    const Color value{0.1F + seed, 0.2F + seed, 0.3F + seed, 0.4F + seed};
    glMaterialfv(face, name, value.data());
  }
  glMaterialf(face, GL_SHININESS, 12 + seed);
}

void set_texture_generation() {
  GLfloat seed = 0;
  for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE2}) {
    GL_CALL(glActiveTexture)(unit);
    for (const GLenum coordinate : {GL_S, GL_T, GL_R, GL_Q}) {
      for (const GLenum plane : {GL_EYE_PLANE, GL_OBJECT_PLANE}) {
        seed += 0.1F;
        const Color value{1 + seed, 2 + seed, 3 + seed, 4 + seed};
        glTexGenfv(coordinate, plane, value.data());
      }
    }
    glMatrixMode(GL_TEXTURE);
    glRotatef(20 + seed, 0.3F, 1, 0);
    glTranslatef(seed, 2, 3);
  }
  GL_CALL(glActiveTexture)(GL_TEXTURE0);
}

void set_matrices() {
  glMatrixMode(GL_PROJECTION);
  glFrustum(-1, 1.2, -0.8, 1, 1, 9);
  glMatrixMode(GL_MODELVIEW);
  glTranslatef(0.5F, 0.25F, -2);
  glRotatef(33, 1, 2, 3);
  glScalef(1, 1.5F, 0.75F);
}

void set_other_state() {
  const Color color{0.2F, 0.4F, 0.6F, 0.8F};
  glFogfv(GL_FOG_COLOR, color.data());
  glFogf(GL_FOG_DENSITY, 0.3F);
  glFogf(GL_FOG_START, 2);
  glFogf(GL_FOG_END, 7);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, color.data());
  const std::array<GLdouble, 4> plane{1, 2, 3, 4};
  glClipPlane(GL_CLIP_PLANE2, plane.data());
  const std::array<GLfloat, 3> attenuation{1, 0.5F, 0.25F};
  glPointSize(3);
  GL_CALL(glPointParameterfv)(GL_POINT_DISTANCE_ATTENUATION, attenuation.data());
  GL_CALL(glPointParameterf)(GL_POINT_SIZE_MIN, 2);
  GL_CALL(glPointParameterf)(GL_POINT_SIZE_MAX, 8);
  GL_CALL(glPointParameterf)(GL_POINT_FADE_THRESHOLD_SIZE, 1.5F);
}

TEST_F(AssemblyValues, EveryBinding) {
  set_matrices();
  set_light(GL_LIGHT0, 0);
  set_light(GL_LIGHT3, 0.5F);
  set_material(GL_FRONT, 0);
  set_material(GL_BACK, 0.4F);
  set_texture_generation();
  set_other_state();
  glNormal3f(0.3F, 0.4F, 0.5F);
  glColor4f(0.1F, 0.2F, 0.3F, 0.4F);
  GL_CALL(glSecondaryColor3f)(0.5F, 0.6F, 0.7F);
  GL_CALL(glFogCoordf)(2.5F);
  GL_CALL(glMultiTexCoord4f)(GL_TEXTURE0, 1, 2, 3, 4);
  GL_CALL(glMultiTexCoord3f)(GL_TEXTURE5, 5, 6, 7);
  std::vector<std::string> bindings = {"vertex.position",
                                       "vertex.normal",
                                       "vertex.color",
                                       "vertex.color.secondary",
                                       "vertex.fogcoord",
                                       "vertex.texcoord",
                                       "vertex.texcoord[5]",
                                       "state.material.front.shininess",
                                       "state.light[3].attenuation",
                                       "state.light[3].spot.direction",
                                       "state.light[0].half",
                                       "state.lightmodel.ambient",
                                       "state.lightmodel.scenecolor",
                                       "state.lightmodel.back.scenecolor",
                                       "state.fog.color",
                                       "state.fog.params",
                                       "state.clip[2].plane",
                                       "state.point.size",
                                       "state.point.attenuation"};
  for (const std::string value : {"ambient", "diffuse", "specular"}) {
    bindings.push_back("state.light[3]." + value);
    bindings.push_back("state.lightprod[3]." + value);
    bindings.push_back("state.lightprod[0].back." + value);
    bindings.push_back("state.material." + value);
    bindings.push_back("state.material.back." + value);
  }
  for (const std::string coordinate : {"s", "t", "r", "q"}) {
    bindings.push_back("state.texgen[2].eye." + coordinate);
    bindings.push_back("state.texgen.object." + coordinate);
  }
  for (const std::string matrix : {"modelview", "modelview[0]", "projection", "mvp", "texture", "texture[2]"}) {
    for (const std::string change : {"", ".inverse", ".transpose", ".invtrans"}) {
      bindings.push_back("state.matrix." + matrix + change + ".row[1]");
    }
  }
  for (const std::string& binding : bindings) expect_same_color("MOV result.color, " + binding + ";");
}

TEST_F(AssemblyValues, EveryResult) {
  GL_CALL(glVertexAttrib4f)(1, 0.25F, 0.5F, 0.75F, 2);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  const std::vector<std::array<std::string, 2>> results = {{"color", "color"},
                                                           {"color.primary", "color.primary"},
                                                           {"color.front.secondary", "color.secondary"},
                                                           {"texcoord", "texcoord"},
                                                           {"texcoord[6]", "texcoord[6]"},
                                                           {"fogcoord", "fogcoord.x"},
                                                           {"texcoord[1].xz", "texcoord[1].xyzw"}};
  for (const auto& [written, read] : results) {
    load(GL_FRAGMENT_PROGRAM_ARB, "!!ARBfp1.0\nMOV result.color, fragment." + read + ";\nEND\n");
    expect_same_color("MOV result." + written + ", vertex.attrib[1];");
  }
}

}  // namespace
}  // namespace glark::refine::assembly
