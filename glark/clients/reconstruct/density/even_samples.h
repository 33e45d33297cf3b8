// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Makes samples fit for cells of about one size: without outliers, and with sparse parts filled.
#pragma once

#include <vector>

#include "glark/clients/reconstruct/density/fill.h"

namespace glark::reconstruct {

class EvenSamples {
 public:
  // Keeps views of the given arrays.
  EvenSamples(const PointSet& given, const Workers& workers);

  PointSet points() const;
  SortedSamples take_sorted() { return std::move(sorted_); }
  // Returns the indices of the given samples that lie on no surface, in ascending order.
  std::vector<std::uint32_t> outliers() const;

 private:
  void remove_outliers(const Workers& workers);
  void fill_sparse_parts(const Workers& workers);
  void change(const std::vector<std::uint32_t>& removed, const Filling& added, const Workers& workers);

  PointSet given_;
  SortedSamples sorted_;
  std::vector<std::uint32_t> outliers_;  // the indices of given samples, in no order
  std::vector<std::uint32_t> given_as_;  // for each of the samples below, its index as given; added samples have none
  // Empty if all given samples are used as they are.
  std::vector<float> positions_, normals_;
  std::vector<std::uint8_t> colours_;
};

}  // namespace glark::reconstruct
