// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The inputs of the vertex stage: the vertex arrays, the buffers bound to targets, and the current attribute values.
// State of arrays and buffers that the hooks do not know is queried from GL.
#pragma once

#include "glark/core/state/arrays/bound_buffers.h"
#include "glark/core/state/arrays/buffer_stamps.h"
#include "glark/core/state/arrays/current_values.h"
#include "glark/core/state/arrays/vertex_arrays.h"
#include "glark/core/state/bindings.h"
#include "glark/core/state/capabilities.h"
#include "glark/core/state/immediate_mode.h"
#include "glark/core/state/stamps.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

class ArrayState {
 public:
  // The objects that array state depends on; all of them outlive the array state.
  struct Neighbours {
    const gl::Dispatch& gl;
    const Capabilities& capabilities;
    Bindings& bindings;
    const ImmediateMode& immediate;
    const BufferStamps& buffers;
    Stamps& stamps;
  };
  explicit ArrayState(const Neighbours& neighbours) : of_(neighbours) { forget_current_values(); }

  BoundBuffers& bound_buffers() { return bound_buffers_; }
  const BoundBuffers& bound_buffers() const { return bound_buffers_; }
  VertexArrays& vertex_arrays() { return vertex_arrays_; }
  // The vertex array that is bound, to read it. Hooks change it by VertexArrays::change().
  VertexArray& current() { return vertex_arrays_.current(of_.bindings.vertex_array); }

  // The buffer bound to a target. Queries GL where that is not known.
  BoundBuffer bound_buffer(GLenum target);
  // The source of an attribute of the bound vertex array, and the buffer of its indices. Query GL where they are not
  // known.
  const AttributeSource& attribute_source(int slot);
  const BoundBuffer& element_buffer();

  CurrentValues& current_values() { return current_values_; }
  const CurrentValues& current_values() const { return current_values_; }
  // Something may have changed all current values.
  void forget_current_values() { current_values_.forget(of_.stamps.next()); }

  // The unit that glTexCoordPointer sets (glClientActiveTexture); 0: not known.
  GLenum client_texture() const { return client_texture_; }
  void set_client_texture(GLenum unit) { client_texture_ = unit; }
  // Reads the bound vertex array and that unit, which the hooks follow from then on.
  void read_client_state();

 private:
  void confirm(BoundBuffer& bound, GLuint name);
  std::uint64_t generation_of(GLuint name);

  Neighbours of_;
  BoundBuffers bound_buffers_;
  VertexArrays vertex_arrays_;
  CurrentValues current_values_;
  GLenum client_texture_ = 0;
};

}  // namespace glark::core
