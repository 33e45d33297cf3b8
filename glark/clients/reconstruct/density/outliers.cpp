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
constexpr float farthest = 3;  // a sample tells about places up to this many distances of its sixth neighbour away
constexpr std::ptrdiff_t least_reaching = 6;  // fewer neighbours that tell about a place are too few
// The greatest share of neighbours without support, where most sparse samples have none.
constexpr float most_unsupported = 0.7F;
// A sample that faces away from so many neighbours is an outlier, unless some of its many neighbours agree with it.
constexpr std::size_t least_surrounding = 9, many_neighbours = 48;
constexpr float common_normal = 0.55F;  // the least length of their mean normal: at the corner of a box, it is .58
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
  using Nears = std::span<const Neighbours::Near>;  // the nearest first

  Judge(const Neighbours& neighbours, float noise) : neighbours_(neighbours), noise_(noise) {}

  // near: outlives the use of this judge.
  void look_at(std::uint32_t entry, Nears near) {
    near_ = near;
    point_ = neighbours_.point(entry);
    normal_ = neighbours_.normal(entry);
  }
  Nears near() const { return near_; }
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
  Nears near_;
  Float4 point_{}, normal_{};
};

float square_of(std::span<const Neighbours::Near> near, std::size_t which) {
  return near.size() < which ? 4 : near[which - 1].square;
}

class Search {
 public:
  Search(std::span<const std::uint32_t> suspects, const Neighbours& neighbours, float sparse, float others, float noise,
         const Workers& workers)
      : suspects_(suspects),
        neighbours_(neighbours),
        sparse_(sparse),
        others_(others),
        noise_(noise),
        workers_(workers),
        near_(suspects.size() * neighbours_each),
        counts_(suspects.size()),
        fourth_(suspects.size()),
        sixth_(suspects.size()),
        isolated_(suspects.size()),
        supported_(suspects.size()),
        groups_(suspects.size() + 1) {}

  std::vector<std::uint32_t> run() {
    each([&](std::size_t i, std::vector<Neighbours::Near>& near) {
      neighbours_.find(suspects_[i], neighbours_each, near);
      keep(i, near);
      fourth_[i] = square_of(near, 4);
      sixth_[i] = square_of(near, 6);
    });
    each([&](std::size_t i, std::vector<Neighbours::Near>& near) {
      isolated_[i] = is_isolated(i) ? 1 : 0;
      look_farther(i, near);
      const Judge judge = judge_of(i);
      supported_[i] = judge.is_supported() && (sixth_[i] <= sparse_ || judge.is_flat()) ? 1 : 0;
    });
    drop_support_by_chance();
    group();
    std::vector<std::uint8_t> outlying(suspects_.size());
    each([&](std::size_t i, std::vector<Neighbours::Near>& near) {
      outlying[i] = kept_[i] == 0 && (isolated_[i] != 0 ? !is_beside_kept(i) : contradicts(i, near)) ? 1 : 0;
    });
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
      std::vector<Neighbours::Near> near;
      for (std::size_t i = begin; i < end; ++i) body(i, near);
    });
  }

  void keep(std::size_t i, std::span<const Neighbours::Near> near) {
    counts_[i] = static_cast<std::uint8_t>(std::min(near.size(), neighbours_each));
    std::copy_n(near.begin(), counts_[i], &near_[i * neighbours_each]);
  }
  Judge::Nears near_of(std::size_t i) const { return {&near_[i * neighbours_each], counts_[i]}; }
  Judge judge_of(std::size_t i) const {
    Judge judge(neighbours_, noise_);
    judge.look_at(suspects_[i], near_of(i));
    return judge;
  }

  std::optional<std::size_t> suspect(std::uint32_t entry) const {
    const auto at = std::lower_bound(suspects_.begin(), suspects_.end(), entry);
    if (at == suspects_.end() || *at != entry) return std::nullopt;
    return static_cast<std::size_t>(at - suspects_.begin());
  }

  bool is_isolated(std::size_t i) const {
    if (sixth_[i] > sparse_) return true;
    int count = 0;
    float sum = 0;
    for (const Neighbours::Near& other : near_of(i)) {
      const std::optional<std::size_t> which = suspect(other.entry);
      if (!which) continue;
      sum += std::sqrt(fourth_[*which]);
      ++count;
    }
    return std::sqrt(fourth_[i]) * static_cast<float>(count) > isolation * sum;
  }

  // Returns whether the distance of another sample is one that it has from its own neighbours. If not, a surface of
  // samples as dense as the other one would have more of them in between: it says nothing about this place.
  bool reaches(const Neighbours::Near& other) const {
    const std::optional<std::size_t> which = suspect(other.entry);
    return other.square < farthest * farthest * (which ? sixth_[*which] : others_);
  }

  // The nearest neighbours of an outlier beside the boundary of a surface are samples of the surface. The outlier may lie
  // on their planes by chance. So a sample far from them needs others that are as far apart as it is.
  void look_farther(std::size_t i, std::vector<Neighbours::Near>& near) {
    const Judge::Nears nearest = near_of(i);
    const auto can_reach = [&](const Neighbours::Near& other) { return reaches(other); };
    if (std::count_if(nearest.begin(), nearest.end(), can_reach) >= least_reaching) return;
    const std::size_t first = neighbours_.level_for(std::sqrt(square_of(nearest, 1)));
    counts_[i] = 0;
    for (std::size_t level = first; level < neighbours_.levels() && counts_[i] < neighbours_each; ++level) {
      neighbours_.find_one_a_cell(suspects_[i], level, near);
      std::erase_if(near, [&](const Neighbours::Near& other) { return !reaches(other); });
      if (near.size() > counts_[i]) keep(i, near);
    }
  }

  // Returns whether most of the neighbours of a sparse sample have no support. A few random samples may lie on a plane by
  // chance, but on a surface most samples have support.
  bool is_among_unsupported(std::size_t i) const {
    if (sixth_[i] <= sparse_) return false;
    const Judge::Nears near = near_of(i);
    const auto others = std::count_if(near.begin(), near.end(), [&](const Neighbours::Near& other) {
      const std::optional<std::size_t> which = suspect(other.entry);
      return which && supported_[*which] == 0;
    });
    return static_cast<float>(others) > most_unsupported * static_cast<float>(near.size());
  }

  // Takes support from sparse samples among outliers. This may leave their neighbours without support, too.
  void drop_support_by_chance() {
    std::size_t sparse = 0, unsupported = 0;
    for (std::size_t i = 0; i < suspects_.size(); ++i) {
      sparse += sixth_[i] > sparse_ ? 1 : 0;
      unsupported += sixth_[i] > sparse_ && supported_[i] == 0 ? 1 : 0;
    }
    std::vector<std::uint8_t> by_chance(suspects_.size());
    for (bool any = 2 * unsupported > sparse; any;) {
      each([&](std::size_t i, std::vector<Neighbours::Near>&) {
        by_chance[i] = supported_[i] != 0 && is_among_unsupported(i) ? 1 : 0;
      });
      any = false;
      for (std::size_t i = 0; i < suspects_.size(); ++i) {
        if (by_chance[i] == 0) continue;
        supported_[i] = 0;
        any = true;
      }
    }
  }

  // Joins supported suspects that agree. The last set is that of all samples that are no suspects.
  void group() {
    const auto others = static_cast<std::uint32_t>(suspects_.size());
    for (std::uint32_t i = 0; i < suspects_.size(); ++i) {
      if (supported_[i] == 0) continue;
      const Judge judge = judge_of(i);
      for (const Neighbours::Near& other : judge.near()) {
        const std::optional<std::size_t> which = suspect(other.entry);
        if (which && (supported_[*which] == 0 || groups_.find(i) == groups_.find(static_cast<std::uint32_t>(*which))))
          continue;
        if (reaches(other) && judge.agrees(other)) groups_.join(i, which ? static_cast<std::uint32_t>(*which) : others);
      }
    }
    std::vector<std::size_t> sizes(suspects_.size() + 1);
    for (std::uint32_t i = 0; i < suspects_.size(); ++i) sizes[groups_.find(i)] += supported_[i];
    sizes[groups_.find(others)] = least_group;
    kept_.resize(suspects_.size());
    for (std::uint32_t i = 0; i < suspects_.size(); ++i)
      kept_[i] = supported_[i] != 0 && sizes[groups_.find(i)] >= least_group ? 1 : 0;
  }

  // Returns whether the sample lies on planes of samples that are kept.
  bool is_beside_kept(std::size_t i) const {
    const Judge judge = judge_of(i);
    return std::count_if(judge.near().begin(), judge.near().end(), [&](const Neighbours::Near& other) {
             const std::optional<std::size_t> which = suspect(other.entry);
             return (!which || kept_[*which] != 0) && reaches(other) && judge.is_on_plane_of(other);
           }) >= least_planes;
  }

  // Returns whether the sample lies in a surface, but faces the opposite way. It would look like the back of a thin sheet.
  bool contradicts(std::size_t i, std::vector<Neighbours::Near>& near) const {
    Float4 normals{};
    std::size_t count = 0;
    for (const Neighbours::Near& other : near_of(i)) {
      const std::optional<std::size_t> which = suspect(other.entry);
      if (which && kept_[*which] == 0) continue;
      normals += neighbours_.normal(other.entry);
      ++count;
    }
    const auto least = common_normal * static_cast<float>(count);
    if (count < least_surrounding || dot(normals, normals) < least * least) return false;
    if (dot(neighbours_.normal(suspects_[i]), normals) > 0) return false;
    neighbours_.find(suspects_[i], many_neighbours, near);
    Judge judge(neighbours_, noise_);
    judge.look_at(suspects_[i], near);
    return !judge.is_supported();
  }

  std::span<const std::uint32_t> suspects_;
  const Neighbours& neighbours_;
  float sparse_, others_, noise_;
  const Workers& workers_;
  std::vector<Neighbours::Near> near_;  // [neighbours_each * suspects], of which the first counts_[i] are set
  std::vector<std::uint8_t> counts_;
  std::vector<float> fourth_, sixth_;  // squared distances of the fourth and sixth neighbour
  std::vector<std::uint8_t> isolated_, supported_, kept_;
  DisjointSets groups_;
};

}  // namespace

std::vector<std::uint32_t> suspects_of(const Neighbours& neighbours, float sparse, float noise,
                                       const Workers& workers) {
  constexpr std::uint32_t most_in_cell = 256;  // because all pairs are looked at
  constexpr std::uint8_t enough = 7;           // samples that agree
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
          if (!(square > 0) || square > support_share * sparse ||
              !agree(apart, records[a].normal, records[b].normal, noise))
            continue;
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
                                          float sparse, float others, float noise, const Workers& workers) {
  return Search(suspects, neighbours, sparse, others, noise, workers).run();
}

Sampling look_at_some(const Neighbours& neighbours, float noise, const Workers& workers) {
  constexpr std::size_t most_tried = 4096, one_of = 64;
  const std::size_t count = std::min(most_tried, neighbours.size() / one_of);
  std::vector<float> squares(count);  // -1 without support
  workers.each(count, grain, [&](std::size_t begin, std::size_t end) {
    Judge judge(neighbours, noise);
    std::vector<Neighbours::Near> near;
    for (std::size_t i = begin; i < end; ++i) {
      const auto entry = static_cast<std::uint32_t>(i * neighbours.size() / count);
      neighbours.find(entry, neighbours_each, near);
      judge.look_at(entry, near);
      squares[i] = judge.is_supported() ? square_of(near, 6) : -1;
    }
  });
  std::erase(squares, -1.0F);
  if (squares.empty()) return {};
  const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::nth_element(squares.begin(), middle, squares.end());
  return {1 - static_cast<double>(squares.size()) / static_cast<double>(count), *middle};
}

}  // namespace glark::reconstruct
