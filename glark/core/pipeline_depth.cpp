// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Before a draw: to which depths it is refined, by tags, a uniform level or measures.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "glark/core/context.h"
#include "glark/core/pipeline.h"

namespace glark::core {
namespace {

bool current_tag_is_zero(const Context& context) {
  const CurrentValue* value = context.state().current_values().find(static_cast<int>(context.ark().tag_attribute));
  if (value != nullptr && value->again == set_tag) {
    GLuint tag = 0;
    std::memcpy(&tag, value->components.data(), sizeof(tag));
    return tag == 0;
  }
  GLfloat current[4] = {0, 0, 0, 0};
  context.supported().GetVertexAttribfv(context.ark().tag_attribute, GL_CURRENT_VERTEX_ATTRIB, current);
  return !(current[0] > 0);
}

}  // namespace

EdgeMeasure Pipeline::measure() const {
  if (context_.options().transparent) {
    return context_.options().measure;
  }
  return context_.ark().depth_source == DepthSource::measured ? context_.ark().measure : EdgeMeasure{};
}

// Behind a geometry shader, the vertex stage need not know where on the screen its vertices go.
bool Pipeline::can_measure(const Program& program) const {
  const EdgeMeasure wanted = measure();
  if (!context_.state().programs().subroutines().empty()) {
    return false;  // the choice would have to be made for the program of the corners, too
  }
  return (wanted.pixels > 0 && !program.has_stage(GL_GEOMETRY_SHADER)) ||
         (wanted.degrees > 0 && capture::normal_offset(program.fields) >= 0);
}

unsigned Pipeline::current_tag() const {
  const auto highest = static_cast<unsigned>(context_.ark().pool_level);
  const CurrentValue* value = context_.state().current_values().find(static_cast<int>(context_.ark().tag_attribute));
  if (value != nullptr && value->again == set_tag) {
    GLuint tag = 0;
    std::memcpy(&tag, value->components.data(), sizeof(tag));
    return std::min(tag, highest);
  }
  GLfloat current[4] = {0, 0, 0, 0};
  gl_.GetVertexAttribfv(context_.ark().tag_attribute, GL_CURRENT_VERTEX_ATTRIB, current);
  const double tag = std::isnan(current[0]) ? 0.0 : current[0];  // a float + 0.5 may not be a float
  return static_cast<unsigned>(std::clamp(std::floor(tag + 0.5), 0.0, static_cast<double>(highest)));
}

void Pipeline::plan_depth(const DrawCall& call, Plan& plan) const {
  plan_wanted_depth(call, plan);
  // Captured by the program of the refined draws before it, but coarse.
  plan.coarse = owns_feedback() && !context_.options().transparent && !context_.ark().enabled;
  if (plan.coarse) {
    plan.level = plan.deepest = 0;
  }
}

void Pipeline::plan_wanted_depth(const DrawCall& call, Plan& plan) const {
  if (can_measure(*plan.program)) {
    plan.adaptive = plan.measured = true;
    plan.deepest = context_.options().transparent ? context_.options().max_level
                                                  : static_cast<unsigned>(std::max(context_.ark().pool_level, 0));
    return;
  }
  if (context_.options().transparent) {
    plan.level = context_.options().level;
    return;
  }
  const ArkState& ark = context_.ark();
  if (ark.depth_source != DepthSource::tag) {
    plan.level = ark.uniform_level;
    return;
  }
  plan.adaptive =
      call.tags_vary || feedback_tagged() ||
      context_.state().attribute_source(static_cast<int>(ark.tag_attribute)).enabled ||
      (ark.geomorph && !current_tag_is_zero(context_));  // uniform patterns are cut otherwise: that would pop
  if (!plan.adaptive) {
    plan.level = current_tag();
  }
  plan.deepest = static_cast<unsigned>(ark.pool_level);
}

Cause Pipeline::plan_measure(Plan& plan) {
  const EdgeMeasure wanted = measure();
  if (wanted.degrees > 0) {
    plan.normal_offset = capture::normal_offset(plan.layout->fields);
  }
  if (wanted.pixels > 0 && !plan.program->has_stage(GL_GEOMETRY_SHADER)) {
    plan.corners = derived_program(plan, DerivedKey{.at_corner = true});
    if (plan.corners == nullptr) {
      return Cause::program_not_derived;
    }
    plan.corner_program = plan.corners->name;
  }
  return Cause::count_;
}

}  // namespace glark::core
