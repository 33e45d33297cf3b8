// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/evaluate/evaluation.h"

#include <limits>

#include "glark/core/programs/uniform_watch.h"
#include "glark/core/refine/program/uniform_copy.h"
#include "glark/core/shape.h"

namespace glark::evaluate {
namespace {

constexpr std::uint64_t most_indices = std::numeric_limits<GLsizei>::max();

std::int64_t bytes_of(std::uint64_t vertices, const VertexFormat& format) {
  return static_cast<std::int64_t>(vertices) * format.words * 4;
}

}  // namespace

bool Evaluation::find_heights(core::HeightMap& heights) const {
  const core::Displacement& displacement = env_.ark.displacement;
  core::TextureStamps& textures = env_.share.textures;
  textures.watch();
  const core::TextureBindings::Unit unit = env_.state.textures().at(env_.gl, static_cast<GLuint>(displacement.unit));
  heights = {.texture = unit.texture,
             .sampler = unit.sampler,
             .written = textures.state(unit.texture),
             .unit = displacement.unit,
             .channel = displacement.channel,
             .scale = displacement.scale,
             .bias = displacement.bias};
  return unit.texture != 0 && textures.trusted(unit.texture);
}

std::optional<core::RefinedVerticesKey> Evaluation::key_of(const core::DrawPlan& plan,
                                                           const core::DrawCache::Entry& entry) const {
  const core::DerivedProgram& derived = *plan.derived;
  core::RefinedVerticesKey key{.level = plan.depth.level,
                               .refinement = derived.refinement,
                               .shape_number = core::shape_number(env_.options, env_.ark, derived.refinement),
                               .surface = derived.surface,
                               .heights = {},
                               .view = entry.view.number};
  if (derived.height_map >= 0 && !find_heights(key.heights)) {
    return std::nullopt;
  }
  if (!plan.program->refinement_source.empty()) {
    if (plan.owner == nullptr || plan.owner->uniforms_stale) {
      return std::nullopt;
    }
    key.shader = derived.number;
    key.uniform_changes = derived.shape_uniforms != nullptr ? derived.shape_uniforms->changes.load() : 0;
  }
  return key;
}

// The application's queries would count the evaluation, and its own transform feedback has a mode that ours changes.
bool Evaluation::may_evaluate() const {
  const core::Bindings& b = env_.bindings();
  return !b.transform_feedback.active && !b.queries.primitives();
}

const core::RefinedVertices* Evaluation::find(const core::DrawPlan& plan, const core::KeptDraw& kept) {
  if (!plan.keeps_vertices || !kept.filled) {
    return nullptr;
  }
  core::DrawCache::Entry& entry = *kept.entry;
  if (plan.depth.measured && !entry.view.kept()) {
    return nullptr;
  }
  const std::optional<core::RefinedVerticesKey> key = key_of(plan, entry);
  if (!key || !(entry.vertices.key == *key)) {
    parts_.kept.drop_vertices(entry);
    entry.vertices.key = key.value_or(core::RefinedVerticesKey{});
    entry.reuses = entry.frames_reused = 0;  // programs that alternate between two levels keep neither
  }
  if (entry.vertices.vertex_array != 0) {
    return &entry.vertices;
  }
  if (!key || entry.vertices.refused || !entry.repeats_often() || !may_evaluate()) {
    return nullptr;
  }
  core::ErrorScope errors(env_.errors);
  const bool made = make(plan, entry);
  entry.vertices.key = *key;
  entry.vertices.refused = !made;
  env_.gl.BindVertexArray(env_.bindings().vertex_array);
  parts_.programs.use_application();
  return entry.vertices.refused ? nullptr : &entry.vertices;
}

bool Evaluation::make(const core::DrawPlan& plan, core::DrawCache::Entry& entry) {
  Mesh mesh{.format = vertex_format(plan.derived->layout.fields)};
  if (mesh.format.attributes.empty()) {
    return false;
  }
  if (!(plan.placed ? make_pieces(plan, entry, mesh) : make_grids(plan, entry, mesh))) {
    parts_.kept.drop_vertices(entry);
    return false;
  }
  entry.vertices.vertex_array = make_vertex_array(env_.gl, mesh.format, entry.vertices.buffer, mesh.indices);
  entry.vertices.index_count = static_cast<GLsizei>(mesh.index_count);
  entry.vertices.lifetime = std::make_shared<const char>();
  if (entry.vertices.vertex_array == 0 || env_.gl.GetError() != GL_NO_ERROR) {
    parts_.kept.drop_vertices(entry);
    return false;
  }
  return true;
}

// A uniform level of one piece a triangle. All draws of the level share the indices.
bool Evaluation::make_grids(const core::DrawPlan& plan, core::DrawCache::Entry& entry, Mesh& mesh) {
  const capture::CoarseTriangles& triangles = entry.triangles;
  const unsigned level = plan.depth.level;
  mesh.index_count = triangles.count * lattice_indices(level);
  const core::DrawCache::VertexRoom room{bytes_of(triangles.count * lattice_points(level), mesh.format), 0};
  if (mesh.index_count > most_indices ||
      !parts_.kept.allocate_vertices(entry, room, grids_.bytes_with(level, triangles.count))) {
    return false;
  }
  const GridIndices::Grid grid =
      grids_.ensure(env_.gl, parts_.pool.pool(), parts_.pool.number(), level, triangles.count);
  mesh.indices = grid.indices;
  const submit::PointDraw draw{
      .first = grid.first_vertex,
      .count = grid.vertex_count,
      .instances = static_cast<GLsizei>(triangles.count),
      .chunks = plan.capture.layout->chunk_count(),
      .source = {triangles.buffer, triangles.offset, plan.capture.layout->triangle_words() * 4}};
  return grid.indices != 0 && evaluate(plan, entry, {&draw, 1});
}

// Depths that vary, and levels that are cut into tiles.
bool Evaluation::make_pieces(const core::DrawPlan& plan, core::DrawCache::Entry& entry, Mesh& mesh) {
  const PieceBatches batches({env_.gl, parts_.pool.pool(), parts_.pool.number(), patterns_}, plan, entry);
  mesh.index_count = batches.index_count();
  if (!batches.complete() || mesh.index_count > most_indices || batches.vertex_count() > most_indices) {
    return false;
  }
  const core::DrawCache::VertexRoom room{bytes_of(batches.vertex_count(), mesh.format),
                                         static_cast<std::int64_t>(mesh.index_count * sizeof(std::uint32_t))};
  if (!parts_.kept.allocate_vertices(entry, room, grids_.bytes())) {
    return false;
  }
  mesh.indices = entry.vertices.indices.name();
  batches.write_indices(env_.gl, entry.vertices.indices);
  core::GpuBuffer points;
  const std::vector<submit::PointDraw> draws = batches.point_draws(env_.gl, *plan.capture.layout, points);
  const bool done = !draws.empty() && evaluate(plan, entry, draws);
  points.release(env_.gl);
  return done;
}

// Gives the program the values of the derived one.
void Evaluation::set_uniforms(const core::DrawPlan& plan, const EvaluationProgram& program) const {
  core::DerivedProgram& derived = *plan.derived;
  if (program.shape_number >= 0) {
    env_.gl.ProgramUniform1f(program.name, program.shape_number,
                             core::shape_number(env_.options, env_.ark, derived.refinement));
  }
  if (program.displacement.height_map >= 0) {
    core::set_displacement(env_.gl, env_.ark.displacement, program.name, program.displacement);
  }
  if (plan.program->refinement_source.empty()) {
    return;
  }
  core::DerivedProgram copy;
  copy.name = program.name;
  refine::map_uniform_locations(env_.gl, derived.name, copy);
  refine::copy_uniform_values(env_.gl, derived.name, copy);
  core::watch_uniforms(env_.gl, program.uniforms, *plan.program, derived);
}

// Returns whether GL has written all vertices. It writes none in a conditional rendering that is off; such a draw is
// refused until it changes.
bool Evaluation::evaluate(const core::DrawPlan& plan, const core::DrawCache::Entry& entry,
                          std::span<const submit::PointDraw> draws) {
  const core::Bindings& b = env_.bindings();
  const EvaluationProgram& program = programs_.find({plan.derived, plan.placed, plan.program->refinement_source});
  if (program.name == 0) {
    return false;
  }
  set_uniforms(plan, program);
  if (b.primitive_restart) {
    env_.gl.Disable(GL_PRIMITIVE_RESTART);
  }
  std::uint32_t points = 0;
  parts_.capture.begin(program.name, b, capture::Count::checked, &entry.vertices.buffer, GL_POINTS);
  for (const submit::PointDraw& draw : draws) {
    points += static_cast<std::uint32_t>(draw.count) * static_cast<std::uint32_t>(draw.instances);
    points_.draw_points(parts_.pool.pool(), draw);
  }
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
