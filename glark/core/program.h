// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What we know of the application's programs: the sources they were linked from and the programs derived from them.
#pragma once

#include <compare>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "glark/core/capture/record.h"
#include "glark/core/refine/derive.h"
#include "glark/core/refinement.h"
#include "glark/core/report.h"

namespace glark::core {

// Uniform locations from here on are ours: uniforms that only the application's refinement shader declares.
inline constexpr GLint virtual_location_base = 0x40000000;

struct StageSource {
  GLenum stage;
  std::shared_ptr<const std::string> source;
};

// What selects one of the programs derived from an application program.
struct DerivedKey {
  Refinement refinement = Refinement::linear_inputs;
  int provoking_corner = 2;
  bool flat_colors = false;
  bool clamp_colors = false;
  bool tagged = false;
  bool placed = true;  // pieces have a placement (patch); a uniform level of one piece a triangle needs none
  auto operator<=>(const DerivedKey&) const = default;
};

struct DerivedProgram {
  GLuint name = 0;
  capture::Layout layout;
  GLuint capture_program = 0;              // of the capture stage
  std::vector<int> input_slots;            // attributes that the capture reads, by AttributeSlot
  std::vector<GLint> location_of;          // application location -> ours, -1 where we have none
  std::vector<GLint> virtual_location_of;  // by location - virtual_location_base
};

// Where a glUniform* call of the application must also go.
struct UniformMirror {
  GLuint program = 0;
  const DerivedProgram* derived = nullptr;

  GLint location(GLint application) const {
    const auto& table = application >= virtual_location_base ? derived->virtual_location_of : derived->location_of;
    const auto index = static_cast<std::size_t>(
        application >= virtual_location_base ? application - virtual_location_base : application);
    return application >= 0 && index < table.size() ? table[index] : -1;
  }
};

struct Program {
  GLuint name = 0;  // the application's program; for fixed function a program of ours that holds the generated shader
  bool fixed_function = false;
  std::vector<StageSource> stages;
  bool from_binary = false;
  bool may_store = false;       // its shaders may write buffers
  bool prepared = false;        // fields, traits and cause below are valid
  Cause cause = Cause::count_;  // why it cannot be refined; count_ if it can
  std::vector<capture::Field> fields;
  refine::VertexStageTraits traits;
  std::map<DerivedKey, std::unique_ptr<DerivedProgram>> derived;  // null: tried, and failed
  std::vector<UniformMirror> mirrors;
  std::string refinement_source;
  std::string refinement_log;
  std::vector<std::string> virtual_uniforms;  // names, by location - virtual_location_base
  bool uniforms_stale = false;                // changed by a display list: copy all values before the next refined draw

  bool has_stage(GLenum stage) const {
    for (const StageSource& source : stages) {
      if (source.stage == stage) {
        return true;
      }
    }
    return false;
  }
};

}  // namespace glark::core
