// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/state/gl_state.h"

#include <cstring>

namespace glark::core {
namespace {

GLint get(const gl::Dispatch& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return value;
}

GLuint get_name(const gl::Dispatch& gl, GLenum binding) { return static_cast<GLuint>(get(gl, binding)); }

// The generation of an object that GL names and that was attached at an unknown time. A name that was never deleted has only
// one generation, the first. Any other name gets `unique`.
std::uint64_t generation_of(const ShareGroup& share, GLuint name, std::uint64_t unique) {
  return share.buffers.generation(name) == 0 ? 0 : unique;
}

// The first stamp of a context: the stamps of two contexts of a share group never meet.
std::uint64_t first_stamp(ShareGroup& share) {
  constexpr int stamp_bits = 40;
  return (share.contexts_made.fetch_add(1, std::memory_order_relaxed) + 1) << stamp_bits;
}

}  // namespace

GlState::GlState(const gl::Dispatch& gl, const Capabilities& capabilities, ShareGroup& share, PendingError& pending,
                 ProgramWatcher& watcher)
    : gl_(gl),
      capabilities_(capabilities),
      share_(share),
      stamp_(first_stamp(share)),
      programs_(gl, capabilities, share, pending, watcher) {
  forget_current_values();
}

void GlState::forget() {
  forget_bindings();
  vertex_arrays_.forget_current();
  touch_fixed_function();
}

Quiet GlState::quiet() {
  refresh();
  return {gl_, bindings_.debug_output};
}

void GlState::read_client_state() {
  bindings_.vertex_array = get_name(gl_, GL_VERTEX_ARRAY_BINDING);
  client_texture_ = capabilities_.is_compatibility() ? get_name(gl_, GL_CLIENT_ACTIVE_TEXTURE) : 0;
}

// GL says that `name` is bound. If the hooks thought so too, they also know since when.
void GlState::confirm(BoundBuffer& bound, GLuint name) {
  if (bound.name != name) {
    bound = {false, name, generation_of(share_, name, next_stamp())};
  }
  bound.known = true;
  if (bound.generation == share_.buffers.generation(name)) {  // not an object whose name was deleted
    bound_buffers_.confirm(name, bound.generation);
  }
}

BoundBuffer GlState::bound_buffer(GLenum target) {
  if (target == GL_ELEMENT_ARRAY_BUFFER) {
    return immediate_.open || !capabilities_.refinable ? BoundBuffer() : element_buffer();
  }
  BoundBuffer* kept = bound_buffers_.at(target);
  if (kept != nullptr && kept->known) {
    return *kept;
  }
  // Between glBegin and glEnd nothing can be asked, and old versions do not answer for every target.
  if (kept == nullptr || immediate_.open || !capabilities_.refinable) {
    return {};
  }
  confirm(*kept, get_name(gl_, binding_of(target)));
  return *kept;
}

const AttributeSource& GlState::attribute_source(int slot) {
  VertexArray& array = vertex_arrays_.current(bindings_.vertex_array);
  AttributeSource& source = array.sources[static_cast<std::size_t>(slot)];
  if ((array.known & slot_bit(slot)) == 0) {
    source = read_source(gl_, slot);
    source.generation = generation_of(share_, source.buffer, next_stamp());
    array.known |= slot_bit(slot);
  }
  return source;
}

const BoundBuffer& GlState::element_buffer() {
  BoundBuffer& elements = vertex_arrays_.current(bindings_.vertex_array).elements;
  if (!elements.known) {
    confirm(elements, get_name(gl_, GL_ELEMENT_ARRAY_BUFFER_BINDING));
  }
  return elements;
}

void GlState::forget_values() {
  forget_in_list();
  if (!lists_.compiling) {
    forget_current_values();
  }
}

void GlState::forget_in_list() {
  if (lists_.compiling) {
    lists_.segment.opaque = true;
    lists_.segment.late |= !immediate_.before_vertices();
  }
}

void GlState::record_current(int slot, CurrentValue::Again again, GLuint index, const void* components,
                             std::uint32_t bytes) {
  CurrentValue value{again, index, bytes};
  std::memcpy(value.components.data(), components, bytes);
  lists_.segment.record(slot, value, immediate_.before_vertices());
}

LockedMirrors GlState::uniform_mirrors() {
  if (programs_.current() == nullptr && bindings_.program == 0 && bindings_.pipeline != 0) {
    return uniform_mirrors(programs_.pipelines().object(bindings_.pipeline).active);
  }
  return programs_.current() != nullptr ? LockedMirrors(programs_.current(), gl_, bindings_.debug_output)
                                        : LockedMirrors();
}

LockedMirrors GlState::uniform_mirrors(GLuint program) {
  std::shared_ptr<Program> known = programs_.find(program);
  return known != nullptr ? LockedMirrors(std::move(known), gl_, bindings_.debug_output) : LockedMirrors();
}

void GlState::read_bindings() {
  bindings_stale_ = false;
  programs_.forget_subroutines();
  Bindings& b = bindings_;
  b.program = get_name(gl_, GL_CURRENT_PROGRAM);
  b.pipeline = get_name(gl_, GL_PROGRAM_PIPELINE_BINDING);
  b.vertex_array = get_name(gl_, GL_VERTEX_ARRAY_BINDING);
  vertex_arrays_.bind(b.vertex_array);
  b.transform_feedback = get_name(gl_, GL_TRANSFORM_FEEDBACK_BINDING);
  b.transform_feedback_active = get(gl_, GL_TRANSFORM_FEEDBACK_ACTIVE) != 0;
  if (!feedback_ours_) {  // ours is paused between our draws
    b.transform_feedback_paused = get(gl_, GL_TRANSFORM_FEEDBACK_PAUSED) != 0;
  }
  read_buffer_bindings();
  read_modes();
  if (capabilities_.is_compatibility()) {
    read_compatibility_modes();
  }
  if (programs_.current() == nullptr ? b.program != 0 : programs_.current()->name != b.program) {
    programs_.adopt(b.program);
  }
}

void GlState::read_buffer_bindings() {
  Bindings& b = bindings_;
  b.draw_indirect_buffer = get_name(gl_, GL_DRAW_INDIRECT_BUFFER_BINDING);
  b.query_buffer = capabilities_.query_buffer ? get_name(gl_, GL_QUERY_BUFFER_BINDING) : 0;
  b.parameter_buffer = capabilities_.parameter_buffer ? get_name(gl_, GL_PARAMETER_BUFFER_BINDING) : 0;
  b.feedback_buffer = get_name(gl_, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING);
  b.storage_buffer = get_name(gl_, GL_SHADER_STORAGE_BUFFER_BINDING);
  for (GLuint i = 0; i < b.storage.size(); ++i) {
    GLint buffer = 0;
    GLint64 offset = 0;
    GLint64 size = 0;
    gl_.GetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, i, &buffer);
    gl_.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, i, &offset);
    gl_.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, i, &size);
    b.storage[i] = {static_cast<GLuint>(buffer), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size)};
  }
}

void GlState::read_modes() {
  Bindings& b = bindings_;
  b.debug_output = gl_.IsEnabled(GL_DEBUG_OUTPUT) != GL_FALSE;
  b.blend = gl_.IsEnabled(GL_BLEND) != GL_FALSE;
  b.depth_test = gl_.IsEnabled(GL_DEPTH_TEST) != GL_FALSE;
  b.depth_writes = get(gl_, GL_DEPTH_WRITEMASK) != 0;
  b.depth_function = static_cast<GLenum>(get(gl_, GL_DEPTH_FUNC));
  GLfloat viewport[4] = {0, 0, 0, 0};
  gl_.GetFloatv(GL_VIEWPORT, viewport);
  b.viewport = {viewport[2], viewport[3]};
  b.rasterizer_discard = gl_.IsEnabled(GL_RASTERIZER_DISCARD) != GL_FALSE;
  b.primitive_restart_fixed = gl_.IsEnabled(GL_PRIMITIVE_RESTART_FIXED_INDEX) != GL_FALSE;
  if (capabilities_.api != Capabilities::Api::es) {
    b.primitive_restart = gl_.IsEnabled(GL_PRIMITIVE_RESTART) != GL_FALSE;
    GLint modes[2] = {GL_FILL, GL_FILL};
    gl_.GetIntegerv(GL_POLYGON_MODE, modes);
    b.front_polygon_mode = static_cast<GLenum>(modes[0]);
    b.back_polygon_mode = capabilities_.is_compatibility() ? static_cast<GLenum>(modes[1]) : b.front_polygon_mode;
    b.provoking_vertex = static_cast<GLenum>(get(gl_, GL_PROVOKING_VERTEX));
  }
  b.polygon_mode = b.front_polygon_mode == GL_FILL ? b.back_polygon_mode : b.front_polygon_mode;
}

void GlState::read_compatibility_modes() {
  Bindings& b = bindings_;
  b.vertex_program = gl_.IsEnabled(GL_VERTEX_PROGRAM_ARB) != GL_FALSE;
  b.two_side = gl_.IsEnabled(GL_VERTEX_PROGRAM_TWO_SIDE) != GL_FALSE;
  b.matrix_mode = static_cast<GLenum>(get(gl_, GL_MATRIX_MODE));
  touch_any_matrix();
  b.shade_model = static_cast<GLenum>(get(gl_, GL_SHADE_MODEL));
  b.clamp_vertex_color = get(gl_, GL_CLAMP_VERTEX_COLOR) != GL_FALSE;
  b.render_mode = static_cast<GLenum>(get(gl_, GL_RENDER_MODE));
  b.list_base = get_name(gl_, GL_LIST_BASE);
}

}  // namespace glark::core
