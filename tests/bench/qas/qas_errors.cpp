// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "tests/bench/qas/qas_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace glark::bench {
namespace {

using qas::Sample;
using Vector = std::array<double, 3>;

Vector of(const std::array<float, 3>& a) { return {a[0], a[1], a[2]}; }
Vector sum(double s, const Vector& a, double t, const Vector& b) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector unit(const Vector& a) { return sum(1 / std::max(std::sqrt(dot(a, a)), 1e-300), a, 0, a); }

class Tally {
 public:
  explicit Tally(double diagonal) : diagonal_(diagonal) {}

  void add(const Sample& sample, const Sample& exact) {
    const Vector difference = sum(1, of(sample.position), -1, of(exact.position));
    const double distance = 100 * std::sqrt(dot(difference, difference)) / diagonal_;
    const double height = 100 * std::fabs(dot(difference, unit(of(exact.normal)))) / diagonal_;
    const double cosine = std::clamp(dot(unit(of(sample.normal)), unit(of(exact.normal))), -1.0, 1.0);
    const double degrees = std::acos(cosine) * 180 / std::numbers::pi;
    ++count_;
    squares_ += distance * distance;
    height_squares_ += height * height;
    highest_ = std::max(highest_, height);
    normal_squares_ += degrees * degrees;
    most_ = std::max(most_, distance);
    normal_most_ = std::max(normal_most_, degrees);
  }

  Deviation result() const {
    return {std::sqrt(squares_ / count_),        most_,       std::sqrt(height_squares_ / count_), highest_,
            std::sqrt(normal_squares_ / count_), normal_most_};
  }

 private:
  double diagonal_, count_ = 0, squares_ = 0, most_ = 0, height_squares_ = 0, highest_ = 0, normal_squares_ = 0,
                    normal_most_ = 0;
};

// Source: A. Vlachos et al., Curved PN Triangles, 2001.
class PnTriangle {
 public:
  explicit PnTriangle(const std::array<Sample, 3>& corners) {
    Vector edges{};
    for (std::size_t i = 0; i < 3; ++i) {
      p_[i] = of(corners[i].position);
      n_[i] = of(corners[i].normal);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      from_[i] = control(i, j);
      to_[i] = control(j, i);
      edges = sum(1, edges, 1.0 / 6, sum(1, from_[i], 1, to_[i]));
      const Vector along = sum(1, p_[j], -1, p_[i]), both = sum(1, n_[i], 1, n_[j]);
      middle_normal_[i] = unit(sum(1, both, -2 * dot(along, both) / std::max(dot(along, along), 1e-300), along));
    }
    const Vector centre = sum(1.0 / 3, sum(1, p_[0], 1, p_[1]), 1.0 / 3, p_[2]);
    inner_ = sum(1.5, edges, -0.5, centre);
  }

  Sample at(const std::array<double, 3>& b) const {
    Vector position = sum(6 * b[0] * b[1] * b[2], inner_, 0, inner_), normal{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      position = sum(1, position, b[i] * b[i] * b[i], p_[i]);
      position = sum(1, position, 3 * b[i] * b[j], sum(b[i], from_[i], b[j], to_[i]));
      normal = sum(1, normal, b[i] * b[i], n_[i]);
      normal = sum(1, normal, b[i] * b[j], middle_normal_[i]);
    }
    Sample sample{};
    for (std::size_t i = 0; i < 3; ++i) {
      sample.position[i] = static_cast<float>(position[i]);
      sample.normal[i] = static_cast<float>(normal[i]);
    }
    return sample;
  }

 private:
  Vector control(std::size_t i, std::size_t j) const {
    const double height = dot(sum(1, p_[j], -1, p_[i]), n_[i]);
    return sum(1.0 / 3, sum(2, p_[i], 1, p_[j]), -height / 3, n_[i]);
  }

  std::array<Vector, 3> p_, n_, from_, to_, middle_normal_;
  Vector inner_;
};

// Evaluates the split mesh: finds the patch in which (w, u, v) lies, and the coordinates there.
Sample of_split(const qas::Surface& split, std::size_t triangle, const std::array<double, 3>& b) {
  std::size_t child = 3;
  std::array<double, 3> there = {1 - 2 * b[2], 1 - 2 * b[0], 1 - 2 * b[1]};
  for (std::size_t i = 0; i < 3; ++i) {
    if (b[i] < 0.5) continue;
    child = i;
    there = {2 * b[0], 2 * b[1], 2 * b[2]};
    there[i] -= 1;
    break;
  }
  return split.evaluate(4 * triangle + child, {float(there[0]), float(there[1]), float(there[2])});
}

}  // namespace

QasErrors qas_errors(const qas::test::ControlMesh& mesh, unsigned level) {
  const std::size_t triangles = mesh.triangles.size() / 3;
  qas::Surface surface(mesh.view()), split(mesh.view(), {.splits = 1});
  qas::LoopSurface exact(mesh.view());
  surface.update(mesh.positions);
  split.update(mesh.positions);
  exact.update(mesh.positions);
  const unsigned side = 1U << level;
  std::vector<Sample> samples(triangles * (side + 1) * (side + 2) / 2);
  exact.refine(level, samples);
  Tally of_qas(mesh.diagonal()), of_splits(mesh.diagonal()), of_quartic(mesh.diagonal()), of_pn(mesh.diagonal());
  auto sample = samples.begin();
  for (std::size_t t = 0; t < triangles; ++t) {
    const PnTriangle pn(
        {surface.evaluate(t, {1, 0, 0}), surface.evaluate(t, {0, 1, 0}), surface.evaluate(t, {0, 0, 1})});
    for (unsigned i = 0; i <= side; ++i) {
      for (unsigned j = 0; i + j <= side; ++j, ++sample) {
        const std::array<double, 3> b = {double(side - i - j) / side, double(i) / side, double(j) / side};
        of_qas.add(surface.evaluate(t, {float(b[0]), float(b[1]), float(b[2])}), *sample);
        of_quartic.add(split.evaluate_quartic(t, {float(b[0]), float(b[1]), float(b[2])}), *sample);
        of_splits.add(of_split(split, t, b), *sample);
        of_pn.add(pn.at(b), *sample);
      }
    }
  }
  return {mesh.name, triangles, of_qas.result(), of_splits.result(), of_quartic.result(), of_pn.result()};
}

}  // namespace glark::bench
