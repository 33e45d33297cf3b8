// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Normals that a pass over a mesh has, for the passes that have none: a shadow map or a selection pass often enables the
// positions alone. No GL.
#pragma once

#include <optional>

#include "glark/core/state/arrays/vertex_arrays.h"

namespace glark::core {

// Two arrays of one draw: vertex i has the i-th element of both.
class NormalsBeside {
 public:
  // Notes the arrays of a pass. Only buffers count: client memory may be gone when another pass is drawn. `lender_lives`:
  // nobody has deleted the buffer of the normals that were noted last.
  void note(const AttributeSource& positions, const AttributeSource& normals, bool lender_lives);
  const AttributeSource& lender() const { return normals_; }
  // Returns the array with the normals of these positions. Nothing: none is known, or passes disagree about it.
  std::optional<AttributeSource> find(const AttributeSource& positions) const;

 private:
  bool known_ = false;
  bool disputed_ = false;  // the same positions had other normals, or parts of them have
  AttributeSource positions_;
  AttributeSource normals_;
};

// Returns whether no call can tell the source of this generic attribute from GL's initial one.
bool is_initial(const AttributeSource& source, GLuint index);

}  // namespace glark::core
