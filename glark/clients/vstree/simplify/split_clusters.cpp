// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/vstree/simplify/split_clusters.h"

#include <algorithm>
#include <numeric>
#include <queue>

namespace glark::vstree {
namespace {

// The points of a cluster follow one another in `order`.
struct Part {
  std::uint32_t begin = 0, end = 0;
  std::uint32_t cluster = 0;
  int axis = 0;      // on which the points extend most
  float middle = 0;  // of their range
  float extent = 0;

  // The largest comes first; the order must not depend on the queue.
  bool operator<(const Part& other) const {
    return extent != other.extent ? extent < other.extent : cluster > other.cluster;
  }
};

class Splitter {
 public:
  Splitter(const Surface& surface, Clusters& clusters) : surface_(surface), clusters_(clusters) {
    std::vector<std::uint32_t> ends(clusters.count);
    for (const std::uint32_t cluster : clusters.of) ++ends[cluster];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<std::uint32_t> next(clusters.count);
    for (std::uint32_t k = 1; k < clusters.count; ++k) next[k] = ends[k - 1];
    order_.resize(clusters.of.size());
    for (std::uint32_t i = 0; i < clusters.of.size(); ++i) order_[next[clusters.of[i]]++] = i;
    for (std::uint32_t k = 0; k < clusters.count; ++k) push(k == 0 ? 0 : ends[k - 1], ends[k], k);
  }

  void run(std::size_t wanted) {
    while (clusters_.count < wanted && !parts_.empty()) {
      const Part part = parts_.top();
      parts_.pop();
      const auto begin = order_.begin() + part.begin, end = order_.begin() + part.end;
      const auto upper = std::stable_partition(
          begin, end, [&](std::uint32_t i) { return surface_.point(i)[part.axis] < part.middle; });
      const auto at = static_cast<std::uint32_t>(upper - order_.begin());
      for (std::uint32_t i = at; i < part.end; ++i) clusters_.of[order_[i]] = clusters_.count;
      push(part.begin, at, part.cluster);
      push(at, part.end, clusters_.count++);
    }
  }

 private:
  // Adds a part, unless all its points have one position.
  void push(std::uint32_t begin, std::uint32_t end, std::uint32_t cluster) {
    Float4 low = surface_.point(order_[begin]), high = low;
    for (std::uint32_t i = begin + 1; i < end; ++i) {
      low = least(low, surface_.point(order_[i]));
      high = greatest(high, surface_.point(order_[i]));
    }
    Part part{begin, end, cluster};
    for (int k = 0; k < 3; ++k) {
      if (high[k] - low[k] <= part.extent) continue;
      part.extent = high[k] - low[k];
      part.axis = k;
      part.middle = low[k] + part.extent / 2;
      if (part.middle <= low[k]) part.middle = high[k];  // neighbouring numbers
    }
    if (part.extent > 0) parts_.push(part);
  }

  const Surface& surface_;
  Clusters& clusters_;
  std::vector<std::uint32_t> order_;
  std::priority_queue<Part> parts_;
};

}  // namespace

void split_largest(const Surface& surface, std::size_t wanted, Clusters& clusters) {
  Splitter(surface, clusters).run(wanted);
}

}  // namespace glark::vstree
