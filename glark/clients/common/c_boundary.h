// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// From C to C++ and back, for the c_api.cpp of every client library: arrays become spans, exceptions become codes.
#pragma once

#include <glark/c/types.h>
#include <glark/error.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glark::c {

// Returns `pointer`. Throws ArgumentError, which names the argument, if it is NULL.
template <class T>
T& needed(T* pointer, const char* name) {
  if (pointer == nullptr) {
    throw ArgumentError("glark: the argument " + std::string(name) + " is NULL; pass its address");
  }
  return *pointer;
}

// Three numbers for each index of 32 bits.
inline constexpr std::uint64_t most_elements = 3 * (std::uint64_t{1} << 32U);

// The array as a span. Throws ArgumentError, which names the argument, if it cannot be one.
template <class T>
std::span<T> span_of(T* data, std::size_t count, const char* name) {
  if (count > most_elements) {
    throw ArgumentError("glark: " + std::string(name) + " has " + std::to_string(count) + " elements; " +
                        std::to_string(most_elements) + " are possible: check its count");
  }
  if (data == nullptr && count > 0) {
    throw ArgumentError("glark: " + std::string(name) + " has " + std::to_string(count) +
                        " elements, but is NULL; pass its address");
  }
  return {data, count};
}
inline std::span<const float> span_of(const glark_floats& array, const char* name) {
  return span_of(array.data, array.count, name);
}
inline std::span<const std::uint32_t> span_of(const glark_indices& array, const char* name) {
  return span_of(array.data, array.count, name);
}
inline std::span<const std::uint8_t> span_of(const glark_bytes& array, const char* name) {
  return span_of(array.data, array.count, name);
}
inline std::span<float> span_of(const glark_float_output& array, const char* name) {
  return span_of(array.data, array.count, name);
}

// C may pass any number as an enumeration, whose values are 0 to `last`. Throws ArgumentError for another one.
template <class Enumeration>
Enumeration enumeration_of(int value, Enumeration last, std::string_view name) {
  if (value < 0 || value > static_cast<int>(last)) {
    throw ArgumentError("glark: " + std::string(name) + " is " + std::to_string(value) + "; 0 to " +
                        std::to_string(static_cast<int>(last)) + " are possible: use a value of its enumeration");
  }
  return static_cast<Enumeration>(value);
}

inline glark_floats array_of(std::span<const float> span) { return {span.data(), span.size()}; }
inline glark_indices array_of(std::span<const std::uint32_t> span) { return {span.data(), span.size()}; }
inline glark_bytes array_of(std::span<const std::uint8_t> span) { return {span.data(), span.size()}; }

// The byte at or before `at` where a character of UTF-8 begins. A message must not end within one. A character has at
// most four bytes; names of files may have bytes that are no UTF-8.
inline std::size_t begin_of_character(std::string_view text, std::size_t at) {
  for (std::size_t begin = at, left = 4; left > 0; --begin, --left) {
    if ((static_cast<unsigned char>(text[begin]) & 0xC0U) != 0x80U) return begin;
    if (begin == 0) break;
  }
  return at;
}

inline glark_code fail(glark_error* error, glark_code code, std::string_view message, int element = GLARK_NO_ELEMENT,
                       std::size_t index = 0) {
  if (error != nullptr) {
    error->code = code;
    error->element = element;
    error->index = index;
    std::size_t length = std::min(message.size(), std::size_t{GLARK_MESSAGE_SIZE} - 1);
    if (length < message.size()) length = begin_of_character(message, length);
    std::copy_n(message.data(), length, error->message);
    error->message[length] = '\0';
  }
  return code;
}

// Runs `step`, and returns how it ended. `LibraryError` is the library's Error, which names an element.
template <class LibraryError, class Step>
glark_code guarded(glark_error* error, const Step& step) {
  try {
    step();
    return fail(error, GLARK_SUCCESS, "");
  } catch (const LibraryError& bad) {
    if constexpr (requires { bad.element(); }) {
      return fail(error, GLARK_BAD_ARGUMENT, bad.what(), static_cast<int>(bad.element()), bad.index());
    }
    return fail(error, GLARK_BAD_ARGUMENT, bad.what());
  } catch (const ArgumentError& bad) {
    return fail(error, GLARK_BAD_ARGUMENT, bad.what());
  } catch (const std::bad_alloc&) {
    return fail(error, GLARK_OUT_OF_MEMORY, "glark: there is not enough memory; use less data");
  } catch (const std::exception& other) {
    return fail(error, GLARK_INTERNAL_ERROR, other.what());
  }
}

}  // namespace glark::c
