// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/states.h"

#include <fmt/format.h>

#include "glark/clients/common/fnv.h"

namespace glark::maps {
namespace {

[[noreturn]] void fail(const std::string& problem) { throw Error(Element::file, 0, problem); }

std::uint64_t checksum(const CoarseMesh& mesh) {
  std::uint64_t sum = common::add_array_to_fnv(common::fnv_of_nothing, std::span<const double>(mesh.origin));
  for (const std::span<const float> array : {mesh.positions, mesh.normals, mesh.texcoords})
    sum = common::add_array_to_fnv(sum, array);
  return common::add_array_to_fnv(sum, mesh.triangles);
}

// All that the saved states depend on, a line for each.
std::string identity_of(const CoarseMesh& mesh, const stream::Source& source, const BakeOptions& options) {
  std::string identity = fmt::format("glark maps {}\n", GLARK_VERSION);
  const auto add_line = [&](const char* name, const auto& value) { identity += fmt::format("{} {}\n", name, value); };
  add_line("source", source.identity);
  add_line("coarse mesh", checksum(mesh));
  add_line("texture_memory", options.texture_memory);
  add_line("most_side", options.most_side);
  add_line("width", options.width);
  add_line("height", options.height);
  add_line("texcoords", static_cast<int>(options.texcoords));
  add_line("noise", options.noise);
  add_line("texels_per_point", options.texels_per_point);
  add_line("reach", options.reach);
  add_line("skip_invalid", options.skip_invalid);
  return identity;
}

// Throws Error for work that cannot be resumed.
common::WorkFolder open_folder(const CoarseMesh& mesh, const stream::Source& source, const BakeOptions& options) {
  if (options.resume && options.work.empty())
    throw Error(Element::option, 0, "resume needs `work`, the folder where the state of the work is");
  if (options.work.empty() || source.identity.empty()) return {{}, "", false, fail};
  const std::string identity = identity_of(mesh, source, options);
  if (options.resume) common::require_same_work(options.work, identity, fail);
  return {options.work, identity, options.resume, fail};
}

}  // namespace

BakeStates::BakeStates(const CoarseMesh& mesh, const stream::Source& source, const BakeOptions& options)
    : folder_(open_folder(mesh, source, options)) {}

bool BakeStates::load(Census& census) const {
  Census saved;
  const bool is_good = folder_.load("census", [&](common::StateReader& state) {
    return state.get_all(saved.points) && state.get_all(saved.spreads) && state.get(saved.points_with_foot) &&
           state.get(saved.root_mean_square);
  });
  if (is_good) census = std::move(saved);
  return is_good;
}

void BakeStates::save(const Census& census) {
  folder_.save("census", [&](common::StateWriter& state) {
    state.put_all(std::span(census.points));
    state.put_all(std::span(census.spreads));
    state.put(census.points_with_foot);
    state.put(census.root_mean_square);
  });
}

void BakeStates::begin_points(std::span<const ChartMap> maps, std::optional<std::uint64_t> points) {
  store_.emplace(folder_, maps);
  checkpoints_.emplace(folder_, points.value_or(0));
  saved_ = Clock::now();
}

template <class Counts>
bool BakeStates::load(const char* name, Counts& counts, std::vector<ChartMap>& maps, const common::Workers& workers) {
  Counts saved;
  const bool is_good = folder_.load(
      name, [&](common::StateReader& state) { return state.get(saved) && store_->load(state, maps, workers); });
  if (is_good) {
    counts = saved;
    return true;
  }
  for (ChartMap& map : maps) map.clear();
  return false;
}

template <class Counts>
void BakeStates::save(const char* name, const Counts& counts, std::vector<ChartMap>& maps,
                      const common::Workers& workers) {
  const Clock::time_point begin = Clock::now();
  store_->write(maps, workers);
  folder_.save(name, [&](common::StateWriter& state) {
    state.put(counts);
    store_->save(state);
  });
  saved_ = Clock::now();
  cost_ = saved_ - begin;
}

namespace {

struct FilledCounts {
  PointCounts points;
  FillCounts fill;
};

}  // namespace

bool BakeStates::load_points(PointCounts& points, std::vector<ChartMap>& maps, const common::Workers& workers) {
  const bool is_good = load("points", points, maps, workers);
  if (is_good) checkpoints_->begin(points.read);
  return is_good;
}

bool BakeStates::load_filled(PointCounts& points, FillCounts& fill, std::vector<ChartMap>& maps,
                             const common::Workers& workers) {
  FilledCounts counts;
  const bool is_good = load("filled", counts, maps, workers);
  points = counts.points;
  fill = counts.fill;
  return is_good;
}

bool BakeStates::is_worth_it() const {
  constexpr int part = 10;
  return folder_.is_used() && Clock::now() - saved_ >= part * cost_;
}

void BakeStates::save_points(const PointCounts& points, std::vector<ChartMap>& maps, const common::Workers& workers) {
  if (checkpoints_->is_due(points.read)) save_all_points(points, maps, workers);
}

void BakeStates::save_all_points(const PointCounts& points, std::vector<ChartMap>& maps,
                                 const common::Workers& workers) {
  if (is_worth_it()) save("points", points, maps, workers);
}

void BakeStates::save_filled(const PointCounts& points, const FillCounts& fill, std::vector<ChartMap>& maps,
                             const common::Workers& workers) {
  if (is_worth_it()) save("filled", FilledCounts{points, fill}, maps, workers);
}

}  // namespace glark::maps
