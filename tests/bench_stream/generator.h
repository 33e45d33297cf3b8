// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Scans of any size: points on the triangles of a model, with detail and noise.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace glark::bench {

struct ScanOptions {
  std::uint64_t points = 1000000;
  bool shuffled = false;  // else in slices along the longest axis, as a scanner or a volumetric merge writes them
  double detail = 2e-4;   // the height of the bumps, relative to the diagonal
  double noise = 1e-5;    // the greatest noise along the normal, relative to the diagonal
};

// Point `i` of the scan depends on nothing but the model and the options, so that a scan takes no memory.
class ScanGenerator {
 public:
  ScanGenerator(const std::filesystem::path& model, const ScanOptions& options);
  // Writes the position and the normal.
  void point(std::uint64_t i, double* position, float* normal) const;

 private:
  struct Corner {
    std::array<double, 3> position, normal;
  };
  std::vector<std::array<Corner, 3>> triangles_;
  std::vector<double> areas_;  // of all triangles up to this one, with it
  ScanOptions options_;
  double diagonal_ = 1;
  std::uint64_t step_ = 1;  // of the shuffle: coprime to the number of points
};

void write_scan(const ScanGenerator& generator, std::uint64_t points, const std::filesystem::path& file);

}  // namespace glark::bench
