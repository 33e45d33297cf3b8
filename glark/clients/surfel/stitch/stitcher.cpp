// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/stitch/stitcher.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "glark/clients/surfel/level/slot_array.h"
#include "glark/clients/surfel/stitch/agreement.h"
#include "glark/clients/surfel/stitch/conflict_region.h"
#include "glark/clients/surfel/stitch/triangle_cost.h"

namespace glark::surfel {
namespace {

constexpr std::size_t regions_a_batch = 16;

void sort_unique(std::vector<std::uint32_t>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

class Stitcher {
 public:
  Stitcher(Level& level, const LevelOptions& options) : level_(level), options_(options) {}

  std::vector<std::uint32_t> run(std::span<const std::uint32_t> leaves, const common::Workers& workers);

 private:
  // A triangle on which not all leaves agree.
  struct Conflict {
    Corners corners;
    bool reversed, may_be_drawn;
    std::uint8_t votes;    // the number of leaves that have the triangle
    std::uint32_t region;  // an index in regions_
  };
  struct AgreedTriangle {
    std::uint32_t region;  // an index in regions_
    Triangle triangle;
  };
  struct Extent {
    std::size_t first = 0, count = 0;
  };
  // The region's ranges of points_, conflicts_ and agreed_.
  struct Region {
    Extent points, conflicts, agreed;
  };

  void dissolve_regions();
  void collect_conflicts();
  std::uint32_t root_of(std::uint32_t point);
  void join_points();
  void number_regions();
  std::uint32_t region_at(std::uint32_t lowest_point) const;
  template <typename Item>
  void sort_by_region(std::vector<Item>& items, Extent Region::*part);
  void sort_conflicts();
  void collect_agreed(const common::Workers& workers);
  void collect_agreed_of(std::uint32_t leaf, std::vector<AgreedTriangle>& found) const;
  void stitch_region(ConflictRegion& region, const Region& parts, std::vector<ConflictingTriangle>& conflicting);
  void distribute(const std::vector<std::vector<StitchedTriangle>>& batches);

  Level& level_;
  const LevelOptions& options_;
  std::vector<std::uint32_t> leaves_;
  std::vector<Conflict> conflicts_;
  std::vector<AgreedTriangle> agreed_;
  std::vector<std::uint32_t> points_;                  // the points of all regions
  std::unique_ptr<std::uint32_t[]> number_in_region_;  // set only for the points of regions
  std::vector<std::uint32_t> lowest_points_;           // the lowest point of each region, ascending
  std::vector<Region> regions_;
};

std::vector<std::uint32_t> Stitcher::run(std::span<const std::uint32_t> leaves, const common::Workers& workers) {
  leaves_.assign(leaves.begin(), leaves.end());
  dissolve_regions();
  collect_conflicts();
  join_points();
  number_regions();
  sort_conflicts();
  collect_agreed(workers);
  std::vector<std::vector<StitchedTriangle>> batches((regions_.size() + regions_a_batch - 1) / regions_a_batch);
  workers.in_pieces(regions_.size(), regions_a_batch, [&](std::size_t begin, std::size_t end) {
    ConflictRegion region(level_, number_in_region_.get(), options_);
    std::vector<ConflictingTriangle> conflicting;
    for (std::size_t i = begin; i < end; ++i) {
      stitch_region(region, regions_[i], conflicting);
      for (const Triangle& triangle : region.drawn()) {
        batches[begin / regions_a_batch].push_back({triangle, lowest_points_[i]});
      }
    }
  });
  distribute(batches);
  return leaves_;
}

// Dissolves the regions that have a point of these leaves or of their conflicts, because they are stitched again. Adds
// all leaves of these regions.
void Stitcher::dissolve_regions() {
  sort_unique(leaves_);
  if (level_.next_in_region.empty()) return;
  std::vector<std::uint32_t> dissolved;
  const auto add_region_of = [&](std::uint32_t point) {
    if (level_.region_of[point] != none) dissolved.push_back(level_.region_of[point]);
  };
  for (const std::uint32_t leaf : leaves_) {
    for (const Surfel& surfel : level_.tree.unique_surfels(level_.tree.leaves[leaf])) add_region_of(surfel.index);
    for (const Candidate& candidate : level_.candidates_of(leaf)) {
      if (candidate.state == CandidateState::agreed) continue;
      std::for_each(candidate.corners.begin(), candidate.corners.end(), add_region_of);
    }
    for (const StitchedTriangle& stitched : level_.patches[leaf].stitched) dissolved.push_back(stitched.region);
  }
  sort_unique(dissolved);
  for (const std::uint32_t region : dissolved) {
    if (level_.region_of[region] != region) continue;
    std::uint32_t point = region;
    do {
      level_.region_of[point] = none;
      leaves_.push_back(level_.owner[point]);
      point = level_.next_in_region[point];
    } while (point != region);
  }
  sort_unique(leaves_);
  for (const std::uint32_t leaf : leaves_) {
    std::erase_if(level_.patches[leaf].stitched, [&](const StitchedTriangle& stitched) {
      return std::binary_search(dissolved.begin(), dissolved.end(), stitched.region);
    });
  }
}

// Collects the conflicts of these leaves, except those in remaining regions.
void Stitcher::collect_conflicts() {
  for (const std::uint32_t leaf : leaves_) {
    for (const Candidate& candidate : level_.candidates_of(leaf)) {
      if (candidate.state == CandidateState::agreed || level_.region_of[candidate.corners[0]] != none) continue;
      const bool may_be_drawn = candidate.state == CandidateState::conflicting;
      conflicts_.push_back({candidate.corners, candidate.reversed, may_be_drawn, 1, none});
    }
  }
  std::sort(conflicts_.begin(), conflicts_.end(),
            [](const Conflict& a, const Conflict& b) { return is_before(a.corners, b.corners); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < conflicts_.size(); ++i) {
    if (kept > 0 && conflicts_[kept - 1].corners == conflicts_[i].corners) {
      ++conflicts_[kept - 1].votes;
    } else {
      conflicts_[kept++] = conflicts_[i];
    }
  }
  conflicts_.resize(kept);
}

// Union-find in Level::region_of. The array leads from each point to a lower one, up to the lowest point of the region.
std::uint32_t Stitcher::root_of(std::uint32_t point) {
  std::vector<std::uint32_t>& parent = level_.region_of;
  while (parent[point] != point) point = parent[point] = parent[parent[point]];
  return point;
}

// Joins the corners of each conflict to one region.
void Stitcher::join_points() {
  for (const Conflict& conflict : conflicts_) {
    std::uint32_t root = none;
    for (const std::uint32_t corner : conflict.corners) {
      if (level_.region_of[corner] == none) {
        level_.region_of[corner] = corner;
        points_.push_back(corner);
      }
      const std::uint32_t other = root_of(corner);
      const std::uint32_t low = std::min(root, other), high = std::max(root, other);
      if (high != none) level_.region_of[high] = low;
      root = low;
    }
  }
}

// Sorts points by region and number, and links the points of each region to a ring.
void Stitcher::number_regions() {
  std::vector<std::uint64_t> order;
  order.reserve(points_.size());
  for (const std::uint32_t point : points_) {
    level_.region_of[point] = root_of(point);
    order.push_back(std::uint64_t{level_.region_of[point]} << 32 | point);
  }
  std::sort(order.begin(), order.end());
  if (!order.empty()) {
    level_.next_in_region.resize(level_.region_of.size());
    number_in_region_ = std::make_unique_for_overwrite<std::uint32_t[]>(level_.region_of.size());
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto region = static_cast<std::uint32_t>(order[i] >> 32);
    points_[i] = static_cast<std::uint32_t>(order[i]);
    if (points_[i] == region) {
      regions_.push_back({{i, 0}, {}, {}});
      lowest_points_.push_back(region);
    } else {
      level_.next_in_region[points_[i - 1]] = points_[i];
    }
    level_.next_in_region[points_[i]] = region;
    number_in_region_[points_[i]] = static_cast<std::uint32_t>(regions_.back().points.count++);
  }
}

// Returns the index in regions_, or `none` for regions that were not dissolved.
std::uint32_t Stitcher::region_at(std::uint32_t lowest_point) const {
  const auto found = std::lower_bound(lowest_points_.begin(), lowest_points_.end(), lowest_point);
  if (found == lowest_points_.end() || *found != lowest_point) return none;
  return static_cast<std::uint32_t>(found - lowest_points_.begin());
}

// Sorts by counting. Fills in `part` of each region.
template <typename Item>
void Stitcher::sort_by_region(std::vector<Item>& items, Extent Region::*part) {
  for (const Item& item : items) ++(regions_[item.region].*part).count;
  std::vector<std::size_t> next;
  std::size_t first = 0;
  for (Region& region : regions_) {
    (region.*part).first = first;
    next.push_back(first);
    first += (region.*part).count;
  }
  std::vector<Item> sorted(items.size());
  for (const Item& item : items) sorted[next[item.region]++] = item;
  items = std::move(sorted);
}

void Stitcher::sort_conflicts() {
  for (Conflict& conflict : conflicts_) conflict.region = region_at(level_.region_of[conflict.corners[0]]);
  sort_by_region(conflicts_, &Region::conflicts);
}

// Collects the agreed triangles that have a point of a region.
void Stitcher::collect_agreed(const common::Workers& workers) {
  std::vector<std::uint32_t> owners;
  for (const std::uint32_t point : points_) owners.push_back(level_.owner[point]);
  sort_unique(owners);
  std::vector<std::vector<AgreedTriangle>> batches((owners.size() + leaves_a_batch - 1) / leaves_a_batch);
  workers.in_pieces(owners.size(), leaves_a_batch, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) collect_agreed_of(owners[i], batches[begin / leaves_a_batch]);
  });
  for (const std::vector<AgreedTriangle>& batch : batches) agreed_.insert(agreed_.end(), batch.begin(), batch.end());
  sort_by_region(agreed_, &Region::agreed);
}

// An agreed triangle is a candidate of every leaf that owns one of its corners. A region must get the triangle only
// once: from the leaf that owns its first corner in this region.
void Stitcher::collect_agreed_of(std::uint32_t leaf, std::vector<AgreedTriangle>& found) const {
  for (const Candidate& candidate : level_.candidates_of(leaf)) {
    if (candidate.state != CandidateState::agreed) continue;
    const auto [a, b, c] = candidate.corners;
    const std::array<std::uint32_t, 3> regions = {level_.region_of[a], level_.region_of[b], level_.region_of[c]};
    if ((regions[0] & regions[1] & regions[2]) == none) continue;  // `none` has all bits: no corner is in a region
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_repeated = (k > 0 && regions[k] == regions[0]) || (k > 1 && regions[k] == regions[1]);
      if (regions[k] == none || is_repeated || level_.owner[candidate.corners[k]] != leaf) continue;
      const std::uint32_t region = region_at(regions[k]);
      if (region != none) found.push_back({region, triangle_of(candidate)});
    }
  }
}

void Stitcher::stitch_region(ConflictRegion& region, const Region& parts,
                             std::vector<ConflictingTriangle>& conflicting) {
  region.begin(std::span(points_).subspan(parts.points.first, parts.points.count));
  const auto agreed = std::span(agreed_).subspan(parts.agreed.first, parts.agreed.count);
  std::sort(agreed.begin(), agreed.end(),
            [](const AgreedTriangle& a, const AgreedTriangle& b) { return is_before(a.triangle, b.triangle); });
  for (const AgreedTriangle& one : agreed) region.add_agreed(one.triangle);
  conflicting.clear();
  for (const Conflict& conflict : std::span(conflicts_).subspan(parts.conflicts.first, parts.conflicts.count)) {
    if (!conflict.may_be_drawn) continue;
    const auto [a, b, c] = conflict.corners;
    const Triangle triangle = conflict.reversed ? Triangle{a, c, b} : Triangle{a, b, c};
    const std::uint32_t p = level_.owner[a], q = level_.owner[b], r = level_.owner[c];
    const std::uint32_t owners = 1 + (q != p ? 1 : 0) + (r != p && r != q ? 1 : 0);
    const std::uint32_t missing = owners - std::min<std::uint32_t>(owners, conflict.votes);
    conflicting.push_back({triangle, missing, triangle_cost(level_, triangle)});
  }
  region.stitch(conflicting);
}

void Stitcher::distribute(const std::vector<std::vector<StitchedTriangle>>& batches) {
  for (const std::vector<StitchedTriangle>& batch : batches) {
    for (const StitchedTriangle& stitched : batch) {
      level_.patches[drawing_leaf(level_, stitched.triangle)].stitched.push_back(stitched);
    }
  }
}

}  // namespace

std::vector<std::uint32_t> stitch(Level& level, std::span<const std::uint32_t> leaves, const LevelOptions& options,
                                  const common::Workers& workers) {
  return Stitcher(level, options).run(leaves, workers);
}

}  // namespace glark::surfel
