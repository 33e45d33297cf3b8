// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks of arguments. A failed check throws Error, and only then formats a message. So valid tags cause no allocation.
#pragma once

#include <fmt/format.h>
#include <glark/depth.h>

#include <span>

namespace glark::depth {

template <class... Values>
void require(bool holds, fmt::format_string<Values...> problem, Values&&... values) {
  if (!holds) throw Error("glark-depth: " + fmt::format(problem, std::forward<Values>(values)...));
}

// Checks that the array has `components` floats for each vertex. `what` is the name of the array in the message.
void check_length(const char* what, std::size_t length, std::size_t vertices, std::size_t components);
void check_finite(const char* what, std::span<const float> values, std::size_t components);

void check_tags(const char* what, std::span<const float> tags, std::size_t vertices);
// Checks an array of tags before it is written.
void check_target(std::span<const float> tags, std::size_t vertices);
void check_positions(std::span<const float> positions, std::size_t vertices);
// The array may be empty.
void check_normals(std::span<const float> normals, std::size_t vertices);
void check_view(const View& view);

}  // namespace glark::depth
