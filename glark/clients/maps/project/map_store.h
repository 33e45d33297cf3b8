// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The maps of the charts in a file, from which a killed run continues.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "glark/clients/common/resume/work_folder.h"
#include "glark/clients/common/workers.h"
#include "glark/clients/maps/project/chart_map.h"

namespace glark::maps {

// The file has two places for each chart. A write goes to the one that the last saved state does not use, so a run may be
// killed at any moment.
class MapStore {
 public:
  // maps: all have their sizes.
  MapStore(const common::WorkFolder& folder, std::span<const ChartMap> maps);

  // Writes the charts that have changed since the last call. Fails as the folder does.
  void write(std::span<ChartMap> maps, const common::Workers& workers);
  // Which place each chart has, and the checksum there.
  void save(common::StateWriter& state) const;
  // Reads the charts of a saved state; the others stay. Returns false if the file or the state does not fit: the maps may
  // have changed then.
  bool load(common::StateReader& state, std::span<ChartMap> maps, const common::Workers& workers);

 private:
  static constexpr std::uint32_t in_no_place = 2;
  struct Place {
    std::uint32_t copy = in_no_place;  // 0 or 1
    std::uint32_t unused = 0;
    std::uint64_t sum = 0;
  };
  std::uint64_t offset(std::size_t chart, std::uint32_t copy) const { return copy * offsets_.back() + offsets_[chart]; }

  const common::WorkFolder& folder_;
  std::string file_;
  std::vector<std::uint64_t> offsets_;  // of each chart, and the end
  std::vector<Place> places_;
};

}  // namespace glark::maps
