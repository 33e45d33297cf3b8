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
    "record_offset",   "corner_words",     "tag_offset",  "tags_are_edge_depths", "triangle_count",
    "pool_level",      "normal_offset",    "turn_offset", "straight_position",    "straight_position_words",
    "straight_normal", "straight_control", "counted",     "culled_side",          "half_size"};
constexpr std::size_t culled_side_uniform = 13;
constexpr std::size_t half_size = 14;
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

OrderedStage::Passes& OrderedStage::prepare(const Measures& measures) {
  const auto [entry, fresh] = passes_.try_emplace(measures);
  Passes& made = entry->second;
  for (std::size_t i = 0; fresh && i < made.by_size.size(); ++i) {
    core::ComputeText text{.what = "the pass for small draws",
                           .source = ordered_source,
                           .es = language_ == capture::Language::es,
                           .defines = defines_of(measures),
                           .failure = core::LogLevel::warning};
    const core::ComputeText::Define own[] = {{"GLARK_GROUP", group_sizes[i]},
                                             {"GLARK_TRIANGLES", most_triangles},
                                             {"GLARK_INSTANCES", most_instances},
                                             {"GLARK_TAGS", measures.tags ? 1U : 0U}};
    text.defines.insert(text.defines.end(), std::begin(own), std::end(own));
    if (!made.by_size[i].build(gl_, text, uniform_names)) {
      made.release(gl_);
      break;
    }
  }
  return made;
}

const OrderedStage::Passes* OrderedStage::find(const Measures& measures) const {
  const auto found = passes_.find(measures);
  return found != passes_.end() ? &found->second : nullptr;
}

bool OrderedStage::has_room(const capture::Layout& layout, std::uint32_t triangles, const Measures& measures) const {
  const Passes* const made = find(measures);
  return triangles > most_triangles || (made != nullptr && (!made->built() || bytes_for(layout) <= result_.size()));
}

void OrderedStage::reserve(const capture::Layout& layout, std::uint32_t triangles, const Measures& measures) {
  if (triangles > most_triangles) {
    return;
  }
  Passes& made = prepare(measures);
  if (made.built() && !result_.reserve(gl_, bytes_for(layout), GL_DYNAMIC_COPY)) {
    made.release(gl_);
  }
}

bool OrderedStage::takes(const capture::Layout& layout, const capture::CoarseTriangles& triangles,
                         const DepthPlan& plan) const {
  const Passes* const made = find(measures_of(plan, layout));
  return made != nullptr && made->built() && !triangles.count_on_gpu && triangles.count <= most_triangles &&
         plan.deepest <= static_cast<unsigned>(pattern::tile_level) && bytes_for(layout) <= result_.size();
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
  const auto group = std::lower_bound(std::begin(group_sizes), std::end(group_sizes), triangles.count);
  const MeasureRequest& measure = request.measure;
  const core::ComputePass& pass =
      find(measure.measures)->by_size[static_cast<std::size_t>(group - std::begin(group_sizes))];
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
  for (auto& [measures, made] : passes_) {
    made.release(gl_);
  }
  passes_.clear();
  result_.release(gl_);
}

}  // namespace glark::depth
