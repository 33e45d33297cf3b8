// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Inputs that take several attributes: matrices, and arrays of scalars, vectors and matrices. Each attribute has an array,
// an array of instances, or a current value of its own.
#include <fmt/core.h>

#include <array>
#include <bit>
#include <cstring>

#include "conformance/cases/cases.h"
#include "conformance/cases/repeated/repeated.h"
#include "conformance/support/refined_draw.h"

namespace glark::conformance {
namespace {

struct InputArray {
  const char* type;
  GLuint columns;
  GLuint rows;
  GLuint elements;  // 0: no array
  GLuint location;
  GLenum number = GL_FLOAT;

  std::string leaf() const { return elements > 0 ? fmt::format("{}_{}", type, elements) : type; }
  GLuint slots() const { return columns * std::max(elements, 1U); }
  GLuint components() const { return slots() * rows; }
  // OpenGL ES has no arrays of inputs.
  Apis apis() const { return elements > 0 || number == GL_DOUBLE ? desktop_apis : every_api; }
};

constexpr InputArray input_arrays[] = {
    {"mat2", 2, 2, 2, 3},
    {"mat3", 3, 3, 2, 2},
    {"mat4", 4, 4, 2, 5},
    {"mat2x3", 2, 3, 3, 4},
    {"mat3x2", 3, 2, 3, 3},
    {"mat2x4", 2, 4, 4, 2},
    {"mat4x2", 4, 2, 3, 2},
    {"mat3x4", 3, 4, 2, 6},
    {"mat4x3", 4, 3, 2, 3},
    {"mat2", 2, 2, 0, 9},
    {"mat3x4", 3, 4, 0, 4},
    {"mat4x2", 4, 2, 0, 7},
    {"float", 1, 1, 9, 3},
    {"vec2", 1, 2, 5, 8},
    {"vec3", 1, 3, 4, 2},
    {"vec4", 1, 4, 7, 5},
    {"ivec3", 1, 3, 3, 4, GL_INT},
    {"uint", 1, 1, 4, 6, GL_UNSIGNED_INT},
    {"dvec2", 1, 2, 3, 4, GL_DOUBLE},
    {"dmat2", 2, 2, 2, 3, GL_DOUBLE},
};

constexpr std::size_t input_corners = 3;
constexpr GLuint most_slots = 16;

// What the attribute `slot` has at a corner, in sixteenths. Of an array of instances, corners are instances.
GLint sixteenths_of(GLuint slot, std::size_t corner, GLuint row) {
  return static_cast<GLint>((5 * slot + 7 * corner + 3 * row + slot * corner * row) % 17);
}
GLint sixteenths_of_current(GLuint slot, GLuint row) { return sixteenths_of(slot + 4, 1, row + 2); }

enum class Carrier { array, instances, current };
using Carriers = Carrier (*)(GLuint slot);

// Which attributes have arrays.
struct CarrierChoice {
  const char* name;
  Carriers carrier_of;
  GLsizei instances = 1;
};
constexpr CarrierChoice carrier_choices[] = {
    {"arrays", [](GLuint) { return Carrier::array; }},
    {"even arrays", [](GLuint slot) { return slot % 2 == 0 ? Carrier::array : Carrier::current; }},
    {"odd arrays", [](GLuint slot) { return slot % 2 == 1 ? Carrier::array : Carrier::current; }},
    {"even instances", [](GLuint slot) { return slot % 2 == 0 ? Carrier::instances : Carrier::array; }, 2},
    {"odd instances", [](GLuint slot) { return slot % 2 == 1 ? Carrier::instances : Carrier::current; }, 2},
};

GLint expected_sixteenths(Carrier carrier, GLuint slot, std::size_t corner, std::size_t instance, GLuint row) {
  if (carrier == Carrier::current) return sixteenths_of_current(slot, row);
  return sixteenths_of(slot, carrier == Carrier::instances ? instance : corner, row);
}

// Each component is an output of its own.
GLuint input_array_program(Test& t, const InputArray& input) {
  std::string copies;
  std::string colour = "0.0";
  GLuint next = 0;
  for (GLuint slot = 0; slot < input.slots(); ++slot)
    for (GLuint row = 0; row < input.rows; ++row) {
      std::string name = "value";
      if (input.elements > 0) name += fmt::format("[{}]", slot / input.columns);
      if (input.columns > 1) name += fmt::format("[{}]", slot % input.columns);
      if (input.rows > 1) name += fmt::format("[{}]", row);
      const char* const scale = input.number == GL_FLOAT || input.number == GL_DOUBLE ? "" : " / 16.0";
      copies += fmt::format("  components[{}] = float({}){};\n", next, name, scale);
      colour += fmt::format(" + {}.0 * components[{}]", 1 + next % 3, next);
      ++next;
    }
  const std::string size = input.elements > 0 ? fmt::format("[{}]", input.elements) : "";
  return build_program(
      t, {.vertex = fmt::format("layout(location = 0) in vec4 position; layout(location = 1) in vec3 weights;\n"
                                "layout(location = {}) in {} value{};\n"
                                "out vec3 weights_out; out vec4 colour; out float components[{}];\nvoid main() {{\n{}"
                                "  float sum = ({}) / {}.0; colour = vec4(sum, 1.0 - sum, fract(2.0 * sum), 1.0);\n"
                                "  weights_out = weights; gl_Position = position;\n}}\n",
                                input.location, input.type, size, next, copies, colour, 2 * next),
          .fragment = "in vec4 colour; out vec4 pixel; void main() { pixel = vec4(colour.rg, 0.5, 1.0); }",
          .captured = {"weights_out", "components"}});
}

template <typename Number>
void upload_slots(const InputArray& input, std::array<GLuint, most_slots>& buffers) {
  const bool is_integer = input.number == GL_INT || input.number == GL_UNSIGNED_INT;
  for (GLuint slot = 0; slot < input.slots(); ++slot) {
    std::vector<Number> numbers;
    for (std::size_t corner = 0; corner < input_corners; ++corner)
      for (GLuint row = 0; row < input.rows; ++row)
        numbers.push_back(static_cast<Number>(sixteenths_of(slot, corner, row)) /
                          static_cast<Number>(is_integer ? 1 : 16));
    gl.GenBuffers(1, &buffers[slot]);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers[slot]);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(numbers.size() * sizeof(Number)), numbers.data(),
                  GL_STATIC_DRAW);
    const auto rows = static_cast<GLint>(input.rows);
    const GLuint attribute = input.location + slot;
    if (input.number == GL_FLOAT) gl.VertexAttribPointer(attribute, rows, GL_FLOAT, GL_FALSE, 0, nullptr);
    if (is_integer) gl.VertexAttribIPointer(attribute, rows, input.number, 0, nullptr);
    if (input.number == GL_DOUBLE) gl.VertexAttribLPointer(attribute, rows, GL_DOUBLE, 0, nullptr);
  }
}

void set_current_slot(const InputArray& input, GLuint slot) {
  std::array<GLint, 4> integers{};
  std::array<GLfloat, 4> floats{};
  std::array<GLdouble, 4> doubles{};
  for (GLuint row = 0; row < input.rows; ++row) {
    integers[row] = sixteenths_of_current(slot, row);
    floats[row] = static_cast<GLfloat>(integers[row]) / 16;
    doubles[row] = static_cast<GLdouble>(integers[row]) / 16;
  }
  const GLuint attribute = input.location + slot;
  if (input.number == GL_FLOAT) gl.VertexAttrib4fv(attribute, floats.data());
  if (input.number == GL_INT) gl.VertexAttribI4iv(attribute, integers.data());
  if (input.number == GL_UNSIGNED_INT)
    gl.VertexAttribI4uiv(attribute, std::bit_cast<std::array<GLuint, 4>>(integers).data());
  if (input.number == GL_DOUBLE) gl.VertexAttribL4dv(attribute, doubles.data());
}

void carry_slots(const InputArray& input, const CarrierChoice& choice) {
  for (GLuint slot = 0; slot < input.slots(); ++slot) {
    const Carrier carrier = choice.carrier_of(slot);
    if (carrier == Carrier::current) {
      gl.DisableVertexAttribArray(input.location + slot);
      set_current_slot(input, slot);
    } else {
      gl.EnableVertexAttribArray(input.location + slot);
    }
    gl.VertexAttribDivisor(input.location + slot, carrier == Carrier::instances ? 1 : 0);
  }
}

float expected_input(const InputArray& input, Carrier carrier, GLuint component, std::size_t instance,
                     GLenum refinement, const reference::Weights& at) {
  const auto value = [&](std::size_t corner) {
    const GLuint slot = component / input.rows;
    return static_cast<float>(expected_sixteenths(carrier, slot, corner, instance, component % input.rows)) / 16;
  };
  if (input.number != GL_FLOAT && refinement == GL_LINEAR_INPUTS_ARK) return value(2);  // the provoking corner
  return reference::refined(value(0), value(1), value(2), at);
}

std::string fault_of_inputs(const InputArray& input, const CarrierChoice& choice, GLenum refinement,
                            const std::vector<float>& captured) {
  const std::size_t stride = 3 + input.components();
  for (std::size_t at = 0; at < captured.size(); at += stride) {
    const auto weights = reference::exact_weights(captured[at], captured[at + 1], captured[at + 2]);
    if (!weights.has_value()) return "weights that are none";
    const std::size_t instance = choice.instances == 2 && 2 * at >= captured.size() ? 1 : 0;
    for (GLuint k = 0; k < input.components(); ++k) {
      const float expected =
          expected_input(input, choice.carrier_of(k / input.rows), k, instance, refinement, *weights);
      if (captured[at + 3 + k] != expected)
        return fmt::format("component {} of instance {} at ({}, {}, {}): expected {}, got {}", k, instance,
                           captured[at], captured[at + 1], captured[at + 2], expected, captured[at + 3 + k]);
    }
  }
  return {};
}

void expect_inputs(Test& t, const InputArray& input, const CarrierChoice& choice, GLenum refinement) {
  const std::string what = fmt::format("{}, refinement 0x{:x}", choice.name, refinement);
  const auto draw = [&] { gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, choice.instances); };
  const Picture refined = picture_of(draw);
  repeat_often(draw);
  if (input.number != GL_DOUBLE) {  // an implementation may leave a draw with such inputs unrefined
    const auto bytes = capture_bytes(t, 4 * (3 + input.components()), 3, 1000, GL_TRIANGLES, draw);
    std::vector<float> captured(bytes.size() / 4);
    std::memcpy(captured.data(), bytes.data(), bytes.size());
    const std::size_t vertices = captured.size() / (3 + input.components());
    t.expect_equal(vertices, std::size_t{48} * static_cast<std::size_t>(choice.instances), what + ": vertices");
    const std::string fault = fault_of_inputs(input, choice, refinement, captured);
    t.expect(fault.empty(), what + ": " + fault);
  }
  const Picture again = picture_of(draw);
  t.expect_same_picture(again, refined, what + ", repeated");
  if ((input.number == GL_INT || input.number == GL_UNSIGNED_INT) && refinement == GL_LINEAR_INPUTS_ARK) return;
  gl.Disable(GL_ARK);
  t.expect_same_picture(refined, picture_of(draw), what + ": picture", 4, 80);
  gl.Enable(GL_ARK);
}

void check_input_array(Test& t, const InputArray& input) {
  gl.UseProgram(input_array_program(t, input));
  const MeshBuffers mesh = upload(one_triangle(), false);
  for (GLuint i = at_normal; i <= at_extra; ++i) gl.DisableVertexAttribArray(i);
  gl.BindBuffer(GL_ARRAY_BUFFER, mesh.buffer);
  gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(MeshVertex),
                         reinterpret_cast<const void*>(offsetof(MeshVertex, weights)));
  gl.EnableVertexAttribArray(1);
  std::array<GLuint, most_slots> buffers{};
  if (input.number == GL_FLOAT) upload_slots<GLfloat>(input, buffers);
  if (input.number == GL_DOUBLE) upload_slots<GLdouble>(input, buffers);
  if (input.number == GL_INT || input.number == GL_UNSIGNED_INT) upload_slots<GLint>(input, buffers);
  // Each choice meets both refinements over the types.
  std::size_t turn = input.location + input.rows;
  for (const CarrierChoice& choice : carrier_choices) {
    const GLenum refinement = ++turn % 2 == 0 ? GL_LINEAR_OUTPUTS_ARK : GL_LINEAR_INPUTS_ARK;
    refine_uniformly(2, refinement);
    carry_slots(input, choice);
    expect_inputs(t, input, choice, refinement);
  }
  t.expect_no_error("the draws");
}

}  // namespace

Cases input_arrays_cases() {
  Cases cases;
  for (const InputArray& input : input_arrays)
    cases.push_back(
        {.name = fmt::format("ark.program.input_arrays.{}", input.leaf()),
         .clauses = {"11.R.6-6", "11.R.6-4", "11.R.6-7", "11.R.13-1"},
         .plan = "Each attribute of this input has an array, an array of instances or a current value. "
                 "Capture all components, and compare the picture.",
         .wrong = "Attributes after the first, or after the first matrix, have no value or that of another.",
         .apis = input.apis(),
         .check = [&input](Test& t) { check_input_array(t, input); }});
  return cases;
}

}  // namespace glark::conformance
