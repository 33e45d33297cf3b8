// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/passes/triangle_passes.h"

#include <string>

#include "glark/core/capture/feedback_aside.h"

namespace glark::core {
namespace {

depth::SortRoom sort_room(const DrawPlan& plan, std::uint32_t triangles, bool exact) {
  return {plan.depth, *plan.capture.layout, triangles, plan.derived->numbered, plan.derived->stored(), exact};
}

}  // namespace

TrianglePasses::TrianglePasses(const Environment& environment, const pattern::PoolInUse& pool,
                               capture::DrawCapture& capture)
    : env_(environment),
      pool_(pool),
      capture_(capture),
      centroids_(environment.gl),
      cuts_(environment.gl),
      weld_(environment, capture::language_of(environment.capabilities)),
      sorter_(environment, pool, capture::language_of(environment.capabilities)) {}

bool TrianglePasses::has_room(const DrawPlan& plan, std::uint32_t triangles, bool exact) const {
  return (!plan.weld.on || weld_.stage().has_room(plan.weld, *plan.capture.layout, triangles)) &&
         (!plan.depth.adaptive || sorter_.has_room(sort_room(plan, triangles, exact)));
}

bool TrianglePasses::reserve(const DrawPlan& plan, std::uint32_t triangles, bool exact) {
  const bool welds = !plan.weld.on || weld_.stage().reserve(plan.weld, *plan.capture.layout, triangles);
  if (!plan.depth.adaptive) {
    return welds;
  }
  const capture::FeedbackAside aside(env_.gl, capture_.stage(), env_.bindings());
  return sorter_.reserve(sort_room(plan, triangles, exact)) && welds;
}

std::optional<Cause> TrianglePasses::ensure_room(const DrawPlan& plan, const RoomOfDraw& room) {
  const capture::Layout& layout = *plan.capture.layout;
  const auto refined = static_cast<std::uint32_t>(room.refined);
  if (!capture_.stage().can_reserve(layout, room.captured)) {
    return Cause::out_of_memory;
  }
  if (capture_.stage().has_room(layout, room.captured) && has_room(plan, refined, room.exact)) {
    return std::nullopt;
  }
  ErrorScope errors(env_.errors);
  const auto reserve_all = [&] {
    return capture_.stage().reserve(layout, room.captured) && reserve(plan, refined, room.exact);
  };
  const bool at_once = env_.compilation.pace() == CompilePace::at_once;
  const bool reserved = at_once ? env_.compilation.at_once(reserve_all) : reserve_all();
  if (env_.compilation.refused()) {
    return Cause::compiling;
  }
  return reserved ? std::nullopt : std::optional(Cause::out_of_memory);
}

bool TrianglePasses::compile(const DrawPlan& plan, std::uint64_t triangles, bool exact) {
  const auto count = static_cast<std::uint32_t>(triangles);
  if (env_.compilation.pace() == CompilePace::at_once || has_room(plan, count, exact) ||
      !capture_.stage().can_reserve(*plan.capture.layout, triangles)) {
    return true;
  }
  ErrorScope errors(env_.errors);
  reserve(plan, count, exact);
  return !env_.compilation.refused();
}

// Without the pass, flat outputs have the value of another vertex.
bool TrianglePasses::cut(const DrawPlan& plan, const capture::CoarseTriangles& captured) {
  if (!plan.cut) {
    return false;
  }
  if (!cuts_.built()) {
    ErrorScope errors(env_.errors);
    if (!cuts_.build()) {
      return false;
    }
  }
  cuts_.run(*plan.capture.layout, captured, *plan.cut, capture_.stage().count_buffer());
  return true;
}

bool TrianglePasses::weld(const DrawPlan& plan, const capture::CoarseTriangles& captured) {
  const bool changed = cut(plan, captured);
  return weld_.weld_captured(plan.weld, *plan.capture.layout, captured, capture_.count_command()) || changed;
}

bool TrianglePasses::ensure_split_room(const DrawPlan& plan, const polygons::SplitRequest& request) {
  const bool exact = !request.triangles.count_on_gpu;
  if (centroids_.has_room(request) && has_room(plan, request.records(), exact)) {
    return true;
  }
  ErrorScope errors(env_.errors);
  if (centroids_.reserve(request) && reserve(plan, request.records(), exact)) {
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

Records TrianglePasses::split(const DrawPlan& plan, const capture::CoarseTriangles& captured) {
  const capture::Layout& layout = *plan.capture.layout;
  if (!plan.polygons) {
    return {captured, &capture_.count_command()};
  }
  const polygons::SplitRequest request{
      &layout, captured, *plan.polygons, pool_.pool().max_level(), plan.depth.depth_steps(), plan.polygon_sides};
  Records records{captured, &capture_.count_command()};
  if (ensure_split_room(plan, request)) {
    records = {centroids_.split(request, capture_.stage().count_buffer()), &centroids_.count_command(), true};
  }
  weld_.weld_split(plan.weld, layout, records.triangles, *records.count_command);
  return records;
}

void TrianglePasses::release() {
  weld_.release();
  centroids_.release();
  cuts_.release();
  sorter_.release();
}

}  // namespace glark::core
