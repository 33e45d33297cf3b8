// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Any text as an assembly vertex program: no crash, no hang; either GLSL or an error. The first byte says whether a clip
// plane is enabled.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "glark/core/refine/assembly/translate.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view program(reinterpret_cast<const char*>(data) + 1, size - 1);
  const glark::refine::assembly::Translation translation =
      glark::refine::assembly::translate(program, (data[0] & 1U) != 0);
  if (translation.ok != translation.error.empty() || translation.ok == translation.source.empty()) std::abort();
  return 0;
}
