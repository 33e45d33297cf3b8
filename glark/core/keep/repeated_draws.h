// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Draws of kept refined vertices that come again. A plan, and the key of its draw, are long. They give the same refined
// vertices as last time if everything that they depend on is the same as last time, and comparing that is short.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "glark/core/capture/draw_call.h"
#include "glark/core/keep/draw_cache.h"
#include "glark/core/report/refinement_fallback.h"
#include "glark/core/state/environment.h"

namespace glark::core {

class RepeatedDraws {
 public:
  explicit RepeatedDraws(const Environment& environment) : env_(environment) {}

  // What a draw of kept vertices needs from its plan.
  struct Planned {
    const Program* program = nullptr;  // its vertex stage is refined
    DrawCache::Entry* entry = nullptr;
    std::optional<RefinementFallback> fallback;
  };
  // Null: the draw must be planned. `fixed_function`: the program that stands for it, if its state is known to be the
  // same; else null.
  const Planned* find(const DrawCall& call, const Program* fixed_function);
  // The draw was planned, and its kept vertices were drawn. `inputs`: the slots that its capture reads. `buffers`: what
  // it reads, in the order of the states of the entry.
  void note(const DrawCall& call, const Program* fixed_function, const Planned& planned, std::span<const int> inputs,
            std::span<const GLuint> buffers);
  void forget();

 private:
  // The options that plans depend on.
  struct PlannedOptions {
    bool transparent = false;
    unsigned level = 0;
    unsigned max_level = 0;
    Refinement refinement = Refinement::linear_inputs;
    bool smooth = false;
    ShapeNumbers shape_numbers{};
    bool weld = false;
    float crease = 0;
    bool geometry_normals = false;
    bool geomorph = false;
    bool centroids = false;
    EdgeMeasure measure;
    unsigned left_draws = 0;
    bool keeps_vertices = false;
    bool operator==(const PlannedOptions&) const = default;
  };
  // The state that the plans of all draws depend on. Programs have few of them in a frame.
  struct State {
    PlannedModes modes;
    ArkState ark;
    PlannedOptions options;
    bool operator==(const State&) const = default;
  };
  struct Identity {
    ArrayDraw arrays;
    std::uint64_t segment = 0;  // of a display list
    GLuint vertex_array = 0;
    const Program* program = nullptr;  // in use
    const Program* fixed_function = nullptr;
    std::size_t state = 0;
    bool operator==(const Identity&) const = default;
  };
  struct Source {
    int slot = 0;
    AttributeSource array;
  };
  struct Value {
    int slot = 0;
    std::optional<CurrentValue> value;  // empty: not known, but set in this era
    std::uint64_t era = 0;
  };
  struct Buffer {
    GLuint name = 0;
    BufferStamps::State state;
  };
  struct Repeat {
    Identity identity;
    std::weak_ptr<const char> lifetime;  // of the refined vertices
    std::uint64_t array_version = 0;
    std::vector<Source> sources;
    BoundBuffer elements;
    std::vector<Value> values;
    std::vector<Buffer> buffers;
    Planned planned;
    bool repeated = false;
  };

  static PlannedOptions options_of(const ContextOptions& options);
  bool may_repeat(const DrawCall& call) const;
  void follow_programs();
  bool same_options(const PlannedOptions& old) const;
  bool is_now(const State& state) const;
  std::size_t number_of_state();
  Identity identity_of(const DrawCall& call, const Program* fixed_function);
  std::uint64_t hash_of(const Identity& identity) const;
  Repeat* look_up(std::uint64_t hash) const;
  Repeat& place_for(std::uint64_t hash);
  bool same_arrays(Repeat& repeat) const;
  bool same_sources(const Repeat& repeat, const VertexArray& array) const;
  bool same_values(const Repeat& repeat) const;
  bool same_buffers(const Repeat& repeat) const;
  bool note_sources(const DrawCall& call, std::span<const int> inputs, Repeat& repeat);
  void note_value(int slot, Repeat& repeat) const;
  void note_inherited(const ListSegment& segment, std::span<const int> inputs, Repeat& repeat) const;

  const Environment& env_;
  std::uint64_t program_epoch_ = 0;
  std::vector<State> states_;
  std::size_t state_ = 0;  // of the last draw, in `states_`
  struct Place {
    std::uint64_t hash = 0;
    std::unique_ptr<Repeat> repeat;
  };
  unsigned wasted_notes_ = 0;  // in a row, of draws that did not repeat
  unsigned skipped_notes_ = 0;
  std::vector<Place> table_;  // by the last bits of the hash
};

}  // namespace glark::core
