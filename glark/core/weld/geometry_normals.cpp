// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/weld/geometry_normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glark/core/weld/weld.h"

namespace glark::weld {
namespace {

constexpr char normals_source[] =
#include "glark/core/weld/geometry_normals.glsl.inc"
    ;

constexpr const char* normal_uniforms[] = {"record_offset",   "corner_words",   "triangle_bound", "count_on_gpu",
                                           "position_offset", "position_words", "normal_offset",  "slot_count",
                                           "key_count",       "key_offset",     "ends_of_edge",   "corners_of_triangle",
                                           "least_cosine"};
constexpr std::size_t least_cosine = 12;

}  // namespace

bool GeometryNormals::build() {
  bool built = true;
  for (std::size_t pass = 0; pass < passes_.size(); ++pass) {
    const core::ComputeText text{.what = "a pass that makes normals",
                                 .source = normals_source,
                                 .es = language_ == capture::Language::es,
                                 .defines = {{"GLARK_PASS", pass}, {"GLARK_GROUP", core::ComputePass::group_size}}};
    built = compilation_.build(passes_.at(pass), text, normal_uniforms) && built;
  }
  return built;
}

void GeometryNormals::run(const GeometryNormalsRequest& request) const {
  const capture::Layout& layout = *request.layout;
  const capture::Field* position = capture::find_role(layout.fields, capture::Role::position);
  const GLint values[] = {static_cast<GLint>(request.triangles.offset / 4),
                          layout.corner_words,
                          static_cast<GLint>(request.triangles.count),
                          request.triangles.count_on_gpu ? 1 : 0,
                          position->offset,
                          position->words,
                          capture::normal_offset(layout.fields),
                          static_cast<GLint>(request.slots),
                          request.keys,
                          request.key_offset,
                          ends_of_edge,
                          corners_of_triangle};
  constexpr float rounding = 1e-4F;  // faces that meet at exactly the angle join
  const float cosine = std::cos(request.crease * std::numbers::pi_v<float> / 180) - rounding;
  for (std::size_t i = 0; i < passes_.size(); ++i) {
    const core::ComputePass& pass = passes_.at(i);
    pass.use(gl_);
    pass.set_integers(gl_, values);
    if (pass.location(least_cosine) >= 0) {
      gl_.Uniform1f(pass.location(least_cosine), cosine);
    }
    core::ComputePass::dispatch(gl_, i == 0 ? static_cast<std::uint32_t>(request.slots) : 3 * request.triangles.count);
    gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }
}

void GeometryNormals::release() {
  for (core::ComputePass& pass : passes_) {
    pass.release(gl_);
  }
}

}  // namespace glark::weld
