// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the draws of changed_draw.h read: one source of each kind that GL has. Each buffer holds its first content and
// then another one, so that a change has something to change to.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "conformance/support/program.h"

namespace glark::conformance {

// Further inputs of the scene's program.
inline constexpr GLuint at_steps = 7;  // ivec4, a current value

inline constexpr GLintptr block_bytes = 256;  // from one content of the uniform block to the other
inline constexpr GLuint block_binding = 2;
inline constexpr GLuint image_unit = 1;
inline constexpr GLuint texel_unit = 2;

// The programs of several scenes of one case, so that they are compiled once.
class ScenePrograms {
 public:
  ScenePrograms() = default;
  ~ScenePrograms();
  ScenePrograms(const ScenePrograms&) = delete;
  ScenePrograms& operator=(const ScenePrograms&) = delete;

  GLuint find(Test& t, bool reads_all);

 private:
  std::array<GLuint, 2> made_{};  // by reads_all
};

// The picture shows each of them: colour = (colours + current + steps / 8) * tint * block * image * texel.
struct Scene {
  // `reads_all`: the program also reads integers and gl_InstanceID. An implementation may keep less of such a draw.
  // shared: nullptr for a program of its own, which may change.
  Scene(Test& t, int triangles, bool reads_all, ScenePrograms* shared = nullptr);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  GLsizei vertices() const { return vertex_count_; }
  GLsizeiptr colour_bytes() const { return 4 * GLsizeiptr{vertex_count_}; }  // of one content
  // Where the other content begins, in bytes.
  GLintptr other_colours() const { return 4 * vertex_count_; }
  GLintptr other_indices() const { return 2 * vertex_count_; }
  GLsizeiptr all_colour_bytes() const { return 2 * colour_bytes(); }
  // The colours of the other content, RGBA8, and then those of the first one.
  const std::vector<std::uint32_t>& new_colours() const { return second_colours_; }
  // The indices in the other order as well.
  const std::vector<std::uint16_t>& new_indices() const { return second_indices_; }
  // Points the array of colours at a place in the bound buffer.
  void point_at(GLintptr offset, GLsizei stride = 4) const;
  // Makes and binds a vertex array like the first one, with colours from `offset`.
  GLuint make_array(GLintptr offset) const;

  GLuint program = 0;
  GLuint array = 0;     // bound
  GLuint places = 0;    // positions, normals and tags
  GLuint colours = 0;   // bound to GL_ARRAY_BUFFER
  GLuint indices = 0;   // GLushort: all vertices; then the first half of them twice
  GLuint commands = 0;  // for arrays, for indices; then the same for half of the vertices
  GLuint block = 0;
  GLuint image = 0;
  GLuint texels = 0;  // the buffer of texel_image
  GLuint texel_image = 0;
  GLuint feedback = 0;            // a transform feedback object that has captured all vertices; not in OpenGL ES
  std::vector<GLuint> made = {};  // further buffers, deleted at the end

 private:
  void make_places();
  void make_indices();
  void make_textures();

  GLsizei vertex_count_;
  bool is_desktop_;
  bool is_shared_;  // the program
  std::vector<std::uint32_t> first_colours_;
  std::vector<std::uint32_t> second_colours_;
  std::vector<std::uint16_t> second_indices_;
};

// A buffer with these bytes, bound to the target.
GLuint make_buffer(GLenum target, const void* data, std::size_t bytes);

}  // namespace glark::conformance
