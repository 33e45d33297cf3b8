// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/immediate/immediate_capture.h"

#include <algorithm>
#include <string>
#include <utility>

#include "glark/core/passes/compile_ahead.h"

namespace glark::core {
namespace {

constexpr std::uint64_t most_bytes = std::uint64_t{512} << 20;

// The passes have room for this many triangles before these are counted. Room for a whole capture would take five times
// its memory.
constexpr std::uint64_t first_room = 4096;

// Whether the triangles of a plan can be drawn in several parts.
bool is_divisible(const DrawPlan& plan, bool exact) { return exact && !plan.polygons; }

}  // namespace

// The number of triangles that a capture of the plan may hold.
std::uint64_t ImmediateCapture::room() const {
  return bytes_ / static_cast<std::uint64_t>(plan_.capture.layout->triangle_words() * 4);
}

bool ImmediateCapture::make_room(std::uint64_t triangles) {
  while (room() < triangles && bytes_ < most_bytes) {
    bytes_ = std::min(2 * bytes_, most_bytes);
  }
  return room() >= triangles;
}

std::uint64_t ImmediateCapture::begin(GLenum mode, MaterialSet materials, std::uint64_t least,
                                      std::optional<Cause>& cause) {
  const auto nothing = [] {};
  const bool tags_vary = !env_.options.transparent && env_.ark.depth_source == DepthSource::tag;
  const DrawCall call{
      .mode = mode, .tags_vary = tags_vary, .whole_polygons = true, .materials = materials, .issue = nothing};
  Decision decision = planner_.plan(call);
  cause = decision.cause;
  plan_ = std::move(decision.plan);
  // The number of triangles is not known in advance where glArrayElement may restart the primitive.
  exact_ = !env_.bindings().primitive_restart && !env_.state.immediate().elements_restart();
  if (cause == Cause::mesh_waits) {
    compile_ahead(meshes_, passes_, call, plan_, first_room);
  }
  if (!cause && !make_room(least)) {
    cause = Cause::out_of_memory;
  }
  if (!cause) {
    const std::uint64_t counted_later = is_divisible(plan_, exact_) ? std::min(first_room, room()) : room();
    cause = passes_.ensure_room(plan_, {.captured = room(), .refined = counted_later, .exact = false});
  }
  if (cause) {
    return 0;
  }
  capture_.begin(plan_.capture, {.count = exact_ ? capture::Count::known : capture::Count::by_query});
  return room();
}

std::uint64_t ImmediateCapture::limited(std::uint64_t triangles) {
  const std::uint64_t capacity = room();
  if (triangles <= capacity) {
    return triangles;
  }
  log(LogLevel::warning,
      "glBegin..glEnd of " + std::to_string(triangles) + " joined triangles exceeds the " + std::to_string(capacity) +
          " that are captured at once; the rest is not drawn this time; use vertex arrays for meshes of this size");
  make_room(triangles);  // of the next one
  return capacity;
}

ImmediateCapture::Captured ImmediateCapture::end(std::uint64_t triangles) {
  triangles = limited(triangles);
  Captured captured;
  captured.triangles = capture_.end(plan_.capture, triangles, exact_);
  captured.plan = std::exchange(plan_, DrawPlan{});  // the plan's programs may be deleted
  if (is_divisible(captured.plan, exact_) && triangles > first_room &&
      passes_.ensure_room(captured.plan, {.captured = 0, .refined = triangles, .exact = false})) {
    captured.most_at_once = first_room;
    captured.plan.weld.on = false;
  }
  if (triangles > 0 && !captured.plan.depth.adaptive) {
    captured.cause = planner_.cause_when_counted(captured.plan, triangles);
    captured.plan.depth.level = captured.cause ? 0 : captured.plan.depth.level;
  }
  return captured;
}

}  // namespace glark::core
