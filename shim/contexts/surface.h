// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "shim/contexts/provider.h"

namespace glark::shim {

// The target of a context's drawing. surface_size() asks for its size when it is needed.
struct Surface {
  void* display = nullptr;
  void* drawable = nullptr;  // an XID, an EGLSurface; null for OSMesa and for a context without a surface
  int width = 0;             // OSMesa only
  int height = 0;
  bool operator==(const Surface&) const = default;
};

struct Size {
  int width = 0;
  int height = 0;
  bool operator==(const Size&) const = default;
};

}  // namespace glark::shim
