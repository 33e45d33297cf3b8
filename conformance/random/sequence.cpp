// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/random/sequence.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

namespace glark::conformance {
namespace {

constexpr std::size_t paths_in_a_sequence = 4;
constexpr std::size_t rows_in_a_sequence = 96;
constexpr std::size_t rows_in_a_round = 3;
constexpr std::size_t focus_rows_in_a_round = 2;  // of one family: some faults need several changes of related state
constexpr std::size_t draws_in_a_round = 2;

bool is_of(WorldKind kind, Where where) {
  if (where == Where::everywhere) return true;
  if (kind == WorldKind::fixed || kind == WorldKind::polygons)
    return where == Where::fixed || where == Where::within_begin;
  if (kind == WorldKind::uniforms) return where == Where::shader || where == Where::uniforms;
  return where == Where::shader || where == Where::stage;
}

// Vertices may leave the view, and be clipped.
bool moves_vertices(const Row& row) {
  return std::string_view(row.family) == "matrices" || std::string_view(row.family) == "clip planes" ||
         std::string_view(row.name) == "written places" || std::string_view(row.family) == "display lists";
}
bool moves_vertices(const RandomPath&) { return false; }

template <typename Entry>
std::vector<const Entry*> entries_of(const std::vector<Entry>& all, WorldKind kind, Offer offer) {
  std::vector<const Entry*> found;
  for (const Entry& each : all)
    if (is_of(kind, each.where) && !(kind == WorldKind::polygons && moves_vertices(each)) &&
        each.apis.contains(offer.api) && (offer.api == Api::gles || offer.version >= each.version))
      found.push_back(&each);
  return found;
}

template <typename Entry>
void shuffle(std::vector<Entry>& all, Values& values) {
  for (std::size_t i = all.size(); i > 1; --i) std::swap(all[i - 1], all[values.below(i)]);
}

// Which pairs of a row and a path have met.
class Coverage {
 public:
  Coverage(std::vector<const Row*> rows, std::size_t paths)
      : rows_(std::move(rows)), paths_(paths), met_(rows_.size() * paths) {}

  // The rows that have met the fewest of these paths, in a random order.
  std::vector<const Row*> choose(const std::vector<std::size_t>& paths, std::size_t count, Values& values) {
    std::vector<std::pair<std::size_t, std::size_t>> order;  // pairs that have met, row
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      std::size_t met = 0;
      for (const std::size_t path : paths) met += met_[row * paths_ + path];
      order.emplace_back(met, row);
    }
    shuffle(order, values);
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    order.resize(std::min(count, order.size()));
    shuffle(order, values);
    std::vector<const Row*> chosen;
    for (const auto& [met, row] : order) {
      for (const std::size_t path : paths) ++met_[row * paths_ + path];
      chosen.push_back(rows_[row]);
    }
    return chosen;
  }

 private:
  std::vector<const Row*> rows_;
  std::size_t paths_;
  std::vector<std::size_t> met_;
};

// The rows of the families in turn, from sequence to sequence.
std::vector<const Row*> focus_of(const std::vector<const Row*>& rows, std::size_t number) {
  std::vector<std::string_view> families;
  for (const Row* row : rows)
    if (std::find(families.begin(), families.end(), row->family) == families.end()) families.emplace_back(row->family);
  std::vector<const Row*> found;
  for (const Row* row : rows)
    if (row->family == families[number % families.size()]) found.push_back(row);
  return found;
}

// Some rows and some draws in turn. The last draws are by all paths.
RandomSequence sequence_of(WorldKind kind, const std::vector<const Row*>& rows, const std::vector<const Row*>& focus,
                           const std::vector<const RandomPath*>& paths, Values& values) {
  RandomSequence sequence{kind, {}};
  const auto draw = [&](const RandomPath* path) {
    sequence.steps.push_back({nullptr, path, values.seed(), values.pick({1, 1, 2, 3, 5})});
  };
  std::vector<std::uint32_t> seeds;  // few: only a draw that repeats shows what was kept of it
  for (std::size_t i = 0; i < paths.size(); ++i) seeds.push_back(values.seed());
  const auto draw_again = [&](std::size_t i) {
    draw(paths[i]);
    if (values.below(3) != 0) sequence.steps.back().seed = seeds[i];
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    sequence.steps.push_back({rows[i], nullptr, values.seed(), 1});
    if (i % rows_in_a_round != rows_in_a_round - 1) continue;
    for (std::size_t k = 0; k < focus_rows_in_a_round; ++k)
      sequence.steps.push_back({focus[values.below(focus.size())], nullptr, values.seed(), 1});
    for (std::size_t k = 0; k < draws_in_a_round; ++k) draw_again(values.below(paths.size()));
  }
  for (std::size_t i = 0; i < paths.size(); ++i) draw_again(i);
  return sequence;
}

}  // namespace

const Rows& all_rows() {
  static const Rows all = [] {
    Rows rows;
    for (const Rows& each :
         {array_rows(), client_array_rows(), current_value_rows(), uniform_rows(), program_rows(), raster_rows(),
          refinement_rows(), matrix_rows(), light_rows(), fixed_texture_rows(), list_rows()})
      rows.insert(rows.end(), each.begin(), each.end());
    return rows;
  }();
  return all;
}

const std::vector<RandomPath>& all_random_paths() {
  static const std::vector<RandomPath> all = [] {
    std::vector<RandomPath> paths = stage_paths();
    const std::vector<RandomPath> others = fixed_paths();
    paths.insert(paths.end(), others.begin(), others.end());
    return paths;
  }();
  return all;
}

std::vector<const Row*> rows_of(WorldKind kind, Offer offer) { return entries_of(all_rows(), kind, offer); }
std::vector<const RandomPath*> paths_of(WorldKind kind, Offer offer) {
  return entries_of(all_random_paths(), kind, offer);
}

std::size_t sequence_count(WorldKind kind) {
  return kind == WorldKind::fixed      ? 20
         : kind == WorldKind::curved   ? 4
         : kind == WorldKind::polygons ? 8
         : kind == WorldKind::uniforms ? 13
                                       : 10;
}

std::vector<RandomSequence> random_sequences(std::uint32_t seed, WorldKind kind, Offer offer) {
  Values values(seed + 977 * static_cast<std::uint32_t>(kind));
  const std::vector<const RandomPath*> paths = paths_of(kind, offer);
  const std::vector<const Row*> all = rows_of(kind, offer);
  Coverage coverage(all, paths.size());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < paths.size(); ++i) order.push_back(i);
  shuffle(order, values);
  std::vector<RandomSequence> sequences;
  for (std::size_t i = 0; i < sequence_count(kind); ++i) {
    std::vector<std::size_t> numbers;
    std::vector<const RandomPath*> chosen;
    for (std::size_t k = 0; k < std::min(paths_in_a_sequence, paths.size()); ++k) {
      numbers.push_back(order[(paths_in_a_sequence * i + k) % order.size()]);
      chosen.push_back(paths[numbers.back()]);
    }
    const std::vector<const Row*> rows = coverage.choose(numbers, rows_in_a_sequence, values);
    sequences.push_back(sequence_of(kind, rows, focus_of(all, i), chosen, values));
  }
  return sequences;
}

std::string text_of(const RandomSequence& sequence) {
  std::string text;
  for (const RandomStep& step : sequence.steps)
    text += step.row != nullptr
                ? fmt::format("{}{}", text.empty() ? "" : "\n", step.row->name)
                : fmt::format("{}draw: {}, {} times", text.empty() ? "" : "\n", step.path->name, step.times);
  return text;
}

}  // namespace glark::conformance
