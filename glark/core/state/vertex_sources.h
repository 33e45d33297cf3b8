// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What makes a vertex of glArrayElement, and of glEvalCoord and glEvalPoint. OpenGL 4.6 compatibility, 10.3.9 and 23.1.
#pragma once

namespace glark::core {

enum class VertexSource { call, elements, map1, map2 };

// Which of them give vertices now.
struct VertexSources {
  bool elements = false;  // an array of positions is enabled
  bool map1 = false;      // a map of positions is enabled: one variable
  bool map2 = false;      // two variables

  bool give(VertexSource source) const {
    switch (source) {
      case VertexSource::elements: return elements;
      case VertexSource::map1: return map1;
      case VertexSource::map2: return map2;
      default: return true;
    }
  }
};

}  // namespace glark::core
