// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Checks of arguments. Each throws Error, and formats its message only then, so that updates of tags allocate nothing.
#pragma once

#include <fmt/format.h>
#include <glark/depth.h>

#include <span>

namespace glark::depth {

template <class... Values>
void require(bool holds, fmt::format_string<Values...> problem, Values&&... values) {
  if (!holds) throw Error("glark-depth: " + fmt::format(problem, std::forward<Values>(values)...));
}

// The array has `components` floats for each vertex. `what` names it.
void check_length(const char* what, std::size_t length, std::size_t vertices, std::size_t components);
void check_finite(const char* what, std::span<const float> values, std::size_t components);

void check_tags(const char* what, std::span<const float> tags, std::size_t vertices);
// An array of tags that is about to be written.
void check_target(std::span<const float> tags, std::size_t vertices);
void check_positions(std::span<const float> positions, std::size_t vertices);
// An empty array is possible.
void check_normals(std::span<const float> normals, std::size_t vertices);
void check_view(const View& view);

}  // namespace glark::depth
