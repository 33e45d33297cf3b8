// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The text of errors that name an element of an argument.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glark::common {

// "glark-qas: triangle 7 has ..."; without an index "glark-qas: mesh has ...".
inline std::string error_message(std::string_view library, std::string_view element, std::optional<std::size_t> index,
                                 std::string_view problem) {
  std::string text(library);
  text.append(": ").append(element).append(" ");
  if (index) text.append(std::to_string(*index)).append(" ");
  return text.append(problem);
}

}  // namespace glark::common
