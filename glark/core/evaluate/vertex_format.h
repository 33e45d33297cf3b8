// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Where a vertex array finds the vertex inputs of the application in refined vertices.
#pragma once

#include <vector>

#include "glark/core/capture/record.h"
#include "glark/core/objects/gpu_buffer.h"
#include "glark/core/state/arrays/attribute_slots.h"

namespace glark::evaluate {

struct VertexAttribute {
  int slot = core::no_slot;
  GLint components = 0;  // floats
  int offset = 0;        // first word in a refined vertex
  bool operator==(const VertexAttribute&) const = default;
};

struct VertexFormat {
  std::vector<VertexAttribute> attributes;  // empty: an input is no float, or GL has no array for it
  int words = 0;                            // of a refined vertex
};

// Fields that the vertex stage reads. Refined vertices hold these.
std::vector<capture::Field> copied_fields(const std::vector<capture::Field>& fields);
VertexFormat vertex_format(const std::vector<capture::Field>& fields);

// Makes a vertex array of ours. Leaves it bound; restores all other bindings. 0: GL has no memory.
GLuint make_vertex_array(const gl::Dispatch& gl, const VertexFormat& format, const core::GpuBuffer& vertices,
                         GLuint indices);

}  // namespace glark::evaluate
