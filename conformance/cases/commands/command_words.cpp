// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Indirect draws that repeat, and then one word of one command changes: each word, by each way to write it (GL 4.6, 10.4).
#include <fmt/core.h>

#include <array>
#include <cstring>
#include <span>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/capture.h"
#include "conformance/support/counted.h"

namespace glark::conformance {
namespace {

constexpr GLsizei word_triangles = 6;  // in the arrays
constexpr GLuint at_place = 7;         // of an instance
constexpr std::size_t words_each = 8;  // from one command to the next: a stride of 32 bytes
using CommandWords = std::array<GLuint, 3 * words_each>;

const void* at_word(std::size_t word) { return reinterpret_cast<const void*>(4 * word); }

struct Word {
  const char* leaf;
  std::size_t at;  // in the command
  GLuint first;    // its first value, which is that of each command
  std::array<GLuint, 4> others;
  bool is_desktop = false;  // ES has a reserved word there
};

constexpr Word array_words[] = {{"count", 0, 9, {3, 12, 0, 9}},
                                {"instance_count", 1, 2, {1, 3, 0, 2}},
                                {"first", 2, 3, {0, 6, 3, 1}},
                                {"base_instance", 3, 0, {1, 2, 0, 1}, true}};
constexpr Word element_words[] = {{"count", 0, 9, {3, 12, 0, 9}},
                                  {"instance_count", 1, 2, {1, 3, 0, 2}},
                                  {"first_index", 2, 3, {0, 6, 3, 1}},
                                  {"base_vertex", 3, 0, {3, 6, 0, 1}},
                                  {"base_instance", 4, 0, {1, 2, 0, 1}, true}};

struct WordPath {
  const char* leaf;
  bool has_indices;
  std::size_t changed;  // which command changes, of those that are drawn
  void (*draw)();
  Apis apis = every_api;
  int version = 0;
};

constexpr WordPath word_paths[] = {
    {"arrays", false, 0, [] { gl.DrawArraysIndirect(GL_TRIANGLES, nullptr); }},
    {"elements", true, 0, [] { gl.DrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, nullptr); }},
    {"arrays_behind", false, 2, [] { gl.DrawArraysIndirect(GL_TRIANGLES, at_word(2 * words_each)); }},
    {"elements_behind", true, 2,
     [] { gl.DrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, at_word(2 * words_each)); }},
    {"multi_arrays", false, 1, [] { gl.MultiDrawArraysIndirect(GL_TRIANGLES, nullptr, 3, 4 * words_each); },
     desktop_apis},
    {"multi_elements", true, 1,
     [] { gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, nullptr, 3, 4 * words_each); }, desktop_apis},
    {"last_of_multi_arrays", false, 2, [] { gl.MultiDrawArraysIndirect(GL_TRIANGLES, nullptr, 3, 4 * words_each); },
     desktop_apis},
    {"last_of_multi_elements", true, 2,
     [] { gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, nullptr, 3, 4 * words_each); }, desktop_apis},
    {"counted_arrays", false, 1, [] { gl.MultiDrawArraysIndirectCount(GL_TRIANGLES, nullptr, 0, 3, 4 * words_each); },
     desktop_apis, 46},
    {"counted_elements", true, 1,
     [] { gl.MultiDrawElementsIndirectCount(GL_TRIANGLES, GL_UNSIGNED_SHORT, nullptr, 0, 3, 4 * words_each); },
     desktop_apis, 46},
};

// Writes one word of the buffer of commands, which is bound.
struct WordWrite {
  const char* name;
  void (*write)(Test& t, GLuint buffer, std::size_t word, GLuint value);
  Apis apis = every_api;
  int version = 0;
};

void write_mapped_word(GLbitfield flags, std::size_t word, GLuint value) {
  void* const mapped =
      gl.MapBufferRange(GL_DRAW_INDIRECT_BUFFER, static_cast<GLintptr>(4 * word), 4, GL_MAP_WRITE_BIT | flags);
  if (mapped != nullptr) std::memcpy(mapped, &value, 4);
  if ((flags & GL_MAP_FLUSH_EXPLICIT_BIT) != 0) gl.FlushMappedBufferRange(GL_DRAW_INDIRECT_BUFFER, 0, 4);
  gl.UnmapBuffer(GL_DRAW_INDIRECT_BUFFER);
}

void store_word(Test& t, GLuint buffer, std::size_t word, GLuint value) {
  GLint in_use = 0;
  gl.GetIntegerv(GL_CURRENT_PROGRAM, &in_use);
  const std::string text =
      glsl_head(t) + fmt::format(
                         "layout(local_size_x = 1) in;\nlayout(std430, binding = 0) buffer Words {{ uint w[]; }};\n"
                         "void main() {{ w[{}] = {}u; }}\n",
                         word, value);
  const char* const source = text.c_str();
  const GLuint program = gl.CreateShaderProgramv(GL_COMPUTE_SHADER, 1, &source);
  gl.UseProgram(program);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
  gl.DispatchCompute(1, 1, 1);
  gl.MemoryBarrier(GL_COMMAND_BARRIER_BIT);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, 0);
  gl.UseProgram(static_cast<GLuint>(in_use));
  gl.DeleteProgram(program);
}

void copy_word(Test&, GLuint, std::size_t word, GLuint value) {
  GLuint source = 0;
  gl.GenBuffers(1, &source);
  gl.BindBuffer(GL_COPY_READ_BUFFER, source);
  gl.BufferData(GL_COPY_READ_BUFFER, 4, &value, GL_STATIC_DRAW);
  gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_DRAW_INDIRECT_BUFFER, 0, static_cast<GLintptr>(4 * word), 4);
  gl.DeleteBuffers(1, &source);
}

constexpr WordWrite word_writes[] = {
    {"BufferSubData",
     [](Test&, GLuint, std::size_t word, GLuint value) {
       gl.BufferSubData(GL_DRAW_INDIRECT_BUFFER, static_cast<GLintptr>(4 * word), 4, &value);
     }},
    {"BufferSubData of another target",
     [](Test&, GLuint buffer, std::size_t word, GLuint value) {
       gl.BindBuffer(GL_COPY_WRITE_BUFFER, buffer);
       gl.BufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(4 * word), 4, &value);
       gl.BindBuffer(GL_COPY_WRITE_BUFFER, 0);
     }},
    {"MapBufferRange", [](Test&, GLuint, std::size_t word, GLuint value) { write_mapped_word(0, word, value); }},
    {"FlushMappedBufferRange",
     [](Test&, GLuint, std::size_t word, GLuint value) { write_mapped_word(GL_MAP_FLUSH_EXPLICIT_BIT, word, value); }},
    {"CopyBufferSubData", copy_word},
    {"a compute shader", store_word},
    {"MapBuffer",
     [](Test&, GLuint, std::size_t word, GLuint value) {
       auto* const mapped = static_cast<GLuint*>(gl.MapBuffer(GL_DRAW_INDIRECT_BUFFER, GL_READ_WRITE));
       if (mapped != nullptr) mapped[word] = value;
       gl.UnmapBuffer(GL_DRAW_INDIRECT_BUFFER);
     },
     desktop_apis},
    {"ClearBufferSubData",
     [](Test&, GLuint, std::size_t word, GLuint value) {
       gl.ClearBufferSubData(GL_DRAW_INDIRECT_BUFFER, GL_R32UI, static_cast<GLintptr>(4 * word), 4, GL_RED_INTEGER,
                             GL_UNSIGNED_INT, &value);
     },
     desktop_apis},
    {"NamedBufferSubData",
     [](Test&, GLuint buffer, std::size_t word, GLuint value) {
       gl.NamedBufferSubData(buffer, static_cast<GLintptr>(4 * word), 4, &value);
     },
     desktop_apis, 45},
};

// What the vertex stage reads besides its arrays. An implementation may keep less of the second draw.
constexpr const char* word_stages[] = {
    "vec2 moved() { return vec2(0.0); }\n",
    "vec2 moved() { return vec2(0.0, 0.3 * float(gl_InstanceID)); }\n",
};

GLuint word_program(Test& t, std::size_t stage) {
  return build_program(t,
                       {.vertex = std::string(word_stages[stage]) +
                                  "layout(location = 0) in vec4 position; layout(location = 3) in vec4 vertex_colour;\n"
                                  "layout(location = 7) in vec4 place; out vec4 colour;\n"
                                  "void main() { colour = vertex_colour * vec4(1.0, place.z, place.w, 1.0);\n"
                                  "  gl_Position = vec4(position.xy + place.xy + moved(), position.zw); }\n"});
}

// Triangles side by side, with colours of their own; instances one above the other.
struct WordScene {
  GLuint commands = 0;
  GLuint array = 0;
  std::vector<GLuint> buffers;

  WordScene(const WordPath& path, const CommandWords& words) {
    Mesh mesh;
    for (int i = 0; i < word_triangles; ++i)
      for (MeshVertex vertex : one_triangle({1, 2, 1})) {
        vertex.position[0] = 0.15F * vertex.position[0] - 0.82F + 0.31F * static_cast<float>(i);
        vertex.position[1] = 0.15F * vertex.position[1] - 0.7F;
        for (std::size_t k = 0; k < 3; ++k) vertex.colour[k] = 0.4F + 0.1F * static_cast<float>((i * 2 + int(k)) % 6);
        mesh.push_back(vertex);
      }
    const MeshBuffers uploaded = upload(mesh);
    array = uploaded.array;
    buffers.push_back(uploaded.buffer);
    const Vec4 places[] = {{0, 0, 1, 1},    {0.02F, 0.35F, 0.5F, 1}, {0.04F, 0.7F, 1, 0.5F}, {0.06F, 1.05F, 0.7F, 0.3F},
                           {0, 1.3F, 1, 1}, {0.03F, 1.4F, 0.4F, 1}};
    make(GL_ARRAY_BUFFER, places, sizeof(places));
    gl.VertexAttribPointer(at_place, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.VertexAttribDivisor(at_place, 1);
    gl.EnableVertexAttribArray(at_place);
    std::array<GLushort, 3 * word_triangles> indices{};
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<GLushort>(i);
    if (path.has_indices) make(GL_ELEMENT_ARRAY_BUFFER, indices.data(), sizeof(indices));
    commands = make(GL_DRAW_INDIRECT_BUFFER, words.data(), sizeof(words));
    const GLuint drawn = 3;
    if (path.version == 46) make(GL_PARAMETER_BUFFER, &drawn, sizeof(drawn));
  }
  ~WordScene() {
    gl.BindVertexArray(0);
    gl.DeleteVertexArrays(1, &array);
    gl.DeleteBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
  }
  WordScene(const WordScene&) = delete;
  WordScene& operator=(const WordScene&) = delete;

 private:
  GLuint make(GLenum target, const void* data, std::size_t bytes) {
    GLuint name = 0;
    gl.GenBuffers(1, &name);
    gl.BindBuffer(target, name);
    gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
    buffers.push_back(name);
    return name;
  }
};

std::span<const Word> words_for(const WordPath& path) {
  return path.has_indices ? std::span<const Word>(element_words) : std::span<const Word>(array_words);
}

// The other commands draw the last triangle.
CommandWords words_of(const WordPath& path) {
  CommandWords words{};
  for (std::size_t command = 0; command < 3; ++command) {
    words[command * words_each] = 3;
    words[command * words_each + 1] = 1;
    words[command * words_each + 2] = 3 * (word_triangles - 1);
  }
  for (const Word& word : words_for(path)) words[path.changed * words_each + word.at] = word.first;
  return words;
}

constexpr GLint uniform_level = 2;

// Unrefined, 4^d triangles take the place of each one at a uniform depth.
void expect_command(Test& t, const WordPath& path, bool has_tags, const std::string& what) {
  std::vector<Picture> refined;
  GLuint triangles = 0;
  for (int again = 0; again < 2; ++again)
    refined.push_back(picture_of([&] { triangles = count_generated(path.draw); }));
  gl.Disable(GL_ARK);
  GLuint coarse = 0;
  const Picture plain = picture_of([&] { coarse = count_generated(path.draw); });
  gl.Enable(GL_ARK);
  for (const Picture& picture : refined) t.expect_same_picture(picture, plain, what, 4, 80);
  if (!has_tags) t.expect_equal(triangles, coarse << (2 * uniform_level), what + ": triangles");
}

void check_word(Test& t, const WordPath& path, const Word& word) {
  if (!t.is_gles() && t.version() < path.version) t.not_supported("these commands are not in this version");
  std::size_t turn = 0;
  for (const WordWrite& write : word_writes) {
    if (!write.apis.contains(t.api()) || (!t.is_gles() && t.version() < write.version)) continue;
    for (const bool has_tags : {false, true}) {
      const std::size_t stage = ++turn % std::size(word_stages);
      gl.UseProgram(word_program(t, stage));
      const WordScene scene(path, words_of(path));
      has_tags ? refine_by_tags(3) : refine_uniformly(uniform_level);
      const std::string with = fmt::format("{}, {}, stage {}", write.name, has_tags ? "tags" : "uniform depth", stage);
      for (int again = 0; again < 3; ++again) path.draw();
      expect_command(t, path, has_tags, "before: " + with);
      const bool is_often = turn % 4 < 2;
      for (const GLuint value : word.others) {
        if (is_often) repeat_often(path.draw);
        write.write(t, scene.commands, path.changed * words_each + word.at, value);
        expect_command(t, path, has_tags, fmt::format("{} is {} by {}", word.leaf, value, with));
      }
    }
  }
  t.expect_no_error("the draws");
}

// The pictures of all values differ from that of the first one, without refinement.
void check_word_shows(Test& t, const WordPath& path, const Word& word) {
  if (!t.is_gles() && t.version() < path.version) return;
  gl.UseProgram(word_program(t, 1));
  const WordScene scene(path, words_of(path));
  const Picture before = picture_of(path.draw);
  for (const GLuint value : word.others) {
    if (value == word.first) continue;
    word_writes[0].write(t, scene.commands, path.changed * words_each + word.at, value);
    t.expect(count_different(before, picture_of(path.draw), 8) > 20, fmt::format("{} as {} shows", word.leaf, value));
  }
}

}  // namespace

Cases command_words_cases() {
  Cases cases;
  for (const WordPath& path : word_paths)
    for (const Word& word : words_for(path)) {
      const Apis apis = word.is_desktop ? desktop_apis : path.apis;
      cases.push_back({.name = fmt::format("ark.draw.again.word.{}.{}", path.leaf, word.leaf),
                       .clauses = {"10.R.2-1", "11.R.13-1"},
                       .plan = "Repeat an indirect draw, change only this word of its command, by each way to write a "
                               "buffer, and compare picture and number of triangles with the unrefined draw.",
                       .wrong =
                           "The command before the change: commands are compared by some of their words, or not all "
                           "writes are noticed.",
                       .apis = apis,
                       .is_optional = path.version != 0,
                       .control = [&path, &word](Test& t) { check_word_shows(t, path, word); },
                       .check = [&path, &word](Test& t) { check_word(t, path, word); }});
    }
  return cases;
}

}  // namespace glark::conformance
