// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/soundness/operations.h"

#include <algorithm>
#include <iterator>

namespace glark::refine {
namespace {

using glslang::TOperator;

struct Row {
  TOperator op;
  Operation operation;
};
constexpr bool each = true;
constexpr bool all = false;

constexpr Row rows[] = {
    {glslang::EOpNegative, {Effect::linear, each, {}}},
    {glslang::EOpAdd, {Effect::linear, each, {}}},
    {glslang::EOpSub, {Effect::linear, each, {}}},
    {glslang::EOpPreIncrement, {Effect::linear, each, {}}},
    {glslang::EOpPreDecrement, {Effect::linear, each, {}}},
    {glslang::EOpPostIncrement, {Effect::linear, each, {}}},
    {glslang::EOpPostDecrement, {Effect::linear, each, {}}},
    {glslang::EOpCopyObject, {Effect::linear, each, {}}},
    {glslang::EOpRadians, {Effect::linear, each, {}}},
    {glslang::EOpDegrees, {Effect::linear, each, {}}},
    {glslang::EOpTranspose, {Effect::linear, all, {}}},
    // Truth values keep the variation that their comparison gave them.
    {glslang::EOpLogicalNot, {Effect::linear, each, {}}},
    {glslang::EOpVectorLogicalNot, {Effect::linear, each, {}}},
    {glslang::EOpLogicalAnd, {Effect::linear, all, {}}},
    {glslang::EOpLogicalOr, {Effect::linear, all, {}}},
    {glslang::EOpLogicalXor, {Effect::linear, all, {}}},
    {glslang::EOpAny, {Effect::linear, all, {}}},
    {glslang::EOpAll, {Effect::linear, all, {}}},

    {glslang::EOpMul, {Effect::product, each, {}}},
    {glslang::EOpVectorTimesScalar, {Effect::product, each, {}}},
    {glslang::EOpMatrixTimesScalar, {Effect::product, all, {}}},
    {glslang::EOpVectorTimesMatrix, {Effect::product, all, {}}},
    {glslang::EOpMatrixTimesVector, {Effect::product, all, {}}},
    {glslang::EOpMatrixTimesMatrix, {Effect::product, all, {}}},
    {glslang::EOpOuterProduct, {Effect::product, all, {}}},
    {glslang::EOpDot, {Effect::product, all, {}}},
    {glslang::EOpCross, {Effect::product, all, {}}},
    {glslang::EOpFma, {Effect::fused, each, {}}},
    {glslang::EOpDiv, {Effect::quotient, each, {}}},
    {glslang::EOpMix, {Effect::mixture, each, {}}},

    {glslang::EOpSin, {Effect::continuous, each, {}}},
    {glslang::EOpCos, {Effect::continuous, each, {}}},
    {glslang::EOpTan, {Effect::continuous, each, {}}},
    {glslang::EOpAsin, {Effect::continuous, each, {}}},
    {glslang::EOpAcos, {Effect::continuous, each, {}}},
    {glslang::EOpAtan, {Effect::continuous, each, {}}},
    {glslang::EOpSinh, {Effect::continuous, each, {}}},
    {glslang::EOpCosh, {Effect::continuous, each, {}}},
    {glslang::EOpTanh, {Effect::continuous, each, {}}},
    {glslang::EOpAsinh, {Effect::continuous, each, {}}},
    {glslang::EOpAcosh, {Effect::continuous, each, {}}},
    {glslang::EOpAtanh, {Effect::continuous, each, {}}},
    {glslang::EOpPow, {Effect::continuous, each, {}}},
    {glslang::EOpExp, {Effect::continuous, each, {}}},
    {glslang::EOpLog, {Effect::continuous, each, {}}},
    {glslang::EOpExp2, {Effect::continuous, each, {}}},
    {glslang::EOpLog2, {Effect::continuous, each, {}}},
    {glslang::EOpSqrt, {Effect::continuous, each, {}}},
    {glslang::EOpInverseSqrt, {Effect::continuous, each, {}}},
    {glslang::EOpAbs, {Effect::continuous, each, {}}},
    {glslang::EOpMin, {Effect::continuous, each, {}}},
    {glslang::EOpMax, {Effect::continuous, each, {}}},
    {glslang::EOpClamp, {Effect::continuous, each, {}}},
    {glslang::EOpSmoothStep, {Effect::continuous, each, {}}},
    {glslang::EOpLength, {Effect::continuous, all, {}}},
    {glslang::EOpDistance, {Effect::continuous, all, {}}},
    {glslang::EOpNormalize, {Effect::continuous, all, {}}},
    {glslang::EOpReflect, {Effect::continuous, all, {}}},
    {glslang::EOpRefract, {Effect::continuous, all, {}}},
    {glslang::EOpDeterminant, {Effect::continuous, all, {}}},
    {glslang::EOpMatrixInverse, {Effect::continuous, all, {}}},
    {glslang::EOpNoise, {Effect::continuous, all, {}}},

    {glslang::EOpLessThan, {Effect::switched, each, "comparison"}},
    {glslang::EOpGreaterThan, {Effect::switched, each, "comparison"}},
    {glslang::EOpLessThanEqual, {Effect::switched, each, "comparison"}},
    {glslang::EOpGreaterThanEqual, {Effect::switched, each, "comparison"}},
    {glslang::EOpSign, {Effect::switched, each, "sign()"}},
    {glslang::EOpStep, {Effect::switched, each, "step()"}},
    {glslang::EOpFaceForward, {Effect::switched, all, "faceforward()"}},
    {glslang::EOpIsNan, {Effect::switched, each, "isnan()"}},
    {glslang::EOpIsInf, {Effect::switched, each, "isinf()"}},

    // A float that is compared for equality is a name.
    {glslang::EOpEqual, {Effect::undefined, all, "test for equality"}},
    {glslang::EOpNotEqual, {Effect::undefined, all, "test for equality"}},
    {glslang::EOpVectorEqual, {Effect::undefined, each, "test for equality"}},
    {glslang::EOpVectorNotEqual, {Effect::undefined, each, "test for equality"}},
    {glslang::EOpFloor, {Effect::undefined, each, "floor()"}},
    {glslang::EOpTrunc, {Effect::undefined, each, "trunc()"}},
    {glslang::EOpRound, {Effect::undefined, each, "round()"}},
    {glslang::EOpRoundEven, {Effect::undefined, each, "roundEven()"}},
    {glslang::EOpCeil, {Effect::undefined, each, "ceil()"}},
    {glslang::EOpFract, {Effect::undefined, each, "fract()"}},
    {glslang::EOpMod, {Effect::undefined, each, "mod()"}},
    {glslang::EOpModf, {Effect::undefined, each, "modf()"}},
};

struct AssignmentRow {
  TOperator assignment;
  TOperator op;
};
constexpr AssignmentRow assignments[] = {
    {glslang::EOpAssign, glslang::EOpNull},
    {glslang::EOpAddAssign, glslang::EOpAdd},
    {glslang::EOpSubAssign, glslang::EOpSub},
    {glslang::EOpMulAssign, glslang::EOpMul},
    {glslang::EOpVectorTimesMatrixAssign, glslang::EOpVectorTimesMatrix},
    {glslang::EOpVectorTimesScalarAssign, glslang::EOpVectorTimesScalar},
    {glslang::EOpMatrixTimesScalarAssign, glslang::EOpMatrixTimesScalar},
    {glslang::EOpMatrixTimesMatrixAssign, glslang::EOpMatrixTimesMatrix},
    {glslang::EOpDivAssign, glslang::EOpDiv},
    {glslang::EOpModAssign, glslang::EOpMod},
    {glslang::EOpAndAssign, glslang::EOpAnd},
    {glslang::EOpInclusiveOrAssign, glslang::EOpInclusiveOr},
    {glslang::EOpExclusiveOrAssign, glslang::EOpExclusiveOr},
    {glslang::EOpLeftShiftAssign, glslang::EOpLeftShift},
    {glslang::EOpRightShiftAssign, glslang::EOpRightShift},
};

const AssignmentRow* find_assignment(TOperator op) {
  const auto* const found = std::find_if(std::begin(assignments), std::end(assignments),
                                         [&](const AssignmentRow& row) { return row.assignment == op; });
  return found == std::end(assignments) ? nullptr : found;
}

}  // namespace

Operation operation(TOperator op) {
  const auto* const found =
      std::find_if(std::begin(rows), std::end(rows), [&](const Row& row) { return row.op == op; });
  return found == std::end(rows) ? Operation{} : found->operation;
}

TOperator within_assignment(TOperator op) {
  const AssignmentRow* const row = find_assignment(op);
  return row != nullptr ? row->op : glslang::EOpNull;
}

bool is_assignment(TOperator op) { return find_assignment(op) != nullptr; }

}  // namespace glark::refine
