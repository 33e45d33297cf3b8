// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "glark/core/capture/lent_array.h"
#include "glark/core/capture/record.h"
#include "glark/gl/types.h"

namespace glark::capture {

// How the coarse triangles of a draw are captured.
struct CapturePlan {
  GLuint program = 0;
  const std::vector<int>* inputs = nullptr;  // the attributes that the program reads, by core::AttributeSlot
  const Layout* layout = nullptr;            // layout of the records
  GLenum convention = 0;  // of the provoking vertex, set while the draw is captured; 0: the application's
  std::optional<LentArray> lent = std::nullopt;
};

}  // namespace glark::capture
