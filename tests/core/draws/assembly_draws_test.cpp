// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws with assembly vertex programs are refined without changing the picture, above every kind of fragment stage.
// Links the core without the shim: the hooks draw refined, and the driver's own functions draw the picture to compare
// with.
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "glark/core/context.h"
#include "glark/core/stages.h"
#include "glark/gl/dispatch.h"
#include "glark/gl/hooks.h"

namespace glark::core {
namespace {

constexpr int side = 64;
gl::Dispatch real;

void* get_proc(void* /*user*/, const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); }

using Picture = std::vector<GLubyte>;

// A fan around the centre that covers the picture. Its depth and its texture coordinates are no multiples of the position.
constexpr std::array<GLfloat, 6 * 7> fan = {
    // x, y, z, s, t, r, q
    0,  0,  0.5F,  0.5F, 0.5F, 0, 1,     //
    -1, -1, -0.3F, 0,    0,    1, 1,     //
    1,  -1, 0.2F,  1,    0.2F, 0, 2,     //
    1,  1,  -0.4F, 0.9F, 1,    1, 1,     //
    -1, 1,  0.3F,  0,    0.7F, 0, 1.5F,  //
    -1, -1, -0.3F, 0,    0,    1, 1};

class AssemblyDraws : public testing::Test {
 public:
  AssemblyDraws(const AssemblyDraws&) = delete;
  AssemblyDraws& operator=(const AssemblyDraws&) = delete;

 protected:
  AssemblyDraws() {
    const std::array<int, 7> attributes{
        OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0};
    window_ = OSMesaCreateContextAttribs(attributes.data(), nullptr);
    OSMesaMakeCurrent(window_, pixels_.data(), GL_UNSIGNED_BYTE, side, side);
    gl::load(real, get_proc, nullptr);
    start(Refinement::linear_outputs);
    real.VertexPointer(3, GL_FLOAT, stride, fan.data());
    real.TexCoordPointer(4, GL_FLOAT, stride, fan.data() + 3);
    real.EnableClientState(GL_VERTEX_ARRAY);
    real.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    real.Normal3f(0.1F, 0.2F, 0.9F);
  }
  ~AssemblyDraws() override {
    context_->release();
    context_.reset();
    OSMesaDestroyContext(window_);
  }

  void start(Refinement refinement) {
    if (context_ != nullptr) context_->release();
    ContextOptions options;
    options.transparent = true;
    options.refinement = refinement;
    options.level = 2;
    options.left_draws = 0;
    context_ = Context::create(real, make_share_group(), options);
  }

  void set(GLenum capability, bool on = true) { (on ? hook::Enable : hook::Disable)(*context_, capability); }

  GLuint load(const std::string& body, GLenum target = GL_VERTEX_PROGRAM_ARB, GLuint name = 0) {
    if (name == 0) name = ++last_name_;  // binding makes the object
    hook::BindProgramARB(*context_, target, name);
    const std::string text = (target == GL_VERTEX_PROGRAM_ARB ? "!!ARBvp1.0\n" : "!!ARBfp1.0\n") + body + "END\n";
    hook::ProgramStringARB(*context_, target, GL_PROGRAM_FORMAT_ASCII_ARB, static_cast<GLsizei>(text.size()),
                           text.data());
    EXPECT_EQ(real.GetError(), GLenum{GL_NO_ERROR}) << real.GetString(GL_PROGRAM_ERROR_STRING_ARB);
    set(target);
    return name;
  }
  void set_local(GLuint index, GLfloat x, GLfloat y, GLfloat z) {
    hook::ProgramLocalParameter4fARB(*context_, GL_VERTEX_PROGRAM_ARB, index, x, y, z, 1);
  }

  // An oblique view in perspective, in which the fan still covers the picture.
  void look_obliquely() {
    constexpr std::array<GLfloat, 16> perspective{1.9F, 0, 0, 0, 0.1F, 1.7F, 0, 0, 0, 0, -1.2F, -1, 0, 0, -1.1F, 0};
    hook::MatrixMode(*context_, GL_PROJECTION);
    real.LoadMatrixf(perspective.data());
    hook::MatrixMode(*context_, GL_MODELVIEW);
    real.Translatef(0, 0, -1.3F);
    real.Rotatef(12, 1, 0.5F, 0.3F);
    context_->changes().touch_any_matrix();
  }

  void clear() {
    real.ClearColor(0, 0, 0, 0);
    real.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  static void draw_plain() { real.DrawArrays(GL_TRIANGLE_FAN, 0, 6); }
  void draw_refined() {
    context_->state().arrays().vertex_arrays().forget_current();
    const std::uint64_t before = statistics().draws_refined;
    hook::DrawArrays(*context_, GL_TRIANGLE_FAN, 0, 6);
    EXPECT_EQ(statistics().draws_refined, before + 1) << "the draw was not refined";
  }
  Picture picture() {
    real.Finish();
    return pixels_;
  }

  // Few pixels differ, because the refined vertices are rounded to the raster.
  static void expect_same(const Picture& plain, const Picture& refined) {
    int differing = 0;
    int visible = 0;
    for (std::size_t i = 0; i < plain.size(); i += 4) {
      int difference = 0;
      for (std::size_t j = i; j < i + 4; ++j) difference = std::max(difference, std::abs(plain[j] - refined[j]));
      differing += difference > 2 ? 1 : 0;
      visible += plain[i] + plain[i + 1] + plain[i + 2] > 0 ? 1 : 0;
    }
    EXPECT_LE(differing, 8);
    EXPECT_GT(visible, side * side / 3) << "the scene shows nothing";
  }
  // Lit as blue everywhere, with normals that make the fan round.
  void light() {
    constexpr std::array<GLfloat, 4> blue{0, 0, 1, 1};
    set(GL_LIGHTING);
    set(GL_LIGHT0);
    real.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, blue.data());
    real.NormalPointer(GL_FLOAT, stride, fan.data());
    real.EnableClientState(GL_NORMAL_ARRAY);
  }
  void expect_all_covered() {
    std::vector<GLfloat> depths(side * side);
    real.ReadPixels(0, 0, side, side, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    const Picture shown = picture();
    int covered = 0;
    int missing = 0;
    for (std::size_t i = 0; i < depths.size(); ++i) {
      covered += depths[i] < 1 ? 1 : 0;
      missing += depths[i] < 1 && shown[4 * i + 2] < 128 ? 1 : 0;
    }
    EXPECT_GT(covered, side * side / 2);
    EXPECT_EQ(missing, 0);
  }
  Picture expect_same_draw() {
    clear();
    draw_plain();
    Picture plain = picture();
    clear();
    draw_refined();
    expect_same(plain, picture());
    EXPECT_EQ(real.GetError(), GLenum{GL_NO_ERROR});
    return plain;
  }

  static constexpr GLsizei stride = 7 * sizeof(GLfloat);
  Picture pixels_ = Picture(side * side * 4);
  OSMesaContext window_ = nullptr;
  std::unique_ptr<Context> context_;
  GLuint last_name_ = 0;
};

constexpr char by_matrix[] =
    "PARAM m[4] = { state.matrix.mvp };\nDP4 result.position.x, m[0], vertex.position;\n"
    "DP4 result.position.y, m[1], vertex.position;\nDP4 result.position.z, m[2], vertex.position;\n"
    "DP4 result.position.w, m[3], vertex.position;\n";
constexpr char invariant[] = "OPTION ARB_position_invariant;\n";
constexpr char colored[] = "MAD result.color, vertex.texcoord, program.local[1], program.env[2];\n";

TEST_F(AssemblyDraws, AreRefined) {
  look_obliquely();
  load(std::string(by_matrix) + colored);
  set_local(1, 0.7F, 0.6F, 0.4F);
  hook::ProgramEnvParameter4fARB(*context_, GL_VERTEX_PROGRAM_ARB, 2, 0.1F, 0.2F, 0.3F, 1);
  expect_same_draw();
}

TEST_F(AssemblyDraws, FollowTheirParameters) {
  load(std::string(invariant) + colored);
  set_local(1, 0.8F, 0.7F, 0.3F);
  std::vector<Picture> pictures;
  const auto draw = [&] { pictures.push_back(expect_same_draw()); };
  draw();
  set_local(1, 0.5F, 0, 1);
  draw();
  constexpr std::array<GLdouble, 4> green{0, 0.4, 0, 1};
  hook::ProgramEnvParameter4dvARB(*context_, GL_VERTEX_PROGRAM_ARB, 2, green.data());
  draw();
  constexpr std::array<GLfloat, 8> both{0, 0, 0, 0, 0.3F, 0.9F, 0.2F, 1};
  hook::ProgramLocalParameters4fvEXT(*context_, GL_VERTEX_PROGRAM_ARB, 0, 2, both.data());
  draw();
  for (std::size_t i = 1; i < pictures.size(); ++i) EXPECT_NE(pictures[i - 1], pictures[i]) << i;
}

// A display list changes the parameters, the program and its text unseen.
TEST_F(AssemblyDraws, FollowDisplayLists) {
  load(std::string(invariant) + "MOV result.color, program.local[1];\n");
  set_local(1, 1, 1, 0);
  const Picture yellow = expect_same_draw();
  const GLuint other = load(std::string(invariant) + "MOV result.color, program.env[2];\n");
  hook::NewList(*context_, 1, GL_COMPILE);
  hook::BindProgramARB(*context_, GL_VERTEX_PROGRAM_ARB, other);
  hook::ProgramEnvParameter4fARB(*context_, GL_VERTEX_PROGRAM_ARB, 2, 0.5F, 0, 1, 1);
  hook::EndList(*context_);
  hook::BindProgramARB(*context_, GL_VERTEX_PROGRAM_ARB, 0);
  hook::CallList(*context_, 1);
  EXPECT_NE(expect_same_draw(), yellow);
}

TEST_F(AssemblyDraws, FollowTheProgram) {
  const GLuint first = load(std::string(invariant) + "MOV result.color, {1, 0.5, 0};\n");
  const Picture orange = expect_same_draw();
  const GLuint second = load(std::string(invariant) + "MOV result.color, {0, 0.5, 1};\n");
  const Picture blue = expect_same_draw();
  EXPECT_NE(blue, orange);
  hook::BindProgramARB(*context_, GL_VERTEX_PROGRAM_ARB, first);
  EXPECT_EQ(expect_same_draw(), orange);
  hook::BindProgramARB(*context_, GL_VERTEX_PROGRAM_ARB, second);
  hook::DeleteProgramsARB(*context_, 1, &first);
  hook::PushAttrib(*context_, GL_ALL_ATTRIB_BITS);
  set(GL_VERTEX_PROGRAM_ARB, false);
  real.Color3f(1, 1, 1);
  EXPECT_NE(expect_same_draw(), blue);
  hook::PopAttrib(*context_);
  EXPECT_EQ(expect_same_draw(), blue);
}

TEST_F(AssemblyDraws, FollowTextThatIsReplaced) {
  const std::string version = reinterpret_cast<const char*>(real.GetString(GL_VERSION));
  if (version.find("Mesa 25.") != std::string::npos)
    GTEST_SKIP() << "Mesa 25 crashes here without glark: fault program_string_again in tests/drivers";
  const GLuint program = load(std::string(invariant) + "MOV result.color, {1, 0.5, 0};\n");
  const Picture orange = expect_same_draw();
  load(std::string(invariant) + "MOV result.color, {0, 0.5, 1};\n", GL_VERTEX_PROGRAM_ARB, program);
  EXPECT_NE(expect_same_draw(), orange);
}

TEST_F(AssemblyDraws, FollowProgramMatrices) {
  load(std::string(invariant) + "MOV result.color, state.matrix.program[1].row[2];\n");
  hook::MatrixMode(*context_, GL_MATRIX1_ARB);
  constexpr std::array<GLfloat, 16> matrix{0, 0, 0.5F, 0, 0, 0, 0.25F, 0, 0, 0, 1, 0, 0, 0, 0.75F, 1};
  real.LoadMatrixf(matrix.data());
  context_->changes().touch_matrices();
  const Picture first = expect_same_draw();
  real.Scalef(0.5F, 4, 1);
  context_->changes().touch_matrices();
  EXPECT_NE(expect_same_draw(), first);
  GLint mode = 0;
  real.GetIntegerv(GL_MATRIX_MODE, &mode);
  EXPECT_EQ(mode, GL_MATRIX1_ARB);
}

// The second pass shows every pixel of the first one, although only equal depths pass.
TEST_F(AssemblyDraws, MeetTheFixedFunctionToTheBit) {
  for (const Refinement refinement : {Refinement::linear_outputs, Refinement::linear_inputs, Refinement::pn}) {
    start(refinement);
    real.LoadIdentity();
    look_obliquely();
    load(std::string(invariant) + "MAD result.color, vertex.normal, 0.01, {0, 0, 1, 1};\n");
    light();
    set(GL_DEPTH_TEST);
    for (const bool assembly_first : {false, true}) {
      clear();
      hook::DepthFunc(*context_, GL_LESS);
      set(GL_VERTEX_PROGRAM_ARB, assembly_first);
      real.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
      draw_refined();
      hook::DepthFunc(*context_, GL_EQUAL);
      set(GL_VERTEX_PROGRAM_ARB, !assembly_first);
      real.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
      draw_refined();
      expect_all_covered();
    }
  }
}

TEST_F(AssemblyDraws, AboveAnAssemblyFragmentProgram) {
  load(std::string(by_matrix) +
       "MOV result.texcoord[1].xyz, vertex.texcoord; MOV result.fogcoord.x, vertex.position.z;\n");
  load("ADD result.color, fragment.texcoord[1], fragment.fogcoord.x;\n", GL_FRAGMENT_PROGRAM_ARB);
  expect_same_draw();
}

TEST_F(AssemblyDraws, AboveTheFixedFunctionsTexturesAndFog) {
  constexpr std::array<GLubyte, 16> texels{255, 0, 0, 255, 0, 255, 0, 255, 0, 80, 255, 255, 255, 255, 255, 255};
  GLuint texture = 0;
  real.GenTextures(1, &texture);
  real.BindTexture(GL_TEXTURE_2D, texture);
  real.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  real.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  set(GL_TEXTURE_2D);
  set(GL_FOG);
  real.Fogf(GL_FOG_DENSITY, 0.7F);
  load(std::string(invariant) +
       "MOV result.color, 1.0; MOV result.texcoord, vertex.texcoord; ABS result.fogcoord.x, vertex.position.z;\n");
  expect_same_draw();
}

TEST_F(AssemblyDraws, AboveAGlslFragmentShader) {
  const char* const source = "uniform vec4 tint;\nvoid main() { gl_FragColor = gl_TexCoord[0] * tint; }\n";
  const GLuint shader = real.CreateShader(GL_FRAGMENT_SHADER);
  const GLuint program = real.CreateProgram();
  real.ShaderSource(shader, 1, &source, nullptr);
  hook::CompileShader(*context_, shader);
  real.AttachShader(program, shader);
  hook::LinkProgram(*context_, program);
  hook::UseProgram(*context_, program);
  load(std::string(by_matrix) + "MOV result.texcoord, vertex.texcoord;\n");
  const GLint tint = real.GetUniformLocation(program, "tint");
  real.Uniform4f(tint, 1, 0.5F, 0.8F, 1);
  expect_same_draw();
}

TEST_F(AssemblyDraws, WithUserClipPlanes) {
  look_obliquely();
  constexpr std::array<GLdouble, 4> plane{1, 0.3, 0.2, 0.3};
  real.ClipPlane(GL_CLIP_PLANE0, plane.data());
  set(GL_CLIP_PLANE0);
  for (const char* const position : {invariant, by_matrix}) {
    load(std::string(position) + "MOV result.color, vertex.texcoord.wxyz;\n");
    expect_same_draw();
  }
}

TEST_F(AssemblyDraws, WithTwoSides) {
  load(std::string(invariant) + "MOV result.color, {1, 0, 0}; MOV result.color.back, {0, 1, 0};\n");
  set(GL_VERTEX_PROGRAM_TWO_SIDE);
  const Picture front = expect_same_draw();
  real.FrontFace(GL_CW);
  EXPECT_NE(expect_same_draw(), front);
}

TEST_F(AssemblyDraws, WithGenericAttributes) {
  load(std::string(invariant) + "MOV result.color, vertex.attrib[3];\n");
  real.VertexAttribPointer(3, 4, GL_FLOAT, GL_FALSE, stride, fan.data() + 3);
  real.EnableVertexAttribArray(3);
  expect_same_draw();
}

// Nothing is drawn, and the error is the driver's.
TEST_F(AssemblyDraws, WithoutAProgramStayAsTheyAre) {
  set(GL_VERTEX_PROGRAM_ARB);
  const auto before = statistics().passed_through[static_cast<std::size_t>(Cause::assembly_program)].load();
  hook::DrawArrays(*context_, GL_TRIANGLE_FAN, 0, 6);
  EXPECT_EQ(statistics().passed_through[static_cast<std::size_t>(Cause::assembly_program)], before + 1);
  EXPECT_EQ(real.GetError(), GLenum{GL_INVALID_OPERATION});
}

// A steady scene uploads nothing and asks for nothing.
TEST_F(AssemblyDraws, AskNothingOnceTheyAreKnown) {
  load(std::string(invariant) + colored);
  draw_refined();
  draw_refined();
  static int calls = 0;
  static gl::Dispatch driver;
  calls = 0;
  driver = real;
  real.GetProgramLocalParameterfvARB = [](auto... arguments) {
    ++calls, driver.GetProgramLocalParameterfvARB(arguments...);
  };
  real.GetProgramEnvParameterfvARB = [](auto... arguments) {
    ++calls, driver.GetProgramEnvParameterfvARB(arguments...);
  };
  real.ProgramUniform4fv = [](auto... arguments) { ++calls, driver.ProgramUniform4fv(arguments...); };
  real.GetProgramivARB = [](auto... arguments) { ++calls, driver.GetProgramivARB(arguments...); };
  draw_refined();
  EXPECT_EQ(calls, 0);
  set_local(1, 0.5F, 0.5F, 0.5F);
  draw_refined();
  real = driver;
}

}  // namespace
}  // namespace glark::core
