// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/context.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>

#include "glark/core/pipeline.h"
#include "glark/core/report.h"
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

std::vector<std::string> extensions_of(const gl::Dispatch& gl) {
  GLint count = 0;
  gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  std::vector<std::string> names;
  for (GLint i = 0; i < count; ++i) {
    if (const auto* text = reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
        text != nullptr) {
      names.emplace_back(text);
    }
  }
  return names;
}

// Some GL libraries have an address for every name, so a function pointer says nothing: what the context does not offer is taken
// out here, and the core may then test for it.
void remove_unsupported(gl::Dispatch& gl, const Capabilities& capabilities) {
  if (capabilities.api == Capabilities::Api::es) {
    gl.PolygonMode = nullptr;
    gl.GetProgramStageiv = nullptr;
    gl.BindFragDataLocationIndexed = nullptr;
    gl.ShaderStorageBlockBinding = nullptr;
    gl.GetBufferSubData = nullptr;
  }
  if (!capabilities.multi_draw_indirect) {
    gl.MultiDrawElementsIndirect = nullptr;
  } else if (capabilities.api == Capabilities::Api::es) {
    gl.MultiDrawElementsIndirect = gl.MultiDrawElementsIndirectEXT;
  }
  if (capabilities.api != Capabilities::Api::compatibility) {
    gl.GetProgramStringARB = nullptr;
  }
}

GLint get(const gl::Dispatch& gl, GLenum name) {
  GLint value = 0;
  gl.GetIntegerv(name, &value);
  return value;
}

// Of an object that GL names, attached we do not know when: if the name was never deleted, it is the first. Otherwise `unique`.
std::uint64_t generation_of(const ShareGroup& share, GLuint name, std::uint64_t unique) {
  return share.buffers.generation(name) == 0 ? 0 : unique;
}

}  // namespace

std::shared_ptr<ShareGroup> make_share_group() { return std::make_shared<ShareGroup>(); }

Context::Context(const gl::Dispatch& dispatch, std::shared_ptr<ShareGroup> group, const ContextOptions& wanted)
    : gl(dispatch), share(std::move(group)), options(wanted) {
  constexpr int stamp_bits = 40;
  stamp_ = (share->contexts_made.fetch_add(1, std::memory_order_relaxed) + 1) << stamp_bits;
  current_values.forget(next_stamp());
  const std::lock_guard lock(share->mutex);
  share->contexts.push_back(this);
  mirror_uniforms = share->any_derived.load();
}

// Objects live on in the share group: another context deletes them.
Context::~Context() {
  const std::vector<GLuint> buffers = pipeline != nullptr ? pipeline->take_kept_buffers() : std::vector<GLuint>();
  const std::lock_guard lock(share->mutex);
  share->orphaned_buffers.insert(share->orphaned_buffers.end(), buffers.begin(), buffers.end());
  std::erase(share->contexts, this);
}

std::unique_ptr<Context> Context::create(const gl::Dispatch& gl, std::shared_ptr<ShareGroup> share,
                                         const ContextOptions& options) {
  std::unique_ptr<Context> context(new Context(gl, std::move(share), options));
  context->read_capabilities();
  if (context->capabilities.refinable) {
    context->supported = gl;
    remove_unsupported(context->supported, context->capabilities);
    context->pipeline = std::make_unique<Pipeline>(*context);
    const auto attributes = static_cast<GLuint>(context->capabilities.max_vertex_attributes);
    context->ark.tag_attribute = attributes - 1;
    context->ark.discontinuity_attribute = attributes - 2;
    context->ark.scalar_tag_attribute = attributes - 3;
  }
  context->update_refining();
  return context;
}

void Context::read_capabilities() {
  if (gl.GetString == nullptr || gl.GetIntegerv == nullptr) {
    return;
  }
  ErrorScope errors(*this);
  const auto* version = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
  if (version == nullptr) {
    return;
  }
  const std::string text(version);
  const bool es = text.rfind("OpenGL ES", 0) == 0;
  const std::size_t digit = text.find_first_of("0123456789");
  if (digit == std::string::npos || digit + 2 >= text.size()) {
    return;
  }
  capabilities.version = (text[digit] - '0') * 10 + (text[digit + 2] - '0');
  if (es) {
    capabilities.api = Capabilities::Api::es;
    capabilities.refinable = capabilities.version >= 32;
  } else {
    const bool core =
        capabilities.version >= 32 && (get(gl, GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT) != 0;
    capabilities.api = core ? Capabilities::Api::core : Capabilities::Api::compatibility;
    capabilities.refinable = capabilities.version >= 43;
  }
  if (es && options.wireframe) {  // it has no glPolygonMode
    log(LogLevel::warning, "OpenGL ES draws no wireframes: refined triangles are filled in context " + text);
    options.wireframe = false;
  }
  if (!capabilities.refinable) {
    log(LogLevel::warning, "context " + text + " is below OpenGL 4.3 and OpenGL ES 3.2: its draws stay as they are");
    return;
  }
  capabilities.extensions = extensions_of(gl);
  const auto has_extension = [&](std::string_view name) {
    return std::find(capabilities.extensions.begin(), capabilities.extensions.end(), name) !=
           capabilities.extensions.end();
  };
  capabilities.attribute_stack =
      is_compatibility() ? static_cast<std::size_t>(std::max(0, get(gl, GL_MAX_ATTRIB_STACK_DEPTH))) : 0;
  capabilities.query_buffer = !es && (capabilities.version >= 44 || has_extension("GL_ARB_query_buffer_object"));
  capabilities.multi_draw_indirect =
      !es || (has_extension("GL_EXT_multi_draw_indirect") && has_extension("GL_EXT_base_instance"));
  capabilities.parameter_buffer = !es && (capabilities.version >= 46 || has_extension("GL_ARB_indirect_parameters"));
  capabilities.quads_follow_convention =
      !is_compatibility() || get(gl, GL_QUADS_FOLLOW_PROVOKING_VERTEX_CONVENTION) != GL_FALSE;
  capabilities.max_texture_units = get(gl, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
  capabilities.max_vertex_attributes = std::min<GLint>(get(gl, GL_MAX_VERTEX_ATTRIBS), generic_slots);
  if (capabilities.version >= (es ? 31 : 44)) {
    capabilities.max_vertex_attribute_stride = get(gl, GL_MAX_VERTEX_ATTRIB_STRIDE);
  }
  capabilities.fog_distance = has_extension("GL_NV_fog_distance");
  capabilities.max_vertex_storage_blocks = get(gl, GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS);
  capabilities.max_feedback_components = get(gl, GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS);
  read_client_state();
}

void Context::release() {
  if (pipeline != nullptr) {
    pipeline->release();
  }
}

void Context::frame_finished() {
  std::vector<GLuint> orphans;
  {
    const std::lock_guard lock(share->mutex);
    orphans.swap(share->orphaned_buffers);
  }
  if (!orphans.empty()) {
    gl.DeleteBuffers(static_cast<GLsizei>(orphans.size()), orphans.data());
  }
  if (pipeline != nullptr) {
    pipeline->frame_finished();
  }
}

LockedMirrors Context::uniform_mirrors() const {
  if (current_program == nullptr && bindings.program == 0 && bindings.pipeline != 0) {
    return uniform_mirrors(pipeline->active_program(bindings.pipeline));
  }
  return current_program != nullptr ? LockedMirrors(current_program, gl, bindings.debug_output) : LockedMirrors();
}

LockedMirrors Context::uniform_mirrors(GLuint program) const {
  std::shared_ptr<Program> known = track::find_program(*this, program);
  return known != nullptr ? LockedMirrors(std::move(known), gl, bindings.debug_output) : LockedMirrors();
}

void Context::mirror_from_now_on() {
  if (share->any_derived.exchange(true)) {
    return;
  }
  const std::lock_guard lock(share->mutex);
  for (Context* context : share->contexts) {
    context->mirror_uniforms = true;
  }
}

void Context::read_client_state() {
  bindings.vertex_array = static_cast<GLuint>(get(gl, GL_VERTEX_ARRAY_BINDING));
  client_texture = is_compatibility() ? static_cast<GLenum>(get(gl, GL_CLIENT_ACTIVE_TEXTURE)) : 0;
}

// GL says that `name` is bound: if that is what the hooks thought, they know since when too.
void Context::confirm(BoundBuffer& bound, GLuint name) {
  if (bound.name != name) {
    bound = {false, name, generation_of(*share, name, next_stamp())};
  }
  bound.known = true;
  if (bound.generation == share->buffers.generation(name)) {  // not an object whose name was deleted
    bound_buffers.confirm(name, bound.generation);
  }
}

BoundBuffer Context::bound_buffer(GLenum target) {
  if (target == GL_ELEMENT_ARRAY_BUFFER) {
    return immediate.open || !capabilities.refinable ? BoundBuffer() : element_buffer();
  }
  BoundBuffer* kept = bound_buffers.at(target);
  if (kept != nullptr && kept->known) {
    return *kept;
  }
  // Between glBegin and glEnd nothing can be asked, and not everything in old versions.
  if (kept == nullptr || immediate.open || !capabilities.refinable) {
    return {};
  }
  confirm(*kept, static_cast<GLuint>(get(gl, binding_of(target))));
  return *kept;
}

void Context::wrote_buffer_of(GLenum target) {
  const BoundBuffer bound = bound_buffer(target);
  bound.known ? wrote_buffer(bound.name) : share->buffers.wrote_any(next_stamp());
}

const AttributeSource& Context::attribute_source(int slot) {
  VertexArray& array = vertex_arrays.current(bindings.vertex_array);
  AttributeSource& source = array.sources[static_cast<std::size_t>(slot)];
  if ((array.known & slot_bit(slot)) == 0) {
    source = read_source(gl, slot);
    source.generation = generation_of(*share, source.buffer, next_stamp());
    array.known |= slot_bit(slot);
  }
  return source;
}

const BoundBuffer& Context::element_buffer() {
  BoundBuffer& elements = vertex_arrays.current(bindings.vertex_array).elements;
  if (!elements.known) {
    confirm(elements, static_cast<GLuint>(get(gl, GL_ELEMENT_ARRAY_BUFFER_BINDING)));
  }
  return elements;
}

void Context::forget_values() {
  forget_in_list();
  if (!compiling_list) {
    current_values.forget(next_stamp());
  }
}

void Context::forget_in_list() {
  if (compiling_list) {
    list.segment.opaque = true;
    list.segment.late |= !before_vertices();
  }
}

void Context::record_current(int slot, CurrentValue::Again again, GLuint index, const void* components,
                             std::uint32_t bytes) {
  CurrentValue value{again, index, bytes};
  std::memcpy(value.components.data(), components, bytes);
  list.segment.record(slot, value, before_vertices());
}

void Context::update_refining() {
  refining = capabilities.refinable && (options.transparent || (ark.enabled && ark.pool_level >= 0) || list.cutting ||
                                        (pipeline != nullptr && pipeline->watches_feedback()));
}

void Context::forget_state() {
  bindings_stale = true;
  touch_vertex_arrays();
  touch_fixed_function();
}

Quiet Context::quiet() {
  refresh_bindings();
  return {gl, bindings.debug_output};
}

void Context::raise(GLenum error) {
  if (pending_error == GL_NO_ERROR) {
    pending_error = error;
  }
}

void Context::refresh_bindings() {
  if (!bindings_stale) {
    return;
  }
  bindings_stale = false;
  subroutines_known = false;
  const bool desktop = capabilities.api != Capabilities::Api::es;
  Bindings& b = bindings;
  b.program = static_cast<GLuint>(get(gl, GL_CURRENT_PROGRAM));
  b.pipeline = static_cast<GLuint>(get(gl, GL_PROGRAM_PIPELINE_BINDING));
  b.vertex_array = static_cast<GLuint>(get(gl, GL_VERTEX_ARRAY_BINDING));
  vertex_arrays.bind(b.vertex_array);
  b.transform_feedback = static_cast<GLuint>(get(gl, GL_TRANSFORM_FEEDBACK_BINDING));
  b.transform_feedback_active = get(gl, GL_TRANSFORM_FEEDBACK_ACTIVE) != 0;
  if (pipeline == nullptr || !pipeline->owns_feedback()) {  // which is paused between our draws
    b.transform_feedback_paused = get(gl, GL_TRANSFORM_FEEDBACK_PAUSED) != 0;
  }
  b.draw_indirect_buffer = static_cast<GLuint>(get(gl, GL_DRAW_INDIRECT_BUFFER_BINDING));
  b.query_buffer = capabilities.query_buffer ? static_cast<GLuint>(get(gl, GL_QUERY_BUFFER_BINDING)) : 0;
  b.parameter_buffer = capabilities.parameter_buffer ? static_cast<GLuint>(get(gl, GL_PARAMETER_BUFFER_BINDING)) : 0;
  b.feedback_buffer = static_cast<GLuint>(get(gl, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING));
  b.storage_buffer = static_cast<GLuint>(get(gl, GL_SHADER_STORAGE_BUFFER_BINDING));
  for (GLuint i = 0; i < b.storage.size(); ++i) {
    GLint buffer = 0;
    GLint64 offset = 0;
    GLint64 size = 0;
    gl.GetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, i, &buffer);
    gl.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, i, &offset);
    gl.GetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, i, &size);
    b.storage[i] = {static_cast<GLuint>(buffer), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size)};
  }
  b.debug_output = gl.IsEnabled(GL_DEBUG_OUTPUT) != GL_FALSE;
  b.blend = gl.IsEnabled(GL_BLEND) != GL_FALSE;
  b.depth_test = gl.IsEnabled(GL_DEPTH_TEST) != GL_FALSE;
  b.depth_writes = get(gl, GL_DEPTH_WRITEMASK) != 0;
  b.depth_function = static_cast<GLenum>(get(gl, GL_DEPTH_FUNC));
  GLfloat viewport[4] = {0, 0, 0, 0};
  gl.GetFloatv(GL_VIEWPORT, viewport);
  b.viewport = {viewport[2], viewport[3]};
  b.rasterizer_discard = gl.IsEnabled(GL_RASTERIZER_DISCARD) != GL_FALSE;
  b.primitive_restart_fixed = gl.IsEnabled(GL_PRIMITIVE_RESTART_FIXED_INDEX) != GL_FALSE;
  if (desktop) {
    b.primitive_restart = gl.IsEnabled(GL_PRIMITIVE_RESTART) != GL_FALSE;
    GLint modes[2] = {GL_FILL, GL_FILL};
    gl.GetIntegerv(GL_POLYGON_MODE, modes);
    b.front_polygon_mode = static_cast<GLenum>(modes[0]);
    b.back_polygon_mode = is_compatibility() ? static_cast<GLenum>(modes[1]) : b.front_polygon_mode;
    b.provoking_vertex = static_cast<GLenum>(get(gl, GL_PROVOKING_VERTEX));
  }
  b.polygon_mode = b.front_polygon_mode == GL_FILL ? b.back_polygon_mode : b.front_polygon_mode;
  if (is_compatibility()) {
    b.vertex_program = gl.IsEnabled(GL_VERTEX_PROGRAM_ARB) != GL_FALSE;
    b.two_side = gl.IsEnabled(GL_VERTEX_PROGRAM_TWO_SIDE) != GL_FALSE;
    b.matrix_mode = static_cast<GLenum>(get(gl, GL_MATRIX_MODE));
    touch_any_matrix();
    b.shade_model = static_cast<GLenum>(get(gl, GL_SHADE_MODEL));
    b.clamp_vertex_color = get(gl, GL_CLAMP_VERTEX_COLOR) != GL_FALSE;
    b.render_mode = static_cast<GLenum>(get(gl, GL_RENDER_MODE));
    b.list_base = static_cast<GLuint>(get(gl, GL_LIST_BASE));
  }
  if (current_program == nullptr ? b.program != 0 : current_program->name != b.program) {
    track::adopt_current_program(*this);
  }
}

ErrorScope::ErrorScope(Context& context) : context_(context) {
  for (GLenum error = context.gl.GetError(); error != GL_NO_ERROR; error = context.gl.GetError()) {
    context.raise(error);
    if (error == GL_CONTEXT_LOST) {
      break;
    }
  }
}

GLenum ErrorScope::take() {
  GLenum first = GL_NO_ERROR;
  for (GLenum error = context_.gl.GetError(); error != GL_NO_ERROR; error = context_.gl.GetError()) {
    first = first == GL_NO_ERROR ? error : first;
    if (error == GL_CONTEXT_LOST) {
      break;
    }
  }
  return first;
}

ErrorScope::~ErrorScope() { take(); }

}  // namespace glark::core
