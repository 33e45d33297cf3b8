// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/depth/measure/shown_edges.h"

#include <vector>

#include "glark/core/depth/measure/measuring_pass.h"

namespace glark::depth {
namespace {

constexpr const char* shown_uniforms[] = {"record_offset", "corner_words", "triangle_bound", "turn_offset",
                                          "shown_stamp",   "pool_level",   "culled_side",    "half_size"};
constexpr std::size_t culled_side_uniform = 6;
constexpr std::size_t shown_half_size = 7;
constexpr std::int64_t edge_bytes_a_triangle = 3 * 4;
constexpr GLint last_stamp = (1 << 22) - 1;  // a word has 10 bits for the steps

// The measures that the pass depends on.
Measures what_shows(const Measures& measures) {
  return {.points = measures.points, .depth_steps = measures.depth_steps};
}

}  // namespace

int culled_side(const core::Bindings& bindings) {
  if (!bindings.culling.enabled || bindings.culling.face == GL_FRONT_AND_BACK) {
    return 0;
  }
  return (bindings.culling.face == GL_BACK) == (bindings.culling.front_face == GL_CCW) ? 1 : -1;
}

bool ShownEdges::has_room(std::uint32_t triangles, const Measures& measures) const {
  const auto found = passes_.find(what_shows(measures));
  return found != passes_.end() && found->second.built() &&
         std::int64_t{triangles} * edge_bytes_a_triangle <= marks_.size();
}

bool ShownEdges::reserve(std::uint32_t triangles, const Measures& measures) {
  const Measures shown = what_shows(measures);
  if (!compilation_.build(passes_[shown], measuring_pass(language_, 2, shown), shown_uniforms)) {
    return false;
  }
  if (has_room(triangles, measures)) {
    return true;
  }
  const std::vector<std::uint32_t> none(std::size_t{triangles} * 3 + std::size_t{triangles}, 0U);
  stamp_ = 0;
  return marks_.allocate(gl_, static_cast<std::int64_t>(none.size() * sizeof(none[0])), none.data(), GL_DYNAMIC_COPY);
}

GLint ShownEdges::mark(const ShownRequest& request, const core::Bindings& bindings) {
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, marks_.name());
  if (request.layout.turn_offset < 0) {
    return 0;
  }
  const core::ComputePass& pass = passes_.at(what_shows(request.measures));
  pass.use(gl_);
  if (stamp_ == last_stamp) {
    clear(pass);
  }
  ++stamp_;
  const GLint values[] = {static_cast<GLint>(request.triangles.offset / 4),
                          request.layout.corner_words,
                          static_cast<GLint>(request.triangles.count),
                          request.layout.turn_offset,
                          stamp_,
                          static_cast<GLint>(request.pool_level)};
  pass.set_integers(gl_, values);
  gl_.Uniform1f(pass.location(culled_side_uniform), static_cast<float>(culled_side(bindings)));
  gl_.Uniform2f(pass.location(shown_half_size), 0.5F * bindings.viewport[0], 0.5F * bindings.viewport[1]);
  core::ComputePass::dispatch(gl_, request.triangles.count);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return stamp_;
}

// The pass is in use.
void ShownEdges::clear(const core::ComputePass& pass) {
  const auto triangles = static_cast<std::uint32_t>(marks_.size() / edge_bytes_a_triangle);
  const GLint values[] = {0, 0, static_cast<GLint>(triangles), 0, 0};
  pass.set_integers(gl_, values);
  core::ComputePass::dispatch(gl_, triangles);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  stamp_ = 0;
}

void ShownEdges::release() {
  for (auto& [measures, pass] : passes_) {
    pass.release(gl_);
  }
  passes_.clear();
  marks_.release(gl_);
}

}  // namespace glark::depth
