// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "glark/core/refine/epilogue/epilogue.h"

namespace glark::refine {
namespace {

constexpr std::array<std::string_view, 5> constructors = {"", "float", "vec2", "vec3", "vec4"};

// The same from the storage block: vec3(glark_w(3), glark_w(4), glark_w(5)).
std::string stored_words_expression(int first, int count) {
  std::string parts;
  for (int word = first; word < first + count; ++word) {
    parts += (word == first ? "@w(" : ", @w(") + std::to_string(word) + ")";
  }
  return count == 1 ? parts : std::string(constructors[count]) + "(" + parts + ")";
}

// Words [first, first + count) of the coarse record as a float or vector expression: vec3(glark_chunk0.w,
// glark_chunk1.xy).
std::string words_expression(const EpiloguePlan& plan, int first, int count) {
  static constexpr std::string_view components = "xyzw";
  if (plan.stored) return stored_words_expression(first, count);
  std::string parts;
  int part_count = 0;
  for (int word = first; word < first + count;) {
    const int in_chunk = word % 4;
    const int taken = std::min(4 - in_chunk, first + count - word);
    parts += std::string(part_count++ == 0 ? "" : ", ") + chunk_input_prefix + std::to_string(word / 4);
    if (taken < 4) parts += "." + std::string(components.substr(in_chunk, taken));
    word += taken;
  }
  return part_count == 1 ? parts : std::string(constructors[count]) + "(" + parts + ")";
}

std::string column_expression(const EpiloguePlan& plan, Scalar scalar, int first, int rows) {
  if (scalar == Scalar::float32) return words_expression(plan, first, rows);
  if (scalar == Scalar::int32) return "floatBitsToInt(" + words_expression(plan, first, rows) + ")";
  if (scalar == Scalar::uint32) return "floatBitsToUint(" + words_expression(plan, first, rows) + ")";
  if (scalar == Scalar::boolean) return "floatBitsToInt(" + words_expression(plan, first, rows) + ")";
  std::string doubles;
  for (int row = 0; row < rows; ++row) {
    doubles += (row == 0 ? "" : ", ");
    doubles += "packDouble2x32(floatBitsToUint(" + words_expression(plan, first + 2 * row, 2) + "))";
  }
  return rows == 1 ? doubles : "dvec" + std::to_string(rows) + "(" + doubles + ")";
}

std::string element_name(const InputVariable& input, int element) {
  return input.field.is_array ? input.global + "[" + std::to_string(element) + "]" : input.global;
}

// At points, each vertex is a triangle. With a placement, instances count over all bins. The first one of a bin is its base instance, which GLSL ES cannot
// read.
std::string storage_declarations(const EpiloguePlan& plan) {
  const std::string layout = plan.version.es ? "std430, binding = " + std::to_string(records_binding) : "std430";
  const bool numbered = plan.placed && plan.version.es;
  const std::string instance = plan.at_points ? "gl_VertexID"
                               : numbered     ? std::string("int(") + instance_input + ")"
                               : plan.placed  ? "(gl_InstanceID + gl_BaseInstanceARB)"
                                              : "gl_InstanceID";
  return (numbered ? std::string("in highp uint ") + instance_input + ";\n" : "") + "layout(" + layout +
         ") readonly buffer " + records_block + " { float " + words_member + "[]; };\nuniform int " +
         first_word_uniform + ";\nint @record;\nvoid @find_record() { @record = " + first_word_uniform + " + " +
         instance + " * " + std::to_string(3 * plan.corner_words) + "; }\nfloat @w(int word) { return " + words_member +
         "[@record + word]; }\n";
}

}  // namespace

std::string chunk_declarations(const EpiloguePlan& plan) {
  const std::string storage = plan.version.has_in_out() ? "in" : "attribute";
  const std::string precision = plan.version.es ? " highp" : "";
  std::string text;
  if (!plan.at_corner) text += storage + precision + " vec2 " + lattice_input + ";\n";
  if (plan.placed && !plan.at_corner) text += storage + precision + " vec4 " + patch_input + ";\n";
  if (plan.stored) return text + storage_declarations(plan);
  for (int chunk = 0; chunk < plan.chunk_count; ++chunk) {
    text += storage + precision + " vec4 " + chunk_input_prefix + std::to_string(chunk) + ";\n";
  }
  return text;
}

std::string corner_expression(const EpiloguePlan& plan, const InputVariable& input, int element, int corner) {
  const NumericType& type = *input.type;
  const int column_words = type.words() / type.columns;
  const int first = corner * plan.corner_words + input.field.offset + element * type.words();
  if (type.columns == 1) return column_expression(plan, type.scalar, first, type.rows);
  std::string columns;
  for (int column = 0; column < type.columns; ++column) {
    columns +=
        (column == 0 ? "" : ", ") + column_expression(plan, type.scalar, first + column * column_words, type.rows);
  }
  return std::string(type.name) + "(" + columns + ")";
}

std::string corner_vector(const EpiloguePlan& plan, int offset, int corner, int words) {
  return words_expression(plan, corner * plan.corner_words + offset, words);
}

std::string fill_from_corner(const EpiloguePlan& plan, int corner) {
  std::string text;
  for (const InputVariable& input : plan.inputs) {
    for (int element = 0; element < input.field.array_size; ++element) {
      text += "  " + element_name(input, element) + " = " + corner_expression(plan, input, element, corner) + ";\n";
    }
  }
  return text;
}

std::string fill_by_interpolation(const EpiloguePlan& plan, TypeSet& mixed_types) {
  std::string text;
  for (const InputVariable& input : plan.inputs) {
    if (plan.curved() && &input == position_of(plan)) continue;
    if (plan.traits().curves_normals && &input == normal_of(plan)) continue;
    for (int element = 0; element < input.field.array_size; ++element) {
      text += "  " + element_name(input, element) + " = ";
      if (!input.type->interpolates()) {
        text += corner_expression(plan, input, element, plan.provoking_corner) + ";\n";
        continue;
      }
      mixed_types.insert(std::string(input.type->name));
      text += "@mix(" + corner_expression(plan, input, element, 0) + ", " + corner_expression(plan, input, element, 1) +
              ", " + corner_expression(plan, input, element, 2) + ");\n";
    }
  }
  return text;
}

// On an edge, the weights of the ends are the first two summands, or one of them and the third. The remaining product
// is zero, so the sum is the same in any order of the ends.
std::string mix_functions(const TypeSet& types, bool define) {
  std::string text;
  for (const std::string& type : types) {
    text += type + " @mix(" + type + " a, " + type + " b, " + type + " c)";
    if (!define) {
      text += ";\n";
      continue;
    }
    const bool wide = numeric_type(type)->scalar == Scalar::float64;
    const auto weight = [&](const char* component) {
      return wide ? std::string("double(@weights.") + component + ")" : std::string("@weights.") + component;
    };
    text += " {\n  @precise " + type + " sum = (" + weight("x") + " * a + " + weight("y") + " * b) + " + weight("z") +
            " * c;\n  return sum;\n}\n";
  }
  return text;
}

}  // namespace glark::refine
