// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/sample/grid/census.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <mutex>

#include "glark/clients/stream/format/layout.h"

namespace glark::stream {
namespace {

constexpr std::uint64_t batch = 1 << 20;
constexpr std::size_t probes = 64, points_a_probe = 64;
constexpr std::size_t least_of_thread = 512;  // cubes

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

// What all threads have counted.
class SharedCounts {
 public:
  SharedCounts(const Census& begun, std::size_t most_cubes) : all_(begun), cubes_(most_cubes) {
    cubes_.coarsen_to(begun.level);
    for (const Cube& cube : begun.cubes) cubes_.add(cube);
    all_.cubes = {};
  }
  unsigned level() const { return cubes_.level(); }
  void add(const CubeTable& table) {
    table.each([&](const Cube& cube) { cubes_.add(cube); });
  }
  void add_others(std::uint64_t left_out, const std::array<double, 3>& low, const std::array<double, 3>& high) {
    all_.left_out += left_out;
    for (std::size_t k = 0; k < 3; ++k) {
      all_.low[k] = std::min(all_.low[k], low[k]);
      all_.high[k] = std::max(all_.high[k], high[k]);
    }
  }
  Census census(std::uint64_t points) const {
    Census census = all_;
    census.points = points;
    census.level = cubes_.level();
    census.cubes = cubes_.sorted();
    return census;
  }

 private:
  Census all_;
  BoundedCubes cubes_;
};

// Counts of one thread. They go to the shared ones when there are many.
class Counts {
 public:
  Counts(SharedCounts& shared, std::mutex& mutex, std::size_t most_cubes)
      : shared_(shared), mutex_(mutex), most_cubes_(most_cubes) {
    reset_box();
  }

  void add(const Points& points, const Lattice& lattice, const std::string& file) {
    Cube* cube = nullptr;  // most points are in the cube of the point before
    std::array<std::uint32_t, 3> place{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double* position = &points.positions[3 * i];
      if (!is_within_floats(position)) {
        if (is_finite(position)) fail_beyond_floats(file, points.first + i, position);
        ++left_out_;
        continue;
      }
      const std::array<std::uint32_t, 3> here = lattice.cube(position);
      if (cube == nullptr || here != place) {
        if (table_.size() >= most_cubes_) share();
        cube = &table_.at(key_at_level(Lattice::key(here), level_));
      }
      place = here;
      ++cube->count;
      cube->first = std::min(cube->first, points.first + i);
      cube->last = std::max(cube->last, points.first + i);
      for (std::size_t k = 0; k < 3; ++k) {
        low_[k] = std::min(low_[k], position[k]);
        high_[k] = std::max(high_[k], position[k]);
      }
    }
  }
  void share() {
    const std::lock_guard lock(mutex_);
    shared_.add(table_);
    shared_.add_others(left_out_, low_, high_);
    level_ = shared_.level();
    table_.clear();
    left_out_ = 0;
    reset_box();
  }

 private:
  void reset_box() {
    low_.fill(std::numeric_limits<double>::infinity());
    high_.fill(-std::numeric_limits<double>::infinity());
  }

  SharedCounts& shared_;
  std::mutex& mutex_;
  std::size_t most_cubes_;
  CubeTable table_;
  unsigned level_ = 0;
  std::uint64_t left_out_ = 0;
  std::array<double, 3> low_{}, high_{};
};

void save(const Census& census, common::StateWriter& state) {
  state.put(census.lattice);
  state.put(census.level);
  state.put(census.points);
  state.put(census.left_out);
  state.put(census.low);
  state.put(census.high);
  state.put_all(std::span<const Cube>(census.cubes));
}

bool load(common::StateReader& state, Census& census) {
  return state.get(census.lattice) && state.get(census.level) && state.get(census.points) &&
         state.get(census.left_out) && state.get(census.low) && state.get(census.high) && state.get_all(census.cubes);
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

double Census::dimension() const {
  std::size_t larger = 0;
  std::uint64_t before = Cube::no_key;
  for (const Cube& cube : cubes) {
    const std::uint64_t key = key_at_level(cube.key, level + 1);
    if (key != before) ++larger;
    before = key;
  }
  return std::log2(static_cast<double>(cubes.size()) / static_cast<double>(larger));
}

Census take_census(BlockSource& source, const CensusOptions& options, const Advance& advance,
                   common::Checkpoints& checkpoints) {
  constexpr const char* name = "census";
  Census begun;
  begun.lattice = options.lattice;
  begun.low.fill(std::numeric_limits<double>::infinity());
  begun.high.fill(-std::numeric_limits<double>::infinity());
  if (Census saved = begun;
      checkpoints.folder().load(name, [&](common::StateReader& state) { return load(state, saved); }))
    begun = std::move(saved);
  checkpoints.begin(begun.points);
  const std::uint64_t begin = begun.points;
  SharedCounts shared(begun, options.most_cubes);
  begun.cubes = {};
  std::mutex mutex;
  const std::size_t threads = std::bit_ceil(std::max<std::size_t>(2, options.threads));
  const std::size_t most_of_thread = std::max(least_of_thread, options.most_cubes / threads);
  tbb::enumerable_thread_specific<Counts> counts([&] { return Counts(shared, mutex, most_of_thread); });
  std::uint64_t done = begin;
  const auto counted = [&] {
    for (Counts& some : counts) some.share();
    return shared.census(done);
  };
  const auto count = [&](const Points& points) { counts.local().add(points, options.lattice, source.name()); };
  for (std::uint64_t read = 1; read > 0;) {
    const std::uint64_t first = options.begin + done;
    read = source.each(first, std::min(options.end, first + batch), count);
    done += read;
    if (advance) advance(done);
    if (checkpoints.is_due(done))
      checkpoints.folder().save(name, [&](common::StateWriter& state) { save(counted(), state); });
  }
  if (done > begin) checkpoints.folder().save(name, [&](common::StateWriter& state) { save(counted(), state); });
  return counted();
}

}  // namespace glark::stream
