// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/changes/scene.h"

#include <array>
#include <cstddef>

namespace glark::conformance {
namespace {

struct Place {
  std::array<float, 4> position;
  std::array<float, 3> normal;
  float tag;
};

// The instances lie one above the other, because an implementation may change the order of triangles.
constexpr char all_inputs[] =
    "layout(location = 3) in vec4 colours; layout(location = 6) in vec4 current; layout(location = 7) in ivec4 steps;\n"
    "vec3 inputs() { return (colours + current + vec4(steps) / 8.0).rgb; }\n"
    "float instance() { return float(gl_InstanceID); }\n";
constexpr char few_inputs[] =
    "layout(location = 3) in vec4 colours; layout(location = 6) in vec4 current;\n"
    "vec3 inputs() { return (colours + current).rgb + vec3(0.125, 0.0, 0.0); }\n"
    "float instance() { return 0.0; }\n";
constexpr char stage[] =
    "layout(location = 0) in vec4 position; layout(location = 1) in vec3 normal;\n"
    "layout(location = 0) uniform vec4 tint; layout(binding = 2, std140) uniform Block { vec4 block_tint; };\n"
    "layout(binding = 1) uniform sampler2D image; layout(binding = 2) uniform samplerBuffer texels; out vec4 colour;\n"
    "void main() {\n"
    "  vec3 sum = inputs() * tint.rgb * block_tint.rgb;\n"
    "  sum *= textureLod(image, vec2(0.6), 0.0).rgb * texelFetch(texels, 0).rgb;\n"
    "  colour = vec4(sum, normal.z);\n"
    "  gl_Position = vec4(position.x, 0.5 * position.y + instance() - 0.5, position.zw);\n"
    "}\n";

// Bright, and different for neighbours.
std::uint32_t colour_of(unsigned number, unsigned salt) {
  unsigned bits = (number + 1) * 2654435761U + salt * 40503U;
  bits ^= bits >> 15U;
  return 0xff404040U | (bits & 0x00bfbfbfU);
}

void attribute(GLuint location, GLint components, std::size_t offset) {
  gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, sizeof(Place),
                         reinterpret_cast<const void*>(offset));
}

// Triangles side by side, in rows of 16.
std::vector<Place> places_of(int triangles) {
  const int columns = triangles < 16 ? 2 : 16;
  const int rows = (triangles + columns - 1) / columns;
  std::vector<Place> places;
  for (int i = 0; i < triangles; ++i) {
    const float left = -0.95F + 1.9F * static_cast<float>(i % columns) / static_cast<float>(columns);
    const float low = -0.95F + 1.9F * static_cast<float>(i / columns) / static_cast<float>(rows);  // NOLINT: whole rows
    const float width = 1.8F / static_cast<float>(columns);
    const float height = 1.8F / static_cast<float>(rows);
    const float tag = static_cast<float>(i % 4);
    places.push_back({{left, low, 0, 1}, {0, 0, 1}, tag});
    places.push_back({{left + width, low, 0, 1}, {0, 0, 1}, 2});
    places.push_back({{left + width / 4, low + height, 0, 1}, {0, 0, 1}, 1});
  }
  return places;
}

GLuint scene_program(Test& t, bool reads_all) {
  const std::string head = t.is_gles() ? "precision highp sampler2D; precision highp samplerBuffer;\n" : "";
  return build_program(t, {.vertex = head + (reads_all ? all_inputs : few_inputs) + stage});
}

}  // namespace

GLuint make_buffer(GLenum target, const void* data, std::size_t bytes) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_COPY);
  return buffer;
}

ScenePrograms::~ScenePrograms() {
  for (const GLuint program : made_) gl.DeleteProgram(program);
}

GLuint ScenePrograms::find(Test& t, bool reads_all) {
  GLuint& program = made_[reads_all ? 1 : 0];
  if (program == 0) program = scene_program(t, reads_all);
  return program;
}

Scene::Scene(Test& t, int triangles, bool reads_all, ScenePrograms* shared)
    : vertex_count_(3 * triangles), is_desktop_(!t.is_gles()), is_shared_(shared != nullptr) {
  program = is_shared_ ? shared->find(t, reads_all) : scene_program(t, reads_all);
  gl.UseProgram(program);
  gl.Uniform4f(0, 1, 0.9F, 1, 1);
  gl.VertexAttrib4f(at_extra, 0.1F, 0.05F, 0, 0);
  gl.VertexAttribI4i(at_steps, 1, 0, 0, 0);
  for (unsigned i = 0; i < static_cast<unsigned>(vertex_count_); ++i) {
    first_colours_.push_back(colour_of(i, 1));
    second_colours_.push_back(colour_of(i, 2));
  }
  make_places();
  make_indices();
  make_textures();
  second_colours_.insert(second_colours_.end(), first_colours_.begin(), first_colours_.end());
  gl.BindBuffer(GL_ARRAY_BUFFER, colours);
}

void Scene::make_places() {
  const std::vector<Place> all = places_of(vertex_count_ / 3);
  places = make_buffer(GL_ARRAY_BUFFER, all.data(), all.size() * sizeof(Place));
  std::vector<std::uint32_t> both = first_colours_;
  both.insert(both.end(), second_colours_.begin(), second_colours_.end());
  colours = make_buffer(GL_ARRAY_BUFFER, both.data(), both.size() * 4);
  std::vector<std::uint16_t> elements;
  for (GLsizei i = 0; i < vertex_count_; ++i) {
    elements.push_back(static_cast<std::uint16_t>(i));
    second_indices_.push_back(static_cast<std::uint16_t>(i % (vertex_count_ / 2)));
  }
  second_indices_.insert(second_indices_.end(), elements.begin(), elements.end());
  elements.insert(elements.end(), second_indices_.begin(), second_indices_.begin() + vertex_count_);
  gl.BindVertexArray(0);
  indices = make_buffer(GL_ELEMENT_ARRAY_BUFFER, elements.data(), elements.size() * 2);
  array = make_array(0);
}

void Scene::make_indices() {
  const auto count = static_cast<GLuint>(vertex_count_);
  // DrawArraysIndirectCommand in 4 words, DrawElementsIndirectCommand in 5; 16 words from one content to the other.
  std::array<GLuint, 32> words{};
  for (const GLuint at : {0U, 16U}) {
    const GLuint drawn = at == 0 ? count : count / 2;
    words[at] = words[at + 4] = drawn;
    words[at + 1] = words[at + 5] = 1;
  }
  commands = make_buffer(GL_DRAW_INDIRECT_BUFFER, words.data(), sizeof(words));
  std::array<float, 2 * block_bytes / sizeof(float)> tints{};
  const std::array<float, 8> values = {1, 1, 0.9F, 1, 0.3F, 1, 0.5F, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    tints[i] = values[i];
    tints[block_bytes / sizeof(float) + i] = values[4 + i];
  }
  block = make_buffer(GL_UNIFORM_BUFFER, tints.data(), sizeof(tints));
  gl.BindBufferRange(GL_UNIFORM_BUFFER, block_binding, block, 0, 16);
}

void Scene::make_textures() {
  gl.GenTextures(1, &image);
  gl.ActiveTexture(GL_TEXTURE0 + image_unit);
  gl.BindTexture(GL_TEXTURE_2D, image);
  const std::array<std::uint32_t, 4> pixels = {0xff202020, 0xffff4040, 0xff40ff40, 0xffe6f0ff};
  const std::uint32_t smaller = 0xff60c0ff;
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  gl.TexImage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &smaller);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1);
  std::array<std::uint32_t, 128> texel{};
  texel[0] = 0xffffe6ff;
  texel[64] = 0xff4080ff;  // 256 bytes on, where a range may begin
  texels = make_buffer(GL_TEXTURE_BUFFER, texel.data(), sizeof(texel));
  gl.GenTextures(1, &texel_image);
  gl.ActiveTexture(GL_TEXTURE0 + texel_unit);
  gl.BindTexture(GL_TEXTURE_BUFFER, texel_image);
  gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA8, texels);
  gl.ActiveTexture(GL_TEXTURE0 + image_unit);
}

void Scene::point_at(GLintptr offset, GLsizei stride) const {
  gl.VertexAttribPointer(at_colour, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, reinterpret_cast<const void*>(offset));
}

GLuint Scene::make_array(GLintptr offset) const {
  GLuint name = 0;
  gl.GenVertexArrays(1, &name);
  gl.BindVertexArray(name);
  gl.BindBuffer(GL_ARRAY_BUFFER, places);
  attribute(at_position, 4, offsetof(Place, position));
  attribute(at_normal, 3, offsetof(Place, normal));
  gl.DepthTagPointerARK(GL_FLOAT, sizeof(Place), reinterpret_cast<const void*>(offsetof(Place, tag)));
  gl.Enable(GL_DEPTH_TAG_ARRAY_ARK);
  gl.BindBuffer(GL_ARRAY_BUFFER, colours);
  gl.EnableVertexAttribArray(at_colour);
  point_at(offset);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  return name;
}

Scene::~Scene() {
  gl.BindSampler(image_unit, 0);
  if (is_desktop_) gl.Disable(GL_PRIMITIVE_RESTART);
  gl.BindVertexArray(0);
  gl.DeleteVertexArrays(1, &array);
  for (const GLuint buffer : {places, colours, indices, commands, block, texels}) gl.DeleteBuffers(1, &buffer);
  gl.DeleteBuffers(static_cast<GLsizei>(made.size()), made.data());
  gl.DeleteTextures(1, &image);
  gl.DeleteTextures(1, &texel_image);
  if (feedback != 0) gl.DeleteTransformFeedbacks(1, &feedback);
  gl.UseProgram(0);
  if (!is_shared_) gl.DeleteProgram(program);
}

}  // namespace glark::conformance
