// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Displaced draws that repeat, with another texture, sampler or texture content by every command that has this effect.
// The map_heights are the same at all vertices, so the expected picture is that of a triangle drawn elsewhere.
#include <fmt/core.h>

#include <map>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

constexpr GLuint height_unit = 3;

// Each texture has two texels: its height on the left, and a quarter more on the right. The coordinate is 1.25: by REPEAT
// it is on the left.
constexpr float map_heights[] = {0, 0.125F, 0.25F, 0.375F, 0.5F};
constexpr float other_texel = 0.25F;

void fill_map(GLuint texture, float height) {
  const GLfloat texels[] = {height, height + other_texel};
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R16F, 2, 1, 0, GL_RED, GL_FLOAT, texels);
}

GLuint height_texture(float height) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  fill_map(texture, height);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

GLuint map_sampler(GLenum wrap) {
  GLuint name = 0;
  gl.GenSamplers(1, &name);
  gl.SamplerParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.SamplerParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.SamplerParameteri(name, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap));
  return name;
}

struct Maps {
  GLuint first = 0;     // bound to the unit at first; its height is map_heights[1]
  GLuint second = 0;    // map_heights[3]
  GLuint repeated = 0;  // samplers
  GLuint clamped = 0;
};

struct MapChange {
  const char* leaf;
  float height;  // after the change
  void (*make)(const Maps& m);
  Apis apis = every_api;
  int version = 0;
  const char* extension = nullptr;
};

void at_height_unit(const std::function<void()>& call) {
  gl.ActiveTexture(GL_TEXTURE0 + height_unit);
  call();
  gl.ActiveTexture(GL_TEXTURE0);
}

void draw_map_triangle() { gl.DrawArrays(GL_TRIANGLES, 0, 3); }

// Changes the unit between PushAttrib and PopAttrib, and draws there.
void between_groups(GLbitfield group, const std::function<void()>& change) {
  gl.PushAttrib(group);
  at_height_unit(change);
  repeat_often(draw_map_triangle);
  gl.PopAttrib();
}

constexpr GLfloat new_texels[] = {map_heights[4], map_heights[4] + other_texel};

constexpr MapChange map_changes[] = {
    {"bind_texture", map_heights[3],
     [](const Maps& m) { at_height_unit([&] { gl.BindTexture(GL_TEXTURE_2D, m.second); }); }},
    {"bind_texture_unit", map_heights[3], [](const Maps& m) { gl.BindTextureUnit(height_unit, m.second); },
     desktop_apis, 45},
    {"bind_textures", map_heights[3], [](const Maps& m) { gl.BindTextures(height_unit, 1, &m.second); }, desktop_apis,
     44},
    {"bind_textures_around", map_heights[3],
     [](const Maps& m) {
       const GLuint names[] = {m.first, m.first, m.second, m.first};
       gl.BindTextures(height_unit - 2, 4, names);
     },
     desktop_apis, 44},
    {"bind_multi_texture", map_heights[3],
     [](const Maps& m) { gl.BindMultiTextureEXT(GL_TEXTURE0 + height_unit, GL_TEXTURE_2D, m.second); }, compat_only, 0,
     "GL_EXT_direct_state_access"},
    {"deleted", map_heights[3],
     [](const Maps& m) {
       gl.DeleteTextures(1, &m.first);
       const GLuint again = height_texture(map_heights[3]);  // some implementations use the name again
       at_height_unit([&] { gl.BindTexture(GL_TEXTURE_2D, again); });
     }},
    {"displacement_unit", map_heights[3],
     [](const Maps& m) {
       gl.ActiveTexture(GL_TEXTURE0 + height_unit + 2);
       gl.BindTexture(GL_TEXTURE_2D, m.second);
       gl.ActiveTexture(GL_TEXTURE0);
       gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, height_unit + 2);
     }},
    {"bind_sampler", map_heights[1] + other_texel, [](const Maps& m) { gl.BindSampler(height_unit, m.clamped); }},
    {"bind_samplers", map_heights[1] + other_texel, [](const Maps& m) { gl.BindSamplers(height_unit, 1, &m.clamped); },
     desktop_apis, 44},
    {"bind_samplers_around", map_heights[1] + other_texel,
     [](const Maps& m) {
       const GLuint names[] = {m.repeated, m.clamped, m.repeated};
       gl.BindSamplers(height_unit - 1, 3, names);
     },
     desktop_apis, 44},
    {"no_samplers", map_heights[1] + other_texel,
     [](const Maps& m) {
       at_height_unit([] { gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE); });
       gl.BindSamplers(height_unit, 1, &m.repeated);
       gl.BindSamplers(height_unit, 1, nullptr);
     },
     desktop_apis, 44},
    {"delete_samplers", map_heights[1],
     [](const Maps& m) {
       gl.BindSampler(height_unit, m.clamped);
       gl.DeleteSamplers(1, &m.clamped);
     }},
    {"tex_image", map_heights[4],
     [](const Maps&) {
       at_height_unit([] { gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R16F, 2, 1, 0, GL_RED, GL_FLOAT, new_texels); });
     }},
    {"tex_sub_image", map_heights[4],
     [](const Maps&) {
       at_height_unit([] { gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RED, GL_FLOAT, new_texels); });
     }},
    {"tex_sub_image_elsewhere", map_heights[4],
     [](const Maps& m) {
       gl.BindTexture(GL_TEXTURE_2D, m.first);  // of unit 0
       gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RED, GL_FLOAT, new_texels);
     }},
    {"texture_sub_image", map_heights[4],
     [](const Maps& m) { gl.TextureSubImage2D(m.first, 0, 0, 0, 1, 1, GL_RED, GL_FLOAT, new_texels); }, desktop_apis,
     45},
    {"multi_tex_sub_image", map_heights[4],
     [](const Maps&) {
       gl.MultiTexSubImage2DEXT(GL_TEXTURE0 + height_unit, GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RED, GL_FLOAT, new_texels);
     },
     compat_only, 0, "GL_EXT_direct_state_access"},
    {"pop_attrib.texture", map_heights[1],
     [](const Maps& m) { between_groups(GL_TEXTURE_BIT, [&] { gl.BindTexture(GL_TEXTURE_2D, m.second); }); },
     compat_only},
    {"pop_attrib.all", map_heights[1],
     [](const Maps& m) {
       between_groups(GLbitfield{GL_ALL_ATTRIB_BITS}, [&] { gl.BindTexture(GL_TEXTURE_2D, m.second); });
     },
     compat_only},
    {"pop_attrib.wrap", map_heights[1],
     [](const Maps&) {
       between_groups(GL_TEXTURE_BIT, [] { gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE); });
     },
     compat_only},
    {"pop_attrib.nested", map_heights[1],
     [](const Maps& m) {
       between_groups(GL_TEXTURE_BIT, [&] {
         gl.PushAttrib(GL_CURRENT_BIT);
         gl.BindTexture(GL_TEXTURE_2D, m.second);
         gl.PopAttrib();
       });
     },
     compat_only},
    {"pop_attrib.other_group", map_heights[3],
     [](const Maps& m) { between_groups(GL_ENABLE_BIT, [&] { gl.BindTexture(GL_TEXTURE_2D, m.second); }); },
     compat_only},
    {"pop_attrib.listed", map_heights[1],
     [](const Maps& m) {
       gl.NewList(1, GL_COMPILE);
       gl.PopAttrib();
       gl.EndList();
       gl.PushAttrib(GL_TEXTURE_BIT);
       at_height_unit([&] { gl.BindTexture(GL_TEXTURE_2D, m.second); });
       repeat_often(draw_map_triangle);
       gl.CallList(1);
     },
     compat_only},
    {"copy_image", map_heights[3],
     [](const Maps& m) {
       gl.CopyImageSubData(m.second, GL_TEXTURE_2D, 0, 0, 0, 0, m.first, GL_TEXTURE_2D, 0, 0, 0, 0, 2, 1, 1);
     }},
    {"clear_tex_image", map_heights[4],
     [](const Maps& m) { gl.ClearTexImage(m.first, 0, GL_RED, GL_FLOAT, new_texels); }, desktop_apis, 44},
    {"clear_tex_sub_image", map_heights[4],
     [](const Maps& m) { gl.ClearTexSubImage(m.first, 0, 0, 0, 0, 1, 1, 1, GL_RED, GL_FLOAT, new_texels); },
     desktop_apis, 44},
};

// A flat triangle at this height, which the vertex stage turns into a shift to the right.
void upload_map_triangle(float height) {
  Mesh mesh = one_triangle();
  for (MeshVertex& vertex : mesh) {
    vertex.position[0] = 0.5F * vertex.position[0] - 0.5F;
    vertex.position[2] = height;
    vertex.normal = {0, 0, 1};
    vertex.texture = {1.25F, 0.5F};
  }
  upload(mesh, false);
}

Maps bind_maps() {
  Maps maps{.first = height_texture(map_heights[1]),
            .second = height_texture(map_heights[3]),
            .repeated = map_sampler(GL_REPEAT),
            .clamped = map_sampler(GL_CLAMP_TO_EDGE)};
  at_height_unit([&] { gl.BindTexture(GL_TEXTURE_2D, maps.first); });
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.BindSampler(height_unit, 0);
  return maps;
}

// The pictures of the triangle at all heights, without refinement.
std::map<float, Picture> expected_pictures() {
  std::map<float, Picture> pictures;
  for (const float height : map_heights)
    for (const float texel : {height, height + other_texel}) {
      upload_map_triangle(texel);
      pictures.emplace(texel, picture_of(draw_map_triangle));
    }
  return pictures;
}

void check_map_change(Test& t, const MapChange& change) {
  if (!t.is_gles() && t.version() < change.version) t.not_supported("the command is of a later version");
  if (change.extension != nullptr && !t.has_extension(change.extension)) t.not_supported(change.extension);
  gl.UseProgram(build_program(
      t,
      {.vertex = "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
                 "layout(location = 4) in vec2 texcoord; layout(location = 3) in vec4 vertex_colour;\n"
                 "out vec4 colour; void main() { gl_Position = vec4(position.x + position.z, position.y, 0.0, 1.0);\n"
                 "  colour = vec4(vertex_colour.rgb, abs(normal.z) + 0.001 * texcoord.x); }\n"}));
  const std::map<float, Picture> pictures = expected_pictures();
  upload_map_triangle(0);
  for (const auto& [is_uniform, refinement] :
       {std::pair<bool, GLenum>{true, GL_LINEAR_INPUTS_ARK}, {true, GL_CURVED_PN_ARK}, {false, GL_CURVED_PN_ARK}})
    for (const int history : {1, 24}) {
      if (history == 1 && refinement != GL_LINEAR_INPUTS_ARK) continue;
      is_uniform ? refine_uniformly(2, refinement) : refine_by_tags(3, refinement);
      gl.DepthTag1i(2);
      gl.ARKParameteriARK(GL_DISPLACEMENT_UNIT_ARK, height_unit);
      const Maps maps = bind_maps();
      const auto expect_height = [&](float height, const std::string& what) {
        t.expect_same_picture(picture_of(draw_map_triangle), pictures.at(height),
                              fmt::format("{}, drawn {} times before", what, history), 4, 40);
      };
      for (int again = 0; again < history; ++again) draw_map_triangle();
      if (history > 0) expect_height(map_heights[1], "before the change");
      change.make(maps);
      expect_height(change.height, "after the change");
      repeat_often(draw_map_triangle);
      expect_height(change.height, "long after the change");
      t.expect_no_error("the change");
    }
}

}  // namespace

Cases changed_height_maps_cases() {
  Cases cases;
  for (const MapChange& change : map_changes)
    cases.push_back({.name = std::string("ark.draw.again.heights.") + change.leaf,
                     .clauses = {"11.R.7b-2", "11.R.13-1"},
                     .plan = "Repeat a displaced draw, bind another texture or sampler, or write to the texture, and "
                             "repeat it.",
                     .wrong = "The map_heights of the earlier texture.",
                     .apis = change.apis,
                     .is_optional = change.version != 0 || change.extension != nullptr,
                     .check = [&change](Test& t) { check_map_change(t, change); }});
  return cases;
}

}  // namespace glark::conformance
