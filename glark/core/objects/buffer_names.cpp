// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/objects/buffer_names.h"

#include <cstring>
#include <mutex>
#include <vector>

#include "glark/core/objects/get_integer.h"

namespace glark::core {
namespace {

// Of all contexts: two share groups never have the same name, which costs nothing.
class LargeNames {
 public:
  GLuint take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) {
      return next_--;
    }
    const GLuint name = free_.back();
    free_.pop_back();
    return name;
  }

  void give_back(GLuint name) {
    const std::lock_guard lock(mutex_);
    free_.push_back(name);
  }

  // Downwards from the largest name but one: glGenBuffers still gives the application the names that it gives without
  // ours, and never one of these. Mesa gives names above the largest one in use, and searches only if there is none.
  static constexpr GLuint last = 0xFFFFFFFE;
  static constexpr GLuint least = 0x80000000;

 private:
  std::mutex mutex_;
  std::vector<GLuint> free_;
  GLuint next_ = last;
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
  GLuint name = 0;
  if (takes_chosen_names(gl)) {
    do {
      name = large_names().take();
    } while (gl.IsBuffer(name) == GL_TRUE);  // the application has chosen it, too
  } else {
    gl.GenBuffers(1, &name);
  }
  gl.BindBuffer(GL_COPY_WRITE_BUFFER, name);
  return name;
}

void delete_buffer(const gl::Dispatch& gl, GLuint name) {
  gl.DeleteBuffers(1, &name);
  if (name >= LargeNames::least) {
    large_names().give_back(name);
  }
}

}  // namespace glark::core
