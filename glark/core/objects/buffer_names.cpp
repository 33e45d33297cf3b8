// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/objects/buffer_names.h"

#include <cstring>
#include <mutex>
#include <vector>

#include "glark/core/objects/get_integer.h"

namespace glark::core {
namespace {

// The first buffer of ours in a share group has the largest name. Then glGenBuffers gives the application the names that it
// gives without ours, and never one of ours: Mesa 22.3 gives the name above the largest one in use, and looks for a free
// one from 1 on only if that was the last.
constexpr GLuint largest = 0xFFFFFFFE;
constexpr GLuint least = 0x80000000;

// The other names, downwards from the largest one. Two share groups never have the same name.
class LargeNames {
 public:
  GLuint take() {
    if (free_.empty()) {
      return next_--;
    }
    const GLuint name = free_.back();
    free_.pop_back();
    return name;
  }
  void give_back(GLuint name) { free_.push_back(name); }

  std::mutex mutex;  // held until a buffer has the name, so that no other thread finds the name free

 private:
  std::vector<GLuint> free_;
  GLuint next_ = largest - 1;
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
  GLuint name = largest;
  while (gl.IsBuffer(name) == GL_TRUE) {
    name = large_names().take();
  }
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, name);
  return name;
}

void delete_buffer(const gl::Dispatch& gl, GLuint name) {
  const std::lock_guard lock(large_names().mutex);
  gl.DeleteBuffers(1, &name);
  if (name >= least && name < largest) {
    large_names().give_back(name);
  }
}

}  // namespace glark::core
