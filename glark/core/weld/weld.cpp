// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/weld/weld.h"

#include <algorithm>

namespace glark::weld {
namespace {

constexpr char weld_source[] =
#include "glark/core/weld/weld.glsl.inc"
    ;

constexpr const char* uniform_names[] = {"record_offset",   "corner_words",   "triangle_bound",    "count_on_gpu",
                                         "position_offset", "position_words", "normal_offset",     "control_offset",
                                         "turn_offset",     "border_offset",  "coordinate_offset", "tag_offset",
                                         "slot_count",      "key_count",      "key_words"};
constexpr std::size_t key_words = 14;
constexpr std::uint32_t most_in_one_group = 128;  // triangles: one dispatch costs less than three
constexpr std::size_t all_in_one = 3;             // pass

bool takes_one_dispatch(std::uint32_t triangles) { return triangles <= most_in_one_group; }

// The size of each table. A triangle adds at most 3 entries.
std::uint64_t slots_for(std::uint32_t triangles) { return 4 * std::max<std::uint64_t>(4, triangles); }

std::uint64_t bytes_for(const capture::Layout& layout, std::uint64_t triangles) {
  const std::uint64_t slots = slots_for(static_cast<std::uint32_t>(triangles));
  const std::uint64_t tables = (layout.joins_edges() ? 1 : 0) + (layout.tagged || layout.displaced() ? 1 : 0);
  const std::uint64_t more = (layout.turn_offset >= 0 ? 1 : 0) + (layout.displaced() ? 5 : 0);
  return 4 * (tables * (2 * slots + 3 * triangles) + more * slots);
}

}  // namespace

bool WeldStage::build(std::size_t pass) {
  const core::ComputeText text{
      .what = "a welding pass",
      .source = weld_source,
      .es = language_ == capture::Language::es,
      .defines = {
          {"GLARK_PASS", pass}, {"GLARK_GROUP", core::ComputePass::group_size}, {"GLARK_KEY_WORDS", most_key_words}}};
  return passes_[pass].built() || passes_[pass].build(gl_, text, uniform_names);
}

bool WeldStage::can_hold(const capture::Layout& layout, std::uint64_t triangles) {
  if (largest_block_ == 0) {
    gl_.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest_block_);
  }
  return bytes_for(layout, triangles) <= static_cast<std::uint64_t>(largest_block_);
}

// Room for many triangles is also room for few.
bool WeldStage::has_room(const capture::Layout& layout, std::uint32_t triangles) const {
  return passes_[takes_one_dispatch(triangles) ? all_in_one : all_in_one - 1].built() &&
         bytes_for(layout, triangles) <= static_cast<std::uint64_t>(tables_.size());
}

bool WeldStage::reserve(const capture::Layout& layout, std::uint32_t triangles) {
  const bool built = build(all_in_one) && (takes_one_dispatch(triangles) || (build(0) && build(1) && build(2)));
  return built && can_hold(layout, triangles) &&
         tables_.reserve(gl_, static_cast<GLsizeiptr>(bytes_for(layout, triangles)), GL_DYNAMIC_COPY);
}

void WeldStage::dispatch(std::size_t pass, const WeldRequest& request, std::uint32_t invocations) const {
  const capture::Layout& layout = *request.layout;
  const capture::Field* position = capture::find_role(layout.fields, capture::Role::position);
  const std::span<const GLint> keys = request.key_words.first(std::min(request.key_words.size(), most_key_words));
  const GLint values[] = {static_cast<GLint>(request.triangles.offset / 4),
                          layout.corner_words,
                          static_cast<GLint>(request.triangles.count),
                          request.triangles.count_on_gpu ? 1 : 0,
                          position->offset,
                          position->words,
                          capture::normal_offset(layout.fields),
                          request.edges ? layout.control_offset : -1,
                          request.edges ? layout.turn_offset : -1,
                          request.edges ? layout.border_offset : -1,
                          layout.coordinate_offset,
                          request.tags ? layout.tag_offset : -1,
                          static_cast<GLint>(slots_for(request.triangles.count)),
                          static_cast<GLint>(keys.size())};
  passes_[pass].use(gl_);
  passes_[pass].set_integers(gl_, values);
  if (!keys.empty() && passes_[pass].location(key_words) >= 0) {
    gl_.Uniform1iv(passes_[pass].location(key_words), static_cast<GLsizei>(keys.size()), keys.data());
  }
  core::ComputePass::dispatch(gl_, invocations);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void WeldStage::run(const WeldRequest& request, GLuint captured_count) {
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, request.triangles.buffer);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, tables_.name());
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, captured_count);
  const std::uint32_t triangles = request.triangles.count;
  if (takes_one_dispatch(triangles)) {
    dispatch(all_in_one, request, 1);
  } else {
    dispatch(0, request, static_cast<std::uint32_t>(slots_for(triangles)));
    dispatch(1, request, 3 * triangles);
    dispatch(2, request, 3 * triangles);
  }
  gl_.MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void WeldStage::release() {
  for (core::ComputePass& pass : passes_) {
    pass.release(gl_);
  }
  tables_.release(gl_);
}

}  // namespace glark::weld
