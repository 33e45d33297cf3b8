// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The words of a line, read one after the other.
#pragma once

#include <glark/edit.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace glark::edit {

// A word that cannot be used, without the right form.
class BadWord : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// `name` is how the form calls the word. The functions throw BadWord for a word that is missing or out of range.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  bool at_end();
  std::string_view word(std::string_view name);
  std::string file(std::string_view name);  // a word, or what is between quotes
  double number(std::string_view name);
  double above_zero(std::string_view name);
  double up_to_one(std::string_view name);                     // 0 to 1
  std::size_t whole(std::string_view name, std::size_t most);  // 0 to `most`
  Vector vector(std::string_view name);
  Ball ball();

 private:
  std::string_view rest_;
};

}  // namespace glark::edit
