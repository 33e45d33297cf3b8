// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/weld/weld.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glark::weld {
namespace {

constexpr char weld_source[] =
#include "glark/core/weld/weld.glsl.inc"
    ;

constexpr const char* weld_uniforms[] = {
    "record_offset",     "corner_words",  "triangle_bound",      "count_on_gpu",  "position_offset",
    "position_words",    "normal_offset", "control_offset",      "turn_offset",   "border_offset",
    "coordinate_offset", "tag_offset",    "slot_count",          "key_count",     "extent_offset",
    "key_offset",        "ends_of_edge",  "corners_of_triangle", "crease_cosine", "steepest_cosine"};
constexpr std::size_t crease_cosine = 18;
constexpr std::size_t steepest_cosine = 19;
constexpr std::uint32_t extent[6] = {};  // the words of cells.glsl, before the first corner

// The size of each table. A triangle adds at most 3 entries.
std::uint64_t slots_for(std::uint32_t triangles) { return 4 * std::max<std::uint64_t>(4, triangles); }

// The words of the tables, without the extent behind them.
std::uint64_t table_words(const WeldPlan& plan, const capture::Layout& layout, std::uint64_t triangles) {
  const std::uint64_t slots = slots_for(static_cast<std::uint32_t>(triangles));
  const bool creased = plan.creased(layout);
  const std::uint64_t tables = layout.joins_edges() ? 2 : 1;
  const std::uint64_t more = (layout.turn_offset >= 0 ? 1 : 0) + (layout.displaced() ? 5 : 0) + (creased ? 2 : 0);
  return tables * (2 * slots + 3 * triangles) + more * slots + (creased ? 3 * triangles : 0);
}

std::uint64_t normals_words(const WeldPlan& plan, std::uint64_t triangles) {
  return plan.makes_normals ? 2 * slots_for(static_cast<std::uint32_t>(triangles)) + 6 * triangles : 0;
}

// The extent lies behind the tables, and the words of the key behind the extent.
std::uint64_t extent_offset(const WeldPlan& plan, const capture::Layout& layout, std::uint64_t triangles) {
  return std::max(table_words(plan, layout, triangles), normals_words(plan, triangles));
}

std::uint64_t key_offset(const WeldPlan& plan, const capture::Layout& layout, std::uint64_t triangles) {
  return extent_offset(plan, layout, triangles) + std::size(extent);
}

std::uint64_t bytes_for(const WeldPlan& plan, const capture::Layout& layout, std::uint64_t triangles) {
  return 4 * (key_offset(plan, layout, triangles) + most_key_words);
}

std::span<const GLint> used_keys(const WeldRequest& request) {
  return request.key_words.first(std::min(request.key_words.size(), most_key_words));
}

// Sets the limits of creases.glsl. Faces that meet at exactly the angle of the limit do not make a crease.
void set_limits(const gl::Dispatch& gl, const core::ComputePass& pass, float degrees) {
  constexpr float rounding = 1e-4F;
  const float cosine = std::cos(degrees * std::numbers::pi_v<float> / 180);
  if (pass.location(crease_cosine) >= 0) {
    gl.Uniform1f(pass.location(crease_cosine), rounding - cosine);
    gl.Uniform1f(pass.location(steepest_cosine), cosine - rounding);
  }
}

}  // namespace

WeldStage::Ability WeldStage::ability(const WeldPlan& plan, const capture::Layout& layout) {
  return layout.displaced() ? Ability::displaced : plan.creased(layout) ? Ability::creased : Ability::plain;
}

core::ComputePass& WeldStage::pass(Ability ability, Pass pass) {
  return passes_[static_cast<std::size_t>(ability)][static_cast<std::size_t>(pass)];
}

const core::ComputePass& WeldStage::pass(Ability ability, Pass pass) const {
  return passes_[static_cast<std::size_t>(ability)][static_cast<std::size_t>(pass)];
}

bool WeldStage::build(Ability ability, Pass pass) {
  const core::ComputeText text{.what = "a welding pass",
                               .source = weld_source,
                               .es = language_ == capture::Language::es,
                               .defines = {{"GLARK_PASS", static_cast<std::uint64_t>(pass)},
                                           {"GLARK_GROUP", core::ComputePass::group_size},
                                           {"GLARK_DISPLACED", ability == Ability::displaced ? 1U : 0U},
                                           {"GLARK_CREASED", ability == Ability::creased ? 1U : 0U}}};
  return compilation_.build(this->pass(ability, pass), text, weld_uniforms);
}

// Tries them all, so that it is known how many must wait.
bool WeldStage::build_all(const WeldPlan& plan, const capture::Layout& layout) {
  const Ability needed = ability(plan, layout);
  bool built = true;
  for (const Pass pass : all_passes) {
    built = (!needs(plan, layout, pass) || build(needed, pass)) && built;
  }
  return (!plan.makes_normals || normals_.build()) && built;
}

bool WeldStage::can_hold(const WeldPlan& plan, const capture::Layout& layout, std::uint64_t triangles) {
  if (largest_block_ == 0) {
    gl_.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest_block_);
  }
  return bytes_for(plan, layout, triangles) <= static_cast<std::uint64_t>(largest_block_);
}

bool WeldStage::needs(const WeldPlan& plan, const capture::Layout& layout, Pass pass) {
  switch (pass) {
    case Pass::join: return layout.joins_edges();
    case Pass::rank_turns: return layout.turn_offset >= 0;
    case Pass::measure_faces:
    case Pass::look_beyond:
    case Pass::mark: return plan.creased(layout);
    case Pass::clear:
    case Pass::place:
    case Pass::write: break;
  }
  return true;
}

// Room for many triangles is also room for few.
bool WeldStage::has_room(const WeldPlan& plan, const capture::Layout& layout, std::uint32_t triangles) const {
  const Ability needed = ability(plan, layout);
  return (!plan.makes_normals || normals_.built()) &&
         std::all_of(std::begin(all_passes), std::end(all_passes),
                     [&](Pass pass) { return !needs(plan, layout, pass) || this->pass(needed, pass).built(); }) &&
         bytes_for(plan, layout, triangles) <= static_cast<std::uint64_t>(tables_.size());
}

bool WeldStage::reserve(const WeldPlan& plan, const capture::Layout& layout, std::uint32_t triangles) {
  return build_all(plan, layout) && can_hold(plan, layout, triangles) &&
         tables_.reserve(gl_, static_cast<std::int64_t>(bytes_for(plan, layout, triangles)), GL_DYNAMIC_COPY);
}

void WeldStage::dispatch(Pass step, const WeldRequest& request, std::uint32_t invocations) const {
  const capture::Layout& layout = *request.layout;
  const core::ComputePass& program = pass(ability(*request.plan, layout), step);
  const capture::Field* position = capture::find_role(layout.fields, capture::Role::position);
  const std::uint32_t triangles = request.triangles.count;
  const GLint values[] = {static_cast<GLint>(request.triangles.offset / 4),
                          layout.corner_words,
                          static_cast<GLint>(triangles),
                          request.triangles.count_on_gpu ? 1 : 0,
                          position->offset,
                          position->words,
                          capture::normal_offset(layout.fields),
                          request.edges ? layout.control_offset : -1,
                          request.edges ? layout.turn_offset : -1,
                          request.edges ? layout.border_offset : -1,
                          layout.coordinate_offset,
                          request.tags ? layout.tag_offset : -1,
                          static_cast<GLint>(slots_for(triangles)),
                          static_cast<GLint>(used_keys(request).size()),
                          static_cast<GLint>(extent_offset(*request.plan, layout, triangles)),
                          static_cast<GLint>(key_offset(*request.plan, layout, triangles)),
                          ends_of_edge,
                          corners_of_triangle};
  program.use(gl_);
  program.set_integers(gl_, values);
  set_limits(gl_, program, request.plan->crease);
  core::ComputePass::dispatch(gl_, invocations);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void WeldStage::run(const WeldRequest& request, GLuint captured_count) {
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, request.triangles.buffer);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, captured_count);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, tables_.name());
  upload_keys(request);
  if (request.normals) {
    make_normals(request);
  }
  if (request.edges || request.tags) {
    weld(request);
  }
  gl_.MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void WeldStage::upload_keys(const WeldRequest& request) const {
  const std::span<const GLint> keys = used_keys(request);
  if (!keys.empty()) {
    const std::uint64_t offset = key_offset(*request.plan, *request.layout, request.triangles.count);
    gl_.BufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(4 * offset),
                      static_cast<GLsizeiptr>(keys.size_bytes()), keys.data());
  }
}

void WeldStage::make_normals(const WeldRequest& request) const {
  normals_.run({.layout = request.layout,
                .triangles = request.triangles,
                .keys = static_cast<GLint>(used_keys(request).size()),
                .key_offset = static_cast<GLint>(key_offset(*request.plan, *request.layout, request.triangles.count)),
                .crease = request.plan->crease,
                .slots = slots_for(request.triangles.count)});
}

void WeldStage::weld(const WeldRequest& request) const {
  const capture::Layout& layout = *request.layout;
  const std::uint32_t triangles = request.triangles.count;
  if (request.plan->creased(layout)) {
    const std::uint64_t offset = extent_offset(*request.plan, layout, triangles);
    gl_.BufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(4 * offset), sizeof(extent), extent);
  }
  for (const Pass pass : all_passes) {
    const bool for_all = pass == Pass::clear || pass == Pass::place || pass == Pass::write;
    if ((request.edges || for_all) && needs(*request.plan, layout, pass)) {
      const auto slots = static_cast<std::uint32_t>(slots_for(triangles));
      dispatch(pass, request, pass == Pass::clear ? slots : 3 * triangles);
    }
  }
}

void WeldStage::release() {
  normals_.release();
  for (auto& passes : passes_) {
    for (core::ComputePass& pass : passes) {
      pass.release(gl_);
    }
  }
  tables_.release(gl_);
}

}  // namespace glark::weld
