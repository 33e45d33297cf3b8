// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/seams/equations.h"

#include <algorithm>

#include "glark/clients/maps/seams/samples.h"

namespace glark::maps {
namespace {

// The entries of one column of a sparse matrix.
template <class Scalar>
class Column {
 public:
  explicit Column(std::size_t size) : values_(size), is_used_(size) {}

  void add(std::uint32_t row, Scalar value) {
    if (is_used_[row] == 0) {
      is_used_[row] = 1;
      used_.push_back(row);
    }
    values_[row] += value;
  }
  // Appends the column to the matrix, and begins the next one.
  void append_to(Eigen::SparseMatrix<Scalar>& matrix, Eigen::Index column) {
    std::sort(used_.begin(), used_.end());
    matrix.startVec(column);
    for (const std::uint32_t row : used_) {
      matrix.insertBackByOuterInner(column, row) = values_[row];
      values_[row] = 0;
      is_used_[row] = 0;
    }
    used_.clear();
  }

 private:
  std::vector<Scalar> values_;
  std::vector<std::uint8_t> is_used_;
  std::vector<std::uint32_t> used_;
};

// The factor of the k-th texel of a row in the difference.
template <class Scalar>
Scalar factor(const SeamRow& row, std::size_t k, Scalar turn) {
  const auto weight = static_cast<double>(row.weights[k]);
  return k < 4 ? Scalar(weight) : -turn * weight;
}

TouchedTexels touched_texels(std::span<const ChartImage> charts, std::span<const Seam> seams, float samples_per_texel) {
  TouchedTexels texels(charts);
  for_all_samples(charts, seams, samples_per_texel,
                  [&](std::size_t i, float, const BilinearSample& a, const BilinearSample& b) {
                    for (const std::size_t texel : a.texels) texels.insert(seams[i].a.chart, texel);
                    for (const std::size_t texel : b.texels) texels.insert(seams[i].b.chart, texel);
                  });
  texels.finish();
  return texels;
}

}  // namespace

SeamSystem::SeamSystem(std::span<const ChartImage> charts, std::span<const Seam> seams, const SeamOptions& options)
    : texels_(touched_texels(charts, seams, options.samples_per_texel)),
      samples_per_texel_(options.samples_per_texel),
      fidelity_(options.fidelity * options.samples_per_texel),
      smoothness_(options.smoothness * options.samples_per_texel) {
  set_rows(charts, seams);
  set_pairs(charts);
  set_order();
}

void SeamSystem::set_rows(std::span<const ChartImage> charts, std::span<const Seam> seams) {
  for_all_samples(charts, seams, static_cast<float>(samples_per_texel_),
                  [&](std::size_t i, float, const BilinearSample& a, const BilinearSample& b) {
                    SeamRow& row = rows_.emplace_back();
                    for (std::size_t k = 0; k < 4; ++k) {
                      row.unknowns[k] = texels_.number(seams[i].a.chart, a.texels[k]);
                      row.unknowns[k + 4] = texels_.number(seams[i].b.chart, b.texels[k]);
                      row.weights[k] = a.weights[k];
                      row.weights[k + 4] = b.weights[k];
                    }
                  });
}

void SeamSystem::set_pairs(std::span<const ChartImage> charts) {
  texels_.for_each([&](std::uint32_t chart, std::size_t texel, std::uint32_t i) {
    const unsigned width = charts[chart].width;
    const auto join = [&](std::size_t neighbour) {
      if (texels_.contains(chart, neighbour)) pairs_.push_back({i, texels_.number(chart, neighbour)});
    };
    if (texel % width + 1 < width) join(texel + 1);
    if (texel / width + 1 < charts[chart].height) join(texel + width);
  });
}

void SeamSystem::set_order() {
  order_.resize(texels_.size());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> new_to_old;
  const std::vector<double> turns(rows_.size(), 1.0);
  Eigen::AMDOrdering<int>()(squares<double>(turns, {}).selfadjointView<Eigen::Lower>(), new_to_old);
  for (std::size_t i = 0; i < order_.size(); ++i)
    order_[static_cast<std::size_t>(new_to_old.indices()[static_cast<Eigen::Index>(i)])] =
        static_cast<std::uint32_t>(i);
  for (SeamRow& row : rows_)
    for (std::uint32_t& unknown : row.unknowns) unknown = order_[unknown];
  for (Pair& pair : pairs_)
    for (std::uint32_t& unknown : pair) unknown = order_[unknown];
}

template <class Scalar>
Eigen::SparseMatrix<Scalar> SeamSystem::squares(std::span<const Scalar> turns,
                                                const std::vector<bool>& left_out) const {
  const Incidence rows_at(unknowns(), 8 * rows_.size(), [&](std::size_t k) { return rows_[k / 8].unknowns[k % 8]; });
  const Incidence pairs_at(unknowns(), 2 * pairs_.size(), [&](std::size_t k) { return pairs_[k / 2][k % 2]; });
  const auto size = static_cast<Eigen::Index>(unknowns());
  Eigen::SparseMatrix<Scalar> matrix(size, size);
  constexpr Eigen::Index usual_entries = 8;  // of a column
  matrix.reserve(usual_entries * size);
  Column<Scalar> column(unknowns());
  for (std::uint32_t i = 0; i < unknowns(); ++i) {
    for (const std::uint32_t entry : rows_at[i]) {
      if (!left_out.empty() && left_out[entry / 8]) continue;
      const SeamRow& row = rows_[entry / 8];
      const Scalar turn = turns[entry / 8], of_column = factor(row, entry % 8, turn);
      for (std::size_t k = 0; k < 8; ++k)
        if (row.unknowns[k] >= i) column.add(row.unknowns[k], Eigen::numext::conj(factor(row, k, turn)) * of_column);
    }
    column.add(i, fidelity_ + smoothness_ * static_cast<double>(pairs_at[i].size()));
    for (const std::uint32_t entry : pairs_at[i]) {
      const std::uint32_t neighbour = pairs_[entry / 2][1 - entry % 2];
      if (neighbour > i) column.add(neighbour, -smoothness_);
    }
    column.append_to(matrix, i);
  }
  matrix.finalize();
  return matrix;
}

template <class Scalar>
typename SeamEquations<Scalar>::Values SeamEquations<Scalar>::differences(const Values& values) const {
  Values differences = Values::Zero(static_cast<Eigen::Index>(turns_.size()));
  for (std::size_t r = 0; r < turns_.size(); ++r) {
    const SeamRow& row = system_.rows()[r];
    for (std::size_t k = 0; k < 8; ++k)
      differences[static_cast<Eigen::Index>(r)] += factor(row, k, turns_[r]) * values[row.unknowns[k]];
  }
  return differences;
}

template <class Scalar>
typename SeamEquations<Scalar>::Values SeamEquations<Scalar>::correction(const Values& differences) const {
  Values right_side = Values::Zero(static_cast<Eigen::Index>(system_.unknowns()));
  for (std::size_t r = 0; r < turns_.size(); ++r) {
    const SeamRow& row = system_.rows()[r];
    for (std::size_t k = 0; k < 8; ++k)
      right_side[row.unknowns[k]] +=
          Eigen::numext::conj(factor(row, k, turns_[r])) * differences[static_cast<Eigen::Index>(r)];
  }
  return solver_.solve(right_side);
}

template class SeamEquations<double>;
template class SeamEquations<std::complex<double>>;

}  // namespace glark::maps
