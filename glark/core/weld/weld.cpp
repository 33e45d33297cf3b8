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

constexpr const char* uniform_names[] = {
    "record_offset", "corner_words",   "triangle_bound", "count_on_gpu",  "position_offset",   "position_words",
    "normal_offset", "control_offset", "turn_offset",    "border_offset", "coordinate_offset", "tag_offset",
    "slot_count",    "key_count",      "extent_offset",  "key_words",     "crease_cosine",     "steepest_cosine"};
constexpr std::size_t key_words = 15;
constexpr std::size_t crease_cosine = 16;
constexpr std::size_t steepest_cosine = 17;
constexpr std::uint32_t extent[6] = {};           // the words of cells.glsl, before the first corner
constexpr std::uint32_t most_in_one_group = 128;  // triangles: one dispatch costs less than several

bool takes_one_dispatch(std::uint32_t triangles) { return triangles <= most_in_one_group; }

// The size of each table. A triangle adds at most 3 entries.
std::uint64_t slots_for(std::uint32_t triangles) { return 4 * std::max<std::uint64_t>(4, triangles); }

// The words of the tables, without the extent behind them.
std::uint64_t table_words(const WeldPlan& plan, const capture::Layout& layout, std::uint64_t triangles) {
  const std::uint64_t slots = slots_for(static_cast<std::uint32_t>(triangles));
  const bool creased = plan.creased(layout);
  const std::uint64_t tables =
      (layout.joins_edges() ? 1 : 0) + (layout.tagged || layout.displaced() || creased ? 1 : 0);
  const std::uint64_t more = (layout.turn_offset >= 0 ? 1 : 0) + (layout.displaced() ? 5 : 0) + (creased ? 2 : 0);
  return tables * (2 * slots + 3 * triangles) + more * slots + (creased ? 3 * triangles : 0);
}

std::uint64_t bytes_for(const WeldPlan& plan, const capture::Layout& layout, std::uint64_t triangles) {
  const std::uint64_t for_normals =
      plan.makes_normals ? 2 * slots_for(static_cast<std::uint32_t>(triangles)) + 6 * triangles : 0;
  return 4 * std::max(table_words(plan, layout, triangles), for_normals) + sizeof(extent);
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
                                           {"GLARK_KEY_WORDS", most_key_words},
                                           {"GLARK_DISPLACED", ability == Ability::displaced ? 1U : 0U},
                                           {"GLARK_CREASED", ability == Ability::creased ? 1U : 0U}}};
  core::ComputePass& built = this->pass(ability, pass);
  return built.built() || built.build(gl_, text, uniform_names);
}

bool WeldStage::can_hold(const WeldPlan& plan, const capture::Layout& layout, std::uint64_t triangles) {
  if (largest_block_ == 0) {
    gl_.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest_block_);
  }
  return bytes_for(plan, layout, triangles) <= static_cast<std::uint64_t>(largest_block_);
}

// Room for many triangles is also room for few.
bool WeldStage::has_room(const WeldPlan& plan, const capture::Layout& layout, std::uint32_t triangles) const {
  return (!plan.makes_normals || normals_.built()) &&
         pass(ability(plan, layout), takes_one_dispatch(triangles) ? Pass::all : Pass::write).built() &&
         bytes_for(plan, layout, triangles) <= static_cast<std::uint64_t>(tables_.size());
}

bool WeldStage::reserve(const WeldPlan& plan, const capture::Layout& layout, std::uint32_t triangles) {
  const Ability needed = ability(plan, layout);
  const auto builds_several = [&] {
    return build(needed, Pass::clear) && build(needed, Pass::insert) &&
           (needed != Ability::creased || build(needed, Pass::mark)) && build(needed, Pass::write);
  };
  const bool built = build(needed, Pass::all) && (takes_one_dispatch(triangles) || builds_several());
  return built && (!plan.makes_normals || normals_.build()) && can_hold(plan, layout, triangles) &&
         tables_.reserve(gl_, static_cast<std::int64_t>(bytes_for(plan, layout, triangles)), GL_DYNAMIC_COPY);
}

void WeldStage::dispatch(Pass step, const WeldRequest& request, std::uint32_t invocations) const {
  const capture::Layout& layout = *request.layout;
  const core::ComputePass& program = pass(ability(*request.plan, layout), step);
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
                          static_cast<GLint>(keys.size()),
                          static_cast<GLint>(table_words(*request.plan, layout, request.triangles.count))};
  program.use(gl_);
  program.set_integers(gl_, values);
  set_limits(gl_, program, request.plan->crease);
  if (!keys.empty() && program.location(key_words) >= 0) {
    gl_.Uniform1iv(program.location(key_words), static_cast<GLsizei>(keys.size()), keys.data());
  }
  core::ComputePass::dispatch(gl_, invocations);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void WeldStage::run(const WeldRequest& request, GLuint captured_count) {
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, request.triangles.buffer);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, captured_count);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, tables_.name());
  if (request.normals) {
    make_normals(request);
  }
  if (request.edges || request.tags) {
    weld(request);
  }
  gl_.MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

void WeldStage::make_normals(const WeldRequest& request) const {
  normals_.run({.layout = request.layout,
                .triangles = request.triangles,
                .key_words = request.key_words,
                .crease = request.plan->crease,
                .slots = slots_for(request.triangles.count)});
}

void WeldStage::weld(const WeldRequest& request) const {
  const std::uint32_t triangles = request.triangles.count;
  if (takes_one_dispatch(triangles)) {
    dispatch(Pass::all, request, 1);
  } else {
    if (request.plan->creased(*request.layout)) {
      const std::uint64_t words = table_words(*request.plan, *request.layout, triangles);
      gl_.BufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(4 * words), sizeof(extent), extent);
    }
    dispatch(Pass::clear, request, static_cast<std::uint32_t>(slots_for(triangles)));
    dispatch(Pass::insert, request, 3 * triangles);
    if (request.plan->creased(*request.layout)) {
      dispatch(Pass::mark, request, 3 * triangles);
    }
    dispatch(Pass::write, request, 3 * triangles);
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
