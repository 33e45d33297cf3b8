// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Kept refined vertices are displaced by a texture. After each way to change the texture, its sampling or the parameters,
// the picture is another one.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "tests/core/evaluate/kept_pictures.h"
#include "tests/core/evaluate/shape_ball.h"

namespace glark::core::test {
namespace {

constexpr int seen_pixels = 40;
constexpr GLint unit = 3;
constexpr GLsizei side = 4;
using Texels = std::array<std::array<GLubyte, 4>, std::size_t{side} * side>;

// Other heights in each channel.
Texels waves() {
  Texels texels{};
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const auto height = static_cast<GLubyte>(37 * i % 200);
    texels[i] = {height, static_cast<GLubyte>(200 - height), static_cast<GLubyte>(11 * i), 255};
  }
  return texels;
}
Texels plain() {
  Texels texels{};
  texels.fill({220, 220, 220, 220});
  return texels;
}

GLuint make_texture(const Texels& texels) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  return texture;
}

void draw_to_texture(GLuint framebuffer) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glClearColor(0.9F, 0.9F, 0.9F, 0.9F);
  glClear(GL_COLOR_BUFFER_BIT);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

GLuint attach(GLuint texture) {
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return framebuffer;
}

// A compute shader fills the image of unit 0.
GLuint link_store() {
  const char* const text =
      "#version 430\nlayout(local_size_x = 4, local_size_y = 4) in; layout(rgba8) writeonly uniform image2D image;\n"
      "void main() { imageStore(image, ivec2(gl_GlobalInvocationID.xy), vec4(0.9)); }\n";
  const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader);
  glLinkProgram(program);
  return program;
}

struct Objects {
  GLuint texture = 0;  // bound to the unit, which is active
  GLuint other = 0;    // a plain texture, nowhere bound
  GLuint sampler = 0;  // nowhere bound
  GLuint made = 0;     // by prepare()
};

struct Change {
  const char* name;
  void (*make)(Objects& objects);
  void (*prepare)(Objects& objects) = [](Objects&) {};
};

void write_whole() {
  const Texels texels = plain();
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
}

const Change changes[] = {
    {"TexSubImage", [](Objects&) { write_whole(); }},
    {"TexImage",
     [](Objects&) {
       const Texels texels = plain();
       glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
     }},
    {"TextureSubImage",
     [](Objects& o) {
       const Texels texels = plain();
       glBindTexture(GL_TEXTURE_2D, o.other);
       glTextureSubImage2D(o.texture, 0, 0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
       glBindTexture(GL_TEXTURE_2D, o.texture);
     }},
    {"CopyTexSubImage",
     [](Objects&) {
       draw_to_texture(0);
       glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, side, side);
     }},
    {"CopyImage",
     [](Objects& o) {
       glCopyImageSubData(o.other, GL_TEXTURE_2D, 0, 0, 0, 0, o.texture, GL_TEXTURE_2D, 0, 0, 0, 0, side, side, 1);
     }},
    {"ClearTexImage",
     [](Objects& o) {
       const std::array<GLubyte, 4> texel{220, 220, 220, 220};
       glClearTexImage(o.texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
     }},
    {"Framebuffer", [](Objects& o) { draw_to_texture(attach(o.texture)); }},
    {"FramebufferAttachedBefore", [](Objects& o) { draw_to_texture(o.made); },
     [](Objects& o) { o.made = attach(o.texture); }},
    {"ImageStore",
     [](Objects& o) {
       glUseProgram(o.made);
       glDispatchCompute(1, 1, 1);
       glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
       glUseProgram(0);
     },
     [](Objects& o) {
       o.made = link_store();
       glBindImageTexture(0, o.texture, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
     }},
    {"Swizzle", [](Objects&) { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_ALPHA); }},
    {"TextureParameter", [](Objects& o) { glTextureParameteri(o.texture, GL_TEXTURE_SWIZZLE_R, GL_ALPHA); }},
    {"BindTexture", [](Objects& o) { glBindTexture(GL_TEXTURE_2D, o.other); }},
    {"BindTextureUnit", [](Objects& o) { glBindTextureUnit(unit, o.other); }},
    {"BindTextures", [](Objects& o) { glBindTextures(unit, 1, &o.other); }},
    {"BindSampler", [](Objects& o) { glBindSampler(unit, o.sampler); }},
    {"SamplerParameter", [](Objects& o) { glSamplerParameteri(o.sampler, GL_TEXTURE_MAG_FILTER, GL_LINEAR); },
     [](Objects& o) { glBindSampler(unit, o.sampler); }},
    {"DeletedSampler", [](Objects& o) { glDeleteSamplers(1, &o.sampler); },
     [](Objects& o) { glBindSampler(unit, o.sampler); }},
    {"AnotherTextureOfThatName",
     [](Objects& o) {
       glDeleteTextures(1, &o.texture);
       const Texels texels = plain();
       glBindTexture(GL_TEXTURE_2D, o.texture);
       glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
       glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
     }},
    {"PopAttrib", [](Objects&) { glPopAttrib(); },
     [](Objects& o) {
       glBindTexture(GL_TEXTURE_2D, o.other);
       glPushAttrib(GL_TEXTURE_BIT);
       glBindTexture(GL_TEXTURE_2D, o.texture);
     }},
    {"List", [](Objects& o) { glCallList(o.made); },
     [](Objects& o) {
       o.made = glGenLists(1);
       glNewList(o.made, GL_COMPILE);
       write_whole();
       glEndList();
     }},
    {"Scale", [](Objects&) { glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, -0.3F); }},
    {"Bias", [](Objects&) { glARKParameterfARK(GL_DISPLACEMENT_BIAS_ARK, 0.25F); }},
    {"Channel", [](Objects&) { glARKParameteriARK(GL_DISPLACEMENT_CHANNEL_ARK, GL_ALPHA); }},
    {"Unit", [](Objects&) { glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit + 1); },
     [](Objects& o) { glBindTextureUnit(unit + 1, o.other); }},
    {"Coordinate",
     [](Objects&) { glARKParameteriARK(GL_DISPLACEMENT_COORDINATE_ARK, ShapeBall::discontinuity_location); }},
    {"Off", [](Objects&) { glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, -1); }},
};

class KeptDisplacement : public testing::TestWithParam<Change> {
 protected:
  KeptDisplacement() {
    refine_uniformly(4, GL_CURVED_PN_ARK);
    glActiveTexture(GL_TEXTURE0 + unit);
    objects_.other = make_texture(plain());
    objects_.texture = make_texture(waves());
    glGenSamplers(1, &objects_.sampler);
    glSamplerParameteri(objects_.sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(objects_.sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
    glARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.3F);
  }
  Picture settled() {
    return expect_same_picture([this] { ball_.draw(); });
  }

  OsmesaContext context_{Profile::compatibility};
  ShapeBall ball_;
  Objects objects_;
};

INSTANTIATE_TEST_SUITE_P(All, KeptDisplacement, testing::ValuesIn(changes),
                         [](const testing::TestParamInfo<Change>& row) { return std::string(row.param.name); });

TEST_P(KeptDisplacement, ShowsTheChange) {
  GetParam().prepare(objects_);
  const Picture before = settled();
  GetParam().make(objects_);
  const Picture changed = settled();
  EXPECT_GT(differing_pixels(before, changed), seen_pixels);
}

}  // namespace
}  // namespace glark::core::test
