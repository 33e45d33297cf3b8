// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/assembly/cursor.h"

#include <fmt/format.h>

#include <charconv>

namespace glark::refine::assembly {

Word Cursor::take() {
  Word word = peek();
  if (word.kind == WordKind::end) fail("the program ends here");
  ++at_;
  return word;
}

bool Cursor::accept(std::string_view word) {
  const bool found = peek().kind != WordKind::end && peek().is(word);
  at_ += found ? 1 : 0;
  return found;
}

void Cursor::expect(std::string_view word) {
  if (!accept(word)) fail(fmt::format("'{}' is expected instead of '{}'", word, peek().text));
}

std::string Cursor::name() {
  if (peek().kind != WordKind::name) fail(fmt::format("a name is expected instead of '{}'", peek().text));
  return take().text;
}

int Cursor::integer() {
  const Word word = take();
  int value = 0;
  const char* const end = word.text.data() + word.text.size();
  const auto [stop, error] = std::from_chars(word.text.data(), end, value);
  if (word.kind != WordKind::number || error != std::errc() || stop != end) {
    fail(fmt::format("an integer is expected instead of '{}'", word.text));
  }
  return value;
}

bool Cursor::sign() {
  if (accept("-")) return true;
  accept("+");
  return false;
}

std::vector<PathPart> Cursor::path() {
  std::vector<PathPart> parts;
  do {
    PathPart part{.name = name()};
    if (accept("[")) {
      part.indexed = true;
      part.first = part.last = integer();
      if (accept("..")) part.last = integer();
      expect("]");
    }
    parts.push_back(std::move(part));
  } while (accept("."));
  return parts;
}

// GLSL reads "1" as an integer.
std::string Cursor::number() {
  const std::string minus = sign() ? "-" : "";
  if (!at_number()) fail(fmt::format("a number is expected instead of '{}'", peek().text));
  const std::string text = take().text;
  return minus + text + (text.find_first_of(".eE") == std::string::npos ? ".0" : "");
}

Vector Cursor::constant() {
  if (!accept("{")) return {.text = fmt::format("vec4({})", number())};
  std::string text;
  int count = 0;
  do {
    text += (count > 0 ? ", " : "") + number();
    ++count;
  } while (accept(","));
  expect("}");
  if (count > 4) fail("a constant has more than four components");
  for (; count < 4; ++count) text += count == 3 ? ", 1.0" : ", 0.0";
  return {.text = fmt::format("vec4({})", text)};
}

void Cursor::fail(std::string_view reason) const { throw SyntaxError(fmt::format("line {}: {}", peek().line, reason)); }

std::string component_letters(std::string_view letters) {
  constexpr std::string_view positions = "xyzw";
  constexpr std::string_view colors = "rgba";
  std::string result;
  for (const char letter : letters) {
    const std::size_t place = positions.find(letter);
    const std::size_t color = colors.find(letter);
    if (place == std::string_view::npos && color == std::string_view::npos) return {};
    result += positions[place != std::string_view::npos ? place : color];
  }
  return result;
}

}  // namespace glark::refine::assembly
