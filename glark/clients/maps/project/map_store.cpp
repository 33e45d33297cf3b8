// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/project/map_store.h"

#include <fcntl.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <string_view>

#include "glark/clients/common/descriptor.h"
#include "glark/clients/common/fnv.h"
#include "glark/clients/common/nameless_file.h"

namespace glark::maps {
namespace {

int open_file(const std::string& file, int flags) { return open(file.c_str(), flags | O_CLOEXEC, 0600); }

std::span<char> bytes_of(std::vector<float>& numbers) {
  return {reinterpret_cast<char*>(numbers.data()), numbers.size() * sizeof(float)};
}

std::uint64_t checksum(ChartMap& map) {
  std::uint64_t sum = common::fnv_of_nothing;
  for (const std::span<char> part : {bytes_of(map.values), bytes_of(map.weights)})
    sum = common::add_to_fnv(sum, {part.data(), part.size()});
  return sum;
}

}  // namespace

MapStore::MapStore(const common::WorkFolder& folder, std::span<const ChartMap> maps)
    : folder_(folder), file_(folder.path("maps")), offsets_{0}, places_(maps.size()) {
  for (const ChartMap& map : maps)
    offsets_.push_back(offsets_.back() + sizeof(float) * (map.values.size() + map.weights.size()));
}

void MapStore::write(std::span<ChartMap> maps, const common::Workers& workers) {
  const common::Descriptor file(open_file(file_, O_CREAT | O_WRONLY));
  if (file.number() < 0) folder_.fail_in(file_, errno);
  std::atomic<int> error = 0;
  workers.each(maps.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end && error == 0; ++c) {
      ChartMap& map = maps[c];
      if (!map.is_changed) continue;
      Place& place = places_[c];
      place = {place.copy == 0 ? 1U : 0U, 0, checksum(map)};
      const std::span<char> values = bytes_of(map.values);
      const std::uint64_t at = offset(c, place.copy);
      if (common::write_at(file.number(), at, values) &&
          common::write_at(file.number(), at + values.size(), bytes_of(map.weights)))
        map.is_changed = false;
      else
        error = errno;
    }
  });
  if (error != 0) folder_.fail_in(file_, error);
}

void MapStore::save(common::StateWriter& state) const { state.put_all(std::span<const Place>(places_)); }

bool MapStore::load(common::StateReader& state, std::span<ChartMap> maps, const common::Workers& workers) {
  std::vector<Place> places;
  if (!state.get_all(places) || places.size() != maps.size()) return false;
  const common::Descriptor file(open_file(file_, O_RDONLY));
  if (file.number() < 0 || std::any_of(places.begin(), places.end(), [](Place p) { return p.copy > in_no_place; }))
    return false;
  std::atomic<bool> is_good = true;
  workers.each(maps.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end && is_good; ++c) {
      if (places[c].copy == in_no_place) continue;
      ChartMap& map = maps[c];
      const std::span<char> values = bytes_of(map.values);
      const std::uint64_t at = offset(c, places[c].copy);
      if (!common::read_at(file.number(), at, values) ||
          !common::read_at(file.number(), at + values.size(), bytes_of(map.weights)) || checksum(map) != places[c].sum)
        is_good = false;
    }
  });
  if (is_good) places_ = std::move(places);
  return is_good;
}

}  // namespace glark::maps
