// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/keep/repeated_draws.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

#include "glark/core/state/lists/display_list.h"

namespace glark::core {
namespace {

constexpr std::size_t most_states = 64;
constexpr std::size_t least_places = 256;
constexpr std::size_t most_places = 32768;  // four for each draw of the cache
constexpr std::size_t most_steps = 8;       // from the place of a hash to the place of its draw
constexpr unsigned most_wasted_notes = 64;  // in a row; then most draws are not noted
constexpr unsigned noted_draws = 16;        // one of so many is noted then

std::uint64_t mix(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0xff51afd7ed558ccdU;
  return hash ^ hash >> 32;
}

std::uint64_t pair_of(std::uint64_t low, std::uint64_t high) { return low ^ high << 32; }

std::uint64_t number_of(const void* address) { return reinterpret_cast<std::uintptr_t>(address); }

// Equal bytes are equal values, and comparing them is short. Bytes may differ between members, too: then the values are
// compared.
template <typename Value>
bool same(const Value& a, const Value& b) {
  static_assert(std::is_trivially_copyable_v<Value>);
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): only a positive answer counts
  return std::memcmp(&a, &b, sizeof(Value)) == 0 || a == b;
}

}  // namespace

void RepeatedDraws::forget() {
  table_.clear();
  states_.clear();
}

RepeatedDraws::PlannedOptions RepeatedDraws::options_of(const ContextOptions& options) {
  return {.transparent = options.transparent,
          .level = options.level,
          .max_level = options.max_level,
          .refinement = options.refinement,
          .smooth = options.smooth,
          .shape_numbers = options.shape_numbers,
          .weld = options.weld,
          .crease = options.crease,
          .geometry_normals = options.geometry_normals,
          .geomorph = options.geomorph,
          .centroids = options.centroids,
          .measure = options.measure,
          .left_draws = options.left_draws,
          .keeps_vertices = options.kept_vertex_bytes > 0};
}

// False: something that is not compared takes part in the plan, or watches the draw.
bool RepeatedDraws::may_repeat(const DrawCall& call) const {
  const Bindings& b = env_.bindings();
  const ContextOptions& options = env_.options;
  const bool plain = call.exact && (call.arrays != nullptr || call.segment != nullptr) && call.commands.empty() &&
                     call.materials == 0 && call.polygon_sides == nullptr;
  const bool counted =
      b.transform_feedback.active || (options.transparent && b.queries.primitives()) || options.read_counts;
  const bool chosen = options.live.watches_draws() || !options.rules.empty();
  const bool program_known = b.program != 0 ? env_.state.programs().current() != nullptr : b.pipeline == 0;
  return plain && !counted && !chosen && program_known && !b.rasterizer_discard && !env_.state.immediate().open();
}

// Programs that were linked again, deleted, or given another refinement shader, are other programs.
void RepeatedDraws::follow_programs() {
  const std::uint64_t epoch = env_.share.program_epoch.load(std::memory_order_relaxed);
  if (epoch != program_epoch_) {
    program_epoch_ = epoch;
    forget();
  }
}

// Plans depend on one option alone if the program uses the extension.
bool RepeatedDraws::same_options(const PlannedOptions& old) const {
  const ContextOptions& options = env_.options;
  return options.transparent || old.transparent ? old == options_of(options)
                                                : old.keeps_vertices == (options.kept_vertex_bytes > 0);
}

bool RepeatedDraws::is_now(const State& state) const {
  return same<PlannedModes>(state.modes, env_.bindings()) && same(state.ark, env_.ark) && same_options(state.options);
}

std::size_t RepeatedDraws::number_of_state() {
  if (state_ < states_.size() && is_now(states_[state_])) {
    return state_;
  }
  const auto found = std::find_if(states_.begin(), states_.end(), [&](const State& state) { return is_now(state); });
  state_ = static_cast<std::size_t>(found - states_.begin());
  if (found == states_.end()) {
    if (states_.size() == most_states) {
      forget();
    }
    state_ = states_.size();
    states_.push_back({env_.bindings(), env_.ark, options_of(env_.options)});
    // With the bytes between the members, so that comparing bytes tells that nothing has changed.
    std::memcpy(&states_.back().modes, static_cast<const PlannedModes*>(&env_.bindings()), sizeof(PlannedModes));
    std::memcpy(&states_.back().ark, &env_.ark, sizeof(ArkState));
  }
  return state_;
}

RepeatedDraws::Identity RepeatedDraws::identity_of(const DrawCall& call, const Program* fixed_function) {
  const Program* const program = env_.state.programs().current().get();
  return {.arrays = call.arrays != nullptr ? *call.arrays : ArrayDraw{},
          .segment = call.segment != nullptr ? call.segment->identity : 0,
          .vertex_array = env_.bindings().vertex_array,
          .program = program,
          .fixed_function = program == nullptr ? fixed_function : nullptr,
          .state = number_of_state()};
}

// Programs without vertex array objects draw all their objects from one vertex array: its buffers tell them apart.
std::uint64_t RepeatedDraws::hash_of(const Identity& identity) const {
  const VertexArray& array = env_.state.arrays().current();
  const AttributeSource& first = array.sources[0];
  const AttributeSource& vertex = array.sources[vertex_slot];
  const ArrayDraw& draw = identity.arrays;
  std::uint64_t hash = mix(identity.segment, number_of(draw.indices));
  hash = mix(hash, pair_of(static_cast<std::uint32_t>(draw.first), static_cast<std::uint32_t>(draw.count)));
  hash = mix(hash, pair_of(static_cast<std::uint32_t>(draw.base_vertex), draw.mode));
  hash = mix(hash, pair_of(identity.vertex_array, identity.state));
  hash = mix(hash, number_of(identity.program) ^ number_of(identity.fixed_function));
  hash = mix(hash, pair_of(first.buffer, array.elements.name));
  hash = mix(hash, vertex.buffer);
  return mix(hash, pair_of(static_cast<std::uint64_t>(first.offset), static_cast<std::uint64_t>(vertex.offset)));
}

RepeatedDraws::Repeat* RepeatedDraws::look_up(std::uint64_t hash) const {
  for (std::size_t step = 0; step < most_steps && !table_.empty(); ++step) {
    const Place& place = table_[(hash + step) & (table_.size() - 1)];
    if (place.hash == hash && place.repeat != nullptr) {
      return place.repeat.get();
    }
  }
  return nullptr;
}

// An empty repeat in the place of the hash.
RepeatedDraws::Repeat& RepeatedDraws::place_for(std::uint64_t hash) {
  if (table_.empty()) {
    table_.resize(least_places);
  }
  const auto takes = [&](const Place& place) {
    return place.repeat == nullptr || place.hash == hash || place.repeat->lifetime.expired();
  };
  for (;;) {
    for (std::size_t step = 0; step < most_steps; ++step) {
      Place& place = table_[(hash + step) & (table_.size() - 1)];
      if (takes(place) || (table_.size() == most_places && step + 1 == most_steps)) {
        wasted_notes_ += place.repeat != nullptr && !place.repeat->repeated ? 1 : 0;
        place = {hash, std::make_unique<Repeat>()};
        return *place.repeat;
      }
    }
    std::vector<Place> old(2 * table_.size());
    std::swap(old, table_);
    for (Place& place : old) {
      if (place.repeat != nullptr && !place.repeat->lifetime.expired()) {
        place_for(place.hash) = std::move(*place.repeat);
      }
    }
  }
}

bool RepeatedDraws::same_sources(const Repeat& repeat, const VertexArray& array) const {
  const bool same_elements =
      repeat.elements.name == 0 || (array.elements.known && array.elements.name == repeat.elements.name &&
                                    array.elements.generation == repeat.elements.generation);
  return same_elements && std::all_of(repeat.sources.begin(), repeat.sources.end(), [&](const Source& source) {
           return (array.known & slot_bit(source.slot)) != 0 &&
                  array.sources[static_cast<std::size_t>(source.slot)] == source.array;
         });
}

// The plan of a program that does not know of the extension depends on other arrays, too.
bool RepeatedDraws::same_arrays(Repeat& repeat) const {
  const VertexArray& array = env_.state.arrays().current();
  if (array.version == repeat.array_version) {
    return true;
  }
  if (env_.options.transparent || !same_sources(repeat, array)) {
    return false;
  }
  repeat.array_version = array.version;
  return true;
}

bool RepeatedDraws::same_values(const Repeat& repeat) const {
  const CurrentValues& values = env_.state.arrays().current_values();
  return std::all_of(repeat.values.begin(), repeat.values.end(), [&](const Value& old) {
    const CurrentValue* const value = values.find(old.slot);
    return value != nullptr ? old.value && is_same_call(*value, *old.value) : !old.value && values.era() == old.era;
  });
}

bool RepeatedDraws::same_buffers(const Repeat& repeat) const {
  return std::all_of(repeat.buffers.begin(), repeat.buffers.end(),
                     [&](const Buffer& buffer) { return env_.share.buffers.state(buffer.name) == buffer.state; });
}

const RepeatedDraws::Planned* RepeatedDraws::find(const DrawCall& call, const Program* fixed_function) {
  if (!may_repeat(call)) {
    return nullptr;
  }
  follow_programs();
  const Identity identity = identity_of(call, fixed_function);
  Repeat* const repeat = look_up(hash_of(identity));
  const bool same = repeat != nullptr && repeat->identity == identity && !repeat->lifetime.expired() &&
                    same_arrays(*repeat) && same_values(*repeat) && same_buffers(*repeat);
  if (!same) {
    return nullptr;
  }
  repeat->repeated = true;
  wasted_notes_ = 0;
  return &repeat->planned;
}

void RepeatedDraws::note_value(int slot, Repeat& repeat) const {
  const CurrentValues& values = env_.state.arrays().current_values();
  const CurrentValue* const value = values.find(slot);
  repeat.values.push_back({slot, value != nullptr ? std::optional(*value) : std::nullopt, values.era()});
}

// Notes the values that the vertices of the segment inherit.
void RepeatedDraws::note_inherited(const ListSegment& segment, std::span<const int> inputs, Repeat& repeat) const {
  for (const int slot : inputs) {
    if (slot != vertex_slot && slot != 0 && (segment.effects.own & slot_bit(slot)) == 0) {
      note_value(slot, repeat);
    }
  }
}

// Notes the arrays and current values that the inputs come from. Returns false if an input lies in client memory, which
// may change without a call.
bool RepeatedDraws::note_sources(const DrawCall& call, std::span<const int> inputs, Repeat& repeat) {
  ArrayState& arrays = env_.state.arrays();
  const auto note = [&](int slot) {
    const AttributeSource& source = arrays.attribute_source(slot);
    repeat.sources.push_back({slot, source});
    if (!source.enabled) {
      note_value(slot, repeat);
    }
    return !source.enabled || source.buffer != 0;
  };
  const bool tags_watched = note(generic_slot(env_.ark.tag_attribute));
  if (call.arrays == nullptr) {
    note_inherited(*call.segment, inputs, repeat);
    return true;
  }
  bool watched = tags_watched;
  if (call.arrays->index_type != 0) {
    repeat.elements = arrays.element_buffer();
    watched &= repeat.elements.name != 0;
  }
  for (const int slot : inputs) {
    const bool is_vertex = env_.capabilities.is_compatibility() && (slot == vertex_slot || slot == 0);
    watched &= slot != no_slot && note(is_vertex ? 0 : slot);
    if (is_vertex && !repeat.sources.back().array.enabled) {  // the array of attribute 0 has precedence
      watched &= note(vertex_slot);
    }
  }
  return watched;
}

void RepeatedDraws::note(const DrawCall& call, const Program* fixed_function, const Planned& planned,
                         std::span<const int> inputs, std::span<const GLuint> buffers) {
  const std::shared_ptr<Program>& current = env_.state.programs().current();
  const bool stores = current != nullptr && current->may_store;
  const bool fixed_function_known = !planned.program->fixed_function || planned.program == fixed_function;
  // A program that changed since find() was planned before or after the change.
  const bool programs_stay = env_.share.program_epoch.load(std::memory_order_relaxed) == program_epoch_;
  const bool wastes = wasted_notes_ > most_wasted_notes && ++skipped_notes_ % noted_draws != 0;
  if (wastes || !may_repeat(call) || stores || !fixed_function_known || !programs_stay) {
    return;
  }
  Repeat repeat;
  repeat.identity = identity_of(call, fixed_function);
  repeat.lifetime = planned.entry->vertices.lifetime;
  repeat.planned = planned;
  if (!note_sources(call, inputs, repeat)) {
    return;
  }
  repeat.array_version = env_.state.arrays().current().version;
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    repeat.buffers.push_back({buffers[i], planned.entry->states[i]});
  }
  place_for(hash_of(repeat.identity)) = std::move(repeat);
}

}  // namespace glark::core
