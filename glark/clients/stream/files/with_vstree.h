// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glark/point_stream.h>
#include <glark/vstree.h>

#include <string>
#include <string_view>

namespace glark::stream {

// Calls a function of glark-vstree on the points of a file. Its errors become those of this library, and name the file.
template <class Step>
auto with_vstree(const std::string& file, const Step& step) {
  try {
    return step();
  } catch (const vstree::Error& error) {
    constexpr std::string_view library = "glark-vstree: ";
    std::string text = error.what();
    if (text.starts_with(library)) text.erase(0, library.size());
    const bool is_point = error.element() == vstree::Element::point;
    throw Error(is_point ? Element::point : Element::option, error.index(), file + ": " + text);
  }
}

}  // namespace glark::stream
