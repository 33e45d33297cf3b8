// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Tracks what may have changed in the fixed function since a draw read it.
#pragma once

#include "glark/core/state/fixed_function/matrices.h"

namespace glark::core {

class FixedFunctionChanges {
 public:
  // Lights, materials, texture generation and other state, but not the matrices.
  void touch() { stale_ = true; }
  bool stale() const { return stale_; }
  void mark_read() { stale_ = false; }
  Matrices& matrices() { return matrices_; }

 private:
  bool stale_ = true;
  Matrices matrices_;
};

}  // namespace glark::core
