// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/reconstruct/density/outliers.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "glark/clients/common/disjoint_sets.h"

namespace glark::reconstruct {
namespace {

constexpr std::size_t neighbours_each = 12;
constexpr int least_support = 3;         // neighbours that agree
constexpr std::size_t least_group = 12;  // samples
constexpr int least_planes = 2;          // planes of a surface on which an unsupported sample lies
constexpr float similar = 0.5F;          // the cosine of normals that agree
constexpr float slope = 0.35F;           // the height over a tangent plane, relative to the distance
constexpr float own_slope = 0.2F;        // the same, for the planes of one side only
constexpr float noises = 2.5F;           // heights that noise explains
constexpr float noisy_slope = 0.5F;      // the slope and noise together explain no more, relative to the distance
constexpr float isolation = 1.3F;        // the distance of the fourth neighbour, relative to that of its neighbours
// The variance of a sample and its neighbours along the direction in which they vary least, relative to the sum over
// all directions. Random samples seldom have less, although estimated normals agree among them.
constexpr float flat = 0.07F;
constexpr std::size_t grain = 256;

// Neighbours that are far away for this noise are not on one plane by chance: random samples would often be.
float most_height(float distance, float noise) {
  const float by_noise = noises * noise;
  return std::min(slope * distance + by_noise, std::max(noisy_slope * distance, by_noise));
}

// Whether each of two samples lies near the tangent plane of the other, and their normals are similar. apart: the way
// from one to the other.
bool agree(Float4 apart, Float4 normal, Float4 other, float noise) {
  if (!(dot(normal, other) > similar)) return false;
  const float most = most_height(std::sqrt(dot(apart, apart)), noise);
  return std::abs(dot(apart, normal)) < most && std::abs(dot(apart, other)) < most;
}

// What the neighbours of a sample say.
class Judge {
 public:
  Judge(const Neighbours& neighbours, float noise) : neighbours_(neighbours), noise_(noise) {}

  void look_at(std::uint32_t entry) {
    neighbours_.find(entry, neighbours_each, near_);
    point_ = neighbours_.point(entry);
    normal_ = neighbours_.normal(entry);
  }
  const std::vector<Neighbours::Near>& near() const { return near_; }
  float fourth() const { return near_.size() < 4 ? 4 : near_[3].square; }
  float sixth() const { return near_.size() < 6 ? 4 : near_[5].square; }
  bool agrees(const Neighbours::Near& other) const {
    return agree(neighbours_.point(other.entry) - point_, normal_, neighbours_.normal(other.entry), noise_);
  }
  bool is_on_plane_of(const Neighbours::Near& other) const {
    const Float4 apart = neighbours_.point(other.entry) - point_, normal = neighbours_.normal(other.entry);
    return dot(normal, normal_) > 0 &&
           std::abs(dot(apart, normal)) < own_slope * std::sqrt(other.square) + noises * noise_;
  }
  bool is_supported() const {
    return std::count_if(near_.begin(), near_.end(), [&](const Neighbours::Near& other) { return agrees(other); }) >=
           least_support;
  }
  // Returns whether the neighbours that face the same way lie near to a plane.
  bool is_flat() const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    Eigen::Matrix3f products = Eigen::Matrix3f::Zero();
    float count = 1;  // the sample itself, at 0
    for (const Neighbours::Near& other : near_) {
      if (!(dot(neighbours_.normal(other.entry), normal_) > 0)) continue;
      const Float4 apart = neighbours_.point(other.entry) - point_;
      const Eigen::Vector3f offset(apart[0], apart[1], apart[2]);
      sum += offset;
      products += offset * offset.transpose();
      ++count;
    }
    products -= sum * sum.transpose() / count;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
    solver.computeDirect(products, Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[0] < flat * products.trace();
  }

 private:
  const Neighbours& neighbours_;
  float noise_;
  std::vector<Neighbours::Near> near_;
  Float4 point_{}, normal_{};
};

class Search {
 public:
  Search(std::span<const std::uint32_t> suspects, const Neighbours& neighbours, float sparse, float noise,
         const Workers& workers)
      : suspects_(suspects),
        neighbours_(neighbours),
        sparse_(sparse),
        noise_(noise),
        workers_(workers),
        supported_(suspects.size()),
        fourth_(suspects.size()),
        groups_(suspects.size() + 1) {}

  std::vector<std::uint32_t> run() {
    each([&](std::size_t i, Judge& judge) {
      supported_[i] = judge.is_supported() && (judge.sixth() <= sparse_ || judge.is_flat()) ? 1 : 0;
      fourth_[i] = judge.fourth();
    });
    group();
    std::vector<std::uint8_t> outlying(suspects_.size());
    each([&](std::size_t i, Judge& judge) { outlying[i] = is_outlier(i, judge) ? 1 : 0; });
    std::vector<std::uint32_t> result;
    for (std::size_t i = 0; i < suspects_.size(); ++i) {
      if (outlying[i] != 0) result.push_back(suspects_[i]);
    }
    return result;
  }

 private:
  template <typename Body>
  void each(const Body& body) const {
    workers_.each(suspects_.size(), grain, [&](std::size_t begin, std::size_t end) {
      Judge judge(neighbours_, noise_);
      for (std::size_t i = begin; i < end; ++i) {
        judge.look_at(suspects_[i]);
        body(i, judge);
      }
    });
  }

  std::optional<std::size_t> suspect(std::uint32_t entry) const {
    const auto at = std::lower_bound(suspects_.begin(), suspects_.end(), entry);
    if (at == suspects_.end() || *at != entry) return std::nullopt;
    return static_cast<std::size_t>(at - suspects_.begin());
  }

  // Joins supported suspects that agree. The last set is that of all samples that are no suspects.
  void group() {
    Judge judge(neighbours_, noise_);
    const auto others = static_cast<std::uint32_t>(suspects_.size());
    for (std::uint32_t i = 0; i < suspects_.size(); ++i) {
      if (supported_[i] == 0) continue;
      judge.look_at(suspects_[i]);
      for (const Neighbours::Near& other : judge.near()) {
        const std::optional<std::size_t> which = suspect(other.entry);
        if (which && (supported_[*which] == 0 || groups_.find(i) == groups_.find(static_cast<std::uint32_t>(*which))))
          continue;
        if (judge.agrees(other)) groups_.join(i, which ? static_cast<std::uint32_t>(*which) : others);
      }
    }
    std::vector<std::size_t> sizes(suspects_.size() + 1);
    for (std::uint32_t i = 0; i < suspects_.size(); ++i) sizes[groups_.find(i)] += supported_[i];
    sizes[groups_.find(others)] = least_group;
    kept_.resize(suspects_.size());
    for (std::uint32_t i = 0; i < suspects_.size(); ++i)
      kept_[i] = supported_[i] != 0 && sizes[groups_.find(i)] >= least_group ? 1 : 0;
  }

  bool is_outlier(std::size_t i, const Judge& judge) const {
    if (kept_[i] != 0) return false;
    int planes = 0, count = 0;
    float sum = 0;
    for (const Neighbours::Near& other : judge.near()) {
      const std::optional<std::size_t> which = suspect(other.entry);
      if (which) {
        sum += std::sqrt(fourth_[*which]);
        ++count;
      }
      if ((!which || kept_[*which] != 0) && judge.is_on_plane_of(other)) ++planes;
    }
    if (planes >= least_planes) return false;
    const bool is_sparse = judge.sixth() > sparse_;
    return is_sparse || std::sqrt(judge.fourth()) * static_cast<float>(count) > isolation * sum;
  }

  std::span<const std::uint32_t> suspects_;
  const Neighbours& neighbours_;
  float sparse_, noise_;
  const Workers& workers_;
  std::vector<std::uint8_t> supported_, kept_;
  std::vector<float> fourth_;
  DisjointSets groups_;
};

}  // namespace

std::vector<std::uint32_t> suspects_of(const Neighbours& neighbours, float sparse, float noise,
                                       const Workers& workers) {
  constexpr std::uint32_t most_in_cell = 256;  // because all pairs are looked at
  constexpr std::uint8_t enough = 5;           // samples that agree
  std::vector<std::uint32_t> cells{0};         // the first entries of the cells above the finest ones
  const Level& level = neighbours.finest();
  for (std::size_t i = 1; i < level.keys.size(); ++i) {
    if (level.keys[i] >> 3 != level.keys[i - 1] >> 3) cells.push_back(level.begins[i]);
  }
  cells.push_back(static_cast<std::uint32_t>(neighbours.size()));
  std::vector<std::uint8_t> support(neighbours.size());
  workers.each(cells.size() - 1, grain, [&](std::size_t begin, std::size_t end) {
    std::vector<Record> records;
    for (std::size_t cell = begin; cell < end; ++cell) {
      const std::uint32_t first = cells[cell], count = cells[cell + 1] - first;
      if (count > most_in_cell) continue;
      records.clear();
      for (std::uint32_t i = first; i < first + count; ++i)
        records.push_back({neighbours.point(i), neighbours.normal(i)});
      for (std::uint32_t a = 0; a < count; ++a) {
        for (std::uint32_t b = a + 1; b < count; ++b) {
          const Float4 apart = records[b].point() - records[a].point();
          const float square = dot(apart, apart);
          if (!(square > 0) || square > sparse || !agree(apart, records[a].normal, records[b].normal, noise)) continue;
          if (support[first + a] < enough) ++support[first + a];
          if (support[first + b] < enough) ++support[first + b];
        }
      }
    }
  });
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < support.size(); ++i) {
    if (support[i] < enough) result.push_back(i);
  }
  return result;
}

std::vector<std::uint32_t> outliers_among(std::span<const std::uint32_t> suspects, const Neighbours& neighbours,
                                          float sparse, float noise, const Workers& workers) {
  return Search(suspects, neighbours, sparse, noise, workers).run();
}

Sampling look_at_some(const Neighbours& neighbours, float noise, const Workers& workers) {
  constexpr std::size_t most_tried = 4096, one_of = 64;
  const std::size_t count = std::min(most_tried, neighbours.size() / one_of);
  std::vector<float> squares(count);  // -1 without support
  workers.each(count, grain, [&](std::size_t begin, std::size_t end) {
    Judge judge(neighbours, noise);
    for (std::size_t i = begin; i < end; ++i) {
      judge.look_at(static_cast<std::uint32_t>(i * neighbours.size() / count));
      squares[i] = judge.is_supported() ? judge.sixth() : -1;
    }
  });
  std::erase(squares, -1.0F);
  if (squares.empty()) return {};
  const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  return {1 - static_cast<double>(squares.size()) / static_cast<double>(count), *middle};
}

}  // namespace glark::reconstruct
