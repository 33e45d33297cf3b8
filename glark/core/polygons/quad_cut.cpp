// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/polygons/quad_cut.h"

namespace glark::polygons {
namespace {

constexpr char cut_source[] =
#include "glark/core/polygons/quad_cut.glsl.inc"
    ;

constexpr const char* cut_uniforms[] = {"record_offset", "corner_words", "quad_bound",
                                        "count_on_gpu",  "about",        "corners"};
constexpr std::size_t captured_corners = 5;

}  // namespace

bool QuadCut::build() {
  return pass_.build(gl_, {.what = "the pass that cuts quads", .source = cut_source}, cut_uniforms);
}

void QuadCut::run(const capture::Layout& layout, const capture::CoarseTriangles& triangles, const Cut& cut,
                  GLuint captured_count) const {
  const std::uint32_t quads = triangles.count / 2;
  const GLint values[] = {static_cast<GLint>(triangles.offset / 4), layout.corner_words, static_cast<GLint>(quads),
                          triangles.count_on_gpu ? 1 : 0, cut.about};
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, triangles.buffer);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, captured_count);
  pass_.use(gl_);
  pass_.set_integers(gl_, values);
  gl_.Uniform1iv(pass_.location(captured_corners), static_cast<GLsizei>(cut.captured.corners.size()),
                 cut.captured.corners.data());
  core::ComputePass::dispatch(gl_, quads);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

}  // namespace glark::polygons
