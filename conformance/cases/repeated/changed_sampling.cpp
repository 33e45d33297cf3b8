// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Displaced draws that repeat very often, with a change of how their texture is sampled, by every command. An
// implementation may keep their refined vertices, but not after such a change.
#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "conformance/cases/cases.h"
#include "conformance/cases/displacement/nearest_texture.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/surface.h"

namespace glark::conformance {
namespace {

constexpr GLint unit = 3;
constexpr int size = 4;

// A value in each type. Integers stand for colours from -1 to 1.
struct Value {
  std::array<GLint, 4> whole{};
  std::array<GLuint, 4> bits{};
  std::array<GLfloat, 4> number{};
};
Value value_of(GLenum token) { return {{static_cast<GLint>(token)}, {token}, {static_cast<GLfloat>(token)}}; }
Value border_of(GLfloat red) { return {{static_cast<GLint>(red * 2147483520.0F)}, {}, {red}}; }

struct Command {
  const char* name;
  void (*set)(GLuint object, GLenum parameter, const Value& value);
  bool takes_border = false;  // of normalized texels
};

GLenum bound_target(GLuint) { return GL_TEXTURE_2D; }

#define COMMAND(prefix, suffix, first, value, takes_border)                                           \
  {                                                                                                   \
#prefix #suffix, [](GLuint object, GLenum parameter,                                              \
                        const Value& v) { gl.prefix##suffix(first, parameter, value); }, takes_border \
  }
#define COMMANDS(prefix, first)                                                                            \
  COMMAND(prefix, i, first, v.whole[0], false), COMMAND(prefix, f, first, v.number[0], false),             \
      COMMAND(prefix, iv, first, v.whole.data(), true), COMMAND(prefix, fv, first, v.number.data(), true), \
      COMMAND(prefix, Iiv, first, v.whole.data(), false), COMMAND(prefix, Iuiv, first, v.bits.data(), false)

constexpr Command of_samplers[] = {COMMANDS(SamplerParameter, object)};
constexpr Command of_bound_textures[] = {COMMANDS(TexParameter, bound_target(object))};
constexpr Command of_textures[] = {COMMANDS(TextureParameter, object)};

// The coordinates lie on both sides of the texture.
Mesh wide_mesh() {
  Mesh mesh = bent_mesh();
  for (MeshVertex& vertex : mesh) vertex.texture = {3 * vertex.texture[0] - 1, 3 * vertex.texture[1] - 1};
  return mesh;
}

void draw_all() { gl.DrawArrays(GL_TRIANGLES, 0, 6); }

// The picture after the change is that of a draw that reads other buffers and did not repeat.
void expect_change(Test& t, const std::function<void()>& change, const std::string& what) {
  repeat_often(draw_all);
  const Picture before = picture_of(draw_all);
  change();
  const Picture after = picture_of(draw_all);
  upload(wide_mesh(), false);
  const Picture expected = picture_of(draw_all);
  t.expect(count_different(before, expected, 8) > 60, what + " shows");
  t.expect_same_picture(after, expected, what, 4, 40);
  t.expect_no_error(what);
}

void check_commands(Test& t, std::span<const Command> commands, bool has_sampler) {
  gl.UseProgram(
      build_program(t, {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                                  "layout(location = 4) in vec2 texcoord; out vec4 colour;\n"
                                  "void main() { colour = vec4(abs(normalize(normal)), 1.0) + 0.01 * texcoord.x;\n"
                                  "  gl_Position = vec4(position.xyz, 1.6); }\n"}));
  std::vector<GLubyte> texels;
  for (int i = 0; i < size * size; ++i) texels.insert(texels.end(), {static_cast<GLubyte>(16 * i), 0, 0, 255});
  bind_nearest_texture(unit, size, texels);
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  GLint texture = 0;
  gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
  auto object = static_cast<GLuint>(texture);
  if (has_sampler) {
    gl.GenSamplers(1, &object);
    gl.BindSampler(unit, object);
    gl.SamplerParameteri(object, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.SamplerParameteri(object, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  upload(wide_mesh(), false);
  refine_uniformly(3, GL_CURVED_PN_ARK);
  gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, unit);
  gl.ARKParameterfARK(GL_DISPLACEMENT_SCALE_ARK, 0.4F);
  for (const Command& command : commands) {
    const auto set = [&](GLenum parameter, const Value& value, const std::string& what) {
      expect_change(
          t, [&] { command.set(object, parameter, value); }, std::string(command.name) + " of " + what);
    };
    set(GL_TEXTURE_WRAP_S, value_of(GL_CLAMP_TO_EDGE), "TEXTURE_WRAP_S");
    set(GL_TEXTURE_WRAP_T, value_of(GL_MIRRORED_REPEAT), "TEXTURE_WRAP_T");
    if (command.takes_border) {
      set(GL_TEXTURE_WRAP_S, value_of(GL_CLAMP_TO_BORDER), "TEXTURE_WRAP_S, to the border");
      for (const GLfloat red : {0.75F, 0.25F}) set(GL_TEXTURE_BORDER_COLOR, border_of(red), "TEXTURE_BORDER_COLOR");
    }
    set(GL_TEXTURE_WRAP_S, value_of(GL_REPEAT), "TEXTURE_WRAP_S, again");
    set(GL_TEXTURE_WRAP_T, value_of(GL_REPEAT), "TEXTURE_WRAP_T, again");
  }
}

constexpr Area often_case{"ark.draw.often.sampling."};

Case sampling_case(const std::string& leaf, const std::string& what, std::span<const Command> commands,
                   bool has_sampler, const Apis& apis = every_api) {
  return often_case(
      leaf, {"11.R.7b-2", "11.R.13-1"},
      "Repeat a displaced draw very often; change how " + what + " is sampled, by each command.",
      "The surface of the earlier sampling.",
      [commands, has_sampler](Test& t) { check_commands(t, commands, has_sampler); }, apis);
}

}  // namespace

Cases changed_sampling_cases() {
  Case of_names = sampling_case("named_texture", "a texture", of_textures, false, desktop_apis);
  of_names.check = [](Test& t) {
    if (t.version() < 45) t.not_supported("OpenGL 4.5 is needed");
    check_commands(t, of_textures, false);
  };
  return {sampling_case("sampler", "the texture of a sampler", of_samplers, true),
          sampling_case("texture", "the bound texture", of_bound_textures, false), optional(of_names)};
}

}  // namespace glark::conformance
