// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/random/world.h"

#include <algorithm>
#include <cstring>

#include "conformance/random/stage_program.h"
#include "conformance/support/capture.h"

namespace glark::conformance {
namespace {

constexpr int all_vertices = 288;  // an index of a byte, and a base vertex
constexpr std::size_t data_floats = 4096;

struct Place {
  std::array<float, 4> position;
  std::array<float, 3> normal;
  float tag;
  std::array<std::uint8_t, 4> byte_tag;
  std::array<std::uint16_t, 2> short_tag;
  std::uint32_t integer_tag;
  std::uint32_t unused;
};
static_assert(sizeof(Place) == place_bytes);

std::uint32_t mixed(std::uint32_t number, std::uint32_t salt) {
  std::uint32_t bits = (number + 1) * 2654435761U + salt * 40503U;
  bits ^= bits >> 15U;
  bits *= 2246822519U;
  return bits ^ (bits >> 13U);
}

// A float from 0.25 to 1. Neither half of it is a half-precision NaN or infinity.
float element(std::uint32_t number, std::uint32_t salt) {
  const std::uint32_t bits = 0x3e800000U + (mixed(number, salt) % 256U << 16U) + (mixed(number, salt + 7) & 0x3bffU);
  float value = 0;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

// Triangles in 4 rows of 4. The tags of the first places depend on the type alone; those of the others vary.
std::vector<Place> places_of(unsigned salt, bool is_fixed) {
  std::vector<Place> all;
  for (int i = 0; i < all_vertices; ++i) {
    const int triangle = i % drawn_vertices / 3;
    const int corner = i % 3;
    const float left = -0.95F + 0.48F * static_cast<float>(triangle % 4) + 0.03F * static_cast<float>(salt);
    const int row = triangle / 4;
    const float low = -0.95F + 0.48F * static_cast<float>(row);
    const float x = left + (corner == 1 ? 0.44F : corner == 2 ? 0.1F : 0.0F);
    const float y = low + (corner == 2 ? 0.42F : 0.0F);
    const auto tag = static_cast<std::uint8_t>((triangle + (triangle % 2) * corner) % 4);
    const auto of = [&](GLenum type) { return static_cast<std::uint8_t>(salt == 0 ? tag_of_type(type) : tag); };
    Place place = {{x, y, 0, 1},
                   {0, 0, 1},
                   static_cast<float>(of(GL_FLOAT)),
                   {of(GL_UNSIGNED_BYTE), 0, 0, 0},
                   {of(GL_UNSIGNED_SHORT), 0},
                   of(GL_UNSIGNED_INT),
                   0};
    if (is_fixed) {
      place.position = {8 * x, 8 * y, 0.5F * static_cast<float>((triangle + corner) % 5) - 1, 1};
      place.normal = {x, 0.5F * y, 0.5F + 0.5F * static_cast<float>(corner)};
    }
    all.push_back(place);
  }
  return all;
}

GLuint buffer_of(GLenum target, const void* data, std::size_t bytes) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_COPY);
  return buffer;
}

void attribute(GLuint index, GLint size, GLenum type, GLintptr offset) {
  gl.VertexAttribPointer(index, size, type, GL_FALSE, place_bytes, reinterpret_cast<const void*>(offset));
  gl.EnableVertexAttribArray(index);
}

GLuint integer_at(GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return static_cast<GLuint>(value);
}

}  // namespace

int tag_of_type(GLenum type) {
  return type == GL_FLOAT            ? 2
         : type == GL_UNSIGNED_BYTE  ? 1
         : type == GL_UNSIGNED_SHORT ? 3
         : type == GL_UNSIGNED_INT   ? 0
                                     : -1;
}

void point_at_places(const World& w, std::size_t which) {
  const GLuint before = integer_at(GL_ARRAY_BUFFER_BINDING);
  gl.BindBuffer(GL_ARRAY_BUFFER, w.places[which]);
  attribute(at_position, 4, GL_FLOAT, 0);
  attribute(at_normal, 3, GL_FLOAT, normal_offset);
  gl.BindBuffer(GL_ARRAY_BUFFER, before);
  // No array that is enabled later reads from nowhere.
  for (const GLuint binding : std::initializer_list<GLuint>{at_extra, at_columns, at_columns + 1, spare_binding})
    gl.BindVertexBuffer(binding, w.data[which], 0, 16);
}

World::World(Test& test, WorldKind kind_of) : t(test), kind(kind_of) {
  make_data();
  make_elements();
  if (is_fixed()) {
    make_fixed();
  } else {
    make_programs();
    make_arrays();
  }
  make_queries();
  gl.ARKinit(3);
  gl.ARKParameteriARK(GL_REFINEMENT_ARK, GL_LINEAR_OUTPUTS_ARK);
  gl.ARKParameteriARK(GL_DEPTH_SOURCE_ARK, GL_UNIFORM_DEPTH_ARK);
  gl.ARKParameteriARK(GL_UNIFORM_DEPTH_LEVEL_ARK, 1);
  // Triangles may overlap, and an implementation may change their order. So each pixel shows the maximum of all of them.
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_MAX);
  t.expect_no_error("the objects of a random program");
}

void World::make_data() {
  for (std::size_t which = 0; which < data.size(); ++which) {
    std::vector<float> values;
    for (std::uint32_t i = 0; i < data_floats; ++i) values.push_back(element(i, static_cast<std::uint32_t>(which)));
    data[which] = buffer_of(GL_ARRAY_BUFFER, values.data(), values.size() * 4);
    const std::vector<double> wide(values.begin(), values.end());
    if (which < doubles.size()) doubles[which] = buffer_of(GL_ARRAY_BUFFER, wide.data(), wide.size() * 8);
    if (which == 0) memory = values;
  }
  for (std::size_t which = 0; which < places.size(); ++which) {
    const std::vector<Place> all = places_of(static_cast<unsigned>(which), is_fixed());
    places[which] = buffer_of(GL_ARRAY_BUFFER, all.data(), all.size() * sizeof(Place));
    places_memory.resize(all.size() * sizeof(Place));
    std::memcpy(places_memory.data(), all.data(), places_memory.size());
  }
  gl.BindBuffer(GL_ARRAY_BUFFER, data[0]);
}

// The lists are permutations of the triangles. The bytes also have a restart index for strips.
void World::make_elements() {
  std::vector<std::uint8_t> bytes(4096);
  for (int i = 0; i < 2 * drawn_vertices; ++i) {
    const int triangle = (i / 3 * 5 + i / drawn_vertices) % (drawn_vertices / 3);
    const auto index = static_cast<std::uint8_t>(3 * triangle + (i % 3 + i / drawn_vertices) % 3);
    bytes[static_cast<std::size_t>(i)] = index;
    bytes[static_cast<std::size_t>(restart_bytes + i)] = i % 7 == 3 ? 255 : index;
    elements_memory.push_back(index);
    std::memcpy(&bytes[static_cast<std::size_t>(short_indices + 2 * i)], &elements_memory.back(), 2);
    const std::uint32_t whole = index;
    std::memcpy(&bytes[static_cast<std::size_t>(integer_indices + 4 * i)], &whole, 4);
  }
  elements = buffer_of(GL_COPY_WRITE_BUFFER, bytes.data(), bytes.size());
  std::array<GLuint, 64> words{};
  for (std::size_t i = 0; i < 4; ++i) {  // commands of 8 words: for arrays, and for elements 32 words later
    const auto n = static_cast<GLuint>(i);
    const std::array<GLuint, 4> arrays = {12 + 3 * n, 1 + n % 2, 3 * n, 0};
    const std::array<GLuint, 5> indexed = {9 + 6 * n, 1 + (n + 1) % 2, 6 * n, n, 0};
    std::copy(arrays.begin(), arrays.end(), words.begin() + static_cast<std::ptrdiff_t>(8 * i));
    std::copy(indexed.begin(), indexed.end(), words.begin() + static_cast<std::ptrdiff_t>(32 + 8 * i));
  }
  commands = buffer_of(GL_DRAW_INDIRECT_BUFFER, words.data(), sizeof(words));
  captured = buffer_of(GL_COPY_WRITE_BUFFER, bytes.data(), bytes.size());
}

void World::make_programs() {
  for (std::size_t i = 0; i < programs.size(); ++i) programs[i] = stage_program(t, kind, static_cast<unsigned>(i));
  gl.GenProgramPipelines(static_cast<GLsizei>(pipelines.size()), pipelines.data());
  for (std::size_t i = 0; i < pipelines.size(); ++i)
    gl.UseProgramStages(pipelines[i], GL_VERTEX_SHADER_BIT | GL_FRAGMENT_SHADER_BIT, programs[i]);
  gl.BindProgramPipeline(pipelines[0]);
  gl.UseProgram(programs[0]);
  std::vector<float> tints(colour_blocks * colour_block_bytes / 4);
  for (std::uint32_t i = 0; i < tints.size(); ++i) tints[i] = element(i, 5);
  blocks = buffer_of(GL_UNIFORM_BUFFER, tints.data(), tints.size() * 4);
  gl.BindBufferRange(GL_UNIFORM_BUFFER, colour_block_binding, blocks, 0, 16);
}

void World::make_arrays() {
  gl.GenVertexArrays(static_cast<GLsizei>(arrays.size()), arrays.data());
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    gl.BindVertexArray(arrays[arrays.size() - 1 - i]);
    point_at_places(*this, i % 2);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, elements);
    gl.VertexAttribPointer(at_colour, 4, GL_FLOAT, GL_FALSE, 16, reinterpret_cast<const void*>(16 * i));
    gl.EnableVertexAttribArray(at_colour);
    for (const GLuint index : std::initializer_list<GLuint>{at_extra, at_columns}) {  // they share a binding
      gl.VertexAttribFormat(index, 4, GL_FLOAT, GL_FALSE, 4 * index);
      gl.VertexAttribBinding(index, spare_binding);
      if (i == 0 || (i == 1) == (index == at_columns)) gl.EnableVertexAttribArray(index);
    }
  }
  gl.VertexAttribI4i(at_integers, 1, 2, 3, 4);
  if (is_desktop())
    gl.VertexAttribL4d(at_doubles, 0.5, 0.25, 0.75, 1);  // before, the value of an input of doubles is undefined
}

// Two queries for conditional rendering: one has seen a pixel, the other none.
void World::make_queries() {
  const GLenum target = GL_ANY_SAMPLES_PASSED;
  gl.GenQueries(static_cast<GLsizei>(queries.size()), queries.data());
  for (const GLuint query : queries) {
    gl.BeginQuery(target, query);
    if (query == queries[1] && !is_fixed()) gl.DrawArrays(GL_TRIANGLES, 0, drawn_vertices);
    if (query == queries[1] && is_fixed()) gl.Rectf(-1, -1, 1, 1);
    gl.EndQuery(target);
    GLuint result = 0;
    gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &result);
  }
}

void World::make_fixed() {
  gl.GenTextures(static_cast<GLsizei>(textures.size()), textures.data());
  for (std::size_t i = 0; i < textures.size(); ++i) {
    std::array<GLubyte, 64> texels{};
    for (std::uint32_t k = 0; k < texels.size(); ++k)
      texels[k] = static_cast<GLubyte>(64 + mixed(k, static_cast<std::uint32_t>(i)) % 192);
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    gl.BindTexture(GL_TEXTURE_2D, textures[i]);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  }
  gl.ActiveTexture(GL_TEXTURE0);
  gl.Scalef(0.125F, 0.125F, 0.125F);  // places are from -8 to 8
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 2);  // the initial 0 depends on what 0 to the power of 0 is
  gl.VertexPointer(4, GL_FLOAT, place_bytes, places_memory.data());
  gl.EnableClientState(GL_VERTEX_ARRAY);
  for (GLuint list = 1; list <= 6; ++list) {
    gl.NewList(list, GL_COMPILE);
    gl.Color4f(0.25F * static_cast<float>(list), 0.5F, 1, 1);
    gl.EndList();
  }
}

World::~World() {
  if (!is_fixed()) {
    gl.BindVertexArray(0);
    gl.DeleteVertexArrays(static_cast<GLsizei>(arrays.size()), arrays.data());
    gl.UseProgram(0);
    gl.BindProgramPipeline(0);
    gl.DeleteProgramPipelines(static_cast<GLsizei>(pipelines.size()), pipelines.data());
    for (const GLuint program : programs) gl.DeleteProgram(program);
  }
  gl.DeleteBuffers(static_cast<GLsizei>(data.size()), data.data());
  gl.DeleteBuffers(static_cast<GLsizei>(doubles.size()), doubles.data());
  gl.DeleteBuffers(static_cast<GLsizei>(places.size()), places.data());
  for (const GLuint buffer : {blocks, elements, commands, captured}) gl.DeleteBuffers(1, &buffer);
  gl.DeleteQueries(static_cast<GLsizei>(queries.size()), queries.data());
}

GLuint World::any_float_attribute() { return float_attributes[values.below(float_attributes.size())]; }

GLuint World::program_in_use() const {
  const GLuint program = integer_at(GL_CURRENT_PROGRAM);
  if (program != 0) return program;
  GLint active = 0;
  gl.GetProgramPipelineiv(integer_at(GL_PROGRAM_PIPELINE_BINDING), GL_ACTIVE_PROGRAM, &active);
  return static_cast<GLuint>(active);
}

}  // namespace glark::conformance
