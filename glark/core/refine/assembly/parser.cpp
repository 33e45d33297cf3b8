// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Based on: ARB_vertex_program, section 2.14.2 (the grammar).
#include "glark/core/refine/assembly/parser.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "glark/core/refine/assembly/cursor.h"

namespace glark::refine::assembly {
namespace {

struct Temporary {
  int number = 0;
};
struct Address {
  int number = 0;
};
struct Parameters {
  std::vector<Vector> vectors;
  bool array = false;
  int number = -1;  // among the arrays with relative addressing; -1: not addressed so yet
};
using Symbol = std::variant<Temporary, Address, Vector, Parameters, Output>;

class Parser {
 public:
  explicit Parser(std::string_view text) : at_(text) {}

  Program parse() {
    at_.expect("!!ARBvp1.0");
    while (!at_.accept("END")) statement();
    return std::move(program_);
  }

 private:
  void statement() {
    const std::string word = at_.name();
    if (word == "OPTION") {
      option();
    } else if (word == "ATTRIB") {
      attribute();
    } else if (word == "PARAM") {
      parameter();
    } else if (word == "TEMP" || word == "ADDRESS") {
      registers(word == "ADDRESS");
    } else if (word == "OUTPUT") {
      output();
    } else if (word == "ALIAS") {
      alias();
    } else {
      instruction(word);
    }
    at_.expect(";");
  }

  void option() {
    const std::string name = at_.name();
    if (name != "ARB_position_invariant") at_.fail(fmt::format("glark does not know the option {}", name));
    program_.position_invariant = true;
  }

  void declare(const std::string& name, Symbol symbol) {
    if (!symbols_.try_emplace(name, std::move(symbol)).second) at_.fail(fmt::format("'{}' is declared twice", name));
  }

  void attribute() {
    const std::string name = at_.name();
    at_.expect("=");
    const std::optional<Vector> vector = vertex_attribute(at_.path());
    if (!vector) at_.fail("glark does not know this attribute");
    declare(name, *vector);
  }

  void output() {
    const std::string name = at_.name();
    at_.expect("=");
    const std::optional<Output> output = result(at_.path());
    if (!output) at_.fail("glark does not know this result");
    declare(name, *output);
  }

  void registers(bool addresses) {
    std::vector<std::string>& names = addresses ? program_.addresses : program_.temporaries;
    do {
      const std::string name = at_.name();
      const int number = static_cast<int>(names.size());
      addresses ? declare(name, Address{number}) : declare(name, Temporary{number});
      names.push_back(name);
    } while (at_.accept(","));
  }

  void alias() {
    const std::string name = at_.name();
    at_.expect("=");
    const Symbol* const symbol = find(at_.name());
    if (symbol == nullptr) at_.fail("the name after ALIAS is unknown");
    declare(name, Symbol(*symbol));
  }

  void parameter() {
    const std::string name = at_.name();
    Parameters parameters;
    if (at_.accept("[")) {
      parameters.array = true;
      if (!at_.accept("]")) {
        at_.integer();
        at_.expect("]");
      }
    }
    at_.expect("=");
    if (!parameters.array) {
      parameters.vectors = parameter_item();
    } else {
      at_.expect("{");
      do {
        const std::vector<Vector> item = parameter_item();
        parameters.vectors.insert(parameters.vectors.end(), item.begin(), item.end());
      } while (at_.accept(","));
      at_.expect("}");
    }
    declare(name, std::move(parameters));
  }

  // A constant, a binding, or all vectors of a binding with rows or a range.
  std::vector<Vector> parameter_item() {
    if (at_.peek().kind != WordKind::name) return {at_.constant()};
    std::vector<Vector> vectors = assembly::parameters(at_.path());
    if (vectors.empty()) at_.fail("glark does not know this parameter");
    return vectors;
  }

  const Symbol* find(const std::string& name) const {
    const auto found = symbols_.find(name);
    return found != symbols_.end() ? &found->second : nullptr;
  }

  void instruction(const std::string& opcode) {
    Instruction instruction;
    instruction.row = find_instruction(opcode);
    if (instruction.row == nullptr) at_.fail(fmt::format("glark does not know the instruction {}", opcode));
    instruction.target = target();
    for (int i = 0; i < instruction.row->sources; ++i) {
      at_.expect(",");
      instruction.sources.push_back(source());
    }
    if (opcode == "SWZ") instruction.sources[0].swizzle = extended_swizzle();
    program_.instructions.push_back(std::move(instruction));
  }

  Target target() {
    const std::vector<PathPart> path = at_.path();
    Target target;
    std::size_t used = 1;
    if (const Symbol* const symbol = find(path[0].name)) {
      name_target(*symbol, target);
    } else {
      used = path.size();
      const bool bound = path[0].name == "result" && path.size() > 1;
      std::optional<Output> output = bound ? result(path) : std::nullopt;
      if (!output && bound) output = result(Path(path).first(--used));
      if (!output) at_.fail(fmt::format("'{}' cannot be written", path[0].name));
      name_target(*output, target);
    }
    if (used + 1 < path.size()) at_.fail("this is no write mask");
    if (used < path.size()) target.mask = component_letters(path.back().name);
    if (target.mask.empty()) at_.fail(fmt::format("'{}' is no write mask", path.back().name));
    return target;
  }

  void name_target(const Symbol& symbol, Target& target) const {
    if (const auto* const temporary = std::get_if<Temporary>(&symbol)) {
      target.number = temporary->number;
    } else if (const auto* const address = std::get_if<Address>(&symbol)) {
      target.kind = Target::Kind::address;
      target.number = address->number;
    } else if (const auto* const output = std::get_if<Output>(&symbol)) {
      target.kind = Target::Kind::output;
      target.output = output->name;
      target.scalar = output->scalar;
    } else {
      at_.fail("an attribute or a parameter cannot be written");
    }
  }

  Source source() {
    const bool negated = at_.sign();
    Source source;
    std::string letters = "xyzw";
    const std::string first = at_.peek().text;
    if (at_.peek().kind != WordKind::name) {
      source.vector = at_.constant();
    } else if (find(first) != nullptr) {
      named_source(at_.name(), source);
      if (at_.accept(".")) letters = component_letters(at_.name());
    } else {
      letters = bound_source(source);
    }
    if (letters.size() == 1) letters.assign(4, letters[0]);
    if (letters.size() != 4) at_.fail("this is no swizzle");
    for (std::size_t i = 0; i < 4; ++i) source.swizzle.component[i] = letters[i];
    source.swizzle.negated.fill(negated);
    return source;
  }

  void named_source(const std::string& name, Source& source) {
    Symbol& symbol = symbols_.at(name);
    if (const auto* const temporary = std::get_if<Temporary>(&symbol)) {
      source.kind = Source::Kind::temporary;
      source.number = temporary->number;
    } else if (const auto* const vector = std::get_if<Vector>(&symbol)) {
      source.vector = *vector;
    } else if (auto* const parameters = std::get_if<Parameters>(&symbol)) {
      parameters->array ? element(*parameters, source) : void(source.vector = parameters->vectors.at(0));
    } else {
      at_.fail(fmt::format("'{}' cannot be read", name));
    }
  }

  // "[3]" or "[A0.x + 3]".
  void element(Parameters& parameters, Source& source) {
    at_.expect("[");
    if (at_.at_number()) {
      const int index = at_.integer();
      if (index >= static_cast<int>(parameters.vectors.size())) at_.fail("the array has no such element");
      source.vector = parameters.vectors[static_cast<std::size_t>(index)];
    } else {
      const Symbol* const symbol = find(at_.name());
      const auto* const address = symbol != nullptr ? std::get_if<Address>(symbol) : nullptr;
      if (address == nullptr) at_.fail("an address register is expected");
      at_.expect(".");
      at_.expect("x");
      const bool added = at_.peek().is("+") || at_.peek().is("-");
      const bool below = at_.sign();
      const int offset = added ? at_.integer() : 0;
      source.kind = Source::Kind::element;
      source.number = number_of(parameters);
      source.address = address->number;
      source.offset = below ? -offset : offset;
    }
    at_.expect("]");
  }

  // The number of an array with relative addressing.
  int number_of(Parameters& parameters) {
    if (parameters.number < 0) {
      parameters.number = static_cast<int>(program_.arrays.size());
      program_.arrays.push_back(parameters.vectors);
    }
    return parameters.number;
  }

  // Returns the swizzle, which is the last part of the path unless the whole path is a binding.
  std::string bound_source(Source& source) {
    const std::vector<PathPart> path = at_.path();
    for (const std::size_t length : {path.size(), path.size() - 1}) {
      const Path binding = Path(path).first(length);
      if (length == 0) break;
      const std::optional<Vector> attribute = path[0].name == "vertex" ? vertex_attribute(binding) : std::nullopt;
      const std::vector<Vector> vectors = attribute ? std::vector<Vector>{*attribute} : assembly::parameters(binding);
      if (vectors.size() != 1) continue;
      source.vector = vectors[0];
      return length == path.size() ? "xyzw" : component_letters(path.back().name);
    }
    at_.fail(fmt::format("glark does not know '{}'", path[0].name));
  }

  // ", x, -y, 0, 1"
  Swizzle extended_swizzle() {
    Swizzle swizzle;
    for (std::size_t i = 0; i < 4; ++i) {
      at_.expect(",");
      swizzle.negated[i] = at_.sign();
      const Word word = at_.take();
      const std::string letters = word.kind == WordKind::number ? word.text : component_letters(word.text);
      if (letters.size() != 1 || std::string_view("xyzw01").find(letters[0]) == std::string_view::npos) {
        at_.fail(fmt::format("'{}' is no component", word.text));
      }
      swizzle.component[i] = letters[0];
    }
    return swizzle;
  }

  Cursor at_;
  Program program_;
  std::map<std::string, Symbol> symbols_;  // a name from ALIAS has a copy of the symbol
};

}  // namespace

Parsed parse(std::string_view text) {
  try {
    return {true, Parser(text).parse(), {}};
  } catch (const SyntaxError& error) {
    return {false, {}, error.what()};
  }
}

}  // namespace glark::refine::assembly
