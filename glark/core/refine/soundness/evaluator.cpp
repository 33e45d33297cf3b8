// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/soundness/evaluator.h"

#include <algorithm>
#include <array>
#include <utility>

namespace glark::refine {
namespace {

std::size_t constant_index(const SyntaxNode& node) {
  return node.kind == NodeKind::constant ? static_cast<std::size_t>(std::max(node.first_number, 0LL)) : 0;
}

std::vector<std::size_t> swizzle_of(const SyntaxNode& node) {
  std::vector<std::size_t> components;
  for (const SyntaxNode& component : node.children[1].children) components.push_back(constant_index(component));
  return components;
}

bool is_constructor(const SyntaxNode& node) { return node.words.starts_with("Construct "); }

bool is_texture(const SyntaxNode& node) {
  const std::string_view words = node.words;
  return words.starts_with("texture") || words.starts_with("image") || words.starts_with("sparse");
}

// Built-in functions with output parameters; none of these is the first one.
bool writes_arguments(const SyntaxNode& node) {
  constexpr std::array words = {"modf", "frexp", "addCarry", "subBorrow", "uMulExtended", "iMulExtended"};
  return std::find(words.begin(), words.end(), node.words) != words.end();
}

// The type of a constant is not known. Two to four numbers may be a vector.
Shape shape_of_constant(const SyntaxNode& node) {
  Shape shape;
  if (node.count > 1 && node.count <= 4) shape.parts.resize(node.count);
  return shape;
}

}  // namespace

Shape Evaluator::evaluate(const SyntaxNode& node) {
  ++run_.steps;
  switch (node.kind) {
    case NodeKind::symbol: return read(node);
    case NodeKind::constant: return shape_of_constant(node);
    case NodeKind::selection: return evaluate_selection(node);
    case NodeKind::call: return functions_.call(node);
    case NodeKind::operation: return evaluate_operation(node);
    case NodeKind::sequence: {
      Shape last;
      for (const SyntaxNode& child : node.children) last = evaluate(child);
      return last;
    }
    default: return {};
  }
}

Shape Evaluator::read(const SyntaxNode& symbol) {
  const std::string& name = symbol.words;
  if (is_input(symbol)) {
    const bool constant = name.starts_with("gl_InstanceID") || name.starts_with("gl_Base") ||
                          name.starts_with("gl_DrawID") || run_.constants.contains(name);
    if (constant) return shape_of(*symbol.type);
    Value value{Variation::affine, run_.notes.input(name), -1};
    if (symbol.type->basic == BasicType::integer) {
      value = run_.notes.worsened(value, Variation::undefined, run_.place(symbol.line), "integer value");
    }
    return shape_of(*symbol.type, value);
  }
  const StorageClass storage = symbol.type->storage;
  if (storage == StorageClass::uniform || storage == StorageClass::buffer) return shape_of(*symbol.type);
  return run_.memory.at(run_.memory.variable(symbol, run_.calls.back().unit));
}

Shape Evaluator::evaluate_operation(const SyntaxNode& node) {
  if (selects_part(node)) {
    if (node.words == "direct index for structure") return evaluate_member(node);
    return node.words == "vector swizzle" ? evaluate_swizzle(node) : evaluate_part(node);
  }
  if (node.children.size() != 2) return evaluate_known(node);
  if (node.words == "logical-and" || node.words == "logical-or") return evaluate_logical(node);
  if (const auto operation = within_assignment(node.words)) return evaluate_assignment(node, *operation);
  return evaluate_known(node);
}

Shape Evaluator::evaluate_logical(const SyntaxNode& node) {
  const Shape left = evaluate(node.children[0]);
  const Value outside = run_.control;
  run_.control = worse(outside, merged(left));  // the right side may not be evaluated
  const Shape right = evaluate(node.children[1]);
  run_.control = outside;
  return operate(node, operation(node.words), {left, right});
}

Shape Evaluator::evaluate_assignment(const SyntaxNode& node, std::string_view words) {
  Shape value = evaluate(node.children[1]);
  if (!words.empty()) value = operate(node, operation(words), {evaluate(node.children[0]), value});
  store(node.children[0], value);
  return value;
}

Value Evaluator::as_index(const Value& value, int line) {
  return run_.notes.worsened(value, Variation::undefined, run_.place(line), "index made");
}

Shape Evaluator::evaluate_member(const SyntaxNode& node) {
  const SyntaxNode& whole = node.children[0];
  const std::optional<std::size_t> index = whole.type->member(node.member);
  if (is_anonymous_block(whole) && index) {
    const bool written = whole.type->storage == StorageClass::output;
    return written ? run_.memory.at(run_.memory.block_member(*whole.type, node.member)) : shape_of(*node.type);
  }
  const Shape shape = evaluate(whole);
  return index && *index < shape.parts.size() ? shape.parts[*index] : shape_of(*node.type, merged(shape));
}

Shape Evaluator::evaluate_part(const SyntaxNode& node) {
  const SyntaxNode& whole = node.children[0];
  const Shape shape = evaluate(whole);
  if (node.words == "direct index" && whole.type->has_components()) {
    return component(shape, constant_index(node.children[1]));
  }
  const Value chosen = as_index(merged(evaluate(node.children[1])), node.line);
  Shape result = whole.type->array ? shape : shape_of(*node.type, merged(shape));
  worsen(result, chosen);
  return result;
}

Shape Evaluator::evaluate_swizzle(const SyntaxNode& node) {
  const Shape shape = evaluate(node.children[0]);
  const std::vector<std::size_t> components = swizzle_of(node);
  if (components.size() == 1) return component(shape, components[0]);
  Shape result;
  for (const std::size_t index : components) result.parts.push_back(component(shape, index));
  return result;
}

// Integers have no values between vertices.
Shape Evaluator::convert(const SyntaxNode& node, const Shape& operand) {
  const bool from_float = node.words.starts_with("Convert float") || node.words.starts_with("Convert double");
  if (!from_float || node.type->basic == BasicType::floating) {
    return operate(node, {Effect::linear, true, {}}, {operand});
  }
  const bool truth = node.words.ends_with(" to bool");
  return operate(
      node, {truth ? Effect::switched : Effect::undefined, true, truth ? "conversion to bool" : "integer conversion"},
      {operand});
}

Shape Evaluator::construct(const Type& type, const std::vector<Shape>& arguments) {
  Value all;
  for (const Shape& argument : arguments) all = worse(all, merged(argument));
  if (type.array || type.matrix) {
    if (!type.array || !type.is_structure()) return shape_of(type, all);
    Shape element = shape_of(type);
    for (const Shape& argument : arguments) join(element, argument);
    return element;
  }
  Shape result = shape_of(type);
  if (type.is_structure()) {
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

Shape Evaluator::operate(const SyntaxNode& node, const Operation& operation, const std::vector<Shape>& arguments) {
  Shape result = shape_of(*node.type);
  std::vector<Value> values(arguments.size());
  const auto at = [&](std::size_t i) {
    std::transform(arguments.begin(), arguments.end(), values.begin(),
                   [&](const Shape& argument) { return merged(component(argument, i)); });
    return apply(operation, values, node.line);
  };
  if (operation.by_component && node.type->has_components()) {
    for (std::size_t i = 0; i < result.parts.size(); ++i) fill(result.parts[i], at(i));
    return result;
  }
  std::transform(arguments.begin(), arguments.end(), values.begin(), [](const Shape& a) { return merged(a); });
  fill(result, apply(operation, values, node.line));
  return result;
}

Shape Evaluator::evaluate_known(const SyntaxNode& node) {
  std::vector<Shape> arguments;
  for (const SyntaxNode& argument : node.children) arguments.push_back(evaluate(argument));
  if (node.words == "Comma") return arguments.empty() ? Shape{} : arguments.back();
  if (node.words == "ftransform" && arguments.empty()) {
    return shape_of(*node.type, {Variation::affine, run_.notes.input("gl_Vertex"), -1});
  }
  if (node.words == "array length") return shape_of(*node.type);
  if (node.words.starts_with("Convert ") && arguments.size() == 1) return convert(node, arguments[0]);
  if (is_constructor(node)) return construct(*node.type, arguments);
  Value all;
  for (const Shape& argument : arguments) all = worse(all, merged(argument));
  if (is_texture(node)) return evaluate_texture(node, all);
  Shape result = operate(node, operation(node.words), arguments);
  if (modifies_operand(node)) store(node.children[0], result);
  for (std::size_t i = 1; writes_arguments(node) && i < arguments.size(); ++i) {
    store(node.children[i], {merged(result), {}});
  }
  return result;
}

// A filtered texture is continuous. Texels that are fetched by their numbers are not.
Shape Evaluator::evaluate_texture(const SyntaxNode& node, const Value& arguments) {
  const std::string_view words = node.words;
  const auto contains = [&](std::string_view part) { return words.find(part) != std::string_view::npos; };
  if (words == "textureSize" || words == "textureSamples" || contains("Query")) return shape_of(*node.type);
  const bool by_number = contains("Fetch") || contains("Gather") || words.starts_with("image") || contains("Image") ||
                         node.type->basic == BasicType::integer;
  const Operation effect{by_number ? Effect::undefined : Effect::continuous, false, "texel fetch"};
  return shape_of(*node.type, apply(effect, {arguments}, node.line));
}

Shape Evaluator::evaluate_selection(const SyntaxNode& node) {
  const auto evaluate_case = [&](Role role) {
    const SyntaxNode* const part = node.part(role);
    return part != nullptr ? evaluate(*part) : Shape{};
  };
  const Value chosen = merged(evaluate_case(Role::condition));
  const Value outside = run_.control;
  run_.control = worse(outside, chosen);
  Shape result = evaluate_case(Role::true_case);
  const Shape other = evaluate_case(Role::false_case);
  if (result.parts.size() != other.parts.size()) result = shape_of(*node.type, merged(result));
  join(result, other.parts.size() == result.parts.size() ? other : shape_of(*node.type, merged(other)));
  run_.control = outside;
  worsen(result, chosen);
  return result;
}

Evaluator::Target Evaluator::target(const SyntaxNode& node) {
  if (selects_part(node)) return target_part(node);
  Target result;
  if (node.kind != NodeKind::symbol) return result;
  result.variable = run_.memory.variable(node, run_.calls.back().unit);
  result.shared = node.shares_name;
  return result;
}

Evaluator::Target Evaluator::target_part(const SyntaxNode& node) {
  const SyntaxNode& whole = node.children[0];
  const std::optional<std::size_t> member = whole.type->member(node.member);
  if (is_anonymous_block(whole) && member) {
    Target result;
    result.variable = run_.memory.block_member(*whole.type, node.member);
    return result;
  }
  Target result = target(whole);
  if (node.words == "direct index for structure") {
    result.path.push_back(member.value_or(0));
  } else if (node.words == "vector swizzle" || (node.words == "direct index" && whole.type->has_components())) {
    std::vector<std::size_t> components =
        node.words == "vector swizzle" ? swizzle_of(node) : std::vector<std::size_t>{constant_index(node.children[1])};
    for (std::size_t& index : components) {
      if (result.components && index < result.components->size()) index = (*result.components)[index];
    }
    result.components = std::move(components);
  } else {
    result.shared = true;
    result.index = worse(result.index, as_index(merged(evaluate(node.children[1])), node.line));
  }
  return result;
}

void Evaluator::store(const SyntaxNode& node, Shape value) {
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
