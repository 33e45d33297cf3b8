// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: S. Liu, Z. Ferguson, A. Jacobson, Y. Gingold, Seamless: Seam Erasure and Seam-Aware Decimation of Meshes,
// 2017, section 4: least squares of the differences along seams. There, the texels' change is kept smooth inside the
// charts, too. Here, only the texels that the samples depend on change, each as little as possible.
#include "glark/clients/maps/seams/seams.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "glark/clients/maps/seams/samples.h"
#include "glark/clients/maps/seams/touched_texels.h"

namespace glark::maps {
namespace {

constexpr float measured_samples_per_texel = 8;

using Sparse = Eigen::SparseMatrix<double>;

float value_of(const ChartImage& chart, const BilinearSample& sample, unsigned channels, unsigned channel) {
  float value = 0;
  for (unsigned k = 0; k < 4; ++k) value += chart.values[sample.texels[k] * channels + channel] * sample.weights[k];
  return value;
}

[[maybe_unused]] bool are_valid(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams) {
  return std::all_of(charts.begin(), charts.end(),
                     [&](const ChartImage& chart) {
                       return chart.width > 0 && chart.height > 0 &&
                              chart.values.size() == std::size_t{chart.width} * chart.height * channels;
                     }) &&
         std::all_of(seams.begin(), seams.end(),
                     [&](const Seam& seam) { return seam.a.chart < charts.size() && seam.b.chart < charts.size(); });
}

// The differences along the seams, as linear functions of the texels that they depend on.
struct Differences {
  TouchedTexels texels;
  Sparse matrix;  // a row for each sample, a column for each texel
};

Differences differences_of(std::span<const ChartImage> charts, std::span<const Seam> seams, float samples_per_texel) {
  Differences differences{TouchedTexels(charts), {}};
  Eigen::Index rows = 0;
  for (const Seam& seam : seams) {
    for_samples(charts, seam, samples_per_texel, [&](const BilinearSample& a, const BilinearSample& b) {
      for (const std::size_t texel : a.texels) differences.texels.insert(seam.a.chart, texel);
      for (const std::size_t texel : b.texels) differences.texels.insert(seam.b.chart, texel);
      ++rows;
    });
  }
  const auto columns = static_cast<Eigen::Index>(differences.texels.finish());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(8 * static_cast<std::size_t>(rows));
  int row = 0;
  for (const Seam& seam : seams) {
    for_samples(charts, seam, samples_per_texel, [&](const BilinearSample& a, const BilinearSample& b) {
      for (unsigned k = 0; k < 4; ++k) {
        entries.emplace_back(row, differences.texels.number(seam.a.chart, a.texels[k]), a.weights[k]);
        entries.emplace_back(row, differences.texels.number(seam.b.chart, b.texels[k]), -b.weights[k]);
      }
      ++row;
    });
  }
  differences.matrix.resize(rows, columns);
  differences.matrix.setFromTriplets(entries.begin(), entries.end());
  return differences;
}

// The weights of changes, and of differences between the changes of neighbouring texels. Without the latter, texels that
// samples hardly depend on would stay behind an offset between two charts.
Sparse change_weights(std::span<const ChartImage> charts, const TouchedTexels& texels, Eigen::Index count,
                      const SeamOptions& options) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * static_cast<std::size_t>(count));
  const double fidelity = options.fidelity * options.samples_per_texel;
  const double smoothness = options.smoothness * options.samples_per_texel;
  texels.for_each([&](std::uint32_t chart, std::size_t texel, std::uint32_t i) {
    const unsigned width = charts[chart].width;
    entries.emplace_back(i, i, fidelity);
    const auto join = [&](std::size_t neighbour) {
      if (!texels.contains(chart, neighbour)) return;
      const std::uint32_t j = texels.number(chart, neighbour);
      entries.emplace_back(i, i, smoothness);
      entries.emplace_back(j, j, smoothness);
      entries.emplace_back(i, j, -smoothness);
      entries.emplace_back(j, i, -smoothness);
    };
    if (texel % width + 1 < width) join(texel + 1);
    if (texel / width + 1 < charts[chart].height) join(texel + width);
  });
  Sparse weights(count, count);
  weights.setFromTriplets(entries.begin(), entries.end());
  return weights;
}

}  // namespace

SeamDifferences seam_jumps(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams) {
  assert(are_valid(charts, channels, seams));
  SeamDifferences jumps{std::vector<float>(channels), std::vector<float>(channels)};
  std::vector<double> squares(channels);
  std::size_t count = 0;
  for (const Seam& seam : seams) {
    const ChartImage &chart_a = charts[seam.a.chart], &chart_b = charts[seam.b.chart];
    for_samples(charts, seam, measured_samples_per_texel, [&](const BilinearSample& a, const BilinearSample& b) {
      for (unsigned c = 0; c < channels; ++c) {
        const float jump = std::abs(value_of(chart_a, a, channels, c) - value_of(chart_b, b, channels, c));
        jumps.greatest[c] = std::max(jumps.greatest[c], jump);
        squares[c] += static_cast<double>(jump) * jump;
      }
      ++count;
    });
  }
  for (unsigned c = 0; c < channels && count > 0; ++c)
    jumps.root_mean_square[c] = static_cast<float>(std::sqrt(squares[c] / static_cast<double>(count)));
  return jumps;
}

SeamDifferences equalise(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams,
                         const SeamOptions& options) {
  assert(are_valid(charts, channels, seams));
  const Differences differences = differences_of(charts, seams, options.samples_per_texel);
  const Eigen::Index columns = differences.matrix.cols();
  if (columns == 0) return seam_jumps(charts, channels, seams);
  const Sparse squares = differences.matrix.transpose() * differences.matrix;
  const Eigen::SimplicialLDLT<Sparse> solver(squares + change_weights(charts, differences.texels, columns, options));
  Eigen::VectorXd values(columns);
  for (unsigned c = 0; c < channels; ++c) {
    const auto value = [&](std::uint32_t chart, std::size_t texel) -> float& {
      return charts[chart].values[texel * channels + c];
    };
    differences.texels.for_each([&](std::uint32_t chart, std::size_t texel, std::uint32_t i) {
      values[i] = static_cast<double>(value(chart, texel));
    });
    const Eigen::VectorXd jumps = differences.matrix * values;
    const Eigen::VectorXd right_side = differences.matrix.transpose() * jumps;
    values -= solver.solve(right_side);
    differences.texels.for_each([&](std::uint32_t chart, std::size_t texel, std::uint32_t i) {
      value(chart, texel) = static_cast<float>(values[i]);
    });
  }
  return seam_jumps(charts, channels, seams);
}

}  // namespace glark::maps
