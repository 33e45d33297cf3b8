// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The states of bake() that a killed run continues from: the census, the points that are in the maps, the filled maps.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glark/clients/common/resume/checkpoints.h"
#include "glark/clients/maps/project/census.h"
#include "glark/clients/maps/project/map_store.h"

namespace glark::maps {

// The points that were read.
struct PointCounts {
  std::uint64_t read = 0, left_out = 0, invalid = 0;
};

struct FillCounts {
  std::uint64_t texels = 0, filled = 0, empty_charts = 0;
};

// Without a folder, nothing is saved, and nothing is found.
class BakeStates {
 public:
  // Throws Error for a folder that has other work, or cannot be written. Sources without an identity use no folder.
  BakeStates(const CoarseMesh& mesh, const stream::Source& source, const BakeOptions& options);

  bool load(Census& census) const;
  void save(const Census& census);

  // points: of the whole source, if they are known. The maps have their sizes, and are empty.
  void begin_points(std::span<const ChartMap> maps, std::optional<std::uint64_t> points);
  // Each load() leaves empty maps and counts if there is no such state.
  bool load_points(PointCounts& points, std::vector<ChartMap>& maps, const common::Workers& workers);
  bool load_filled(PointCounts& points, FillCounts& fill, std::vector<ChartMap>& maps, const common::Workers& workers);
  // Saves the maps from time to time: after each twentieth of the points, but so that saving takes at most a tenth of the
  // time.
  void save_points(const PointCounts& points, std::vector<ChartMap>& maps, const common::Workers& workers);
  void save_all_points(const PointCounts& points, std::vector<ChartMap>& maps, const common::Workers& workers);
  void save_filled(const PointCounts& points, const FillCounts& fill, std::vector<ChartMap>& maps,
                   const common::Workers& workers);

 private:
  using Clock = std::chrono::steady_clock;

  bool is_worth_it() const;
  template <class Counts>
  bool load(const char* name, Counts& counts, std::vector<ChartMap>& maps, const common::Workers& workers);
  template <class Counts>
  void save(const char* name, const Counts& counts, std::vector<ChartMap>& maps, const common::Workers& workers);

  common::WorkFolder folder_;
  std::optional<common::Checkpoints> checkpoints_;
  std::optional<MapStore> store_;
  Clock::time_point saved_ = Clock::now();
  Clock::duration cost_{};  // of the last save
};

}  // namespace glark::maps
