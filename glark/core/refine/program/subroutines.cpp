// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/refine/program/subroutines.h"

#include <algorithm>
#include <array>
#include <string>

namespace glark::refine {
namespace {

GLint stage_value(const gl::Dispatch& gl, GLuint program, GLenum stage, GLenum name) {
  GLint value = 0;
  gl.GetProgramStageiv(program, stage, name, &value);
  return value;
}

// The name at each location of subroutine uniforms; "" where there is none.
std::vector<std::string> names_by_location(const gl::Dispatch& gl, GLuint program, GLenum stage) {
  std::vector<std::string> names(
      static_cast<std::size_t>(stage_value(gl, program, stage, GL_ACTIVE_SUBROUTINE_UNIFORM_LOCATIONS)));
  const GLint count = stage_value(gl, program, stage, GL_ACTIVE_SUBROUTINE_UNIFORMS);
  for (GLint i = 0; i < count; ++i) {
    std::array<char, 512> text{};
    GLint size = 1;
    gl.GetActiveSubroutineUniformName(program, stage, static_cast<GLuint>(i), static_cast<GLsizei>(text.size()),
                                      nullptr, text.data());
    gl.GetActiveSubroutineUniformiv(program, stage, static_cast<GLuint>(i), GL_UNIFORM_SIZE, &size);
    std::string base = text.data();
    base.resize(base.ends_with("[0]") ? base.size() - 3 : base.size());
    for (GLint element = 0; element < size; ++element) {
      const std::string name = size == 1 ? std::string(text.data()) : base + "[" + std::to_string(element) + "]";
      const GLint location = gl.GetSubroutineUniformLocation(program, stage, name.c_str());
      if (location >= 0 && static_cast<std::size_t>(location) < names.size()) {
        names[static_cast<std::size_t>(location)] = name;
      }
    }
  }
  return names;
}

core::SubroutineTable map_stage(const gl::Dispatch& gl, GLuint from, GLuint to, GLenum stage) {
  core::SubroutineTable table{stage, {}, {}};
  for (const std::string& name : names_by_location(gl, to, stage)) {
    table.location_from.push_back(name.empty() ? -1 : gl.GetSubroutineUniformLocation(from, stage, name.c_str()));
  }
  const GLint count = stage_value(gl, from, stage, GL_ACTIVE_SUBROUTINES);
  for (GLint i = 0; i < count; ++i) {
    std::array<char, 512> name{};
    gl.GetActiveSubroutineName(from, stage, static_cast<GLuint>(i), static_cast<GLsizei>(name.size()), nullptr,
                               name.data());
    table.index_to.push_back(gl.GetSubroutineIndex(to, stage, name.data()));
  }
  return table;
}

std::vector<GLuint> translate(const std::vector<GLuint>& chosen, const core::SubroutineTable& table) {
  std::vector<GLuint> result;
  for (const GLint location : table.location_from) {
    const GLuint index = location >= 0 && static_cast<std::size_t>(location) < chosen.size()
                             ? chosen[static_cast<std::size_t>(location)]
                             : 0;
    result.push_back(index < table.index_to.size() ? table.index_to[index] : 0);
  }
  return result;
}

}  // namespace

bool has_subroutine_uniforms(const gl::Dispatch& gl, const core::Program& program) {
  const std::vector<core::StageSource>& stages = program.stages;
  return gl.GetProgramStageiv != nullptr &&
         std::any_of(stages.begin(), stages.end(), [&](const core::StageSource& source) {
           return stage_value(gl, program.name, source.stage, GL_ACTIVE_SUBROUTINE_UNIFORM_LOCATIONS) > 0;
         });
}

void read_subroutines(const gl::Dispatch& gl, GLuint program, GLenum stage, core::SubroutineChoice& choice) {
  const GLint locations = stage_value(gl, program, stage, GL_ACTIVE_SUBROUTINE_UNIFORM_LOCATIONS);
  if (locations <= 0) {
    return;
  }
  core::StageSubroutines& of = choice.emplace_back();
  of.stage = stage;
  of.chosen.resize(static_cast<std::size_t>(locations));
  for (GLint location = 0; location < locations; ++location) {
    gl.GetUniformSubroutineuiv(stage, location, &of.chosen[static_cast<std::size_t>(location)]);
  }
}

void choose_subroutines(const gl::Dispatch& gl, const core::SubroutineChoice& choice,
                        const std::vector<core::SubroutineTable>& tables) {
  for (const core::StageSubroutines& of : choice) {
    const auto table = std::find_if(tables.begin(), tables.end(),
                                    [&](const core::SubroutineTable& entry) { return entry.stage == of.stage; });
    const std::vector<GLuint> chosen = table != tables.end() ? translate(of.chosen, *table) : of.chosen;
    if (!chosen.empty()) {
      gl.UniformSubroutinesuiv(of.stage, static_cast<GLsizei>(chosen.size()), chosen.data());
    }
  }
}

std::vector<core::SubroutineTable> map_subroutines(const gl::Dispatch& gl, const core::Program& from, GLuint to) {
  std::vector<core::SubroutineTable> tables;
  if (!has_subroutine_uniforms(gl, from)) {
    return tables;
  }
  for (const core::StageSource& source : from.stages) {
    const bool known = std::any_of(tables.begin(), tables.end(),
                                   [&](const core::SubroutineTable& table) { return table.stage == source.stage; });
    if (!known && stage_value(gl, from.name, source.stage, GL_ACTIVE_SUBROUTINE_UNIFORM_LOCATIONS) > 0) {
      tables.push_back(map_stage(gl, from.name, to, source.stage));
    }
  }
  return tables;
}

}  // namespace glark::refine
