// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The least-squares problem of seams. Based on: S. Liu, Z. Ferguson, A. Jacobson, Y. Gingold, Seamless: Seam Erasure and
// Seam-Aware Decimation of Meshes, 2017, section 4. There, the texels' change is kept smooth inside the charts, too. Here,
// only the texels that the samples depend on change, each as little as possible.
#pragma once

#include <Eigen/SparseCholesky>

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

#include "glark/clients/maps/seams/seams.h"
#include "glark/clients/maps/seams/touched_texels.h"

namespace glark::maps {

// A sample on both sides of a seam: first the four texels of side a, then those of side b.
struct SeamRow {
  std::array<std::uint32_t, 8> unknowns{};
  std::array<float, 8> weights{};
};

// For each unknown, a list of items that contain it.
class Incidence {
 public:
  // unknown_of(k): the unknown of entry k, of `entries` entries.
  template <class UnknownOf>
  Incidence(std::size_t unknowns, std::size_t entries, const UnknownOf& unknown_of)
      : first_(unknowns + 1), entries_(entries) {
    for (std::size_t k = 0; k < entries; ++k) ++first_[unknown_of(k) + 1];
    for (std::size_t i = 0; i < unknowns; ++i) first_[i + 1] += first_[i];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t k = 0; k < entries; ++k) entries_[next[unknown_of(k)]++] = static_cast<std::uint32_t>(k);
  }
  std::span<const std::uint32_t> operator[](std::size_t unknown) const {
    return std::span(entries_).subspan(first_[unknown], first_[unknown + 1] - first_[unknown]);
  }

 private:
  std::vector<std::uint32_t> first_, entries_;
};

// The samples of all seams and the texels that they depend on. The texels are the unknowns, in an order that keeps the
// factors of the equations sparse.
class SeamSystem {
 public:
  SeamSystem(std::span<const ChartImage> charts, std::span<const Seam> seams, const SeamOptions& options);

  std::size_t unknowns() const { return order_.size(); }
  const std::vector<SeamRow>& rows() const { return rows_; }
  // Calls visit(chart, texel, unknown) for all texels.
  template <class Visit>
  void for_each(const Visit& visit) const {
    texels_.for_each([&](std::uint32_t chart, std::size_t texel, std::uint32_t i) { visit(chart, texel, order_[i]); });
  }

  // The squares of the differences, and the weights of the changes: the lower triangle. Without weights of the difference
  // between the changes of neighbouring texels, texels that samples hardly depend on would stay behind an offset between
  // two charts. turns: [rows] factors of side b. left_out: [rows] samples that need not agree; or empty.
  template <class Scalar>
  Eigen::SparseMatrix<Scalar> squares(std::span<const Scalar> turns, const std::vector<bool>& left_out) const;

 private:
  using Pair = std::array<std::uint32_t, 2>;

  void set_rows(std::span<const ChartImage> charts, std::span<const Seam> seams);
  void set_pairs(std::span<const ChartImage> charts);
  void set_order();

  TouchedTexels texels_;
  double samples_per_texel_, fidelity_, smoothness_;
  std::vector<SeamRow> rows_;
  std::vector<Pair> pairs_;           // of neighbouring texels
  std::vector<std::uint32_t> order_;  // for each texel of the set: its unknown
};

// Scalar: double, or std::complex<double> for two channels that turn at the seams.
template <class Scalar>
class SeamEquations {
 public:
  using Values = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  // turns: [rows] factors of side b in the differences a - turn * b. left_out: as in squares(); corrections need the difference 0
  // there.
  SeamEquations(const SeamSystem& system, std::vector<Scalar> turns, const std::vector<bool>& left_out = {})
      : system_(system), turns_(std::move(turns)), solver_(system.squares<Scalar>(turns_, left_out)) {}

  // Returns the differences of all samples; values: of the unknowns.
  Values differences(const Values& values) const;
  // Returns a correction. Subtracted from the unknowns, it makes the differences as small as the weights allow.
  Values correction(const Values& differences) const;

 private:
  const SeamSystem& system_;
  std::vector<Scalar> turns_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<Scalar>, Eigen::Lower, Eigen::NaturalOrdering<int>> solver_;
};

}  // namespace glark::maps
