// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The capture programs of a share group. Derived programs, which contexts share, refer to them by name, so none is deleted
// before the group is gone, and then by GL.
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "glark/gl/types.h"

namespace glark::core {

struct CapturePrograms {
  std::mutex mutex;
  std::map<std::string, GLuint> of_vertex_source;  // 0: it cannot be built
};

}  // namespace glark::core
