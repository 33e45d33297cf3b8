// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL without memory while refined vertices are made: each allocation and each mapping fails in turn. The picture stays,
// and the application sees no error.
#include "tests/core/evaluate/shape_scene.h"

namespace glark::core::test {
namespace {

const gl::Dispatch* real = nullptr;
int calls_until_failure = -1;  // less than 0: nothing fails
int failures = 0;

// GL has no command that raises GL_OUT_OF_MEMORY at will: any error of ours stands for it.
bool fails() {
  if (calls_until_failure < 0 || calls_until_failure-- > 0) return false;
  ++failures;
  real->Enable(0xFFFF);
  return true;
}

void buffer_data(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
  if (!fails()) real->BufferData(target, size, data, usage);
}
void* map_range(GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield access) {
  return fails() ? nullptr : real->MapBufferRange(target, offset, length, access);
}
void sub_data(GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
  if (!fails()) real->BufferSubData(target, offset, size, data);
}
void gen_vertex_arrays(GLsizei n, GLuint* arrays) {
  if (!fails()) real->GenVertexArrays(n, arrays);
}
GLuint create_program() { return fails() ? 0 : real->CreateProgram(); }
void link_program(GLuint program) {
  if (!fails()) real->LinkProgram(program);
}
void draw_instanced(GLenum mode, GLint first, GLsizei count, GLsizei instances) {
  if (!fails()) real->DrawArraysInstanced(mode, first, count, instances);
}

class KeptWithoutMemory : public testing::TestWithParam<ShapeKind> {
 protected:
  KeptWithoutMemory() : failing_(window_.gl) {
    real = &window_.gl;
    calls_until_failure = -1;
    failing_.BufferData = buffer_data;
    failing_.MapBufferRange = map_range;
    failing_.BufferSubData = sub_data;
    failing_.GenVertexArrays = gen_vertex_arrays;
    failing_.CreateProgram = create_program;
    failing_.LinkProgram = link_program;
    failing_.DrawArraysInstanced = draw_instanced;
  }
  ~KeptWithoutMemory() override { calls_until_failure = -1; }

  // The call after so many succeeds no more while the vertices are made. Returns whether there was such a call.
  bool fail_after(int calls) {
    ShapeScene scene(failing_, GetParam());
    const std::vector<GLubyte> picture = scene.draw_frame();
    EXPECT_EQ(scene.kept_of(4), 0U);
    failures = 0;
    calls_until_failure = calls;
    const bool same = scene.draw_frame() == picture;  // the vertices are made in this frame
    calls_until_failure = -1;
    EXPECT_TRUE(same) << "call " << calls;
    EXPECT_EQ(hook::GetError(scene.context()), static_cast<GLenum>(GL_NO_ERROR)) << "call " << calls;
    for (int again = 0; again < 4; ++again) EXPECT_EQ(scene.draw_frame(), picture) << "call " << calls;
    EXPECT_EQ(hook::GetError(scene.context()), static_cast<GLenum>(GL_NO_ERROR)) << "call " << calls;
    return failures > 0;
  }

  PlainContext window_;
  gl::Dispatch failing_;
};

INSTANTIATE_TEST_SUITE_P(All, KeptWithoutMemory,
                         testing::Values(ShapeKind::uniform, ShapeKind::tagged, ShapeKind::displaced));

TEST_P(KeptWithoutMemory, EachCallFailsInTurn) {
  int calls = 0;
  while (fail_after(calls)) ++calls;
  EXPECT_GT(calls, 6);
}

}  // namespace
}  // namespace glark::core::test
