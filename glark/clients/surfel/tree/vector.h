// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include "glark/clients/common/vector.h"

namespace glark::surfel {

using Vector = common::Vector3f;
using common::to_vector;

}  // namespace glark::surfel
