// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/depth/instance_sorter.h"

#include <numeric>
#include <vector>

#include "glark/core/capture/draw_capture.h"
#include "glark/core/report/statistics.h"

namespace glark::depth {

InstanceSorter::InstanceSorter(const core::Environment& environment, const pattern::PoolInUse& pool,
                               capture::Language language)
    : env_(environment),
      pool_(pool),
      measure_(environment.compilation, language),
      bins_(environment.compilation, language),
      ordered_(environment.compilation, language) {}

bool InstanceSorter::has_numbers() const { return numbers_.size() >= std::int64_t{4} * bins_.capacity(); }

bool InstanceSorter::reserve_numbers() {
  if (has_numbers()) {
    return true;
  }
  std::vector<std::uint32_t> numbers(bins_.capacity());
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers_.allocate(env_.gl, std::int64_t{4} * bins_.capacity(), numbers.data(), GL_STATIC_DRAW);
}

namespace {

// Returns whether a draw keeps the order of its triangles. It then needs the passes of OrderedStage alone.
bool is_ordered(const SortRoom& room) {
  return room.exact && !room.stored && OrderedStage::may_take(room.triangles, room.plan);
}

}  // namespace

bool InstanceSorter::has_room_in_bins(const SortRoom& room, const Measures& measures) const {
  return bins_.has_room(room.layout, room.triangles, room.plan) &&
         (!room.plan.measured || measure_.has_depths(room.triangles, measures)) && (!room.numbered || has_numbers());
}

bool InstanceSorter::has_room(const SortRoom& room) const {
  const Measures measures = measures_of(room.plan, room.layout);
  return prepared_for_ == pool_.number() && (!room.plan.measured || measure_.has_ends(room.triangles, measures)) &&
         (is_ordered(room) && !ordered_.gave_up(room.triangles, measures)
              ? ordered_.has_room(room.layout, room.triangles, measures)
              : has_room_in_bins(room, measures));
}

bool InstanceSorter::reserve_bins(const SortRoom& room, const Measures& measures) {
  const bool bins = bins_.reserve(room.layout, room.triangles, room.plan);
  const bool measured = !room.plan.measured || measure_.reserve_depths(room.triangles, measures);
  return bins && measured && (!room.numbered || reserve_numbers());
}

bool InstanceSorter::reserve(const SortRoom& room) {
  const Measures measures = measures_of(room.plan, room.layout);
  if (prepared_for_ != pool_.number() && bins_.prepare(pool_.pool())) {
    prepared_for_ = pool_.number();
  }
  const bool ends = !room.plan.measured || measure_.reserve_ends(room.triangles, measures);
  const bool ordered = is_ordered(room) && ordered_.reserve(room.layout, room.triangles, measures);
  const bool waits = env_.compilation.refused();
  return ends && prepared_for_ == pool_.number() && (ordered || (!waits && reserve_bins(room, measures)));
}

bool InstanceSorter::takes_in_order(const SortRequest& request) const {
  return !request.stored && ordered_.takes(request.layout, request.triangles, request.plan);
}

namespace {

// The application's queries have counted the points that were measured on the screen.
std::int64_t primitives_of_capture(const ScreenProgram& program, std::int64_t triangles) {
  if (program.name == 0) {
    return 0;
  }
  return program.measures_curves() ? (triangles + 2) / 3 * program.points : triangles;
}

}  // namespace

BinnedInstances InstanceSorter::sort(const SortRequest& request) {
  const core::Bindings& b = env_.bindings();
  const DepthPlan& plan = request.plan;
  counted_ = true;
  const unsigned deepest = plan.coarse ? 0 : pool_.pool().max_level();
  const MeasureRequest measured{.layout = &request.layout,
                                .triangles = request.triangles,
                                .screen = plan.screen,
                                .normal_offset = plan.normal_offset,
                                .pool_level = deepest,
                                .measures = measures_of(plan, request.layout),
                                .budget = plan.budget};
  EdgeEnds ends;
  if (plan.measured) {
    ends = measure_.find_ends(measured, plan.measure, bins_.work_buffer(), b);
  }
  capture::add_surplus(env_.state, primitives_of_capture(plan.screen, request.triangles.count));
  return takes_in_order(request) ? ordered_.sort({measured, ends, bins_.work_buffer(), request.tags_are_edge_depths}, b)
                                 : sort_in_bins(request, measured);
}

BinnedInstances InstanceSorter::sort_in_bins(const SortRequest& request, const MeasureRequest& measured) {
  const core::Bindings& b = env_.bindings();
  BinRequest bins{.layout = &request.layout,
                  .triangles = request.triangles,
                  .pool_level = measured.pool_level,
                  .interior = request.plan.interior,
                  .tags_are_edge_depths = request.tags_are_edge_depths,
                  .measured = {},
                  .counted = request.plan.budget.counted};
  if (request.plan.measured) {
    bins.measured = measure_.measure(measured, b);
  }
  const BinnedInstances sorted = bins_.sort(bins, request.count_command->name(), b);
  // The application's queries have counted the instances that were put in order.
  const bool queried = b.queries.generated() != 0 || b.queries.written() != 0;
  const std::uint64_t moved = queried ? bins_.instances_of_last() : 0;
  capture::add_surplus(env_.state, static_cast<std::int64_t>(moved));
  return sorted;
}

InstanceExtent InstanceSorter::extent(const SortRequest& request, const BinnedInstances& sorted) const {
  return takes_in_order(request) ? ordered_.extent(sorted) : bins_.extent(sorted);
}

void InstanceSorter::read_counts() {
  if (counted_) {
    core::statistics().refined_triangles += bins_.take_refined_triangles();
    counted_ = false;
  }
}

void InstanceSorter::release() {
  measure_.release();
  bins_.release();
  ordered_.release();
  numbers_.release(env_.gl);
  prepared_for_ = 0;
}

}  // namespace glark::depth
