// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/grid/census.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "glark/clients/stream/format/layout.h"

namespace glark::stream {
namespace {

constexpr std::uint64_t batch = 1 << 20;
constexpr std::size_t probes = 64, points_a_probe = 64;

bool is_finite(const double* position) {
  return std::isfinite(position[0]) && std::isfinite(position[1]) && std::isfinite(position[2]);
}

bool is_within_floats(const double* position) {
  bool within = true;
  for (std::size_t k = 0; k < 3; ++k) within &= std::abs(position[k]) <= largest_coordinate;
  return within;
}

[[noreturn]] void fail_beyond_floats(const std::string& file, std::uint64_t point, const double* position) {
  std::size_t k = 0;
  while (std::abs(position[k]) <= largest_coordinate) ++k;
  throw Error(Element::point, point,
              fmt::format("{}: point {} has the coordinate {}; finite ones up to 1e18 are possible: remove the point",
                          file, point, position[k]));
}

// Counts of one thread.
struct Counts {
  CubeTable table;
  std::uint64_t left_out = 0;
  std::array<double, 3> low, high;
  Counts() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
  }

  void add(const Points& points, const Lattice& lattice, const std::string& file) {
    Cube* cube = nullptr;  // most points are in the cube of the point before
    std::array<std::uint32_t, 3> place{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double* position = &points.positions[3 * i];
      if (!is_within_floats(position)) {
        if (is_finite(position)) fail_beyond_floats(file, points.first + i, position);
        ++left_out;
        continue;
      }
      const std::array<std::uint32_t, 3> here = lattice.cube(position);
      if (cube == nullptr || here != place) cube = &table.at(Lattice::key(here));
      place = here;
      ++cube->count;
      cube->first = std::min(cube->first, points.first + i);
      cube->last = std::max(cube->last, points.first + i);
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], position[k]);
        high[k] = std::max(high[k], position[k]);
      }
    }
  }
};

// What was counted before, and by all threads.
Census sum_of(const Census& before, const tbb::enumerable_thread_specific<Counts>& counts, std::uint64_t points) {
  CubeTable table;
  const auto add = [&](const Cube& cube) {
    Cube& sum = table.at(cube.key);
    sum.count += cube.count;
    sum.first = std::min(sum.first, cube.first);
    sum.last = std::max(sum.last, cube.last);
  };
  Census all = before;
  all.points = points;
  for (const Cube& cube : before.cubes) add(cube);
  for (const Counts& some : counts) {
    for (const Cube& cube : some.table.sorted()) add(cube);
    all.left_out += some.left_out;
    for (std::size_t k = 0; k < 3; ++k) {
      all.low[k] = std::min(all.low[k], some.low[k]);
      all.high[k] = std::max(all.high[k], some.high[k]);
    }
  }
  all.cubes = table.sorted();
  return all;
}

void save(const Census& census, StateWriter& state) {
  state.put(census.lattice);
  state.put(census.points);
  state.put(census.left_out);
  state.put(census.low);
  state.put(census.high);
  state.put_all(std::span<const Cube>(census.cubes));
}

bool load(StateReader& state, Census& census) {
  return state.get(census.lattice) && state.get(census.points) && state.get(census.left_out) && state.get(census.low) &&
         state.get(census.high) && state.get_all(census.cubes);
}

// Positions from all over the source; from its beginning if it cannot seek.
std::array<std::vector<double>, 3> some_positions(const Source& source, const ReadOptions& options) {
  ReadOptions positions_only = options;
  positions_only.normals = positions_only.channels = false;
  positions_only.keep_invalid = true;  // the census finds them
  const std::unique_ptr<PointReader> reader = source.open(positions_only);
  std::array<std::vector<double>, 3> found;
  const std::uint64_t count = reader->count().value_or(0);
  for (std::size_t probe = 0; probe < probes; ++probe) {
    if (reader->can_seek()) reader->seek(count * probe / probes);
    const Points points = reader->read(points_a_probe);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (is_finite(&points.positions[3 * i]))
        for (std::size_t k = 0; k < 3; ++k) found[k].push_back(points.positions[3 * i + k]);
  }
  return found;
}

}  // namespace

Cube& CubeTable::at(std::uint64_t key) {
  if (2 * used_ >= slots_.size()) grow();
  std::size_t i = place(key, slots_.size());
  while (slots_[i].key != key && slots_[i].key != Cube::no_key) i = (i + 1) & (slots_.size() - 1);
  if (slots_[i].key == Cube::no_key) {
    slots_[i].key = key;
    ++used_;
  }
  return slots_[i];
}

const Cube* CubeTable::find(std::uint64_t key) const {
  std::size_t i = place(key, slots_.size());
  while (slots_[i].key != key && slots_[i].key != Cube::no_key) i = (i + 1) & (slots_.size() - 1);
  return slots_[i].key == key ? &slots_[i] : nullptr;
}

void CubeTable::grow() {
  std::vector<Cube> old(2 * slots_.size());
  old.swap(slots_);
  for (const Cube& cube : old) {
    if (cube.key == Cube::no_key) continue;
    std::size_t i = place(cube.key, slots_.size());
    while (slots_[i].key != Cube::no_key) i = (i + 1) & (slots_.size() - 1);
    slots_[i] = cube;
  }
}

std::vector<Cube> CubeTable::sorted() const {
  std::vector<Cube> cubes;
  cubes.reserve(used_);
  for (const Cube& cube : slots_)
    if (cube.key != Cube::no_key) cubes.push_back(cube);
  std::sort(cubes.begin(), cubes.end(), [](const Cube& a, const Cube& b) { return a.key < b.key; });
  return cubes;
}

// The box holds all but a hundredth of the points at each end, and a fifth more.
Lattice choose_lattice(const Source& source, const ReadOptions& options, unsigned levels) {
  std::array<std::vector<double>, 3> found = some_positions(source, options);
  Lattice lattice;
  if (found[0].empty()) return lattice;
  double side = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<double>& values = found[k];
    std::sort(values.begin(), values.end());
    const double low = values[values.size() / 100], high = values[values.size() - 1 - values.size() / 100];
    lattice.anchor[k] = (low + high) / 2;
    side = std::max(side, 1.2 * (high - low));
  }
  if (!(side > 0))
    side = std::max({1.0, std::abs(lattice.anchor[0]), std::abs(lattice.anchor[1]), std::abs(lattice.anchor[2])});
  lattice.side = std::ldexp(side, -static_cast<int>(levels));
  lattice.cubes_a_unit = 1 / lattice.side;
  return lattice;
}

Census take_census(BlockSource& source, const Lattice& lattice, const Advance& advance, Checkpoints& checkpoints) {
  constexpr const char* name = "census";
  Census begun;
  begun.lattice = lattice;
  begun.low.fill(std::numeric_limits<double>::infinity());
  begun.high.fill(-std::numeric_limits<double>::infinity());
  if (Census saved = begun; checkpoints.folder().load(name, [&](StateReader& state) { return load(state, saved); }))
    begun = std::move(saved);
  checkpoints.begin(begun.points);
  tbb::enumerable_thread_specific<Counts> counts;
  std::uint64_t done = begun.points;
  const auto save_state = [&] {
    checkpoints.folder().save(name, [&](StateWriter& state) { save(sum_of(begun, counts, done), state); });
  };
  const auto count = [&](const Points& points) { counts.local().add(points, lattice, source.name()); };
  for (std::uint64_t read = 1; read > 0;) {
    read = source.each(done, done + batch, count);
    done += read;
    if (advance) advance(done);
    if (checkpoints.is_due(done)) save_state();
  }
  if (done > begun.points) save_state();
  return sum_of(begun, counts, done);
}

}  // namespace glark::stream
