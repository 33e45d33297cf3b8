// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/maps/seams/seams.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "glark/clients/maps/seams/equations.h"
#include "glark/clients/maps/seams/samples.h"

namespace glark::maps {
namespace {

constexpr float measured_samples_per_texel = 8;
constexpr unsigned normal_channels = 3;

using Real = SeamEquations<double>;
using Complex = SeamEquations<std::complex<double>>;

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

// The texels along the seams, and the equations of channels that are the same on both sides.
class Equaliser {
 public:
  Equaliser(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams,
            const SeamOptions& options)
      : charts_(charts),
        channels_(channels),
        seams_(seams),
        options_(options),
        system_(charts, seams, options),
        equations_(system_, std::vector<double>(system_.rows().size(), 1.0)) {}

  void equalise(unsigned channel) {
    Eigen::VectorXd values = values_of(channel);
    values -= equations_.correction(equations_.differences(values));
    set_values(channel, values);
  }

  // The first three channels. The turned equations hold up to the small angle between normals and tangents, which the
  // shader does not remove; and where charts disagree, normals become short, and are scaled to unit length. So what is
  // left of the differences is corrected again.
  void equalise_normals(std::span<const SeamFrames> frames) {
    std::vector<std::complex<double>> turns;
    for_all_samples(charts_, seams_, options_.samples_per_texel,
                    [&](std::size_t seam, float part, const BilinearSample&, const BilinearSample&) {
                      turns.push_back(Frames(frames[seam], part).turn());
                    });
    const Complex turned(system_, std::move(turns));
    constexpr int rounds = 6;
    for (int round = 0; round < rounds; ++round) {
      if (round > 0) scale_short_normals();
      const NormalDifferences left = differences_of_normals(frames);
      const Eigen::VectorXcd across = turned.correction(left.across);
      const Eigen::VectorXd along = equations_.correction(left.along);
      set_values(0, values_of(0) - across.real());
      set_values(1, values_of(1) - across.imag());
      set_values(2, values_of(2) - along);
    }
  }

 private:
  // Of all samples: in the frame of side a.
  struct NormalDifferences {
    Eigen::VectorXcd across;
    Eigen::VectorXd along;
  };

  // Eight bits tell the direction of a short normal badly.
  void scale_short_normals() {
    constexpr float least = 0.6F, most = 1.2F;
    system_.for_each([&](std::uint32_t chart, std::size_t texel, std::uint32_t) {
      float* n = charts_[chart].values.data() + texel * channels_;
      const float length = std::hypot(n[0], n[1], n[2]);
      if (!(length > 0) || (length >= least && length <= most)) return;
      for (std::size_t k = 0; k < 3; ++k) n[k] /= length;
    });
  }

  NormalDifferences differences_of_normals(std::span<const SeamFrames> frames) const {
    std::vector<std::complex<double>> across;
    std::vector<double> along;
    for_all_samples(charts_, seams_, options_.samples_per_texel,
                    [&](std::size_t i, float part, const BilinearSample& a, const BilinearSample& b) {
                      const Frames at(frames[i], part);
                      const Vector left =
                          at.difference(normal_of(seams_[i].a.chart, a), normal_of(seams_[i].b.chart, b));
                      across.emplace_back(common::dot(left, at.a.tangent), common::dot(left, at.a.bitangent));
                      along.push_back(common::dot(left, at.a.normal));
                    });
    return {Eigen::Map<Eigen::VectorXcd>(across.data(), static_cast<Eigen::Index>(across.size())),
            Eigen::Map<Eigen::VectorXd>(along.data(), static_cast<Eigen::Index>(along.size()))};
  }

  Vector normal_of(std::uint32_t chart, const BilinearSample& sample) const {
    return {value_of(charts_[chart], sample, channels_, 0), value_of(charts_[chart], sample, channels_, 1),
            value_of(charts_[chart], sample, channels_, 2)};
  }

  Eigen::VectorXd values_of(unsigned channel) const {
    Eigen::VectorXd values(static_cast<Eigen::Index>(system_.unknowns()));
    system_.for_each([&](std::uint32_t chart, std::size_t texel, std::uint32_t i) {
      values[i] = static_cast<double>(charts_[chart].values[texel * channels_ + channel]);
    });
    return values;
  }
  void set_values(unsigned channel, const Eigen::VectorXd& values) {
    system_.for_each([&](std::uint32_t chart, std::size_t texel, std::uint32_t i) {
      charts_[chart].values[texel * channels_ + channel] = static_cast<float>(values[i]);
    });
  }

  std::span<const ChartImage> charts_;
  unsigned channels_;
  std::span<const Seam> seams_;
  SeamOptions options_;
  SeamSystem system_;
  Real equations_;
};

}  // namespace

SeamDifferences seam_jumps(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams) {
  assert(are_valid(charts, channels, seams));
  SeamDifferences jumps{std::vector<float>(channels), std::vector<float>(channels)};
  std::vector<double> squares(channels);
  std::size_t count = 0;
  for_all_samples(charts, seams, measured_samples_per_texel,
                  [&](std::size_t i, float, const BilinearSample& a, const BilinearSample& b) {
                    for (unsigned c = 0; c < channels; ++c) {
                      const float jump = std::abs(value_of(charts[seams[i].a.chart], a, channels, c) -
                                                  value_of(charts[seams[i].b.chart], b, channels, c));
                      jumps.greatest[c] = std::max(jumps.greatest[c], jump);
                      squares[c] += static_cast<double>(jump) * jump;
                    }
                    ++count;
                  });
  for (unsigned c = 0; c < channels && count > 0; ++c)
    jumps.root_mean_square[c] = static_cast<float>(std::sqrt(squares[c] / static_cast<double>(count)));
  return jumps;
}

SeamDifferences equalise(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams,
                         const SeamOptions& options, std::span<const SeamFrames> frames) {
  assert(are_valid(charts, channels, seams) && (frames.empty() || frames.size() == seams.size()));
  if (seams.empty()) return seam_jumps(charts, channels, seams);
  Equaliser equaliser(charts, channels, seams, options);
  if (!frames.empty()) equaliser.equalise_normals(frames);
  for (unsigned c = frames.empty() ? 0 : normal_channels; c < channels; ++c) equaliser.equalise(c);
  return seam_jumps(charts, channels, seams);
}

}  // namespace glark::maps
