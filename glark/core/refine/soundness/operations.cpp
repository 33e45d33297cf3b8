// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/soundness/operations.h"

#include <algorithm>
#include <iterator>

namespace glark::refine {
namespace {

struct Row {
  std::string_view words;
  Operation operation;
};
constexpr bool each = true;
constexpr bool all = false;

constexpr Row rows[] = {
    {"Negate value", {Effect::linear, each, {}}},
    {"add", {Effect::linear, each, {}}},
    {"subtract", {Effect::linear, each, {}}},
    {"Pre-Increment", {Effect::linear, each, {}}},
    {"Pre-Decrement", {Effect::linear, each, {}}},
    {"Post-Increment", {Effect::linear, each, {}}},
    {"Post-Decrement", {Effect::linear, each, {}}},
    {"copy object", {Effect::linear, each, {}}},
    {"radians", {Effect::linear, each, {}}},
    {"degrees", {Effect::linear, each, {}}},
    {"transpose", {Effect::linear, all, {}}},
    // Truth values keep the variation that their comparison gave them.
    {"Negate conditional", {Effect::linear, each, {}}},
    {"logical-and", {Effect::linear, all, {}}},
    {"logical-or", {Effect::linear, all, {}}},
    {"logical-xor", {Effect::linear, all, {}}},
    {"any", {Effect::linear, all, {}}},
    {"all", {Effect::linear, all, {}}},

    {"component-wise multiply", {Effect::product, each, {}}},
    {"vector-scale", {Effect::product, each, {}}},
    {"matrix-scale", {Effect::product, all, {}}},
    {"vector-times-matrix", {Effect::product, all, {}}},
    {"matrix-times-vector", {Effect::product, all, {}}},
    {"matrix-multiply", {Effect::product, all, {}}},
    {"outer product", {Effect::product, all, {}}},
    {"dot-product", {Effect::product, all, {}}},
    {"cross-product", {Effect::product, all, {}}},
    {"fma", {Effect::fused, each, {}}},
    {"divide", {Effect::quotient, each, {}}},
    {"mix", {Effect::mixture, each, {}}},

    {"sine", {Effect::continuous, each, {}}},
    {"cosine", {Effect::continuous, each, {}}},
    {"tangent", {Effect::continuous, each, {}}},
    {"arc sine", {Effect::continuous, each, {}}},
    {"arc cosine", {Effect::continuous, each, {}}},
    {"arc tangent", {Effect::continuous, each, {}}},
    {"hyp. sine", {Effect::continuous, each, {}}},
    {"hyp. cosine", {Effect::continuous, each, {}}},
    {"hyp. tangent", {Effect::continuous, each, {}}},
    {"arc hyp. sine", {Effect::continuous, each, {}}},
    {"arc hyp. cosine", {Effect::continuous, each, {}}},
    {"arc hyp. tangent", {Effect::continuous, each, {}}},
    {"pow", {Effect::continuous, each, {}}},
    {"exp", {Effect::continuous, each, {}}},
    {"log", {Effect::continuous, each, {}}},
    {"exp2", {Effect::continuous, each, {}}},
    {"log2", {Effect::continuous, each, {}}},
    {"sqrt", {Effect::continuous, each, {}}},
    {"inverse sqrt", {Effect::continuous, each, {}}},
    {"Absolute value", {Effect::continuous, each, {}}},
    {"min", {Effect::continuous, each, {}}},
    {"max", {Effect::continuous, each, {}}},
    {"clamp", {Effect::continuous, each, {}}},
    {"smoothstep", {Effect::continuous, each, {}}},
    {"length", {Effect::continuous, all, {}}},
    {"distance", {Effect::continuous, all, {}}},
    {"normalize", {Effect::continuous, all, {}}},
    {"reflect", {Effect::continuous, all, {}}},
    {"refract", {Effect::continuous, all, {}}},
    {"determinant", {Effect::continuous, all, {}}},
    {"inverse", {Effect::continuous, all, {}}},
    {"noise", {Effect::continuous, all, {}}},

    {"Compare Less Than", {Effect::switched, each, "comparison"}},
    {"Compare Greater Than", {Effect::switched, each, "comparison"}},
    {"Compare Less Than or Equal", {Effect::switched, each, "comparison"}},
    {"Compare Greater Than or Equal", {Effect::switched, each, "comparison"}},
    {"Sign", {Effect::switched, each, "sign()"}},
    {"step", {Effect::switched, each, "step()"}},
    {"face-forward", {Effect::switched, all, "faceforward()"}},
    {"isnan", {Effect::switched, each, "isnan()"}},
    {"isinf", {Effect::switched, each, "isinf()"}},

    // A float that is compared for equality is a name.
    {"Compare Equal", {Effect::undefined, all, "test for equality"}},
    {"Compare Not Equal", {Effect::undefined, all, "test for equality"}},
    {"Equal", {Effect::undefined, each, "test for equality"}},
    {"NotEqual", {Effect::undefined, each, "test for equality"}},
    {"Floor", {Effect::undefined, each, "floor()"}},
    {"trunc", {Effect::undefined, each, "trunc()"}},
    {"round", {Effect::undefined, each, "round()"}},
    {"roundEven", {Effect::undefined, each, "roundEven()"}},
    {"Ceiling", {Effect::undefined, each, "ceil()"}},
    {"Fraction", {Effect::undefined, each, "fract()"}},
    {"mod", {Effect::undefined, each, "mod()"}},
    {"modf", {Effect::undefined, each, "modf()"}},
};

struct AssignmentRow {
  std::string_view assignment;
  std::string_view operation;
};
constexpr AssignmentRow assignments[] = {
    {"move second child to first child", ""},
    {"add second child into first child", "add"},
    {"subtract second child into first child", "subtract"},
    {"multiply second child into first child", "component-wise multiply"},
    {"vector scale second child into first child", "vector-scale"},
    {"matrix scale second child into first child", "matrix-scale"},
    {"matrix mult second child into first child", "matrix-multiply"},
    {"divide second child into first child", "divide"},
    {"mod second child into first child", "mod"},
    {"and second child into first child", "bitwise and"},
    {"or second child into first child", "inclusive-or"},
    {"exclusive or second child into first child", "exclusive-or"},
    {"left shift second child into first child", "left-shift"},
    {"right shift second child into first child", "right-shift"},
};

}  // namespace

Operation operation(std::string_view words) {
  const auto* const found =
      std::find_if(std::begin(rows), std::end(rows), [&](const Row& row) { return row.words == words; });
  return found == std::end(rows) ? Operation{} : found->operation;
}

std::optional<std::string_view> within_assignment(std::string_view words) {
  const auto* const found = std::find_if(std::begin(assignments), std::end(assignments),
                                         [&](const AssignmentRow& row) { return row.assignment == words; });
  if (found == std::end(assignments)) return std::nullopt;
  return found->operation;
}

}  // namespace glark::refine
