// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench/subject/subject_programs.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace glark::bench {
namespace {

constexpr const char* transform_and_light = R"(
uniform mat4 projection;
uniform mat4 view;
uniform vec4 light;
out vec4 shade;
out vec2 coordinates;
void shade_vertex(vec3 position, vec3 normal, vec2 uv) {
  vec4 eye = view * vec4(position, 1.0);
  vec3 n = normalize(mat3(view) * normal);
  float diffuse = max(dot(n, light.xyz), 0.0);
  vec3 halfway = normalize(light.xyz + vec3(0.0, 0.0, 1.0));
  float specular = pow(max(dot(n, halfway), 0.0), 16.0);
  shade = vec4(vec3(0.2, 0.18, 0.15) + diffuse * vec3(0.5, 0.5, 0.4) + specular * vec3(0.2), 1.0);
  coordinates = uv;
  gl_Position = projection * eye;
}
)";

constexpr const char* vertex_main = R"(
layout(location = 1) in vec3 position;
layout(location = 2) in vec3 normal;
layout(location = 3) in vec2 uv;
void main() { shade_vertex(position, normal, uv); }
)";

constexpr const char* fragment_source = R"(#version 400
in vec4 shade;
in vec2 coordinates;
out vec4 color;
void main() { color = shade * (0.9 + 0.1 * coordinates.x); }
)";

constexpr const char* control_point_vertex = R"(#version 400
#extension GL_ARB_explicit_attrib_location : enable
layout(location = 1) in vec3 position;
layout(location = 2) in vec3 normal;
layout(location = 3) in vec2 uv;
out vec3 control_position;
out vec3 control_normal;
out vec2 control_uv;
void main() {
  control_position = position;
  control_normal = normal;
  control_uv = uv;
}
)";

constexpr const char* control_source = R"(#version 400
layout(vertices = 3) out;
in vec3 control_position[];
in vec3 control_normal[];
in vec2 control_uv[];
out vec3 patch_position[];
out vec3 patch_normal[];
out vec2 patch_uv[];
uniform float segments;
void main() {
  patch_position[gl_InvocationID] = control_position[gl_InvocationID];
  patch_normal[gl_InvocationID] = control_normal[gl_InvocationID];
  patch_uv[gl_InvocationID] = control_uv[gl_InvocationID];
  if (gl_InvocationID == 0) {
    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = segments;
    gl_TessLevelInner[0] = segments;
  }
}
)";

constexpr const char* evaluation_main = R"(
layout(triangles, equal_spacing, ccw) in;
in vec3 patch_position[];
in vec3 patch_normal[];
in vec2 patch_uv[];
void main() {
  vec3 t = gl_TessCoord;
  shade_vertex(t.x * patch_position[0] + t.y * patch_position[1] + t.z * patch_position[2],
               t.x * patch_normal[0] + t.y * patch_normal[1] + t.z * patch_normal[2],
               t.x * patch_uv[0] + t.y * patch_uv[1] + t.z * patch_uv[2]);
}
)";

GLuint link(std::initializer_list<std::pair<GLenum, std::string>> stages) {
  const GLuint program = glCreateProgram();
  for (const auto& [stage, source] : stages) {
    const GLuint shader = glCreateShader(stage);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    std::array<char, 1024> log{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE) throw std::runtime_error(std::string("shader does not compile: ") + log.data());
    glDeleteShader(shader);
  }
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) throw std::runtime_error("the program to be measured does not link");
  return program;
}

using Matrix = std::array<float, 16>;

constexpr float near_plane = 1;
constexpr float far_plane = 100;
constexpr float field = 0.35F;  // the tangent of half the field of view

Matrix projection_matrix() {
  const float depth = far_plane - near_plane;
  return {1 / field,
          0,
          0,
          0,
          0,
          1 / field,
          0,
          0,
          0,
          0,
          -(far_plane + near_plane) / depth,
          -1,
          0,
          0,
          -2 * far_plane * near_plane / depth,
          0};
}

Matrix view_matrix(View view) {
  switch (view) {
    case View::plane: {  // the eye is 2 above the near end of the plane and looks a little down
      const float s = std::sin(0.3F);
      const float c = std::cos(0.3F);
      return {1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, -2 * c, -20 - 2 * s, 1};
    }
    default: return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -3.2F, 1};
  }
}

constexpr std::array<float, 4> light_direction{0.48F, 0.6F, 0.64F, 0};

void set_uniforms(GLuint program, View view) {
  glUseProgram(program);
  glUniformMatrix4fv(glGetUniformLocation(program, "projection"), 1, GL_FALSE, projection_matrix().data());
  glUniformMatrix4fv(glGetUniformLocation(program, "view"), 1, GL_FALSE, view_matrix(view).data());
  glUniform4fv(glGetUniformLocation(program, "light"), 1, light_direction.data());
}

void set_fixed_function(View view) {
  glUseProgram(0);
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(projection_matrix().data());
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glLightfv(GL_LIGHT0, GL_POSITION, light_direction.data());
  glLoadMatrixf(view_matrix(view).data());
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_NORMALIZE);
  const std::array<float, 4> specular{0.3F, 0.3F, 0.3F, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular.data());
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 16);
}

// GL 4.6, 14.6.1: culling removes triangles before they are rasterised, but their vertices are processed.
void cull(View view) { glCullFace(view == View::culled ? GL_FRONT_AND_BACK : GL_BACK); }

}  // namespace

GLuint shaded_program() {
  static const GLuint program =
      link({{GL_VERTEX_SHADER, std::string("#version 400\n#extension GL_ARB_explicit_attrib_location : enable\n") +
                                   transform_and_light + vertex_main},
            {GL_FRAGMENT_SHADER, fragment_source}});
  return program;
}

GLuint tessellation_program() {
  static const GLuint program =
      link({{GL_VERTEX_SHADER, control_point_vertex},
            {GL_TESS_CONTROL_SHADER, control_source},
            {GL_TESS_EVALUATION_SHADER, std::string("#version 400\n") + transform_and_light + evaluation_main},
            {GL_FRAGMENT_SHADER, fragment_source}});
  return program;
}

void use_shading(Shading shading, View view) {
  cull(view);
  if (shading == Shading::glsl) {
    set_uniforms(shaded_program(), view);
  } else {
    set_fixed_function(view);
  }
}

void use_tessellation(View view, unsigned level) {
  cull(view);
  set_uniforms(tessellation_program(), view);
  glUniform1f(glGetUniformLocation(tessellation_program(), "segments"), static_cast<float>(1U << level));
  glPatchParameteri(GL_PATCH_VERTICES, 3);
}

}  // namespace glark::bench
