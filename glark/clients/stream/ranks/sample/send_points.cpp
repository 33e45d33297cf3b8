// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/stream/ranks/sample/send_points.h"

#include <algorithm>
#include <numeric>

#include "glark/clients/stream/ranks/deliver.h"
#include "glark/clients/stream/sample/pass/local_points.h"
#include "glark/clients/stream/sample/pass/open_memory.h"

namespace glark::stream {
namespace {

constexpr std::size_t least_of_round = 1 << 15;  // points
constexpr std::size_t bytes_a_point = 128;       // in the arrays of a round

std::uint32_t cell_of(const StreamedPoint& point) { return point.point.cell; }
std::uint32_t cell_of(const ShuffledPoint& point) { return point.cell; }

// Reads points of this rank's range, and sorts them by owners and cells.
template <class Sent>
class Round {
 public:
  using Make = std::function<Sent(const CellFinder& finder, std::uint32_t cell, const Points& points, std::size_t i)>;

  Round(const SendInput& input, std::size_t ranks, const Make& make)
      : input_(input),
        make_(make),
        size_(std::max(least_of_round, input.plan.open_bytes / bytes_a_point)),
        order_(input.plan.cells.size()),
        ends_(ranks) {
    std::vector<std::uint32_t> cells(order_.size());
    std::iota(cells.begin(), cells.end(), 0U);
    const std::vector<std::uint32_t>& owners = input.shares.owners;
    std::stable_sort(cells.begin(), cells.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return owners[a] < owners[b]; });
    for (std::uint32_t i = 0; i < cells.size(); ++i) order_[cells[i]] = i;
  }

  std::uint64_t count_of(std::uint64_t points) const { return (points + size_ - 1) / size_; }

  void read(std::uint64_t round) {
    const RankRange& range = input_.shares.range;
    const std::uint64_t begin = std::min(range.end, range.begin + round * size_);
    const std::uint64_t end = std::min(range.end, begin + size_);
    read_.resize(static_cast<std::size_t>(end - begin));
    input_.source.each(begin, end, [&](const Points& points) { locate(points, begin); });
    sort();
    if (input_.progress && end > range.begin)
      input_.progress(static_cast<double>(end - range.begin) / static_cast<double>(range.end - range.begin));
  }

  std::vector<std::span<const char>> to_each() const {
    std::vector<std::span<const char>> parts;
    std::size_t begin = 0;
    for (const std::size_t end : ends_) {
      parts.push_back(bytes_of(std::span(sorted_).subspan(begin, end - begin)));
      begin = end;
    }
    return parts;
  }

 private:
  void locate(const Points& points, std::uint64_t begin) {
    CellFinder finder(input_.plan, input_.source.name());
    for (std::size_t i = 0; i < points.size(); ++i) {
      Sent& point = read_[static_cast<std::size_t>(points.first + i - begin)];
      const std::uint32_t cell = finder.find(&points.positions[3 * i]);
      point = make_(finder, cell, points, i);
    }
  }

  void sort() {
    keys_.clear();
    for (std::uint32_t i = 0; i < read_.size(); ++i)
      if (const std::uint32_t cell = cell_of(read_[i]); cell != no_cell)
        keys_.push_back(std::uint64_t{order_[cell]} << 32 | i);
    std::sort(keys_.begin(), keys_.end());
    sorted_.resize(keys_.size());
    std::fill(ends_.begin(), ends_.end(), 0);
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      sorted_[i] = read_[static_cast<std::uint32_t>(keys_[i])];
      ++ends_[input_.shares.owners[cell_of(sorted_[i])]];
    }
    std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
  }

  const SendInput& input_;
  const Make make_;
  std::size_t size_;
  std::vector<std::uint32_t> order_;  // the place of each cell: by owner, then by index
  std::vector<Sent> read_, sorted_;
  std::vector<std::uint64_t> keys_;  // the place of the cell, then the point
  std::vector<std::size_t> ends_;    // of each owner's points in sorted_
};

template <class Sent>
void send(Ranks& ranks, const SendInput& input, CellFile& file, const typename Round<Sent>::Make& make) {
  std::unique_ptr<Round<Sent>> round;
  together(ranks, [&] {
    file.begin(input.folder, sizeof(Sent));
    round = std::make_unique<Round<Sent>>(input, ranks.size(), make);
  });
  const RankRange& range = input.shares.range;
  const std::uint64_t rounds = greatest(ranks, round->count_of(range.end - range.begin));
  std::string problem;
  for (std::uint64_t i = 0; i < rounds; ++i) {
    if (problem.empty()) problem = problem_of([&] { round->read(i); });
    require_no_problem(ranks, problem);
    problem = deliver(ranks, round->to_each(), [&](std::size_t from, std::span<const char> records) {
      file.put(from, records, input.source.name());
    });
  }
  if (problem.empty()) problem = problem_of([&] { file.require_complete(input.source.name()); });
  require_no_problem(ranks, problem);
}

}  // namespace

void send_streamed_points(Ranks& ranks, const SendInput& input, CellFile& file) {
  const PointKind kind(input.source.schema());
  const std::uint64_t batch = batch_size(input.plan);
  send<StreamedPoint>(ranks, input, file,
                      [&](const CellFinder& finder, std::uint32_t cell, const Points& points, std::size_t i) {
                        const auto number = static_cast<std::uint32_t>((points.first + i) / batch);
                        return StreamedPoint{local_point(finder, cell, kind, points, i), number};
                      });
}

void send_shuffled_points(Ranks& ranks, const SendInput& input, CellFile& file) {
  const PointKind kind(input.source.schema());
  send<ShuffledPoint>(
      ranks, input, file, [&](const CellFinder& finder, std::uint32_t cell, const Points& points, std::size_t i) {
        return ShuffledPoint{cell, cell == no_cell ? StoredPoint{} : stored_point(finder.centre(), kind, points, i)};
      });
}

}  // namespace glark::stream
