// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// All that glark keeps for one OpenGL context. The hooks (glark/core/track) keep it up to date; the pipeline draws with it.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "glark/core/ark_state.h"
#include "glark/core/bindings.h"
#include "glark/core/bound_buffers.h"
#include "glark/core/current_values.h"
#include "glark/core/immediate_draw.h"
#include "glark/core/program.h"
#include "glark/core/quiet.h"
#include "glark/core/refine/fixed_function/fixed_function.h"
#include "glark/core/refinement.h"
#include "glark/core/share_group.h"
#include "glark/core/vertex_arrays.h"
#include "glark/gl/dispatch.h"

namespace glark::core {

class Context;
class Pipeline;

namespace track {
// The capture under way is full: draws it, and begins another.
void immediate_full(Context& context);
}  // namespace track

// What this driver's context offers.
struct Capabilities {
  enum class Api { compatibility, core, es };
  Api api = Api::compatibility;
  int version = 0;                      // 45 for 4.5
  bool refinable = false;               // GL >= 4.3 or ES >= 3.2
  bool quads_follow_convention = true;  // provoking vertex of quads under GL_FIRST_VERTEX_CONVENTION
  bool parameter_buffer = false;        // GL_PARAMETER_BUFFER is a binding point
  bool query_buffer = false;            // results of queries go to a buffer
  std::size_t attribute_stack = 0;      // glPushAttrib so often
  bool multi_draw_indirect = false;     // with a base instance; otherwise bins are read back
  std::vector<std::string> extensions;
  bool fog_distance = false;  // GL_NV_fog_distance
  GLint max_vertex_attributes = 16;
  GLint max_vertex_attribute_stride = 0;  // 0: there is no limit
  GLint max_texture_units = 0;
  GLint max_feedback_components = 64;
  GLint max_vertex_storage_blocks = 0;
};

// A display list that the application is compiling.
struct ListCompilation {
  bool cutting = false;  // into segments; otherwise the driver compiles it alone
  GLuint name = 0;
  GLenum mode = 0;
  std::shared_ptr<DisplayList> list;
  GLuint open_segment = 0;
  SegmentEffects segment;                // of the open one
  GLenum begun_mode = 0;                 // of a glBegin that is open in a draw segment
  std::vector<VertexList> vertex_lists;  // called since the open glBegin
  bool in_draw = false;
  bool in_begin = false;
};

class Context {
 public:
  // The context must be current. `gl` outlives it.
  static std::unique_ptr<Context> create(const gl::Dispatch& gl, std::shared_ptr<ShareGroup> share,
                                         const ContextOptions& options);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  // Deletes the GL objects of ours; only while the context is current. The destructor alone leaves them to the driver.
  void release();
  // At the end of a frame, before buffers are swapped.
  void frame_finished();

  const gl::Dispatch& gl;  // for the application's calls
  gl::Dispatch supported;  // for ours: without what the context does not offer

  // Read by the generated wrappers at every call.
  bool refining = false;  // draw calls must reach their hooks
  std::atomic<bool> mirror_uniforms =
      false;  // uniform calls must reach derived programs; any context of the group sets it
  bool compiling_list = false;
  bool list_changes_uniforms = false;
  std::uint64_t immediate_vertices = 0;
  unsigned immediate_components = 0;           // bits: how many components those vertices have
  bool elements_restart = false;               // glPrimitiveRestartIndexNV was called: glArrayElement may restart
  std::uint64_t immediate_limit = UINT64_MAX;  // so many vertices fit the capture under way

  // Called before a vertex of so many components between glBegin and glEnd.
  void count_vertex(unsigned components) {
    if (immediate_vertices == immediate_limit) {
      track::immediate_full(*this);
    }
    ++immediate_vertices;
    immediate_components |= 1U << components;
  }
  bool before_vertices() const { return immediate_vertices == 0 && immediate.vertices_before == 0; }

  // Called after the write.
  void wrote_buffer(GLuint buffer) { share->buffers.wrote(buffer, next_stamp()); }
  void wrote_target(GLenum target) {
    const BoundBuffer* bound = bound_buffers.at(target);
    bound != nullptr && bound->known ? wrote_buffer(bound->name) : wrote_buffer_of(target);
  }
  void wrote_pack_buffer() { wrote_target(GL_PIXEL_PACK_BUFFER); }
  void gpu_wrote() { share->buffers.gpu_wrote(next_stamp()); }
  void gpu_may_write(GLuint buffer) { share->buffers.gpu_may_write(buffer); }
  void never_trust_buffer(GLuint buffer) { share->buffers.never_trust(buffer); }
  void never_trust_target(GLenum target) { share->buffers.never_trust(bound_buffer(target).name); }
  void touch_vertex_arrays() { vertex_arrays.forget_current(); }
  void touch_all_vertex_arrays() { vertex_arrays.forget_all(); }
  // The call that `again` makes sets a current attribute value.
  void set_current(int slot, CurrentValue::Again again, GLuint index, const void* components, std::uint32_t bytes) {
    if (compiling_list) {
      record_current(slot, again, index, components, bytes);
    } else if (slot >= 0) {
      current_values.set(slot, again, index, components, bytes);
    }
  }
  // Current values may have changed unseen, or state that a list sets between glBegin and glEnd.
  void forget_values();
  void forget_in_list();
  void touch_fixed_function() {
    fixed_function_stale = true;
    list.segment.touches_state = true;
  }
  void touch_matrices() {
    (bindings.matrix_mode == GL_PROJECTION ? projection_stale : modelview_stale) = true;
    list.segment.touches_state = true;
  }
  void touch_any_matrix() {
    projection_stale = modelview_stale = true;
    list.segment.touches_state = true;
  }
  LockedMirrors uniform_mirrors() const;
  LockedMirrors uniform_mirrors(GLuint program) const;
  // From the first derived program on, every context of the share group mirrors uniforms.
  void mirror_from_now_on();

  // Recomputes `refining` after a change of the state that it depends on.
  void update_refining();
  // Re-reads the bindings from GL if something we cannot follow (a display list, glPopAttrib) changed them.
  void refresh_bindings();
  // Whatever we know of GL state may have changed without our seeing it.
  void forget_state();
  // For the time of GL calls of ours.
  Quiet quiet();
  // The vertex array and the unit of glTexCoordPointer, whose bindings the hooks follow from then on.
  void read_client_state();
  // What is bound to a target, asked for if it is not known.
  BoundBuffer bound_buffer(GLenum target);
  // Where an attribute of the bound vertex array comes from; the buffer of its indices. Queries what is not known.
  const AttributeSource& attribute_source(int slot);
  const BoundBuffer& element_buffer();
  // A number that no other context of the share group has, nor this one had.
  std::uint64_t next_stamp() { return ++stamp_; }
  // Records an error of ours for glGetError; the first stays, as in GL.
  void raise(GLenum error);
  bool is_compatibility() const { return capabilities.api == Capabilities::Api::compatibility; }

  std::shared_ptr<ShareGroup> share;
  ContextOptions options;
  Capabilities capabilities;
  ArkState ark;
  Bindings bindings;
  bool bindings_stale = true;
  BoundBuffers bound_buffers;
  VertexArrays vertex_arrays;
  CurrentValues current_values;
  GLenum client_texture = 0;  // glClientActiveTexture; 0: not known
  bool fixed_function_stale = true;
  MatrixTraits matrices;
  bool projection_stale = true;
  bool modelview_stale = true;
  GLenum pending_error = GL_NO_ERROR;
  ListCompilation list;
  ImmediateDraw immediate;
  std::vector<std::pair<bool, bool>> pushed_enables;        // per glPushAttrib: has GL_ENABLE_BIT, GL_ARK was enabled
  std::unordered_map<GLuint, std::uint64_t> query_surplus;  // triangles that our captures added to a query
  std::shared_ptr<Program> current_program;                 // null: none, or not known to us
  bool subroutines_known = false;                           // `subroutines` is what the program in use has chosen
  SubroutineChoice subroutines;
  std::string extension_string;
  std::unique_ptr<Pipeline> pipeline;

 private:
  Context(const gl::Dispatch& dispatch, std::shared_ptr<ShareGroup> group, const ContextOptions& wanted);
  void read_capabilities();
  void wrote_buffer_of(GLenum target);
  void confirm(BoundBuffer& bound, GLuint name);
  void record_current(int slot, CurrentValue::Again again, GLuint index, const void* components, std::uint32_t bytes);

  std::uint64_t stamp_ = 0;
};

// Keeps the application's pending GL errors apart from those of our own calls: what was pending at construction goes
// to Context::pending_error, what our calls caused is dropped at destruction. For rare operations only (allocation, linking).
class ErrorScope {
 public:
  explicit ErrorScope(Context& context);
  ~ErrorScope();
  ErrorScope(const ErrorScope&) = delete;
  ErrorScope& operator=(const ErrorScope&) = delete;
  GLenum take();  // the first error that our calls caused so far

 private:
  Context& context_;
};

}  // namespace glark::core
