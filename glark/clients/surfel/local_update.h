// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Points that move, and what has to be made anew for them.
// Based on: Boubekeur 2007, ch. 5.2.7.
#pragma once

#include <span>
#include <vector>

#include "glark/clients/surfel/layer.h"

namespace glark::surfel {

// moved: points of the layer at their new places, ascending by index, each once; indices beyond the layer's points are new ones, without
// gaps. Appends to `changed` what changed in `indices`.
void update_layer(Layer& layer, std::span<const Surfel> moved, const LayerOptions& options, const Workers& workers,
                  std::vector<std::uint32_t>& indices, std::vector<Range>& changed);

// Whether most leaves are what points that moved on have left over.
bool overgrown(const Layer& layer, const LayerOptions& options);

// The same points in a new tree.
void rebuild(Layer& layer, const LayerOptions& options, const Workers& workers, std::vector<std::uint32_t>& indices);

// Moves the layer's arrays together where most of them is left over.
void tidy(Layer& layer);

}  // namespace glark::surfel
