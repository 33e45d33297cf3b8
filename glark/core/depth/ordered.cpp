// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/depth/ordered.h"

#include <algorithm>
#include <vector>

#include "glark/core/pattern/pieces.glsl.h"

namespace glark::depth {
namespace {

constexpr char ordered_source[] =
#include "glark/core/depth/ordered.glsl.inc"
    ;

constexpr const char* uniform_names[] = {
    "record_offset",   "corner_words",     "tag_offset",        "tags_are_edge_depths",
    "triangle_count",  "pool_level",       "normal_offset",     "on_screen",
    "depth_steps",     "turn_offset",      "straight_position", "straight_position_words",
    "straight_normal", "straight_control", "counted",           "by_length",
    "point_count",     "culled_side",      "half_size"};
constexpr std::size_t culled_side_uniform = 17;
constexpr std::size_t half_size = 18;
constexpr int most_triangles = 128;                               // the size of a work group that GL and ES guarantee
constexpr std::uint32_t group_sizes[] = {8, 32, most_triangles};  // idle invocations are not free
constexpr int most_instances = 4;                                 // of one triangle that is not deeper than a tile
constexpr std::int64_t slots = std::int64_t{most_triangles} * most_instances;
constexpr GLintptr patches_offset = slots * 20;
constexpr GLintptr records_offset = patches_offset + slots * 16;
constexpr std::int64_t chunk_overrun = 16;  // the last vec4 chunk of the last record may read past its end

std::int64_t bytes_for(const capture::Layout& layout) {
  return records_offset + slots * layout.triangle_words() * 4 + chunk_overrun;
}

}  // namespace

void OrderedStage::Passes::release(const gl::Dispatch& gl) {
  for (core::ComputePass& pass : by_size) {
    pass.release(gl);
  }
}

void OrderedStage::prepare(bool curves) {
  Passes& made = passes(curves);
  made.prepared = true;
  for (std::size_t i = 0; i < made.by_size.size(); ++i) {
    const core::ComputeText text{.what = "the pass for small draws",
                                 .source = ordered_source,
                                 .es = language_ == capture::Language::es,
                                 .defines = {{"GLARK_DEPTHS", core::max_supported_level + 1},
                                             {"GLARK_GROUP", group_sizes[i]},
                                             {"GLARK_TRIANGLES", most_triangles},
                                             {"GLARK_INSTANCES", most_instances},
                                             {"GLARK_CURVES", curves ? 1U : 0U}},
                                 .failure = core::LogLevel::warning};
    if (!made.by_size[i].build(gl_, text, uniform_names)) {
      made.release(gl_);
      return;
    }
  }
}

bool OrderedStage::has_room(const capture::Layout& layout, std::uint32_t triangles, bool curves) const {
  const Passes& made = passes(curves);
  return triangles > most_triangles || (made.prepared && (!made.built() || bytes_for(layout) <= result_.size()));
}

void OrderedStage::reserve(const capture::Layout& layout, std::uint32_t triangles, bool curves) {
  if (triangles > most_triangles) {
    return;
  }
  Passes& made = passes(curves);
  if (!made.prepared) {
    prepare(curves);
  }
  if (made.built() && !result_.reserve(gl_, bytes_for(layout), GL_DYNAMIC_COPY)) {
    made.release(gl_);
  }
}

bool OrderedStage::takes(const capture::Layout& layout, const capture::CoarseTriangles& triangles,
                         const DepthPlan& plan) const {
  return passes(plan.screen.measures_curves()).built() && !triangles.count_on_gpu &&
         triangles.count <= most_triangles && plan.deepest <= static_cast<unsigned>(pattern::tile_level) &&
         bytes_for(layout) <= result_.size();
}

BinnedInstances OrderedStage::sort(const OrderedRequest& request, const core::Bindings& bindings) {
  const capture::Layout& layout = *request.measure.layout;
  const capture::CoarseTriangles& triangles = request.measure.triangles;
  const GLuint buffers[] = {triangles.buffer, result_.name(), request.work, request.ends.positions,
                            request.ends.limits};
  for (GLuint i = 0; i < std::size(buffers); ++i) {
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, i, buffers[i]);
  }
  const auto group = std::lower_bound(std::begin(group_sizes), std::end(group_sizes), triangles.count);
  const MeasureRequest& measure = request.measure;
  const core::ComputePass& pass =
      passes(measure.screen.measures_curves()).by_size[static_cast<std::size_t>(group - std::begin(group_sizes))];
  pass.use(gl_);
  const auto straight = straight_edge_words(request.measure);
  const GLint values[] = {static_cast<GLint>(triangles.offset / 4),
                          layout.corner_words,
                          layout.tag_offset,
                          request.tags_are_edge_depths ? 1 : 0,
                          static_cast<GLint>(triangles.count),
                          static_cast<GLint>(request.measure.pool_level),
                          request.measure.normal_offset,
                          request.measure.screen.name != 0 ? 1 : 0,
                          request.measure.depth_steps,
                          layout.turn_offset,
                          straight[0],
                          straight[1],
                          straight[2],
                          straight[3],
                          request.measure.budget.counted ? 1 : 0,
                          measure.by_length ? 1 : 0,
                          measure.screen.points};
  pass.set_integers(gl_, values);
  gl_.Uniform1f(pass.location(culled_side_uniform), static_cast<float>(culled_side(bindings)));
  gl_.Uniform2f(pass.location(half_size), 0.5F * bindings.viewport[0], 0.5F * bindings.viewport[1]);
  gl_.DispatchCompute(1, 1, 1);
  gl_.MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  return {.records = result_.name(),
          .records_offset = records_offset,
          .record_stride = layout.triangle_words() * 4,
          .patches = result_.name(),
          .patches_offset = patches_offset,
          .commands = result_.name(),
          .commands_offset = 0,
          .command_count = static_cast<GLsizei>(triangles.count) * most_instances};
}

InstanceExtent OrderedStage::extent(const BinnedInstances& sorted) const {
  gl_.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<std::uint32_t> commands(static_cast<std::size_t>(sorted.command_count) * 5);
  result_.read(gl_, sorted.commands_offset, static_cast<std::int64_t>(commands.size() * sizeof(commands[0])),
               commands.data());
  return extent_of(commands, sorted.record_stride);
}

void OrderedStage::release() {
  for (Passes& made : passes_) {
    made.release(gl_);
    made.prepared = false;
  }
  result_.release(gl_);
}

}  // namespace glark::depth
