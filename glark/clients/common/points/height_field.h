// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "glark/clients/common/points/moments.h"

namespace glark::common {

// Returns whether the records are a height field over the plane of their mean and mean normal, within the thresholds
// delta_a and delta_d. The threshold delta_a does not apply to records without a normal.
// Source: Boubekeur 2007, ch. 3.2.2.
bool is_height_field(std::span<const Record> records, const Moments& moments, float delta_a, float delta_d);

}  // namespace glark::common
