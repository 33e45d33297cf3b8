// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// GL_POLYGON_CENTROID_ARK: which draws are split at the centroids of their polygons, how GL cuts those into triangles, and the
// split itself.
#include <algorithm>
#include <numeric>
#include <vector>

#include "glark/core/context.h"
#include "glark/core/pipeline.h"

namespace glark::core {
namespace {

// The centroid has no value for what does not vary linearly: flat outputs take that of the provoking vertex, which is a corner
// of two of the triangles only. What is constant in a draw alone is the same at all vertices.
bool gives_centroids(const Program& program) {
  return !program.traits.writes_flat_outputs &&
         std::none_of(program.fields.begin(), program.fields.end(), [](const capture::Field& field) {
           return capture::is_wide(field.type) ||
                  (capture::is_integer(field.type) && !capture::is_constant_in_draw(field));
         });
}

}  // namespace

bool Pipeline::splits_at_centroid(const DrawCall& call, const Plan& plan) const {
  const bool told_apart =
      call.polygon_sides != nullptr || (call.whole_polygons && (call.exact || call.mode != GL_POLYGON));
  return splits_polygons(context_.options(), context_.ark()) && context_.is_compatibility() &&
         depth::is_polygon_mode(call.mode) && told_apart && context_.state().bindings().shade_model != GL_FLAT &&
         gives_centroids(*plan.program);
}

// Draws vertices that are numbered, and returns the numbers in the order of the corners that GL makes of them. Empty if GL
// captures nothing (conditional rendering, no memory).
std::vector<float> Pipeline::probe(GLenum mode, bool last_vertex_convention) {
  ErrorScope errors(context_.pending_error());
  const GLsizei vertices = depth::probe_vertices(mode);
  const std::uint64_t triangles = triangles_of(mode, static_cast<std::uint64_t>(vertices));
  const capture::Layout layout = capture::make_layout({{.name = "number", .type = GL_FLOAT, .location = 0}}, false);
  Plan plan;
  plan.layout = &layout;
  {
    const capture::FeedbackAside aside(gl_, capture_, context_.state().bindings());
    plan.capture_program = capture_.program_for(layout, context_.ark().tag_attribute);
  }
  plan.last_vertex_convention = last_vertex_convention;
  std::vector<float> numbers(static_cast<std::size_t>(vertices));
  std::iota(numbers.begin(), numbers.end(), 0.0F);
  std::vector<float> corners(3 * triangles, -1.0F);
  GpuBuffer input;
  GpuBuffer output;
  const auto bytes = [](const std::vector<float>& words) {
    return static_cast<GLsizeiptr>(words.size() * sizeof(float));
  };
  if (plan.capture_program != 0 && capture_.reserve(layout, triangles) &&
      input.allocate(gl_, bytes(numbers), numbers.data(), GL_STATIC_DRAW) &&
      output.allocate(gl_, bytes(corners), corners.data(), GL_STREAM_READ)) {
    GLuint array = 0;
    gl_.GenVertexArrays(1, &array);
    gl_.BindVertexArray(array);
    gl_.BindVertexBuffer(0, input.name(), 0, sizeof(float));
    gl_.VertexAttribFormat(0, 1, GL_FLOAT, GL_FALSE, 0);
    gl_.VertexAttribBinding(0, 0);
    gl_.EnableVertexAttribArray(0);
    begin_capture(plan, capture::Count::known, &output);
    gl_.DrawArrays(mode, 0, vertices);
    end_capture(plan, triangles, true);
    use_application_program();
    gl_.BindVertexArray(context_.state().bindings().vertex_array);
    gl_.DeleteVertexArrays(1, &array);
    output.read(gl_, 0, bytes(corners), corners.data());
  }
  input.release(gl_);
  output.release(gl_);
  if (std::find(corners.begin(), corners.end(), -1.0F) != corners.end()) {
    corners.clear();
  }
  return corners;
}

std::optional<depth::Decomposition> Pipeline::decomposition_for(GLenum mode, bool last_vertex_convention) {
  const GLenum convention =
      last_vertex_convention ? GL_LAST_VERTEX_CONVENTION : context_.state().bindings().provoking_vertex;
  const auto known = decompositions_.find({mode, convention});
  if (known != decompositions_.end()) {
    return known->second;
  }
  const std::vector<float> numbers = probe(mode, last_vertex_convention);
  if (numbers.empty()) {
    return std::nullopt;
  }
  const auto found = depth::decomposition_of(mode, numbers);
  if (!found) {
    const char* name = mode == GL_QUADS ? "GL_QUADS" : mode == GL_QUAD_STRIP ? "GL_QUAD_STRIP" : "GL_POLYGON";
    log(LogLevel::warning,
        std::string("this GL cuts ") + name +
            " into triangles that polygons cannot be put together from: GL_POLYGON_CENTROID_ARK has no effect on them");
  }
  decompositions_[{mode, convention}] = found;
  return found;
}

bool Pipeline::ready_to_split(const Plan& plan, const depth::SplitRequest& request) {
  const std::uint32_t records = request.records();
  if (centroids_.has_room(request) && (!plan.welded || weld_.has_room(*plan.layout, records)) &&
      (!plan.adaptive || has_adaptive_room(plan, records))) {
    return true;
  }
  ErrorScope errors(context_.pending_error());
  if (centroids_.reserve(request) && (!plan.welded || weld_.reserve(*plan.layout, records)) &&
      (!plan.adaptive || ensure_bins(plan, records))) {
    return true;
  }
  if (!split_failed_) {
    split_failed_ = true;
    log(LogLevel::warning,
        "cannot split " + std::to_string(request.polygons()) +
            " polygons at their centroids for lack of memory; they are refined as triangles; draw fewer at once");
  }
  return false;
}

Pipeline::Records Pipeline::records_of(const Plan& plan, const capture::CoarseTriangles& captured) {
  if (plan.polygons) {
    const depth::SplitRequest request{plan.layout,       captured,           *plan.polygons,
                                      pool_.max_level(), plan.depth_steps(), plan.polygon_sides};
    if (ready_to_split(plan, request)) {
      const Records records{centroids_.split(request, capture_.count_buffer()), &centroids_.count_command(), true};
      weld(plan, records.triangles, *records.count_command, true);
      return records;
    }
    weld(plan, captured, capture_.count_command(), true);
  }
  return {captured, &capture_.count_command()};
}

}  // namespace glark::core
