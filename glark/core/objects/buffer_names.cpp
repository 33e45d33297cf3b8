// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/objects/buffer_names.h"

#include <cstring>
#include <mutex>

#include "glark/core/objects/get_integer.h"

namespace glark::core {
namespace {

// An empty buffer of ours has the largest name in each share group. Then glGenBuffers gives the application small names, and
// never one of ours: Mesa 22.3 gives the name above the largest one that was in use, and looks for a free one from 1 on only
// if that was the last.
constexpr GLuint largest = 0xFFFFFFFE;
constexpr GLuint least = 0x80000000;

// The other names, downwards from the largest one. Two share groups never have the same name. A name comes again after all
// others: in Mesa 22.3, a vertex array that holds a deleted buffer still holds it after glBindVertexBuffer with a new buffer
// of that name.
class LargeNames {
 public:
  GLuint take() {
    next_ = next_ > least ? next_ - 1 : largest - 1;
    return next_;
  }

  std::mutex mutex;  // held until a buffer has the name, so that no other thread finds the name free

 private:
  GLuint next_ = largest;
};

LargeNames& large_names() {
  static auto* const names = new LargeNames;  // never destroyed: contexts may end after static objects do
  return *names;
}

// A core context refuses names that glGenBuffers did not give.
bool takes_chosen_names(const gl::Dispatch& gl) {
  const auto* version = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
  constexpr char es[] = "OpenGL ES";
  return (version != nullptr && std::strncmp(version, es, sizeof(es) - 1) == 0) ||
         (get_integer(gl, GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT) == 0;
}

}  // namespace

GLuint bind_new_buffer(const gl::Dispatch& gl) {
  if (!takes_chosen_names(gl)) {
    GLuint name = 0;
    gl.GenBuffers(1, &name);
    gl.BindBuffer(GL_COPY_WRITE_BUFFER, name);
    return name;
  }
  const std::lock_guard lock(large_names().mutex);
  if (gl.IsBuffer(largest) == GL_FALSE) {
    gl.BindBuffer(GL_COPY_WRITE_BUFFER, largest);
  }
  GLuint name = large_names().take();
  while (gl.IsBuffer(name) == GL_TRUE) {
    name = large_names().take();
  }
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, name);
  return name;
}

}  // namespace glark::core
