// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/depth/ordered.h"

#include <algorithm>
#include <vector>

#include "glark/core/capture/record.h"
#include "glark/core/pattern/pieces.glsl.h"

namespace glark::depth {
namespace {

constexpr char ordered_source[] =
#include "glark/core/depth/ordered.glsl.inc"
    ;

constexpr const char* ordered_uniforms[] = {
    "record_offset",   "corner_words",     "tag_offset",  "tags_are_edge_depths", "triangle_count",
    "pool_level",      "normal_offset",    "turn_offset", "straight_position",    "straight_position_words",
    "straight_normal", "straight_control", "counted",     "culled_side",          "half_size"};
constexpr std::size_t culled_side_uniform = 13;
constexpr std::size_t half_size = 14;
constexpr int most_triangles = 128;                               // the size of a work group that GL and ES guarantee
constexpr std::uint32_t group_sizes[] = {8, 32, most_triangles};  // idle invocations are not free
constexpr int instances_a_triangle = 4;                           // of one triangle that is not deeper than a tile
constexpr std::int64_t slots = std::int64_t{most_triangles} * instances_a_triangle;
constexpr GLintptr patches_offset = slots * 20;
constexpr GLintptr records_offset = patches_offset + slots * 16;

std::int64_t bytes_for(const capture::Layout& layout) {
  return records_offset + slots * layout.triangle_words() * 4 + capture::chunk_overrun;
}

// The index of the smallest work group that takes so many triangles.
std::size_t group_for(std::uint32_t triangles) {
  return static_cast<std::size_t>(std::lower_bound(std::begin(group_sizes), std::end(group_sizes), triangles) -
                                  std::begin(group_sizes));
}

}  // namespace

bool OrderedStage::build(const Measures& measures, std::size_t group) {
  core::ComputeText text{.what = "the pass for small draws",
                         .source = ordered_source,
                         .es = language_ == capture::Language::es,
                         .defines = defines_of(measures),
                         .failure = core::LogLevel::warning};
  const core::ComputeText::Define own[] = {{"GLARK_GROUP", group_sizes[group]},
                                           {"GLARK_TRIANGLES", most_triangles},
                                           {"GLARK_INSTANCES", instances_a_triangle},
                                           {"GLARK_TAGS", measures.tags ? 1U : 0U}};
  text.defines.insert(text.defines.end(), std::begin(own), std::end(own));
  return compilation_.build(passes_[measures].at(group), text, ordered_uniforms);
}

const core::ComputePass* OrderedStage::find(const Measures& measures, std::uint32_t triangles) const {
  const auto found = passes_.find(measures);
  if (found == passes_.end() || triangles > most_triangles) {
    return nullptr;
  }
  const auto* const pass = std::find_if(found->second.begin() + group_for(triangles), found->second.end(),
                                        [](const core::ComputePass& one) { return one.built(); });
  return pass != found->second.end() ? pass : nullptr;
}

bool OrderedStage::may_take(std::uint32_t triangles, const DepthPlan& plan) {
  return triangles <= most_triangles && plan.interior != pattern::Interior::smooth &&
         plan.deepest <= static_cast<unsigned>(pattern::tile_level);
}

bool OrderedStage::has_room(const capture::Layout& layout, std::uint32_t triangles, const Measures& measures) const {
  const auto found = passes_.find(measures);
  return found != passes_.end() && found->second.at(group_for(triangles)).built() &&
         bytes_for(layout) <= result_.size();
}

bool OrderedStage::gave_up(std::uint32_t triangles, const Measures& measures) const {
  const auto found = passes_.find(measures);
  return no_memory_ || (found != passes_.end() && found->second.at(group_for(triangles)).failed());
}

bool OrderedStage::reserve(const capture::Layout& layout, std::uint32_t triangles, const Measures& measures) {
  if (no_memory_ || !build(measures, group_for(triangles))) {
    return false;
  }
  no_memory_ = !result_.reserve(gl_, bytes_for(layout), GL_DYNAMIC_COPY);
  return !no_memory_;
}

bool OrderedStage::takes(const capture::Layout& layout, const capture::CoarseTriangles& triangles,
                         const DepthPlan& plan) const {
  return !triangles.count_on_gpu && may_take(triangles.count, plan) &&
         find(measures_of(plan, layout), triangles.count) != nullptr && bytes_for(layout) <= result_.size();
}

void OrderedStage::bind_buffers(const OrderedRequest& request) const {
  const GLuint buffers[] = {request.measure.triangles.buffer, result_.name(), request.work, request.ends.positions,
                            request.ends.limits};
  for (GLuint i = 0; i < std::size(buffers); ++i) {
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, i, buffers[i]);
  }
}

BinnedInstances OrderedStage::sort(const OrderedRequest& request, const core::Bindings& bindings) {
  const capture::Layout& layout = *request.measure.layout;
  const capture::CoarseTriangles& triangles = request.measure.triangles;
  bind_buffers(request);
  const core::ComputePass& pass = *find(request.measure.measures, triangles.count);
  pass.use(gl_);
  const auto straight = straight_edge_words(request.measure);
  const GLint values[] = {static_cast<GLint>(triangles.offset / 4),
                          layout.corner_words,
                          layout.tag_offset,
                          request.tags_are_edge_depths ? 1 : 0,
                          static_cast<GLint>(triangles.count),
                          static_cast<GLint>(request.measure.pool_level),
                          request.measure.normal_offset,
                          layout.turn_offset,
                          straight[0],
                          straight[1],
                          straight[2],
                          straight[3],
                          request.measure.budget.counted ? 1 : 0};
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
          .command_count = static_cast<GLsizei>(triangles.count) * instances_a_triangle};
}

InstanceExtent OrderedStage::extent(const BinnedInstances& sorted) const {
  gl_.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<std::uint32_t> commands(static_cast<std::size_t>(sorted.command_count) * 5);
  result_.read(gl_, sorted.commands_offset, static_cast<std::int64_t>(commands.size() * sizeof(commands[0])),
               commands.data());
  return extent_of(commands, sorted.record_stride);
}

void OrderedStage::release() {
  for (auto& [measures, made] : passes_) {
    for (core::ComputePass& pass : made) {
      pass.release(gl_);
    }
  }
  passes_.clear();
  no_memory_ = false;
  result_.release(gl_);
}

}  // namespace glark::depth
