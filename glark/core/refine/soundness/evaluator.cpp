// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/soundness/evaluator.h"

#include <algorithm>

namespace glark::refine {
namespace {

using glslang::TIntermAggregate;
using glslang::TIntermBinary;
using glslang::TIntermSelection;
using glslang::TIntermSymbol;
using glslang::TIntermTyped;
using glslang::TIntermUnary;

std::size_t constant_index(TIntermTyped* node) {
  const glslang::TIntermConstantUnion* const constant = node->getAsConstantUnion();
  return constant != nullptr ? static_cast<std::size_t>(std::max(constant->getConstArray()[0].getIConst(), 0)) : 0;
}

std::vector<std::size_t> swizzle_of(TIntermBinary& node) {
  std::vector<std::size_t> components;
  for (TIntermNode* component : node.getRight()->getAsAggregate()->getSequence()) {
    components.push_back(constant_index(component->getAsTyped()));
  }
  return components;
}

bool is_integer(const glslang::TType& type) {
  const glslang::TBasicType basic = type.getBasicType();
  return basic != glslang::EbtVoid && !type.isStruct() && !type.isFloatingDomain() && !type.isOpaque();
}

bool is_conversion(glslang::TOperator op) {
  return op >= glslang::EOpConvInt8ToBool && op <= glslang::EOpConvUvec2ToAccStruct;
}

// Built-in functions with output parameters; none of these is the first one.
bool writes_arguments(glslang::TOperator op) {
  switch (op) {
    case glslang::EOpModf:
    case glslang::EOpFrexp:
    case glslang::EOpAddCarry:
    case glslang::EOpSubBorrow:
    case glslang::EOpUMulExtended:
    case glslang::EOpIMulExtended: return true;
    default: return false;
  }
}

// The components of a vector can be told apart, unless the vector is an element of an array.
bool has_components(const glslang::TType& type) { return type.isVector() && !type.isArray(); }

}  // namespace

Shape Evaluator::evaluate(TIntermNode* node) {
  ++run_.steps;
  if (node == nullptr) return {};
  if (TIntermSymbol* const symbol = node->getAsSymbolNode()) return read(*symbol);
  if (TIntermBinary* const binary = node->getAsBinaryNode()) return evaluate_binary(*binary);
  if (TIntermUnary* const unary = node->getAsUnaryNode()) return evaluate_unary(*unary);
  if (TIntermAggregate* const aggregate = node->getAsAggregate()) return evaluate_aggregate(*aggregate);
  if (TIntermSelection* const selection = node->getAsSelectionNode()) return evaluate_selection(*selection);
  if (TIntermTyped* const typed = node->getAsTyped()) return shape_of(typed->getType());
  return {};
}

Shape Evaluator::read(TIntermSymbol& symbol) {
  const std::string name{std::string_view(symbol.getName())};
  if (is_input(symbol)) {
    const bool constant = name.starts_with("gl_InstanceID") || name.starts_with("gl_Base") ||
                          name.starts_with("gl_DrawID") || run_.constants.contains(name);
    if (constant) return shape_of(symbol.getType());
    Value value{Variation::affine, run_.notes.input(name), -1};
    if (is_integer(symbol.getType())) {
      value = run_.notes.worsened(value, Variation::undefined, run_.place(symbol.getLoc().line), "integer value");
    }
    return shape_of(symbol.getType(), value);
  }
  const glslang::TStorageQualifier storage = symbol.getQualifier().storage;
  if (storage == glslang::EvqUniform || storage == glslang::EvqBuffer) return shape_of(symbol.getType());
  return run_.memory.at(run_.memory.variable(symbol, run_.calls.back().unit));
}

Shape Evaluator::evaluate_binary(TIntermBinary& node) {
  switch (node.getOp()) {
    case glslang::EOpIndexDirect:
    case glslang::EOpIndexIndirect:
    case glslang::EOpIndexDirectStruct: return evaluate_part(node);
    case glslang::EOpVectorSwizzle: return evaluate_swizzle(node);
    case glslang::EOpLogicalAnd:
    case glslang::EOpLogicalOr: {
      const Shape left = evaluate(node.getLeft());
      const Value outside = run_.control;
      run_.control = worse(outside, merged(left));  // the right side may not be evaluated
      const Shape right = evaluate(node.getRight());
      run_.control = outside;
      return operate(node, operation(node.getOp()), {left, right});
    }
    default: break;
  }
  if (is_assignment(node.getOp())) return evaluate_assignment(node);
  return operate(node, operation(node.getOp()), {evaluate(node.getLeft()), evaluate(node.getRight())});
}

Shape Evaluator::evaluate_assignment(TIntermBinary& node) {
  const glslang::TOperator op = within_assignment(node.getOp());
  Shape value = evaluate(node.getRight());
  if (op != glslang::EOpNull) value = operate(node, operation(op), {evaluate(node.getLeft()), value});
  store(node.getLeft(), value);
  return value;
}

Value Evaluator::as_index(const Value& value, int line) {
  return run_.notes.worsened(value, Variation::undefined, run_.place(line), "index made");
}

Shape Evaluator::evaluate_part(TIntermBinary& node) {
  TIntermTyped& whole = *node.getLeft();
  TIntermSymbol* const symbol = whole.getAsSymbolNode();
  const std::size_t index = constant_index(node.getRight());
  if (node.getOp() == glslang::EOpIndexDirectStruct) {
    if (symbol != nullptr && is_anonymous_block(*symbol)) {
      const bool written = symbol->getQualifier().storage == glslang::EvqVaryingOut;
      return written ? run_.memory.at(run_.memory.block_member(whole.getType(), index)) : shape_of(node.getType());
    }
    const Shape shape = evaluate(&whole);
    return index < shape.parts.size() ? shape.parts[index] : shape_of(node.getType(), merged(shape));
  }
  const Shape shape = evaluate(&whole);
  if (node.getOp() == glslang::EOpIndexDirect && has_components(whole.getType())) return component(shape, index);
  const Value chosen = as_index(merged(evaluate(node.getRight())), node.getLoc().line);
  Shape result = whole.getType().isArray() ? shape : shape_of(node.getType(), merged(shape));
  worsen(result, chosen);
  return result;
}

Shape Evaluator::evaluate_swizzle(TIntermBinary& node) {
  const Shape shape = evaluate(node.getLeft());
  const std::vector<std::size_t> components = swizzle_of(node);
  if (components.size() == 1) return component(shape, components[0]);
  Shape result;
  for (const std::size_t index : components) result.parts.push_back(component(shape, index));
  return result;
}

Shape Evaluator::evaluate_unary(TIntermUnary& node) {
  const Shape operand = evaluate(node.getOperand());
  const glslang::TOperator op = node.getOp();
  if (op == glslang::EOpArrayLength) return shape_of(node.getType());
  if (is_conversion(op)) return convert(node, operand);
  if (node.isConstructor()) return construct(node.getType(), {operand});
  Shape result = operate(node, operation(op), {operand});
  if (node.modifiesState()) store(node.getOperand(), result);
  return result;
}

// Integers have no values between vertices.
Shape Evaluator::convert(TIntermUnary& node, const Shape& operand) {
  const glslang::TType& to = node.getType();
  const bool from_float = node.getOperand()->getType().isFloatingDomain();
  if (!from_float || to.isFloatingDomain()) return operate(node, {Effect::linear, true, {}}, {operand});
  const bool truth = to.getBasicType() == glslang::EbtBool;
  return operate(
      node, {truth ? Effect::switched : Effect::undefined, true, truth ? "conversion to bool" : "integer conversion"},
      {operand});
}

Shape Evaluator::construct(const glslang::TType& type, const std::vector<Shape>& arguments) {
  Value all;
  for (const Shape& argument : arguments) all = worse(all, merged(argument));
  if (type.isArray() || type.isMatrix()) {
    if (!type.isArray() || !type.isStruct()) return shape_of(type, all);
    Shape element = shape_of(type);
    for (const Shape& argument : arguments) join(element, argument);
    return element;
  }
  Shape result = shape_of(type);
  if (type.isStruct()) {
    for (std::size_t i = 0; i < result.parts.size() && i < arguments.size(); ++i) result.parts[i] = arguments[i];
    return result;
  }
  std::vector<Value> components;
  for (const Shape& argument : arguments) {
    if (argument.parts.empty()) components.push_back(argument.value);
    for (const Shape& part : argument.parts) components.push_back(merged(part));
  }
  if (result.parts.empty()) return {components.empty() ? Value{} : components.front(), {}};
  const bool complete = components.size() >= result.parts.size();  // false for one scalar, or for a matrix
  for (std::size_t i = 0; i < result.parts.size(); ++i) fill(result.parts[i], complete ? components[i] : all);
  return result;
}

Value Evaluator::apply(const Operation& operation, const std::vector<Value>& arguments, int line) {
  Value all;
  std::size_t varying = 0;
  for (const Value& argument : arguments) {
    all = worse(all, argument);
    varying += argument.varies() ? 1 : 0;
  }
  const bool last_varies = !arguments.empty() && arguments.back().varies();
  const auto bent = [&](bool bends) {
    if (bends && all.variation == Variation::affine) all.variation = Variation::continuous;
    return all;
  };
  switch (operation.effect) {
    case Effect::linear: return all;
    case Effect::product: return bent(varying > 1);
    case Effect::fused: return bent(arguments[0].varies() && arguments[1].varies());
    case Effect::quotient:
    case Effect::mixture: return bent(last_varies);
    case Effect::continuous: return bent(true);
    case Effect::switched: return run_.notes.worsened(all, Variation::switched, run_.place(line), operation.name);
    case Effect::undefined: break;
  }
  const std::string_view name = operation.name.empty() ? "an integer or unknown operation" : operation.name;
  return run_.notes.worsened(all, Variation::undefined, run_.place(line), name);
}

Shape Evaluator::operate(glslang::TIntermOperator& node, const Operation& operation,
                         const std::vector<Shape>& arguments) {
  const int line = node.getLoc().line;
  Shape result = shape_of(node.getType());
  std::vector<Value> values(arguments.size());
  const auto at = [&](std::size_t i) {
    std::transform(arguments.begin(), arguments.end(), values.begin(),
                   [&](const Shape& argument) { return merged(component(argument, i)); });
    return apply(operation, values, line);
  };
  if (operation.by_component && has_components(node.getType())) {
    for (std::size_t i = 0; i < result.parts.size(); ++i) fill(result.parts[i], at(i));
    return result;
  }
  std::transform(arguments.begin(), arguments.end(), values.begin(), [](const Shape& a) { return merged(a); });
  fill(result, apply(operation, values, line));
  return result;
}

Shape Evaluator::evaluate_aggregate(TIntermAggregate& node) {
  if (node.getOp() == glslang::EOpFunctionCall) return functions_.call(node);
  std::vector<Shape> arguments;
  for (TIntermNode* argument : node.getSequence()) arguments.push_back(evaluate(argument));
  if (node.getOp() == glslang::EOpComma || node.getOp() == glslang::EOpSequence) {
    return arguments.empty() ? Shape{} : arguments.back();
  }
  if (node.getOp() == glslang::EOpFtransform) {
    return shape_of(node.getType(), {Variation::affine, run_.notes.input("gl_Vertex"), -1});
  }
  if (node.isConstructor()) return construct(node.getType(), arguments);
  Value all;
  for (const Shape& argument : arguments) all = worse(all, merged(argument));
  if (node.isTexture() || node.isImage()) return evaluate_texture(node, all);
  Shape result = operate(node, operation(node.getOp()), arguments);
  for (std::size_t i = 1; writes_arguments(node.getOp()) && i < arguments.size(); ++i) {
    store(node.getSequence()[i], {merged(result), {}});
  }
  return result;
}

// A filtered texture is continuous. Texels that are fetched by their numbers are not.
Shape Evaluator::evaluate_texture(TIntermAggregate& node, const Value& arguments) {
  glslang::TCrackedTextureOp access{};
  const TIntermTyped* const first = node.getSequence()[0]->getAsTyped();
  node.crackTexture(first->getType().getSampler(), access);
  if (access.query) return shape_of(node.getType());
  const bool by_number = access.fetch || access.gather || node.isImage() || is_integer(node.getType());
  const Operation effect{by_number ? Effect::undefined : Effect::continuous, false, "texel fetch"};
  return shape_of(node.getType(), apply(effect, {arguments}, node.getLoc().line));
}

Shape Evaluator::evaluate_selection(TIntermSelection& node) {
  const Value chosen = condition(node.getCondition());
  const Value outside = run_.control;
  run_.control = worse(outside, chosen);
  Shape result = evaluate(node.getTrueBlock());
  join(result, evaluate(node.getFalseBlock()));
  run_.control = outside;
  worsen(result, chosen);
  return result;
}

Evaluator::Target Evaluator::target(TIntermNode* node) {
  Target result;
  if (TIntermSymbol* const symbol = node->getAsSymbolNode()) {
    result.variable = run_.memory.variable(*symbol, run_.calls.back().unit);
    return result;
  }
  TIntermBinary* const binary = node->getAsBinaryNode();
  return binary != nullptr ? target_part(*binary) : result;
}

Evaluator::Target Evaluator::target_part(TIntermBinary& node) {
  TIntermTyped& whole = *node.getLeft();
  TIntermSymbol* const symbol = whole.getAsSymbolNode();
  Target result;
  if (node.getOp() == glslang::EOpIndexDirectStruct && symbol != nullptr && is_anonymous_block(*symbol)) {
    result.variable = run_.memory.block_member(whole.getType(), constant_index(node.getRight()));
    return result;
  }
  result = target(&whole);
  if (node.getOp() == glslang::EOpIndexDirectStruct) {
    result.path.push_back(constant_index(node.getRight()));
  } else if (node.getOp() == glslang::EOpVectorSwizzle ||
             (node.getOp() == glslang::EOpIndexDirect && has_components(whole.getType()))) {
    std::vector<std::size_t> components = node.getOp() == glslang::EOpVectorSwizzle
                                              ? swizzle_of(node)
                                              : std::vector<std::size_t>{constant_index(node.getRight())};
    for (std::size_t& index : components) {
      if (result.components && index < result.components->size()) index = (*result.components)[index];
    }
    result.components = std::move(components);
  } else {
    result.shared = true;
    result.index = worse(result.index, as_index(merged(evaluate(node.getRight())), node.getLoc().line));
  }
  return result;
}

void Evaluator::store(TIntermNode* node, Shape value) {
  const Target place = target(node);
  if (place.variable < 0 || run_.memory.state().dead) return;
  worsen(value, worse(run_.whole_control(), place.index));
  Shape* shape = &run_.memory.at(place.variable);
  for (const std::size_t part : place.path) {
    if (part < shape->parts.size()) shape = &shape->parts[part];
  }
  const auto put = [&](Shape& into, const Shape& from) {
    if (place.shared) {
      worsen(into, merged(from));
    } else if (into.parts.size() == from.parts.size()) {
      into = from;
    } else {
      fill(into, merged(from));
    }
  };
  if (!place.components || shape->parts.empty()) {
    if (place.components) worsen(*shape, merged(value));
    if (!place.components) put(*shape, value);
    return;
  }
  for (std::size_t i = 0; i < place.components->size(); ++i) {
    const std::size_t index = (*place.components)[i];
    if (index < shape->parts.size()) put(shape->parts[index], component(value, i));
  }
}

}  // namespace glark::refine
