// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/seams/equaliser.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glark::maps {
namespace {

// The shader's frames on both sides of a place of a seam. Both have the same normal.
struct Frames {
  TangentFrame a, b;

  Frames(const SeamFrames& seam, float part) : a(frame(seam, 0, part)), b(frame(seam, 1, part)) {}

  // Both sides' tangents and bitangents nearly lie in one plane: b's are a's, turned by the angle of this number.
  std::complex<double> turn() const {
    const std::complex<double> turned(common::dot(a.tangent, b.tangent), common::dot(a.bitangent, b.tangent));
    const double size = std::abs(turned);
    return size > 0 ? turned / size : 1;
  }
  Vector difference(Vector of_a, Vector of_b) const { return a.to_world(of_a) - b.to_world(of_b); }

 private:
  static TangentFrame frame(const SeamFrames& seam, std::size_t side, float part) {
    const auto mix = [part](const std::array<Vector, 2>& ends) { return ends[0] * (1 - part) + ends[1] * part; };
    return TangentFrame::of(mix(seam.normals), mix(seam.tangents.at(side)));
  }
};

}  // namespace

float value_of(const ChartImage& chart, const BilinearSample& sample, unsigned channels, unsigned channel) {
  float value = 0;
  for (unsigned k = 0; k < 4; ++k) value += chart.values[sample.texels[k] * channels + channel] * sample.weights[k];
  return value;
}

Equaliser::Equaliser(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams,
                     std::span<const SeamFrames> frames, const SeamOptions& options)
    : charts_(charts),
      channels_(channels),
      seams_(seams),
      frames_(frames),
      samples_per_texel_(options.samples_per_texel),
      system_(charts, seams, options),
      equations_(system_, std::vector<double>(system_.rows().size(), 1.0)) {
  if (frames.empty()) return;
  const std::vector<bool> hard = hard_samples();
  turned_.emplace(system_, turns(), hard);
  if (!hard.empty()) along_.emplace(system_, std::vector<double>(system_.rows().size(), 1.0), hard);
}

// Empty if there are none.
std::vector<bool> Equaliser::hard_samples() const {
  std::vector<bool> hard;
  if (std::none_of(frames_.begin(), frames_.end(), [](const SeamFrames& frames) { return frames.is_hard; }))
    return hard;
  for_all_samples(charts_, seams_, samples_per_texel_,
                  [&](std::size_t seam, float, const BilinearSample&, const BilinearSample&) {
                    hard.push_back(frames_[seam].is_hard);
                  });
  return hard;
}

std::vector<std::complex<double>> Equaliser::turns() const {
  std::vector<std::complex<double>> turns;
  for_all_samples(charts_, seams_, samples_per_texel_,
                  [&](std::size_t seam, float part, const BilinearSample&, const BilinearSample&) {
                    turns.push_back(Frames(frames_[seam], part).turn());
                  });
  return turns;
}

void Equaliser::equalise(unsigned channel) {
  const Eigen::VectorXd values = values_of(channel);
  set_values(channel, values - equations_.correction(equations_.differences(values)));
}

void Equaliser::equalise_normals(int rounds, bool scale) {
  for (int round = 0; round < rounds && turned_; ++round) {
    if (round > 0 && scale) scale_short_normals();
    const NormalDifferences left = differences_of_normals();
    const Eigen::VectorXcd across = turned_->correction(left.across);
    const Eigen::VectorXd along = (along_ ? *along_ : equations_).correction(left.along);
    set_values(0, values_of(0) - across.real());
    set_values(1, values_of(1) - across.imag());
    set_values(2, values_of(2) - along);
  }
}

// Eight bits tell the direction of a short normal badly.
void Equaliser::scale_short_normals() {
  constexpr float least = 0.6F, most = 1.2F;
  system_.for_each([&](std::uint32_t chart, std::size_t texel, std::uint32_t) {
    float* n = charts_[chart].values.data() + texel * channels_;
    const float length = std::hypot(n[0], n[1], n[2]);
    if (!(length > 0) || (length >= least && length <= most)) return;
    for (std::size_t k = 0; k < 3; ++k) n[k] /= length;
  });
}

Equaliser::NormalDifferences Equaliser::differences_of_normals() const {
  std::vector<std::complex<double>> across;
  std::vector<double> along;
  for_all_samples(charts_, seams_, samples_per_texel_,
                  [&](std::size_t i, float part, const BilinearSample& a, const BilinearSample& b) {
                    const Frames at(frames_[i], part);
                    const Vector of_a = normal_of(seams_[i].a.chart, a), of_b = normal_of(seams_[i].b.chart, b);
                    const Vector left = frames_[i].is_hard ? Vector{} : at.difference(of_a, of_b);
                    across.emplace_back(common::dot(left, at.a.tangent), common::dot(left, at.a.bitangent));
                    along.push_back(common::dot(left, at.a.normal));
                  });
  return {Eigen::Map<Eigen::VectorXcd>(across.data(), static_cast<Eigen::Index>(across.size())),
          Eigen::Map<Eigen::VectorXd>(along.data(), static_cast<Eigen::Index>(along.size()))};
}

Vector Equaliser::normal_of(std::uint32_t chart, const BilinearSample& sample) const {
  return {value_of(charts_[chart], sample, channels_, 0), value_of(charts_[chart], sample, channels_, 1),
          value_of(charts_[chart], sample, channels_, 2)};
}

Eigen::VectorXd Equaliser::values_of(unsigned channel) const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(system_.unknowns()));
  system_.for_each([&](std::uint32_t chart, std::size_t texel, std::uint32_t i) {
    values[i] = static_cast<double>(charts_[chart].values[texel * channels_ + channel]);
  });
  return values;
}

void Equaliser::set_values(unsigned channel, const Eigen::VectorXd& values) {
  system_.for_each([&](std::uint32_t chart, std::size_t texel, std::uint32_t i) {
    charts_[chart].values[texel * channels_ + channel] = static_cast<float>(values[i]);
  });
}

}  // namespace glark::maps
