// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The vocabulary of random programs is tables of rows: a command that changes state, or a path of a draw.
#pragma once

#include <array>
#include <tuple>
#include <type_traits>
#include <vector>

#include "conformance/random/world.h"

namespace glark::conformance {

// Which worlds have the row. `shader`: those with programs. `within_begin`: those with the fixed function, where the command
// may also be called between Begin and End.
enum class Where { everywhere, shader, stage, uniforms, fixed, within_begin };

struct Row {
  const char* name;  // the command of GL, or what it does
  const char* family;
  Where where;
  void (*make)(World& w);
  Apis apis = every_api;
  int version = 0;           // the version of desktop GL that has the command, if it is more than 4.3
  bool keeps_affine = true;  // what the vertex stage gives stays affine in its inputs
  bool is_listed = false;    // a display list compiles it
};

struct RandomPath {
  const char* name;
  Where where;
  void (*draw)(World& w);
  Apis apis = every_api;
  int version = 0;
  bool counts_freely = false;  // the number of its triangles does not follow from the depth
};

using Rows = std::vector<Row>;
Rows array_rows();
Rows client_array_rows();
Rows current_value_rows();
Rows uniform_rows();
Rows program_rows();
Rows raster_rows();
Rows refinement_rows();
Rows matrix_rows();
Rows light_rows();
Rows fixed_texture_rows();
Rows list_rows();
std::vector<RandomPath> stage_paths();
std::vector<RandomPath> fixed_paths();

// All of them, in a fixed order.
const Rows& all_rows();
const std::vector<RandomPath>& all_random_paths();
bool is_there(const World& w, const Row& row);
bool is_there(const World& w, const RandomPath& path);

// How a command takes its values.
enum class Scale { plain, normalized };

template <typename Pointer>
struct ArgumentsOf;
template <typename... All>
struct ArgumentsOf<void (*)(All...)> {
  using Types = std::tuple<All...>;
  static constexpr std::size_t count = sizeof...(All);
};
template <auto Command>
using CommandArguments = ArgumentsOf<std::remove_cvref_t<decltype(std::declval<GladGLContext>().*Command)>>;

// One argument. An array has as many values as the longest command reads.
template <typename Argument, Scale scale>
Argument next_argument(Values& values) {
  using Element = std::remove_const_t<std::remove_pointer_t<Argument>>;
  const auto next = [&values] {
    return scale == Scale::normalized ? values.normalized<Element>() : values.plain<Element>();
  };
  if constexpr (std::is_pointer_v<Argument>) {
    static std::array<Element, 16> all;
    for (Element& each : all) each = next();
    return all.data();
  } else {
    return next();
  }
}

// Calls the command with `leading` and then with random values.
template <auto Command, Scale scale = Scale::plain, typename... Leading>
void call(World& w, Leading... leading) {
  using Types = typename CommandArguments<Command>::Types;
  constexpr std::size_t first = sizeof...(Leading);
  constexpr std::size_t rest = CommandArguments<Command>::count - first;
  if (gl.*Command == nullptr) return;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    const std::tuple<std::tuple_element_t<first + I, Types>...> values{
        next_argument<std::tuple_element_t<first + I, Types>, scale>(w.values)...};
    (gl.*Command)(leading..., std::get<I>(values)...);
  }
  (std::make_index_sequence<rest>{});
}

}  // namespace glark::conformance
