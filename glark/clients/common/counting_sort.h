// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// A stable counting sort. The result does not depend on the number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "glark/clients/common/workers.h"

namespace glark::common {

// Writes the keys of records begin .. end - 1.
using KeyFunction = std::function<void(std::size_t begin, std::size_t end, std::uint32_t* keys)>;
// Moves record i of begin .. end - 1 to slots[i - begin] of the destination.
using MoveFunction = std::function<void(std::size_t begin, std::size_t end, const std::uint32_t* slots)>;

// Sorts `count` records by keys below `cells`. Returns [cells + 1] slots: the first slot of each key, and the end of
// the last key.
std::vector<std::uint32_t> sort_by_key(std::size_t count, std::size_t cells, const KeyFunction& key,
                                       const MoveFunction& move, const Workers& workers);

}  // namespace glark::common
