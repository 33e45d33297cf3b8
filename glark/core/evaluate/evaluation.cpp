// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/evaluation.h"

#include <limits>

#include "glark/core/shape.h"

namespace glark::evaluate {
namespace {

int offset_of(const capture::Layout& layout, capture::Role role) {
  const capture::Field* field = capture::find_role(layout.fields, role);
  return field != nullptr ? field->offset : -1;
}

}  // namespace

core::RefinedVerticesKey Evaluation::key_of(const core::DrawPlan& plan) const {
  const core::DerivedProgram& derived = *plan.derived;
  return {.level = plan.depth.level,
          .refinement = derived.refinement,
          .shape_number = core::shape_number(env_.options, env_.ark, derived.refinement),
          .position_offset = offset_of(derived.layout, capture::Role::position),
          .normal_offset = offset_of(derived.layout, capture::Role::normal)};
}

// The application's queries would count the evaluation, and its own transform feedback has a mode that ours changes.
bool Evaluation::may_evaluate() const {
  const core::Bindings& b = env_.bindings();
  return !b.transform_feedback_active && b.primitive_queries == 0 && b.primitives_generated_query == 0 &&
         b.primitives_written_query == 0;
}

const core::RefinedVertices* Evaluation::find(const core::DrawPlan& plan, const core::KeptDraw& kept) {
  if (!plan.keeps_vertices || !kept.filled) {
    return nullptr;
  }
  core::DrawCache::Entry& entry = *kept.entry;
  const core::RefinedVerticesKey key = key_of(plan);
  if (!(entry.vertices.key == key)) {
    parts_.kept.drop_vertices(entry);
    entry.vertices.key = key;
    entry.reuses = entry.frames_reused = 0;  // programs that alternate between two levels keep neither
  }
  if (entry.vertices.vertex_array != 0) {
    return &entry.vertices;
  }
  if (entry.vertices.refused || !entry.repeats_often() || !may_evaluate()) {
    return nullptr;
  }
  core::ErrorScope errors(env_.errors);
  const bool made = make(plan, entry);
  entry.vertices.key = key;
  entry.vertices.refused = !made;
  env_.gl.BindVertexArray(env_.bindings().vertex_array);
  parts_.programs.use_application();
  return entry.vertices.refused ? nullptr : &entry.vertices;
}

bool Evaluation::make(const core::DrawPlan& plan, core::DrawCache::Entry& entry) {
  const VertexFormat format = vertex_format(plan.derived->layout.fields);
  const std::uint32_t triangles = entry.triangles.count;
  if (format.attributes.empty()) {
    return false;
  }
  const unsigned level = plan.depth.level;
  const auto bytes = static_cast<GLsizeiptr>(triangles * lattice_points(level)) * format.words * 4;
  if (triangles * lattice_indices(level) > std::numeric_limits<GLsizei>::max() ||
      !parts_.kept.allocate_vertices(entry, bytes, grids_.bytes_with(level, triangles))) {
    return false;
  }
  const GridIndices::Grid grid = grids_.ensure(env_.gl, parts_.pool.pool(), level, triangles);
  if (grid.indices == 0 || !evaluate(plan, entry, grid)) {
    parts_.kept.drop_vertices(entry);
    return false;
  }
  entry.vertices.vertex_array = make_vertex_array(env_.gl, format, entry.vertices.buffer, grid.indices);
  entry.vertices.index_count = static_cast<GLsizei>(grid.index_count * triangles);
  return true;
}

// Returns whether GL has written all vertices. It writes none in a conditional rendering that is off; such a draw is
// refused until it changes.
bool Evaluation::evaluate(const core::DrawPlan& plan, const core::DrawCache::Entry& entry,
                          const GridIndices::Grid& grid) {
  const core::Bindings& b = env_.bindings();
  const EvaluationProgram& program = programs_.find(plan.derived);
  if (program.name == 0) {
    return false;
  }
  if (program.shape_number >= 0) {
    env_.gl.ProgramUniform1f(program.name, program.shape_number, entry.vertices.key.shape_number);
  }
  if (b.primitive_restart) {
    env_.gl.Disable(GL_PRIMITIVE_RESTART);
  }
  const std::uint32_t points = entry.triangles.count * static_cast<std::uint32_t>(grid.vertex_count);
  parts_.capture.begin(program.name, b, capture::Count::checked, &entry.vertices.buffer, GL_POINTS);
  points_.draw_points(parts_.pool.pool(), entry.triangles, *plan.capture.layout, grid.first_vertex, grid.vertex_count);
  const capture::CoarseTriangles written = parts_.capture.end(*plan.capture.layout, points, b);
  if (b.primitive_restart) {
    env_.gl.Enable(GL_PRIMITIVE_RESTART);
  }
  return written.count == points && env_.gl.GetError() == GL_NO_ERROR;
}

void Evaluation::release() {
  programs_.release();
  grids_.release(env_.gl);
  points_.release();
}

}  // namespace glark::evaluate
