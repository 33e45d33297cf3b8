// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Unchanged draws are not captured again, no matter what else the program does: arrays, current values, bins.
#include <array>

#include "tests/core/support/kept_scene.h"

namespace glark::core::test {
namespace {

class UnchangedDraws : public KeptScene {};

INSTANTIATE_TEST_SUITE_P(All, UnchangedDraws, testing::Values(Profile::compatibility, Profile::core), profile_name);

TEST_P(UnchangedDraws, WritesOfOtherBuffers) {
  const GLuint other = make_buffer(GL_ARRAY_BUFFER, two());
  const auto named = proc<PFNGLNAMEDBUFFERSUBDATAPROC>("glNamedBufferSubData");
  expect_kept(draw_elements, [&] {
    glBindBuffer(GL_ARRAY_BUFFER, other);
    glBufferData(GL_ARRAY_BUFFER, bytes, one().data(), GL_STREAM_DRAW);
    glMapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
    glUnmapBuffer(GL_ARRAY_BUFFER);
    named(other, 0, bytes, two().data());
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, vertices_);
    GLuint fresh = 0;
    glGenBuffers(1, &fresh);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, fresh);
    glBufferData(GL_PIXEL_PACK_BUFFER, 4, nullptr, GL_STREAM_READ);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glDeleteBuffers(1, &fresh);
  });
}

// WebGL 2 has this restart in every draw.
TEST_P(UnchangedDraws, FixedIndexRestart) {
  glEnable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  expect_kept(draw_arrays, [] {});
  const std::vector<GLushort> restarted{0, 1, 2, 0xFFFF, 2, 1, 3, 0xFFFF, 4};
  expect_captured_again(draw_elements, [&] {
    glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(2 * restarted.size()), restarted.data());
  });
  expect_same_scene({2}, draw_elements);
}

// The commands are read anyway: they are part of the key.
TEST_P(UnchangedDraws, IndirectDraws) {
  std::array<GLuint, 10> commands{3, 1, 0, 0, 0, 6, 1, 3, 0, 0};
  make_buffer(GL_DRAW_INDIRECT_BUFFER, std::vector<GLuint>(commands.begin(), commands.end()));
  const auto draw = [] { glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, nullptr, 2, 0); };
  const auto write = [&] { glBufferSubData(GL_DRAW_INDIRECT_BUFFER, 0, sizeof(commands), commands.data()); };
  expect_kept(draw, write);
  commands[5] = 3;
  expect_captured_again(draw, write);
  expect_same_scene({2}, draw);
  expect_kept([] { glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, nullptr); }, write);
}

TEST_P(UnchangedDraws, GpuWritesOfOtherBuffers) {
  const GLuint writer = glCreateProgram();
  attach_shader(
      writer, GL_COMPUTE_SHADER,
      "#version 430\nlayout(local_size_x = 1) in; layout(std430, binding = 0) buffer Data { float data[]; };\n"
      "void main() { data[0] = 1.0; }\n");
  glLinkProgram(writer);
  const GLuint other = make_buffer(GL_SHADER_STORAGE_BUFFER, two());
  expect_kept(draw_elements, [&] {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, other);
    glUseProgram(writer);
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    glUseProgram(program_);
  });
}

// A program without one vertex array per object sets its pointers again before each draw.
TEST_P(UnchangedDraws, PointersSetAnew) {
  const GLuint other = make_buffer(GL_ARRAY_BUFFER, two());
  const auto draw = [&] {
    for (const GLuint buffer : {vertices_, other}) {
      glBindBuffer(GL_ARRAY_BUFFER, buffer);
      point_generic_arrays(nullptr);
      draw_elements();
    }
  };
  expect_kept(draw, [] {});
}

TEST_P(UnchangedDraws, PointersSetAnewShowTheirBuffers) {
  const GLuint other = make_buffer(GL_ARRAY_BUFFER, two());
  const auto draw_with = [](GLuint buffer) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    point_generic_arrays(nullptr);
    draw_arrays();
  };
  const Picture first = picture_of([&] { draw_with(vertices_); });
  const Picture second = picture_of([&] { draw_with(other); });
  EXPECT_GT(differing_pixels(first, second), visible_pixels);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(differing_pixels(first, picture_of([&] { draw_with(vertices_); })), 0);
    EXPECT_EQ(differing_pixels(second, picture_of([&] { draw_with(other); })), 0);
  }
}

// The format is part of the key, no matter which call sets it.
TEST_P(UnchangedDraws, FormatsShow) {
  const auto shown = [](const std::function<void()>& format) {
    format();
    return picture_of(draw_arrays);
  };
  const auto usual = [] { point_generic_arrays(nullptr); };
  const auto shifted = [] { glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(ColoredVertex), nullptr); };
  const auto separate = [] { glVertexAttribFormat(1, 2, GL_FLOAT, GL_FALSE, 4); };
  const auto bytewise = [] { glVertexAttribPointer(1, 3, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ColoredVertex), nullptr); };
  const auto instanced = [] { glVertexAttribDivisor(1, 1); };
  const auto everywhere = [] { glVertexAttribDivisor(1, 0); };
  const std::vector<std::function<void()>> formats = {usual, shifted,  usual, separate,
                                                      usual, bytewise, usual, instanced};
  std::vector<Picture> plain;
  glDisable(GL_ARK);
  for (const auto& format : formats) plain.push_back(shown(format));
  glEnable(GL_ARK);
  for (int round = 0; round < 4; ++round) {
    everywhere();
    for (std::size_t i = 0; i < formats.size(); ++i) {
      EXPECT_LE(differing_pixels(plain[i], shown(formats[i])), tolerated_pixels)
          << "format " << i << " round " << round;
    }
  }
  EXPECT_GT(differing_pixels(plain[0], plain[1]), visible_pixels);
}

TEST_P(UnchangedDraws, ConstantAttribute) {
  glDisableVertexAttribArray(1);
  glVertexAttrib3f(1, 1, 0.5F, 0.25F);
  expect_kept(draw_arrays, [] { glVertexAttrib3f(1, 1, 0.5F, 0.25F); });
  expect_seen(draw_arrays, [] { glVertexAttrib3f(1, 0.25F, 0.5F, 1); });
}

TEST_P(UnchangedDraws, ConstantAttributesTakeTurns) {
  glDisableVertexAttribArray(1);
  const auto draw = [] {
    glVertexAttrib3f(1, 1, 0.5F, 0.25F);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 3);
    glVertexAttrib3f(1, 0.25F, 0.5F, 1);
    glDrawArrays(GL_TRIANGLE_STRIP, 3, 3);
  };
  expect_kept(draw, [] {});
}

class UnchangedDrawsTags : public UnchangedDraws {
 protected:
  UnchangedDrawsTags() {
    glARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_DEPTH_TAG_ARK);
    tags_ = make_buffer(GL_ARRAY_BUFFER, std::vector<GLubyte>{0, 1, 2, 2, 1, 0});
    glDepthTagPointerARK(GL_UNSIGNED_BYTE, 0, nullptr);
    glEnable(GL_DEPTH_TAG_ARRAY_ARK);
  }
  GLuint tags_ = 0;
};

INSTANTIATE_TEST_SUITE_P(All, UnchangedDrawsTags, testing::Values(Profile::compatibility, Profile::core), profile_name);

TEST_P(UnchangedDrawsTags, Bins) {
  expect_kept(draw_arrays, [] {});
}

TEST_P(UnchangedDrawsTags, BinsDrawTheSame) {
  glDisable(GL_ARK);
  const Picture plain = picture_of(draw_arrays);
  glEnable(GL_ARK);
  const Picture first = picture_of(draw_arrays);
  const GLuint primitives = generated_primitives;
  EXPECT_GT(primitives, 4U);
  EXPECT_LE(differing_pixels(plain, first), tolerated_pixels);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(differing_pixels(first, picture_of(draw_arrays)), 0);
    EXPECT_EQ(generated_primitives, primitives);
  }
  EXPECT_EQ(pending_errors(), "");
}

TEST_P(UnchangedDrawsTags, WrittenTags) {
  for (int i = 0; i < 3; ++i) picture_of(draw_arrays);
  const GLuint before = generated_primitives;
  glBufferSubData(GL_ARRAY_BUFFER, 0, 6, "\2\2\2\2\2\2");
  for (int i = 0; i < 3; ++i) {
    picture_of(draw_arrays);
    EXPECT_EQ(generated_primitives, 4U * 16);
  }
  EXPECT_NE(generated_primitives, before);
}

TEST_P(UnchangedDrawsTags, InteriorAndPool) {
  for (int i = 0; i < 3; ++i) picture_of(draw_arrays);
  for (int i = 0; i < 3; ++i) {
    glARKParameteriARK(GL_PATTERN_INTERIOR_ARK, i % 2 == 0 ? GL_SMOOTH_INTERIOR_ARK : GL_MINIMUM_INTERIOR_ARK);
    const Picture refined = picture_of(draw_arrays);
    glDisable(GL_ARK);
    EXPECT_LE(differing_pixels(picture_of(draw_arrays), refined), tolerated_pixels);
    glEnable(GL_ARK);
  }
  glARKinit(1);  // tags end at 1 now, and pieces are elsewhere
  glEnable(GL_ARK);
  const GLuint fewer = (picture_of(draw_arrays), generated_primitives);
  EXPECT_LE(fewer, 4U * 4);
  glDisable(GL_ARK);
  const Picture plain = picture_of(draw_arrays);
  glEnable(GL_ARK);
  EXPECT_LE(differing_pixels(plain, picture_of(draw_arrays)), tolerated_pixels);
}

// After a context is gone, other contexts of the share group delete its kept buffers.
TEST(UnchangedDrawsSharing, ContextGoesFirst) {
  OsmesaContext first(Profile::core);
  {
    OsmesaContext second(Profile::core, &first);
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    make_buffer(GL_ARRAY_BUFFER, first_vertices());
    point_generic_arrays(nullptr);
    glUseProgram(link_program(
        {.vertex = "#version 430\nlayout(location = 0) in vec2 p; void main() { gl_Position = vec4(p, 0, 1); }\n",
         .fragment = "#version 430\nout vec4 c; void main() { c = vec4(1.0); }\n"}));
    refine_uniformly(2);
    for (int i = 0; i < 4; ++i) glDrawArrays(GL_TRIANGLE_STRIP, 0, 6);
    first.make_current();
  }
  glFinish();
  EXPECT_EQ(pending_errors(), "");
}

// The ring of captures holds earlier draws. They must not be drawn in place of a draw that GL rejects.
void expect_rejected(const std::string& errors, const std::function<void()>& draw) {
  for (int i = 0; i < 4; ++i) {
    const Picture picture = picture_of(draw);
    EXPECT_EQ(pending_errors(), errors) << "repetition " << i;
    EXPECT_EQ(generated_primitives, 0U) << "repetition " << i;
    EXPECT_EQ(differing_pixels(picture, Picture(picture.size(), 0)), 0) << "repetition " << i;
  }
}

// glark itself rejects a negative count, before the draw. For other mistakes, GL's error comes after the capture, which
// has room for all triangles of the call.
TEST_P(UnchangedDraws, RejectedDrawsDrawNothing) {
  const Picture drawn = picture_of(draw_arrays);
  expect_rejected("0x0501 ", [] {
    constexpr GLint first[] = {0, 0};
    constexpr GLsizei count[] = {6, -1};
    glMultiDrawArrays(GL_TRIANGLE_STRIP, first, count, 2);
  });
  expect_rejected("0x0500 ", [] { glDrawElements(GL_TRIANGLES, 9, GL_FLOAT, nullptr); });
  expect_rejected("0x0501 ", [] { glDrawRangeElements(GL_TRIANGLES, 5, 0, 9, GL_UNSIGNED_SHORT, nullptr); });
  EXPECT_EQ(differing_pixels(drawn, picture_of(draw_arrays)), 0);
}

TEST_P(UnchangedDraws, EarlierErrorsStayAndDoNotMatter) {
  const Picture drawn = picture_of(draw_arrays);
  for (int i = 0; i < 4; ++i) {
    glEnable(0x7777);
    EXPECT_EQ(differing_pixels(drawn, picture_of(draw_arrays)), 0) << "repetition " << i;
    EXPECT_EQ(generated_primitives, 64U);
    EXPECT_EQ(pending_errors(), "0x0500 ");
  }
}

}  // namespace
}  // namespace glark::core::test
