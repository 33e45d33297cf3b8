// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/passes/kept_views.h"

#include <array>
#include <cstring>
#include <string>
#include <utility>

#include "glark/core/depth/measure/shown_edges.h"
#include "glark/core/programs/uniform_watch.h"
#include "glark/core/refine/program/uniform_copy.h"
#include "glark/core/shape.h"

namespace glark::core {
namespace {

constexpr std::size_t most_uniforms = 64;
constexpr std::size_t largest_uniform = 16;  // numbers
// If the values of uniforms have changed so often in a row, they are not compared in every draw.
constexpr unsigned most_moves = 2;
constexpr unsigned draws_to_pause = 14;

}  // namespace

// ES lacks glGetUniformdv, which reads all types exactly.
const KeptViews::Positions& KeptViews::positions_of(const DrawPlan& plan) {
  const auto found = positions_.find(plan.corners);
  if (found != positions_.end()) {
    return found->second;
  }
  std::erase_if(positions_, [](const auto& entry) { return entry.first.expired(); });
  Positions& positions = positions_[plan.corners];
  DerivedProgram& corners = *plan.corners;
  const std::optional<std::vector<std::string>> names = refine::plain_uniforms(env_.gl, corners.name, "");
  positions.watched = names && names->size() <= most_uniforms && plan.program->traits.system_values.empty() &&
                      env_.gl.GetUniformdv != nullptr && env_.capabilities.api != Capabilities::Api::es;
  if (positions.watched) {
    watch_uniforms(env_.gl, *names, *plan.program, corners);
    for (const std::string& name : *names) {
      positions.locations.push_back(env_.gl.GetUniformLocation(corners.name, name.c_str()));
    }
  }
  return positions;
}

std::optional<ViewKey> KeptViews::key_of(const DrawPlan& plan) {
  const depth::DepthPlan& depth = plan.depth;
  ViewKey key{.measure = depth.measure,
              .deepest = depth.deepest,
              .depth_steps = depth.depth_steps(),
              .interior = static_cast<int>(depth.interior)};
  if (plan.corners == nullptr) {
    return key;
  }
  const bool fixed = plan.owner == nullptr || plan.owner->uniforms_stale || plan.assembly != nullptr;
  if (fixed || plan.pipeline != nullptr || plan.corners->stored() || !positions_of(plan).watched) {
    return std::nullopt;
  }
  key.program = plan.corners->number;
  key.shape_number = shape_number(env_.options, env_.ark, plan.corners->refinement);
  key.viewport = env_.bindings().viewport;
  key.culled_side = depth::culled_side(env_.bindings());
  key.points = depth.screen.points;
  return key;
}

void KeptViews::read_values(const DrawPlan& plan) {
  values_.clear();
  for (const GLint location : positions_of(plan).locations) {
    std::array<GLdouble, largest_uniform> numbers{};
    env_.gl.GetUniformdv(plan.corners->name, location, numbers.data());
    const std::size_t at = values_.size();
    values_.resize(at + 2 * largest_uniform);
    std::memcpy(&values_[at], numbers.data(), sizeof(numbers));
  }
}

// Programs often set the same values again in every frame.
bool KeptViews::same_uniforms(const DrawPlan& plan, ViewUniforms& uniforms) {
  if (plan.corners == nullptr) {
    return true;
  }
  const std::uint64_t changes = plan.corners->shape_uniforms->changes.load();
  if (changes == uniforms.changes) {
    return true;
  }
  uniforms.changes = changes;
  if (uniforms.pause > 0) {
    --uniforms.pause;
    uniforms.values.clear();
    return false;
  }
  read_values(plan);
  const bool same = values_ == uniforms.values;
  std::swap(values_, uniforms.values);
  uniforms.moves = same ? 0 : uniforms.moves + 1;
  if (uniforms.moves >= most_moves) {
    uniforms.moves = 0;
    uniforms.pause = draws_to_pause;
  }
  return same;
}

void KeptViews::follow(const DrawPlan& plan, const KeptDraw& kept) {
  if (!kept.filled) {
    return;
  }
  DrawCache::Entry& entry = *kept.entry;
  KeptView& view = entry.view;
  if (!plan.depth.keeps_view()) {
    if (plan.depth.measured && view.kept()) {  // it was measured without a budget
      kept_.drop_view(entry);
      view.followed = false;
    }
    return;
  }
  const std::optional<ViewKey> key = plan.polygons ? std::nullopt : key_of(plan);
  const bool same = key && view.followed && *key == view.key;
  // Values that were not followed all the time are not compared.
  if (!key || key->program != view.key.program) {
    view.uniforms = {};
  }
  const bool stays = key && same_uniforms(plan, view.uniforms) && same;
  if (!stays) {
    kept_.drop_view(entry);
    view.key = key.value_or(ViewKey{});
    view.followed = key.has_value();
  }
}

bool KeptViews::wants(const DrawPlan& plan, const KeptDraw& kept) {
  return plan.depth.keeps_view() && kept.filled && kept.entry->view.followed && !kept.entry->view.refused &&
         kept.entry->repeats_often();
}

}  // namespace glark::core
