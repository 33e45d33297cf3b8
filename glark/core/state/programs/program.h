// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What we know of the application's programs: the sources they were linked from and the programs derived from them.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "glark/core/capture/record.h"
#include "glark/core/objects/quiet.h"
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

// The same for the same sources in every run: what users name a shader program by.
std::uint64_t source_hash(const std::vector<StageSource>& stages);
std::string hash_text(std::uint64_t hash);  // 16 hexadecimal digits
bool reads_conventional_projection(const std::vector<StageSource>& stages);

// What selects one of the programs derived from an application program.
struct DerivedKey {
  Refinement refinement = Refinement::linear_inputs;
  int provoking_corner = 2;
  bool flat_colors = false;
  bool clamp_colors = false;
  bool tagged = false;
  bool at_corner = false;            // no refinement: gives the position of each captured corner, for measured depths
  int discontinuity_attribute = -1;  // locations of the tags; -1 where vertices carry none
  int scalar_tag_attribute = -1;
  bool displaced = false;
  int coordinate_attribute = -1;  // of the displacement; -1: the input with that role
  bool morphing = false;          // vertices move between levels
  bool welded = false;            // by position: curved edges have control points in the record, where there is room
  bool border = false;            // by position: what displacement takes on edges is in the record, where there is room
  bool turns = false;  // by position: the greatest turn of each edge's sides is in the record, where there is room
  bool placed = true;  // pieces have a placement (patch); a uniform level of one piece a triangle needs none
  auto operator<=>(const DerivedKey&) const = default;
};

// What a stage of the program in use has chosen: the subroutine for each location of its subroutine uniforms.
struct StageSubroutines {
  GLenum stage = 0;
  std::vector<GLuint> chosen;
};
using SubroutineChoice = std::vector<StageSubroutines>;

// From the numbers of the application's subroutines to those of a derived program.
struct SubroutineTable {
  GLenum stage = 0;
  std::vector<GLint> location_from;  // by location of ours: the application's
  std::vector<GLuint> index_to;      // by index of the application's: ours
};

struct DerivedProgram {
  GLuint name = 0;
  capture::Layout layout;
  GLint shape_number = -1;  // location of the uniform with ShapeNumber's value
  GLint height_map = -1;    // locations of the uniforms of displacement
  GLint height_channel = -1;
  GLint height_range = -1;
  GLint first_word = -1;                   // location, in a program that reads the records from the storage block
  bool numbered = false;                   // such a program, and its instances are numbered by an attribute
  std::vector<GLint> location_of;          // application location -> ours, -1 where we have none
  std::vector<GLint> virtual_location_of;  // by location - virtual_location_base
  std::vector<SubroutineTable> subroutines;

  bool stored() const { return first_word >= 0; }
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
  // Contexts that share the program draw with it in their own threads; guards all that follows. Recursive: what derives a
  // program is called from draws and from queries.
  mutable std::recursive_mutex mutex;
  GLuint name = 0;  // the application's program; for fixed function a program of ours that holds the generated shader
  bool fixed_function = false;
  std::vector<StageSource> stages;
  bool from_binary = false;
  bool linked =
      true;  // by its last glLinkProgram; otherwise what it ran before stays in use, and GL cannot return to it
  bool may_store = false;      // its shaders may write buffers
  bool prepared = false;       // fields, traits and cause below are valid
  std::optional<Cause> cause;  // why it cannot be refined
  std::vector<capture::Field> fields;
  refine::VertexStageTraits traits;
  bool subroutines_asked = false;  // the next is valid
  bool uses_subroutines = false;
  std::map<DerivedKey, std::shared_ptr<DerivedProgram>> derived;  // null: tried, and failed
  std::vector<UniformMirror> mirrors;
  std::string refinement_source;
  std::string refinement_log;
  std::vector<std::string> virtual_uniforms;  // names, by location - virtual_location_base
  std::uint64_t hash = 0;                     // of the sources; what the user names it by
  bool left_alone = false;                    // by that hash
  bool conventional_projection = false;       // its vertex stage may multiply by GL_PROJECTION_MATRIX
  ProgramCounters* counters = nullptr;        // from `prepared` on
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

// The mirrors of a program, which stand still while this lives; what is told to them, debug output does not hear.
class LockedMirrors {
 public:
  LockedMirrors() = default;
  LockedMirrors(std::shared_ptr<const Program> program, const gl::Dispatch& gl, bool audible)
      : program_(std::move(program)),
        lock_(program_->mutex),
        mirrors_(program_->mirrors),
        quiet_(gl, audible && !mirrors_.empty()) {}
  auto begin() const { return mirrors_.begin(); }
  auto end() const { return mirrors_.end(); }

 private:
  std::shared_ptr<const Program> program_;
  std::unique_lock<std::recursive_mutex> lock_;
  std::span<const UniformMirror> mirrors_;
  Quiet quiet_;
};

}  // namespace glark::core
