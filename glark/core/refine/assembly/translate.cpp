// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/assembly/translate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "glark/core/refine/assembly/parser.h"

namespace glark::refine::assembly {
namespace {

// A name of the assembly program as part of a GLSL name.
std::string readable(char kind, std::size_t number, std::string_view name) {
  std::string text = fmt::format("{}{}_", kind, number);
  std::copy_if(name.begin(), name.end(), std::back_inserter(text),
               [](unsigned char c) { return std::isalnum(c) != 0; });
  return text.back() == '_' ? text + "register" : text;
}

bool is_constant(const Vector& vector) {
  return vector.bank == Bank::none && vector.text.find('_') == std::string::npos;
}

// Returns whether the array is a piece of one bank, in its order.
bool is_piece_of_bank(const std::vector<Vector>& array) {
  for (std::size_t i = 0; i < array.size(); ++i) {
    if (array[i].bank == Bank::none || array[i].bank != array[0].bank ||
        array[i].index != array[0].index + static_cast<int>(i)) {
      return false;
    }
  }
  return !array.empty();
}

class Generator {
 public:
  Generator(const Program& program, bool clip_planes) : program_(program), clip_planes_(clip_planes) {}

  Translation generate() {
    find_uses();
    translation_.source = declarations() + "\nvoid main() {\n" + registers() + body() + "}\n";
    translation_.matrices.assign(matrices_.begin(), matrices_.end());
    translation_.ok = true;
    return translation_;
  }

 private:
  void find_uses() {
    for (const Instruction& instruction : program_.instructions) {
      for (const Source& source : instruction.sources) {
        if (source.kind == Source::Kind::vector) use(source.vector);
      }
    }
    for (const std::vector<Vector>& array : program_.arrays) {
      for (const Vector& vector : array) use(vector);
    }
  }

  void use(const Vector& vector) {
    if (vector.generic >= 0) generics_.insert(vector.generic);
    if (vector.matrix >= 0) matrices_.insert(vector.matrix);
    if (vector.bank == Bank::none) return;
    ParameterRange& range = range_of(vector.bank);
    const int first = range.count == 0 ? vector.index : std::min(range.first, vector.index);
    const int last = range.count == 0 ? vector.index : std::max(range.first + range.count - 1, vector.index);
    range = {first, last - first + 1};
  }

  ParameterRange& range_of(Bank bank) {
    return bank == Bank::environment ? translation_.environment : translation_.local;
  }

  // Multipass applications test depth for equality: programs that compute the position in the same way must agree.
  std::string declarations() {
    std::string text = "#version 330 compatibility\ninvariant gl_Position;\n";
    for (const int generic : generics_) {
      text += fmt::format("layout(location = {}) in vec4 assembly_attribute_{};\n", generic, generic);
    }
    for (const Bank bank : {Bank::environment, Bank::local}) {
      if (range_of(bank).count > 0) text += fmt::format("uniform vec4 {}[{}];\n", name_of(bank), range_of(bank).count);
    }
    for (const int matrix : matrices_) text += fmt::format("uniform mat4 {}{};\n", matrix_uniform_prefix, matrix);
    const bool calls =
        std::any_of(program_.instructions.begin(), program_.instructions.end(),
                    [](const Instruction& instruction) { return instruction.row->glsl.starts_with("assembly_"); });
    if (calls) text += instruction_functions;
    for (std::size_t i = 0; i < program_.arrays.size(); ++i) {
      if (std::all_of(program_.arrays[i].begin(), program_.arrays[i].end(), is_constant)) text += "const " + array(i);
    }
    return text;
  }

  static const char* name_of(Bank bank) { return bank == Bank::environment ? environment_uniform : local_uniform; }

  std::string array(std::size_t number) {
    const std::vector<Vector>& vectors = program_.arrays[number];
    std::string text = fmt::format("vec4 assembly_array_{}[{}] = vec4[{}](", number, vectors.size(), vectors.size());
    for (std::size_t i = 0; i < vectors.size(); ++i) text += (i > 0 ? ", " : "") + text_of(vectors[i]);
    return text + ");\n";
  }

  std::string registers() {
    std::string text;
    for (std::size_t i = 0; i < program_.arrays.size(); ++i) {
      const std::vector<Vector>& vectors = program_.arrays[i];
      const bool constant = std::all_of(vectors.begin(), vectors.end(), is_constant);
      if (!constant && !is_piece_of_bank(vectors)) text += "  " + array(i);
    }
    for (std::size_t i = 0; i < program_.addresses.size(); ++i) text += "  int " + address(i) + " = 0;\n";
    for (std::size_t i = 0; i < program_.temporaries.size(); ++i) text += "  vec4 " + temporary(i) + " = vec4(0.0);\n";
    return text;
  }

  // Mesa gives 0 to the components that a program does not write.
  std::string unwritten_components() const {
    std::map<std::string, std::set<char>> written;
    for (const Instruction& instruction : program_.instructions) {
      const Target& target = instruction.target;
      if (target.kind != Target::Kind::output || target.scalar) continue;
      written[target.output].insert(target.mask.begin(), target.mask.end());
    }
    std::string text;
    for (const auto& [output, components] : written) {
      if (components.size() < 4) text += "  " + output + " = vec4(0.0);\n";
    }
    return text;
  }

  std::string address(std::size_t number) const { return readable('a', number, program_.addresses[number]); }
  std::string temporary(std::size_t number) const { return readable('t', number, program_.temporaries[number]); }

  // The position is the one of the fixed function. Clip planes are in eye space. Mesa clips by them without the option,
  // too: it takes them to the space of the position.
  std::string body() {
    std::string text = unwritten_components();
    if (program_.position_invariant) text += "  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n";
    for (const Instruction& instruction : program_.instructions) text += "  " + statement(instruction) + "\n";
    if (clip_planes_) {
      text += program_.position_invariant ? "  gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;\n"
                                          : "  gl_ClipVertex = gl_ProjectionMatrixInverse * gl_Position;\n";
    }
    return text;
  }

  std::string statement(const Instruction& instruction) {
    const Target& target = instruction.target;
    std::string value;
    for (std::size_t i = 0; i < instruction.row->glsl.size(); ++i) {
      const char letter = instruction.row->glsl[i];
      if (letter == '@') {
        value += operand(instruction.sources[static_cast<std::size_t>(instruction.row->glsl[++i] - '0')]);
      } else {
        value += letter;
      }
    }
    const auto number = static_cast<std::size_t>(target.number);
    if (target.kind == Target::Kind::address) return address(number) + " = " + value + ";";
    if (target.scalar) {
      return target.mask.starts_with('x') ? target.output + " = (" + value + ").x;" : std::string("// no component");
    }
    const std::string name = target.kind == Target::Kind::output ? target.output : temporary(number);
    if (target.mask == "xyzw") return name + " = " + value + ";";
    return fmt::format("{}.{} = ({}).{};", name, target.mask, value, target.mask);
  }

  std::string operand(const Source& source) {
    const std::string vector = source.kind == Source::Kind::temporary
                                   ? temporary(static_cast<std::size_t>(source.number))
                               : source.kind == Source::Kind::element ? element(source)
                                                                      : text_of(source.vector);
    const Swizzle& swizzle = source.swizzle;
    const std::string_view letters(swizzle.component.data(), swizzle.component.size());
    const bool all = std::all_of(swizzle.negated.begin(), swizzle.negated.end(), [](bool negated) { return negated; });
    const bool any = std::any_of(swizzle.negated.begin(), swizzle.negated.end(), [](bool negated) { return negated; });
    if (letters.find_first_of("01") == std::string_view::npos && any == all) {
      const std::string swizzled = letters == "xyzw" ? vector : fmt::format("{}.{}", vector, letters);
      return all ? "(-" + swizzled + ")" : swizzled;
    }
    std::string text;
    for (std::size_t i = 0; i < letters.size(); ++i) {
      const bool constant = letters[i] == '0' || letters[i] == '1';
      text += i > 0 ? ", " : "";
      text += swizzle.negated[i] ? "-" : "";
      text += constant ? std::string(1, letters[i]) + ".0" : fmt::format("{}.{}", vector, letters[i]);
    }
    return "vec4(" + text + ")";
  }

  std::string element(const Source& source) {
    const auto number = static_cast<std::size_t>(source.number);
    const std::vector<Vector>& array = program_.arrays[number];
    const bool piece = is_piece_of_bank(array);
    const int offset = source.offset + (piece ? array[0].index - range_of(array[0].bank).first : 0);
    const std::string name = piece ? name_of(array[0].bank) : fmt::format("assembly_array_{}", number);
    return fmt::format("{}[{} + {}]", name, address(static_cast<std::size_t>(source.address)), offset);
  }

  std::string text_of(const Vector& vector) {
    if (vector.bank == Bank::none) return vector.text;
    return fmt::format("{}[{}]", name_of(vector.bank), vector.index - range_of(vector.bank).first);
  }

  const Program& program_;
  const bool clip_planes_;
  Translation translation_;
  std::set<int> generics_;
  std::set<int> matrices_;
};

}  // namespace

Translation translate(std::string_view program, bool clip_planes) {
  const Parsed parsed = parse(program);
  if (!parsed.ok) {
    Translation failed;
    failed.error = parsed.error;
    return failed;
  }
  return Generator(parsed.program, clip_planes).generate();
}

}  // namespace glark::refine::assembly
