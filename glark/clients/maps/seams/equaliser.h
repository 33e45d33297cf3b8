// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Changes texels next to seams, so that both sides agree, in one level of the maps.
#pragma once

#include <optional>

#include "glark/clients/maps/seams/equations.h"
#include "glark/clients/maps/seams/samples.h"

namespace glark::maps {

inline constexpr unsigned normal_channels = 3;

float value_of(const ChartImage& chart, const BilinearSample& sample, unsigned channels, unsigned channel);

class Equaliser {
 public:
  // The spans must outlive the object. frames: as in equalise().
  Equaliser(std::span<const ChartImage> charts, unsigned channels, std::span<const Seam> seams,
            std::span<const SeamFrames> frames, const SeamOptions& options);

  void equalise(unsigned channel);
  // The first three channels, if there are frames. The turned equations hold up to the small angle between normals and
  // tangents, which the shader does not remove; so what is left of the differences is corrected again in each round.
  // scale: short normals, which arise where charts disagree, are scaled to unit length before the next round.
  void equalise_normals(int rounds, bool scale);

 private:
  // The differences of all samples, in the frame of side a: tangent and bitangent, and normal.
  struct NormalDifferences {
    Eigen::VectorXcd across;
    Eigen::VectorXd along;
  };

  std::vector<bool> hard_samples() const;
  std::vector<std::complex<double>> turns() const;
  void scale_short_normals();
  NormalDifferences differences_of_normals() const;
  Vector normal_of(std::uint32_t chart, const BilinearSample& sample) const;
  Eigen::VectorXd values_of(unsigned channel) const;
  void set_values(unsigned channel, const Eigen::VectorXd& values);

  std::span<const ChartImage> charts_;
  unsigned channels_;
  std::span<const Seam> seams_;
  std::span<const SeamFrames> frames_;
  float samples_per_texel_;
  SeamSystem system_;
  SeamEquations<double> equations_;  // of channels that are the same on both sides
  std::optional<SeamEquations<std::complex<double>>> turned_;
  std::optional<SeamEquations<double>> along_;  // of the third number of normals, if there are hard seams
};

}  // namespace glark::maps
