// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "conformance/gl.h"

namespace glark::conformance {

Functions gl;

}  // namespace glark::conformance
