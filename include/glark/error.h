// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The exceptions that the client libraries throw for bad arguments. Each library has its own Error, derived from these.
#ifndef GLARK_ERROR_H
#define GLARK_ERROR_H

#if __cplusplus < 202002L
#error "the C++ headers of glark need C++20: compile with -std=c++20, or include the C headers in glark/c"
#endif

#include <glark/export.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace glark {

// A library cannot use an argument. what() names the library, the element, its value, and the remedy.
class GLARK_EXPORT ArgumentError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

// An error in one element of an argument. `Element` is the library's enumeration of the kinds of elements.
template <class Element>
class GLARK_EXPORT ElementError : public ArgumentError {
 public:
  ElementError(Element element, std::size_t index, const std::string& message)
      : ArgumentError(message), element_(element), index_(index) {}

  Element element() const { return element_; }
  std::size_t index() const { return index_; }  // the index of the element; 0 where there is only one

 private:
  Element element_;
  std::size_t index_;
};

}  // namespace glark

#endif  // GLARK_ERROR_H
