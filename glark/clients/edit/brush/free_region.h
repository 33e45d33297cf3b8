// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The smoothest values between samples whose values are given.
#pragma once

#include "glark/clients/edit/shape/shape.h"

namespace glark::edit {

// values: [columns][samples of the graph]. Those of the `free` samples are replaced by the ones with the least squares
// of their Laplacians; the others are given. Neighbours have weights by their distance in `positions`, so that the
// density of the samples does not matter. Samples that no path connects to one with a value stay as they are.
// Source: M. Botsch, L. Kobbelt, An Intuitive Framework for Real-Time Freeform Modeling, 2004, order k = 2.
// Throws Error if the equations have no solution.
void fair_values(const Graph& graph, const Samples& positions, const std::vector<std::uint32_t>& free,
                 std::vector<std::vector<double>>& values);

}  // namespace glark::edit
