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
                                       "on_screen",       "packed_bits",       "depth_steps",
                                       "turn_offset",     "straight_position", "straight_position_words",
                                       "straight_normal", "straight_control",  "by_length",
                                       "point_count",     "shown_stamp",       "half_size"};
constexpr std::size_t half_size = 17;

constexpr std::int64_t rule_offset = 4 * (1 + 2 * limit_depths + 1);
constexpr std::int64_t limit_bytes = rule_offset + sizeof(LimitRule);
constexpr float most_change_while_morphing =
    1.0F / 16;  // of a level in a frame: at 60 frames a second, a quarter of a second

}  // namespace

core::ComputeText measuring_pass(capture::Language language, std::uint64_t pass, bool curves) {
  return {.what = "a measuring pass",
          .source = measure_source,
          .es = language == capture::Language::es,
          .defines = {{"GLARK_PASS", pass}, {"GLARK_DEPTHS", limit_depths}, {"GLARK_CURVES", curves ? 1U : 0U}}};
}

// Tries to compile each pass only once.
bool MeasureStage::prepare(bool curves) {
  if (limits_.name() == 0 && !tried_[0] && !tried_[1]) {
    limits_pass_.build(gl_, measuring_pass(language_, 0, false), {});
    limits_.allocate(gl_, limit_bytes, nullptr, GL_DYNAMIC_COPY);
  }
  core::ComputePass& pass = depth_passes_[curves ? 1 : 0];
  bool& tried = tried_[curves ? 1 : 0];
  if (!tried) {
    tried = true;
    pass.build(gl_, measuring_pass(language_, 1, curves), depth_names);
  }
  return limits_pass_.built() && limits_.name() != 0 && pass.built();
}

bool MeasureStage::has_room(std::uint32_t triangles, int points) const {
  const bool curves = points > corners_only;
  return limits_.name() != 0 && tried_[curves ? 1 : 0] && positions_.has_room(triangles, points) &&
         (!curves || shown_.has_room(triangles));
}

bool MeasureStage::reserve(std::uint32_t triangles, int points) {
  const bool curves = points > corners_only;
  return prepare(curves) && positions_.reserve(triangles, points) && (!curves || shown_.reserve(triangles));
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
  update_limits(rule, request.depth_steps > 1, work);
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
  const MeasuredDepths result{positions_.buffer(), positions_.words_offset(request.screen.points),
                              request.depth_steps == 1 ? 4 : 10};
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, request.triangles.buffer);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, positions_.buffer());
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, limits_.name());
  const GLint stamp = curves ? shown_.mark({*request.layout, request.triangles, request.screen.points,
                                            request.pool_level, request.depth_steps},
                                           bindings)
                             : 0;
  const core::ComputePass& pass = depth_passes_[curves ? 1 : 0];
  pass.use(gl_);
  const auto straight = straight_edge_words(request);
  const GLint values[] = {static_cast<GLint>(request.triangles.offset / 4),
                          request.layout->corner_words,
                          request.normal_offset,
                          static_cast<GLint>(result.offset / 4),
                          static_cast<GLint>(request.triangles.count),
                          static_cast<GLint>(request.pool_level),
                          request.screen.name != 0 ? 1 : 0,
                          result.bits,
                          request.depth_steps,
                          request.layout->turn_offset,
                          straight[0],
                          straight[1],
                          straight[2],
                          straight[3],
                          request.by_length ? 1 : 0,
                          request.screen.points,
                          stamp};
  pass.set_integers(gl_, values);
  gl_.Uniform2f(pass.location(half_size), 0.5F * bindings.viewport[0], 0.5F * bindings.viewport[1]);
  core::ComputePass::dispatch(gl_, request.triangles.count);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return result;
}

void MeasureStage::release() {
  limits_pass_.release(gl_);
  for (core::ComputePass& pass : depth_passes_) {
    pass.release(gl_);
  }
  tried_ = {};
  rule_ = core::EdgeMeasure{};
  limits_.release(gl_);
  positions_.release();
  shown_.release();
}

}  // namespace glark::depth
