// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The captured records as texels, one for each word.
#pragma once

#include <cstdint>

#include "glark/core/capture/coarse_triangles.h"
#include "glark/core/capture/layout.h"
#include "glark/core/objects/buffer_texels.h"

namespace glark::capture {

inline std::int64_t record_bytes(const Layout& layout, std::uint64_t triangles) {
  return static_cast<std::int64_t>(triangles) * layout.triangle_words() * 4;
}

inline core::BufferTexels::Range record_texels(const Layout& layout, const CoarseTriangles& triangles) {
  return {triangles.buffer, triangles.offset, record_bytes(layout, triangles.count)};
}

}  // namespace glark::capture
