// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Changes of a texture, of a buffer texture, and of how they are sampled, between draws whose vertex stage reads them.
#include "conformance/cases/cases.h"
#include "conformance/changes/changed_draw.h"

namespace glark::conformance {
namespace {

constexpr GLuint pixel = 0xff8040f0;
constexpr GLuint pixels[] = {pixel, pixel, pixel, pixel};
constexpr GLubyte bytes[] = {0xf0, 0x40, 0x80, 0xff};

// A texture of one colour, bound to the current unit.
GLuint other_texture() {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

void replace_texture(Scene& s, const std::function<void(GLuint)>& bind) {
  const GLuint other = other_texture();
  gl.BindTexture(GL_TEXTURE_2D, s.image);
  bind(other);
  gl.DeleteTextures(1, &s.image);
  s.image = other;
}

// Waits until the texture has what was drawn or copied: without it, vertex stages on llvmpipe read the old texels, also
// where nothing is refined.
void wait_for_texels() { gl.Finish(); }

void clear_surface_to_colour() {
  gl.ClearColor(0.9F, 0.2F, 0.5F, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

// Draws into the texture, by a clear.
void render(const std::function<void()>& attach) {
  GLint old = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &old);
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  attach();
  gl.Viewport(0, 0, 2, 2);
  clear_surface_to_colour();
  gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(old));
  gl.DeleteFramebuffers(1, &framebuffer);
  wait_for_texels();
}

void sample(const std::function<void(GLuint)>& set) {
  GLuint sampler = 0;
  gl.GenSamplers(1, &sampler);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.SamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  set(sampler);
}

void unpack(const std::function<void()>& upload) {
  const GLuint buffer = make_buffer(GL_PIXEL_UNPACK_BUFFER, pixels, sizeof(pixels));
  upload();
  gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  gl.DeleteBuffers(1, &buffer);
}

std::vector<Change> contents() {
  return {
      {"TexSubImage2D",
       {"TexSubImage2D"},
       Concern::state,
       [](Test&, Scene&) { gl.TexSubImage2D(GL_TEXTURE_2D, 0, 1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel); }},
      {"TexImage2D",
       {"TexImage2D"},
       Concern::state,
       [](Test&, Scene&) { gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels); }},
      {"unpack_buffer",
       {"TexSubImage2D"},
       Concern::state,
       [](Test&, Scene&) {
         unpack([] { gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, nullptr); });
       }},
      {"CopyTexSubImage2D",
       {"CopyTexSubImage2D"},
       Concern::state,
       [](Test&, Scene&) {
         clear_surface_to_colour();
         gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 2, 2);
         wait_for_texels();
       }},
      {"CopyTexImage2D",
       {"CopyTexImage2D"},
       Concern::state,
       [](Test&, Scene&) {
         clear_surface_to_colour();
         gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 2, 2, 0);
         wait_for_texels();
       }},
      {"CopyImageSubData",
       {"CopyImageSubData"},
       Concern::state,
       [](Test&, Scene& s) {
         const GLuint other = other_texture();
         gl.BindTexture(GL_TEXTURE_2D, s.image);
         gl.CopyImageSubData(other, GL_TEXTURE_2D, 0, 0, 0, 0, s.image, GL_TEXTURE_2D, 0, 0, 0, 0, 2, 2, 1);
         gl.DeleteTextures(1, &other);
       }},
      {"GenerateMipmap",
       {"GenerateMipmap"},
       Concern::state,
       [](Test&, Scene&) {
         gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
         gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
         gl.GenerateMipmap(GL_TEXTURE_2D);
         gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);
       }},
      {"FramebufferTexture2D",
       {"FramebufferTexture2D", "Clear"},
       Concern::state,
       [](Test&, Scene& s) {
         render([&] { gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, s.image, 0); });
       }},
      {"FramebufferTexture",
       {"FramebufferTexture"},
       Concern::state,
       [](Test&, Scene& s) {
         render([&] { gl.FramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, s.image, 0); });
       }},
      {"BlitFramebuffer",
       {"BlitFramebuffer"},
       Concern::state,
       [](Test&, Scene& s) {
         clear_surface_to_colour();
         GLint old = 0;
         gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &old);
         GLuint framebuffer = 0;
         gl.GenFramebuffers(1, &framebuffer);
         gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
         gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, s.image, 0);
         gl.BlitFramebuffer(0, 0, 2, 2, 0, 0, 2, 2, GL_COLOR_BUFFER_BIT, GL_NEAREST);
         gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(old));
         gl.DeleteFramebuffers(1, &framebuffer);
         wait_for_texels();
       }},
      {"ClearTexImage",
       {"ClearTexImage"},
       Concern::state,
       [](Test&, Scene& s) { gl.ClearTexImage(s.image, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes); },
       desktop_apis,
       44},
      {"ClearTexSubImage",
       {"ClearTexSubImage"},
       Concern::state,
       [](Test&, Scene& s) { gl.ClearTexSubImage(s.image, 0, 0, 0, 0, 2, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes); },
       desktop_apis,
       44},
      {"TextureSubImage2D",
       {"TextureSubImage2D"},
       Concern::state,
       [](Test&, Scene& s) {
         gl.BindTextureUnit(image_unit, 0);
         gl.TextureSubImage2D(s.image, 0, 0, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
         gl.BindTextureUnit(image_unit, s.image);
       },
       desktop_apis,
       45},
      {"CopyTextureSubImage2D",
       {"CopyTextureSubImage2D"},
       Concern::state,
       [](Test&, Scene& s) {
         clear_surface_to_colour();
         gl.CopyTextureSubImage2D(s.image, 0, 0, 0, 0, 0, 2, 2);
         wait_for_texels();
       },
       desktop_apis,
       45},
  };
}

std::vector<Change> bindings() {
  return {
      {"BindTexture",
       {"BindTexture", "GenTextures"},
       Concern::state,
       [](Test&, Scene& s) { replace_texture(s, [](GLuint other) { gl.BindTexture(GL_TEXTURE_2D, other); }); }},
      {"DeleteTextures",
       {"DeleteTextures"},
       Concern::state,
       [](Test&, Scene& s) {
         gl.DeleteTextures(1, &s.image);
         s.image = other_texture();
       }},
      {"ActiveTexture",
       {"ActiveTexture", "BindTexture"},
       Concern::state,
       [](Test&, Scene& s) {
         gl.ActiveTexture(GL_TEXTURE0);
         const GLuint other = other_texture();
         gl.ActiveTexture(GL_TEXTURE0 + image_unit);
         gl.BindTexture(GL_TEXTURE_2D, other);
         gl.DeleteTextures(1, &s.image);
         s.image = other;
       }},
      {"TexParameteri.filter",
       {"TexParameteri"},
       Concern::state,
       [](Test&, Scene&) {
         gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
         gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
       }},
      {"TexParameteri.level",
       {"TexParameteri"},
       Concern::state,
       [](Test&, Scene&) { gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1); }},
      {"TexParameteriv.swizzle",
       {"TexParameteriv"},
       Concern::state,
       [](Test&, Scene&) {
         const GLint zero = GL_ZERO;
         gl.TexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, &zero);
       }},
      {"TexParameterf.level",
       {"TexParameterf"},
       Concern::state,
       [](Test&, Scene&) { gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1); }},
      {"BindSampler",
       {"BindSampler"},
       Concern::state,
       [](Test&, Scene&) { sample([](GLuint sampler) { gl.BindSampler(image_unit, sampler); }); }},
      {"SamplerParameteri",
       {"SamplerParameteri"},
       Concern::state,
       [](Test&, Scene&) {
         sample([](GLuint sampler) {
           gl.BindSampler(image_unit, sampler);
           gl.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
         });
       }},
      {"TextureParameteri",
       {"TextureParameteri"},
       Concern::state,
       [](Test&, Scene& s) { gl.TextureParameteri(s.image, GL_TEXTURE_BASE_LEVEL, 1); },
       desktop_apis,
       45},
      {"BindTextureUnit",
       {"BindTextureUnit"},
       Concern::state,
       [](Test&, Scene& s) { replace_texture(s, [](GLuint other) { gl.BindTextureUnit(image_unit, other); }); },
       desktop_apis,
       45},
      {"BindTextures",
       {"BindTextures"},
       Concern::state,
       [](Test&, Scene& s) { replace_texture(s, [](GLuint other) { gl.BindTextures(image_unit, 1, &other); }); },
       desktop_apis,
       44},
      {"BindSamplers",
       {"BindSamplers"},
       Concern::state,
       [](Test&, Scene&) { sample([](GLuint sampler) { gl.BindSamplers(image_unit, 1, &sampler); }); },
       desktop_apis,
       44},
  };
}

std::vector<Change> buffer_textures() {
  return {
      {"TexBufferRange",
       {"TexBufferRange"},
       Concern::state,
       [](Test&, Scene& s) {
         gl.ActiveTexture(GL_TEXTURE0 + texel_unit);
         gl.TexBufferRange(GL_TEXTURE_BUFFER, GL_RGBA8, s.texels, 256, 256);
       }},
      {"TexBuffer",
       {"TexBuffer"},
       Concern::state,
       [](Test&, Scene& s) {
         s.made.push_back(make_buffer(GL_TEXTURE_BUFFER, pixels, sizeof(pixels)));
         gl.ActiveTexture(GL_TEXTURE0 + texel_unit);
         gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA8, s.made.back());
       }},
      {"texels",
       {"BufferSubData"},
       Concern::state,
       [](Test&, Scene& s) {
         gl.BindBuffer(GL_COPY_WRITE_BUFFER, s.texels);
         gl.BufferSubData(GL_COPY_WRITE_BUFFER, 0, 4, &pixel);
       }},
      {"TextureBuffer",
       {"TextureBuffer"},
       Concern::state,
       [](Test&, Scene& s) {
         s.made.push_back(make_buffer(GL_COPY_READ_BUFFER, pixels, sizeof(pixels)));
         gl.TextureBuffer(s.texel_image, GL_RGBA8, s.made.back());
       },
       desktop_apis,
       45},
      {"TextureBufferRange",
       {"TextureBufferRange"},
       Concern::state,
       [](Test&, Scene& s) { gl.TextureBufferRange(s.texel_image, GL_RGBA8, s.texels, 256, 256); },
       desktop_apis,
       45},
  };
}

}  // namespace

Cases textures_cases() {
  static const std::vector<Change> changes = joined({contents(), bindings(), buffer_textures()});
  return change_cases("texture", changes, 210);
}

}  // namespace glark::conformance
