// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/depth/measure/measure.h"

#include <numbers>

#include "glark/core/depth/measure/measuring_pass.h"

namespace glark::depth {
namespace {

constexpr char measure_source[] =
#include "glark/core/depth/measure/measure.glsl.inc"
    ;

// The end of the limits' buffer, as measure.glsl reads it.
struct LimitRule {
  GLfloat pixels;
  GLfloat radians_of_turn;
  GLfloat error;
  GLfloat budget;
  GLfloat most_change;
  GLfloat restart;  // 1: all depths begin at no coarseness. The pass that makes the limits sets it to 0
};

// Uniforms of the pass that measures; all but the last are integers.
constexpr const char* depth_names[] = {"record_offset",   "corner_words",      "normal_offset",
                                       "first_depth",     "triangle_bound",    "pool_level",
                                       "turn_offset",     "straight_position", "straight_position_words",
                                       "straight_normal", "straight_control",  "shown_stamp",
                                       "half_size"};
constexpr std::size_t half_size = 12;

constexpr std::int64_t rule_offset = 4 * (1 + 2 * limit_depths + 1);
constexpr std::int64_t limit_bytes = rule_offset + sizeof(LimitRule);
constexpr float most_change_while_morphing =
    1.0F / 16;  // of a level in a frame: at 60 frames a second, a quarter of a second

}  // namespace

Measures measures_of(const DepthPlan& plan, const capture::Layout& layout) {
  if (layout.tag_offset >= 0) {
    return {.tags = true, .depth_steps = plan.depth_steps()};
  }
  const bool has_position = capture::find_role(layout.fields, capture::Role::position) != nullptr;
  return {.lengths = plan.screen.name != 0 && (plan.measure.pixels > 0 || !plan.screen.measures_curves()),
          .normals = plan.normal_offset >= 0,
          .straight = plan.budget.curves_only && has_position && capture::normal_offset(layout.fields) >= 0,
          .points = plan.screen.points,
          .depth_steps = plan.depth_steps()};
}

std::vector<core::ComputeText::Define> defines_of(const Measures& measures) {
  const auto flag = [](bool on) { return std::uint64_t{on ? 1U : 0U}; };
  return {{"GLARK_DEPTHS", limit_depths},
          {"GLARK_CURVES", flag(measures.curves())},
          {"GLARK_LENGTHS", flag(measures.lengths)},
          {"GLARK_NORMALS", flag(measures.normals)},
          {"GLARK_STRAIGHT", flag(measures.straight)},
          {"GLARK_POINTS", static_cast<std::uint64_t>(measures.points)},
          {"GLARK_STEPS", static_cast<std::uint64_t>(measures.depth_steps)}};
}

core::ComputeText measuring_pass(capture::Language language, std::uint64_t pass, const Measures& measures) {
  core::ComputeText text{.what = "a measuring pass",
                         .source = measure_source,
                         .es = language == capture::Language::es,
                         .defines = defines_of(measures)};
  text.defines.push_back({"GLARK_PASS", pass});
  return text;
}

bool MeasureStage::reserve_ends(std::uint32_t triangles, const Measures& measures) {
  if (limits_.name() == 0 && !limits_tried_) {
    limits_tried_ = true;
    limits_.allocate(gl_, limit_bytes, nullptr, GL_DYNAMIC_COPY);
  }
  return compilation_.build(limits_pass_, measuring_pass(language_, 0, {}), {}) && limits_.name() != 0 &&
         positions_.reserve(triangles, measures.points);
}

bool MeasureStage::reserve_depths(std::uint32_t triangles, const Measures& measures) {
  const bool depths = compilation_.build(depth_passes_[measures], measuring_pass(language_, 1, measures), depth_names);
  const bool shown = !measures.curves() || shown_.reserve(triangles, measures);
  return depths && shown;
}

bool MeasureStage::has_ends(std::uint32_t triangles, const Measures& measures) const {
  return limits_.name() != 0 && limits_pass_.built() && positions_.has_room(triangles, measures.points);
}

bool MeasureStage::has_depths(std::uint32_t triangles, const Measures& measures) const {
  const auto found = depth_passes_.find(measures);
  return found != depth_passes_.end() && found->second.built() &&
         (!measures.curves() || shown_.has_room(triangles, measures));
}

// The limits change only between frames, so that every pass over the same geometry gets the same depths.
void MeasureStage::update_limits(const core::EdgeMeasure& rule, bool morphs, GLuint work) {
  const bool restart = rule != rule_;
  if (!restart && !(frame_finished_ && rule.budget > 0)) {
    return;
  }
  if (restart || morphs != morphs_) {
    const LimitRule words{.pixels = rule.pixels,
                          .radians_of_turn = rule.degrees * std::numbers::pi_v<float> / 180.0F,
                          .error = rule.error,
                          .budget = static_cast<GLfloat>(rule.budget),
                          .most_change = morphs ? most_change_while_morphing : 0.0F,
                          .restart = restart ? 1.0F : 0.0F};
    gl_.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    limits_.write(gl_, rule_offset, sizeof(words), &words);
  }
  rule_ = rule;
  morphs_ = morphs;
  frame_finished_ = false;
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, limits_.name());
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, work);
  limits_pass_.use(gl_);
  core::ComputePass::dispatch(gl_, 1);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

EdgeEnds MeasureStage::find_ends(const MeasureRequest& request, const core::EdgeMeasure& rule, GLuint work,
                                 const core::Bindings& bindings) {
  if (request.screen.name != 0) {  // with the storage buffers of the application still bound
    positions_.capture({*request.layout, request.triangles, request.screen}, bindings);
  }
  update_limits(rule, request.measures.depth_steps > 1, work);
  return {positions_.buffer(), limits_.name()};
}

std::array<GLint, straight_edge_uniforms> straight_edge_words(const MeasureRequest& request) {
  const capture::Layout& layout = *request.layout;
  const capture::Field* const position = capture::find_role(layout.fields, capture::Role::position);
  if (!request.budget.curves_only || position == nullptr) {
    return {0, 0, -1, -1};
  }
  return {position->offset, position->words, capture::normal_offset(layout.fields), layout.control_offset};
}

MeasuredDepths MeasureStage::measure(const MeasureRequest& request, const core::Bindings& bindings) {
  const bool curves = request.screen.measures_curves();
  const MeasuredDepths result{positions_.buffer(), positions_.words_offset(request.screen.points)};
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, request.triangles.buffer);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, positions_.buffer());
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, limits_.name());
  const GLint stamp =
      curves ? shown_.mark({*request.layout, request.triangles, request.measures, request.pool_level}, bindings) : 0;
  const core::ComputePass& pass = depth_passes_.at(request.measures);
  pass.use(gl_);
  const auto straight = straight_edge_words(request);
  const GLint values[] = {static_cast<GLint>(request.triangles.offset / 4),
                          request.layout->corner_words,
                          request.normal_offset,
                          static_cast<GLint>(result.offset / 4),
                          static_cast<GLint>(request.triangles.count),
                          static_cast<GLint>(request.pool_level),
                          request.layout->turn_offset,
                          straight[0],
                          straight[1],
                          straight[2],
                          straight[3],
                          stamp};
  pass.set_integers(gl_, values);
  gl_.Uniform2f(pass.location(half_size), 0.5F * bindings.viewport[0], 0.5F * bindings.viewport[1]);
  core::ComputePass::dispatch(gl_, request.triangles.count);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return result;
}

void MeasureStage::release() {
  limits_pass_.release(gl_);
  for (auto& [measures, pass] : depth_passes_) {
    pass.release(gl_);
  }
  depth_passes_.clear();
  rule_ = core::EdgeMeasure{};
  limits_tried_ = false;
  limits_.release(gl_);
  positions_.release();
  shown_.release();
}

}  // namespace glark::depth
