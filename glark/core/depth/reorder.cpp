// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/depth/reorder.h"

#include <algorithm>
#include <string>
#include <vector>

#include "glark/core/capture/record.h"
#include "glark/core/objects/programs/shader.h"

namespace glark::depth {
namespace {

constexpr const char* types[] = {"", "float", "vec2", "vec3", "vec4"};

// The least number of inputs that hold the words of a corner, four words each.
int inputs_of(int corner_words) { return (corner_words + 3) / 4; }
int size_of_input(int corner_words, int input) { return std::min(4, corner_words - 4 * input); }

std::string mover_source(capture::Language language, int corner_words) {
  std::string inputs;
  std::string body;
  for (int input = 0; input < inputs_of(corner_words); ++input) {
    const std::string number = std::to_string(input);
    const std::string type = types[size_of_input(corner_words, input)];
    inputs += "layout(location = " + number + ") in " + type + " words" + number + ";\nout " + type + " moved" +
              number + ";\n";
    body += "  moved" + number + " = words" + number + ";\n";
  }
  const char* version =
      language == capture::Language::es ? "#version 320 es\nprecision highp float;\n" : "#version 430\n";
  return version + inputs + "void main() {\n" + body + "  gl_Position = vec4(0.0);\n}\n";
}

}  // namespace

void Reorder::build(Mover& mover, int corner_words) {
  if (mover.tried || !compilation_.may_begin(&mover)) {
    return;
  }
  const core::Compilation::Step step(compilation_);
  mover.tried = true;
  const std::vector<core::ShaderText> texts{
      {GL_VERTEX_SHADER, mover_source(language_, corner_words)},
      {GL_FRAGMENT_SHADER, core::idle_fragment_shader(language_ == capture::Language::es)}};
  std::vector<std::string> varyings;
  for (int input = 0; input < inputs_of(corner_words); ++input) {
    varyings.push_back("moved" + std::to_string(input));
  }
  mover.program = core::build_program(gl_, "the reordering program", texts, varyings);
  if (mover.program != 0) {
    gl_.GenVertexArrays(1, &mover.vertex_array);
  }
}

bool Reorder::has_room(const capture::Layout& layout, std::uint32_t instances) const {
  const auto mover = movers_.find(layout.corner_words);
  return mover != movers_.end() && mover->second.program != 0 &&
         static_cast<std::int64_t>(instances) * stride(layout) + capture::chunk_overrun <= records_.size();
}

bool Reorder::reserve(const capture::Layout& layout, std::uint32_t instances) {
  if (feedback_ == 0) {
    gl_.GenTransformFeedbacks(1, &feedback_);
  }
  Mover& mover = movers_[layout.corner_words];
  build(mover, layout.corner_words);
  return mover.program != 0 &&
         records_.reserve(gl_, static_cast<std::int64_t>(instances) * stride(layout) + capture::chunk_overrun,
                          GL_DYNAMIC_COPY);
}

void Reorder::run(const capture::Layout& layout, const capture::CoarseTriangles& triangles, const Order& order,
                  const core::Bindings& bindings) {
  const Mover& mover = movers_.at(layout.corner_words);
  gl_.UseProgram(mover.program);
  gl_.BindVertexArray(mover.vertex_array);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, order.indices);
  for (int input = 0; input < inputs_of(layout.corner_words); ++input) {
    const auto location = static_cast<GLuint>(input);
    gl_.EnableVertexAttribArray(location);
    gl_.VertexAttribFormat(location, size_of_input(layout.corner_words, input), GL_FLOAT, GL_FALSE,
                           static_cast<GLuint>(input * 16));
    gl_.VertexAttribBinding(location, 0);
  }
  gl_.BindVertexBuffer(0, triangles.buffer, triangles.offset, layout.corner_words * 4);
  gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback_);
  gl_.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, records_.name());
  gl_.BindBuffer(
      GL_TRANSFORM_FEEDBACK_BUFFER,
      bindings.transform_feedback.buffer);  // only the generic binding point: the indexed one belongs to the object
  gl_.BindBuffer(GL_DRAW_INDIRECT_BUFFER, order.commands);
  if (!bindings.rasterizer_discard) {
    gl_.Enable(GL_RASTERIZER_DISCARD);
  }
  gl_.BeginTransformFeedback(GL_TRIANGLES);
  gl_.DrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(order.command_offset));
  gl_.EndTransformFeedback();
  if (!bindings.rasterizer_discard) {
    gl_.Disable(GL_RASTERIZER_DISCARD);
  }
  gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, bindings.transform_feedback.object);
}

void Reorder::release() {
  for (const auto& [words, mover] : movers_) {
    gl_.DeleteProgram(mover.program);
    gl_.DeleteVertexArrays(1, &mover.vertex_array);
  }
  movers_.clear();
  if (feedback_ != 0) {
    gl_.DeleteTransformFeedbacks(1, &feedback_);
    feedback_ = 0;
  }
  records_.release(gl_);
}

}  // namespace glark::depth
