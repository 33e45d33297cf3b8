// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What a library with all mutants needs at run time. It is never part of the real library: build.py copies it.
//   GLARK_MUTANT          number of the mutant that is chosen; without it the library is right
//   GLARK_MUTANT_REACHED  a file of one byte for each mutant: 1 if it was reached, 2 if its shader did not compile. The
//                         file is mapped, so it is complete however the process ends
#pragma once
#if __cplusplus >= 202002L  // CMake tries the compiler before it knows the standard

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <type_traits>
#include <utility>

namespace glark_mutants {

struct State {
  bool started;
  bool chose_text;  // the chosen mutant is part of the text that was last handed to GL
  int chosen;
  unsigned char* reached;
};

inline State state;
inline unsigned char nowhere[GLARK_MUTANT_COUNT];

inline void start() {
  state.started = true;
  const char* const chosen = std::getenv("GLARK_MUTANT");
  state.chosen = chosen != nullptr ? std::atoi(chosen) : -1;
  state.reached = nowhere;
  const char* const path = std::getenv("GLARK_MUTANT_REACHED");
  const int file = path != nullptr ? open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0644) : -1;
  if (file < 0) return;
  if (ftruncate(file, sizeof(nowhere)) == 0) {
    void* const mapped = mmap(nullptr, sizeof(nowhere), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (mapped != MAP_FAILED) state.reached = static_cast<unsigned char*>(mapped);
  }
  close(file);
}

inline bool reach(int mutant) {
  if (!state.started) start();
  if (state.reached[mutant] == 0) state.reached[mutant] = 1;
  return mutant == state.chosen;
}

// Constant expressions are evaluated by the compiler, which chooses no mutant.
constexpr bool on(int mutant) { return !std::is_constant_evaluated() && reach(mutant); }

// An argument at another argument's place: a mutant exists only if both have the same type.
template <class Wanted, class Given>
  requires std::is_same_v<std::remove_cvref_t<Wanted>, std::remove_cvref_t<Given>>
constexpr Given&& same_type(Given&& given) {
  return std::forward<Given>(given);
}

// Makes the choices in the text of a shader: \1 number \2 mutant \3 original \4.
inline std::string choose(const std::string& text, std::size_t& at, char end) {
  std::string result;
  for (; at < text.size() && text[at] != end; ++at) {
    if (text[at] != '\1') {
      result += text[at];
      continue;
    }
    const int mutant = std::atoi(text.c_str() + at + 1);
    at = text.find('\2', at) + 1;
    const std::string other = choose(text, at, '\3');
    ++at;
    const std::string original = choose(text, at, '\4');
    const bool chosen = reach(mutant);
    state.chose_text = state.chose_text || chosen;
    result += chosen ? other : original;
  }
  return result;
}

inline std::string text_of_shader(const std::string& text) {
  std::size_t at = 0;
  state.chose_text = false;
  return choose(text, at, '\0');
}

inline void shader_compiled(bool compiled) {
  if (!compiled && state.chose_text) state.reached[state.chosen] = 2;
}

}  // namespace glark_mutants
#endif
