// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace glark::stream {

// Gives freed blocks back to the system if this process is near the limit. Tables that grow and go leave holes, which
// the allocator keeps otherwise. limit: bytes; 0: in any case.
void trim_memory(std::size_t limit);

}  // namespace glark::stream
