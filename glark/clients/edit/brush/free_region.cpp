// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/edit/brush/free_region.h"

#include <Eigen/SparseCholesky>

namespace glark::edit {
namespace {

constexpr int outside = -1;
constexpr double nearest = 0.1;  // shorter edges have the weight of this part of the mean length

using Sparse = Eigen::SparseMatrix<double>;

// The free samples and their neighbours: the samples whose Laplacian depends on a free value.
struct Rows {
  std::vector<std::uint32_t> samples;
  double mean_length = 0;
};

Rows rows_around(const Graph& graph, const Samples& positions, const std::vector<std::uint32_t>& free) {
  Rows rows;
  double sum = 0;
  std::size_t edges = 0;
  for (const std::uint32_t i : free) {
    rows.samples.push_back(i);
    for (const std::uint32_t j : graph.of(i)) {
      rows.samples.push_back(j);
      sum += common::length(positions.position(j) - positions.position(i));
      ++edges;
    }
  }
  std::sort(rows.samples.begin(), rows.samples.end());
  rows.samples.erase(std::unique(rows.samples.begin(), rows.samples.end()), rows.samples.end());
  rows.mean_length = edges == 0 ? 1 : sum / static_cast<double>(edges);
  return rows;
}

// The Laplacians of the rows, divided by the root of the row's weights: matrix * free values + given = Laplacians.
struct Equations {
  Sparse matrix;
  std::vector<Eigen::VectorXd> given;  // for each column of values
};

Equations equations_of(const Graph& graph, const Samples& positions, const std::vector<int>& columns, const Rows& rows,
                       std::size_t free, const std::vector<std::vector<double>>& values) {
  const auto height = static_cast<Eigen::Index>(rows.samples.size());
  std::vector<Eigen::Triplet<double>> entries;
  Equations equations{Sparse(height, static_cast<Eigen::Index>(free)), {}};
  for (std::size_t k = 0; k < values.size(); ++k) equations.given.emplace_back(Eigen::VectorXd::Zero(height));
  std::vector<double> weights;
  for (int row = 0; row < static_cast<int>(height); ++row) {
    const std::uint32_t i = rows.samples[static_cast<std::size_t>(row)];
    double sum = 0;
    weights.clear();
    for (const std::uint32_t j : graph.of(i)) {
      const double edge = common::length(positions.position(j) - positions.position(i)) / rows.mean_length;
      const double shown = std::max(edge, nearest);
      sum += weights.emplace_back(1 / (shown * shown));
    }
    const double root = std::sqrt(sum);
    const auto add = [&](std::uint32_t sample, double entry) {
      if (columns[sample] != outside) entries.emplace_back(row, columns[sample], entry);
      for (std::size_t k = 0; k < values.size() && columns[sample] == outside; ++k)
        equations.given[k][row] += entry * values[k][sample];
    };
    add(i, root);
    for (std::size_t k = 0; k < weights.size(); ++k) add(graph.of(i)[k], -weights[k] / root);
  }
  equations.matrix.setFromTriplets(entries.begin(), entries.end());
  return equations;
}

// The free samples that a path of free samples connects to one with a value.
std::vector<std::uint32_t> connected(const Graph& graph, const std::vector<std::uint32_t>& free) {
  std::vector<bool> is_free(graph.size()), is_found(graph.size());
  for (const std::uint32_t i : free) is_free[i] = true;
  std::vector<std::uint32_t> found;
  const auto find = [&](std::uint32_t i) {
    if (!is_found[i]) found.push_back(i);
    is_found[i] = true;
  };
  for (const std::uint32_t i : free)
    for (const std::uint32_t j : graph.of(i))
      if (!is_free[j]) find(i);
  for (std::size_t k = 0; k < found.size(); ++k)
    for (const std::uint32_t j : graph.of(found[k]))
      if (is_free[j]) find(j);
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

void fair_values(const Graph& graph, const Samples& positions, const std::vector<std::uint32_t>& free,
                 std::vector<std::vector<double>>& values) {
  const std::vector<std::uint32_t> unknown = connected(graph, free);
  if (unknown.empty()) return;
  std::vector<int> columns(graph.size(), outside);
  for (std::size_t k = 0; k < unknown.size(); ++k) columns[unknown[k]] = static_cast<int>(k);
  const Rows rows = rows_around(graph, positions, unknown);
  const Equations equations = equations_of(graph, positions, columns, rows, unknown.size(), values);
  const Sparse squares = equations.matrix.transpose() * equations.matrix;
  const Eigen::SimplicialLDLT<Sparse> solver(squares);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Eigen::VectorXd solution = solver.solve(-(equations.matrix.transpose() * equations.given[k]));
    if (solver.info() != Eigen::Success || !solution.allFinite())
      throw Error(Element::operation, 0,
                  "deform: the equations of the free part have no solution; use a larger handle or free ball");
    for (std::size_t i = 0; i < unknown.size(); ++i) values[k][unknown[i]] = solution[static_cast<Eigen::Index>(i)];
  }
}

}  // namespace glark::edit
