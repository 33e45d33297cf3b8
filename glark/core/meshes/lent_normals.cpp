// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/meshes/lent_normals.h"

namespace glark::core {
namespace {

GLintptr first_byte(const AttributeSource& source) {
  return source.offset + static_cast<GLintptr>(source.relative_offset);
}

GLsizei stride_of(const AttributeSource& source) {
  return source.stride != 0 ? source.stride : packed_stride(source.size != 0 ? source.size : 3, source.type);
}

bool holds_vectors(const AttributeSource& normals) {
  return (normals.type == GL_FLOAT || normals.normalized) && !normals.integer && normals.size <= 4;
}

bool can_lend(const AttributeSource& positions, const AttributeSource& normals) {
  return holds_vectors(normals) && positions.buffer != 0 && normals.buffer != 0 && positions.divisor == 0 &&
         normals.divisor == 0 && stride_of(positions) > 0 && stride_of(normals) > 0;
}

}  // namespace

void NormalsBeside::note(const AttributeSource& positions, const AttributeSource& normals, bool lender_lives) {
  if (disputed_ || !can_lend(positions, normals)) {
    known_ = false;
    return;
  }
  if (known_ && lender_lives) {
    const std::optional<AttributeSource> before = find(positions);
    disputed_ = !before || before->buffer != normals.buffer || first_byte(*before) != first_byte(normals);
  }
  known_ = true;
  positions_ = positions;
  normals_ = normals;
  normals_.size = normals.size != 0 ? normals.size : 3;  // GL gives no size for glNormalPointer
}

std::optional<AttributeSource> NormalsBeside::find(const AttributeSource& positions) const {
  if (!known_ || disputed_) {
    return std::nullopt;
  }
  const GLintptr distance = first_byte(positions) - first_byte(positions_);
  const GLintptr stride = stride_of(positions_);
  AttributeSource found = normals_;
  found.offset = first_byte(normals_) + distance / stride * stride_of(normals_);
  found.relative_offset = 0;
  found.stride = stride_of(normals_);
  const bool fits = distance % stride == 0 && stride_of(positions) == stride && found.offset >= 0;
  return fits ? std::optional(found) : std::nullopt;
}

bool is_initial(const AttributeSource& source, GLuint index) {
  return !source.enabled && source.binding == index && !source.normalized && !source.integer && source.size == 4 &&
         source.type == GL_FLOAT && source.relative_offset == 0 && source.divisor == 0 && source.buffer == 0 &&
         source.offset == 0 && (source.stride == 0 || source.stride == 4 * static_cast<GLsizei>(sizeof(GLfloat)));
}

}  // namespace glark::core
