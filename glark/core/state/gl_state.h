// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The application's GL state in one context. The hooks (glark/core/track) keep it up to date; what they cannot follow is marked as
// stale and read again from GL when it is needed.
#pragma once

#include <cstdint>

#include "glark/core/objects/error_scope.h"
#include "glark/core/objects/quiet.h"
#include "glark/core/state/arrays/bound_buffers.h"
#include "glark/core/state/arrays/current_values.h"
#include "glark/core/state/arrays/vertex_arrays.h"
#include "glark/core/state/attribute_stack.h"
#include "glark/core/state/bindings.h"
#include "glark/core/state/capabilities.h"
#include "glark/core/state/immediate_mode.h"
#include "glark/core/state/lists/list_compilation.h"
#include "glark/core/state/matrices.h"
#include "glark/core/state/programs/programs.h"
#include "glark/core/state/query_surplus.h"
#include "glark/core/state/share_group.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

class GlState {
 public:
  GlState(const gl::Dispatch& gl, const Capabilities& capabilities, ShareGroup& share, PendingError& pending,
          ProgramWatcher& watcher);

  Bindings& bindings() { return bindings_; }
  const Bindings& bindings() const { return bindings_; }
  bool bindings_stale() const { return bindings_stale_; }
  // A call that the hooks cannot follow (a display list, glPopAttrib) may have changed the bindings.
  void forget_bindings() { bindings_stale_ = true; }
  // Reads the bindings again if they are stale.
  void refresh() {
    if (bindings_stale_) {
      read_bindings();
    }
  }
  // Everything may have changed without our seeing it.
  void forget();
  // Switches debug output off for the time of our own GL calls.
  Quiet quiet();
  // The application's transform feedback captures refined triangles: between our draws it is paused by us.
  void set_feedback_ours(bool ours) { feedback_ours_ = ours; }

  BoundBuffers& bound_buffers() { return bound_buffers_; }
  const BoundBuffers& bound_buffers() const { return bound_buffers_; }
  // The buffer bound to a target. Queries what is not known.
  BoundBuffer bound_buffer(GLenum target);
  VertexArrays& vertex_arrays() { return vertex_arrays_; }
  // The source of an attribute of the bound vertex array, and the buffer of its indices. Query what is not known.
  const AttributeSource& attribute_source(int slot);
  const BoundBuffer& element_buffer();
  // The vertex array and the unit of glTexCoordPointer, whose bindings the hooks follow from then on.
  void read_client_state();
  // glClientActiveTexture; 0: not known.
  GLenum client_texture() const { return client_texture_; }
  void set_client_texture(GLenum unit) { client_texture_ = unit; }

  CurrentValues& current_values() { return current_values_; }
  const CurrentValues& current_values() const { return current_values_; }
  // The call `again` sets a current attribute value.
  void set_current(int slot, CurrentValue::Again again, GLuint index, const void* components, std::uint32_t bytes) {
    if (lists_.compiling) {
      record_current(slot, again, index, components, bytes);
    } else if (slot >= 0) {
      current_values_.set(slot, again, index, components, bytes);
    }
  }
  // Something may have changed all current values.
  void forget_current_values() { current_values_.forget(next_stamp()); }
  // The same, or state that a list sets between glBegin and glEnd.
  void forget_values();
  void forget_in_list();

  // State of the fixed function changed since fixed_function_read() was called.
  bool fixed_function_stale() const { return fixed_function_stale_; }
  void forget_fixed_function() { fixed_function_stale_ = true; }
  void fixed_function_read() { fixed_function_stale_ = false; }
  Matrices& matrices() { return matrices_; }
  // Calls that also count as state changes of the list that is being compiled.
  void touch_fixed_function() {
    forget_fixed_function();
    lists_.segment.touches_state = true;
  }
  void touch_matrices() {
    matrices_.touch(bindings_.matrix_mode);
    lists_.segment.touches_state = true;
  }
  void touch_any_matrix() {
    matrices_.touch_all();
    lists_.segment.touches_state = true;
  }

  Programs& programs() { return programs_; }
  const Programs& programs() const { return programs_; }
  // The derived programs that uniform calls must reach, too: those of the program in use, or of the one named.
  LockedMirrors uniform_mirrors();
  LockedMirrors uniform_mirrors(GLuint program);

  ListCompilation& lists() { return lists_; }
  const ListCompilation& lists() const { return lists_; }
  ImmediateMode& immediate() { return immediate_; }
  const ImmediateMode& immediate() const { return immediate_; }
  AttributeStack& attribute_stack() { return attribute_stack_; }
  QuerySurplus& query_surplus() { return query_surplus_; }
  // A number that no other context of the share group has, nor this one had.
  std::uint64_t next_stamp() { return ++stamp_; }

 private:
  void read_bindings();
  void read_buffer_bindings();
  void read_modes();
  void read_compatibility_modes();
  void confirm(BoundBuffer& bound, GLuint name);
  void record_current(int slot, CurrentValue::Again again, GLuint index, const void* components, std::uint32_t bytes);

  const gl::Dispatch& gl_;
  const Capabilities& capabilities_;
  ShareGroup& share_;
  std::uint64_t stamp_;
  Bindings bindings_;
  bool bindings_stale_ = true;
  bool feedback_ours_ = false;
  BoundBuffers bound_buffers_;
  VertexArrays vertex_arrays_;
  GLenum client_texture_ = 0;
  CurrentValues current_values_;
  bool fixed_function_stale_ = true;
  Matrices matrices_;
  Programs programs_;
  ListCompilation lists_;
  ImmediateMode immediate_;
  AttributeStack attribute_stack_;
  QuerySurplus query_surplus_;
};

}  // namespace glark::core
