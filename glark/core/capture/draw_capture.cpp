// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/capture/draw_capture.h"

#include <utility>

#include "glark/core/report/statistics.h"

namespace glark::capture {

Language language_of(const core::Capabilities& capabilities) {
  switch (capabilities.api) {
    case core::Capabilities::Api::es: return Language::es;
    case core::Capabilities::Api::core: return Language::core;
    default: return Language::compatibility;
  }
}

bool takes_edge_flags(const core::Environment& environment) {
  return environment.capabilities.is_compatibility() && environment.bindings().polygon_modes.either() != GL_FILL;
}

namespace {

// Mesa 22's zink crashes in draws that clip after a capture under a clip distance: fault `capture_and_clip` of
// docs/reference/drivers.md. What is captured is not clipped in any case.
template <typename Switch>
void switch_clip_distances(unsigned distances, Switch switch_one) {
  for (GLenum i = 0; i < core::clip_distance_count; ++i) {
    if ((distances >> i & 1U) != 0) {
      switch_one(GL_CLIP_DISTANCE0 + i);
    }
  }
}

}  // namespace

void add_surplus(core::GlState& state, std::int64_t triangles) {
  const core::Bindings& b = state.bindings();
  for (const GLuint query : {b.queries.generated(), b.queries.written()}) {
    if (query != 0) {
      state.query_surplus().add(query, triangles);
    }
  }
}

// Counting our own triangles takes the target of one of the two queries that the application may have open.
void DrawCapture::stop_query(Count count) {
  core::ActiveQueries& queries = env_.state.bindings().queries;
  if (count != Count::known && queries.written() != 0 && queries.generated() != 0) {
    env_.gl.EndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
    stopped_query_ = queries.stop_written();
  }
}

// The query counts from 0 again: its surplus is what it had counted before.
void DrawCapture::resume_query() {
  if (stopped_query_ == 0) {
    return;
  }
  core::ActiveQueries& queries = env_.state.bindings().queries;
  const std::uint64_t counted = query_result(env_.gl, stopped_query_, env_.bindings());
  env_.state.query_surplus().add(stopped_query_, -static_cast<std::int64_t>(counted));
  env_.gl.BeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, stopped_query_);
  queries.resume_written(std::exchange(stopped_query_, 0));
}

DrawCapture::DrawCapture(const core::Environment& environment)
    : env_(environment),
      stage_(environment.gl, language_of(environment.capabilities), environment.capabilities.query_buffer) {}

std::optional<CoarseTriangles> DrawCapture::run(const core::DrawCall& call, const CapturePlan& plan,
                                                const Target& target, const core::Quiet& quiet) {
  const auto capture = [&] {
    begin(plan, target);
    quiet.interrupt();
    (call.captured != nullptr ? *call.captured : call.issue)();
    quiet.hush();
    return end(plan, call.triangles, call.exact);
  };
  const CoarseTriangles triangles = capture();
  const GLenum error = env_.gl.GetError();
  if (error == GL_NO_ERROR) {
    return triangles;
  }
  // The draw raised this error, or the error was pending before it. No error is pending before the second attempt.
  env_.errors.raise(error);
  const CoarseTriangles again = capture();
  if (env_.gl.GetError() != GL_NO_ERROR) {
    add_surplus(env_.state, call.exact ? -2 * static_cast<std::int64_t>(call.triangles) : 0);
    return std::nullopt;
  }
  return again;
}

void DrawCapture::begin(const CapturePlan& plan, const Target& target) {
  if (target.count == Count::by_query && env_.options.read_counts) {
    read_uncounted();  // its query is used again
  }
  if (plan.convention != 0) {
    env_.gl.ProvokingVertex(plan.convention);
  }
  if (takes_edge_flags(env_)) {
    env_.gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);  // Mesa 22 captures no vertices that have their own edge flags
  }
  if (plan.lent) {
    plan.lent->lend(env_.gl, env_.state.arrays());
  }
  clip_distances_ = env_.bindings().clip_distances;
  switch_clip_distances(clip_distances_, env_.gl.Disable);
  stop_query(target.count);
  stage_.begin(plan.program, env_.bindings(), target.count, target.own);
}

CoarseTriangles DrawCapture::end(const CapturePlan& plan, std::uint64_t triangles, bool exact) {
  const core::Bindings& b = env_.bindings();
  const CoarseTriangles captured = stage_.end(*plan.layout, triangles, b);
  switch_clip_distances(clip_distances_, env_.gl.Enable);
  if (plan.lent) {
    plan.lent->take_back(env_.gl, env_.state.arrays());
  }
  if (plan.convention != 0) {
    env_.gl.ProvokingVertex(b.provoking_vertex);
  }
  if (takes_edge_flags(env_)) {
    env_.gl.PolygonMode(GL_FRONT, b.polygon_modes.front);
    env_.gl.PolygonMode(GL_BACK, b.polygon_modes.back);
  }
  // The application's queries have counted the capture, too. The count is read back only here, and only if GL alone
  // knows it.
  if (b.queries.generated() != 0 || b.queries.written() != 0) {
    add_surplus(env_.state, static_cast<std::int64_t>(exact ? triangles : stage_.counted(b)));
  }
  resume_query();
  return captured;
}

void DrawCapture::count_drawn(const CoarseTriangles& triangles, unsigned level) {
  if (triangles.count_on_gpu) {
    uncounted_ = true;
    uncounted_level_ = level;
  } else {
    core::statistics().coarse_triangles += triangles.count;
  }
}

void DrawCapture::read_uncounted() {
  if (!uncounted_) {
    return;
  }
  uncounted_ = false;
  const std::uint64_t coarse = stage_.counted(env_.bindings());
  core::statistics().coarse_triangles += coarse;
  core::statistics().refined_triangles += uncounted_level_ > 0 ? coarse << (2 * uncounted_level_) : 0;
}

}  // namespace glark::capture
