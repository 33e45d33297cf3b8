// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Sums over the samples of a cell. The error of the cell follows from them. The sums of a cell are the sums of its
// children, added up.
#pragma once

#include <span>

#include "glark/clients/common/points/record.h"

namespace glark::common {

// The products are relative to the mean. So they are small numbers, and single precision is enough.
// Based on: Chan, Golub, LeVeque, Updating Formulae and a Pairwise Algorithm for Computing Sample Variances, 1979.
struct Moments {
  Float4 mean{};         // the fourth is the number of samples
  Float4 products[3]{};  // row i: the sums of (p - mean)_i * (p - mean)
  Float4 normals{};      // the sum of the normals; the fourth is the number of normals

  float count() const { return mean[3]; }
  Float4 normal() const { return unit(normals); }
  bool at_one_point() const { return products[0][0] + products[1][1] + products[2][2] == 0; }

  static Moments of(std::span<const Record> records);
  void add(const Moments& other);

  // The mean square distance from the plane of the mean and the mean normal. Without a normal, the distance from the
  // mean.
  float plane_error() const;
  // The mean square difference from the mean normal.
  float normal_error() const;
};

}  // namespace glark::common
