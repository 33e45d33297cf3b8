// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Log lines and counters of the core for its host. The core never prints; the host installs a sink.
#pragma once

#include <array>
#include <atomic>
#include <bitset>
#include <cstdint>
#include <functional>
#include <string_view>

namespace glark::core {

enum class LogLevel { error, warning, info, debug };

// Installed by the shim or a test; nullptr discards. Called from any thread.
using LogSink = void (*)(LogLevel level, std::string_view message);
void set_log_sink(LogSink sink);
void log(LogLevel level, std::string_view message);

// The reason why a draw stays unrefined. A function that decides returns std::optional<Cause>; an empty one means that
// the draw may be refined.
enum class Cause {
  not_triangles,        // points, lines, patches, adjacency
  level_zero,           // uniform level 0 with a built-in refinement: the original is the refined draw
  no_program,           // nothing bound that could be refined
  program_not_derived,  // the derived program could not be built
  program_pipeline,     // a pipeline without a vertex program that glark knows
  program_gone,         // deleted, or not linked again
  program_binary,       // a program binary or SPIR-V: there is no source to derive from
  assembly_program,     // ARB vertex program
  tessellation,         // the application has tessellation stages
  too_many_attributes,  // the coarse record does not fit
  primitive_id,         // a later stage counts the triangles
  geometry_shader,      // a geometry shader whose triangles do not depend on the corners
  side_effects,         // vertex stage writes buffers, images or atomics
  transform_feedback,   // the application captures
  primitive_query,      // the application counts primitives
  polygon_mode,         // lines or points asked for
  render_mode,          // select or feedback
  rasterizer_discard,   // nothing would be visible
  indirect_unbounded,   // a count that only the GPU knows and that cannot be bounded
  invalid_draw,         // GL will raise an error
  out_of_memory,        // no room for the capture
  left_shader,          // the user named its shader program
  screen_quad,          // transparent refinement leaves user interfaces and full-screen passes alone: plan/exemptions.h
  overlay,
  orthographic,
  blended,  // the user asked for these three
  no_depth_test,
  no_depth_writes,
};
inline constexpr unsigned cause_count = static_cast<unsigned>(Cause::no_depth_writes) + 1;

// `key` names the cause in the statistics file; `remedy` completes the log line.
struct CauseText {
  std::string_view key;
  std::string_view explanation;
  std::string_view remedy;
};
const CauseText& text_of(Cause cause);

// Process-wide counters; relaxed atomics.
struct Statistics {
  std::atomic<std::uint64_t> draws_seen{0};
  std::atomic<std::uint64_t> draws_refined{0};
  std::array<std::atomic<std::uint64_t>, cause_count> passed_through{};
  std::atomic<std::uint64_t> coarse_triangles{0};
  // Exact for uniform draws; adaptive draws count on the GPU and are added when the buffer is next reused.
  std::atomic<std::uint64_t> refined_triangles{0};
  std::atomic<std::uint64_t> captures_made{0};
  std::atomic<std::uint64_t> captures_reused{0};
  std::atomic<std::uint64_t> programs_derived{0};
  std::atomic<std::uint64_t> programs_failed{0};
};
Statistics& statistics();

// Counts the draws of a context that stay unrefined, and logs the first one of each cause.
class PassedDraws {
 public:
  void count(Cause cause);

 private:
  std::bitset<cause_count> logged_;
};

// Counts the draws of the shader programs with the same sources, in all contexts.
struct ProgramCounters {
  std::atomic<std::uint64_t> draws_seen{0};
  std::atomic<std::uint64_t> draws_refined{0};
};
ProgramCounters& program_counters(std::uint64_t hash);  // the reference stays valid
void for_each_program(const std::function<void(std::uint64_t hash, const ProgramCounters&)>& visit);

// A shader of the application, or one derived from it, for the shader sink.
struct ShownShader {
  std::uint64_t hash = 0;  // names the application's program
  unsigned program = 0;    // its name in GL; 0: fixed function
  std::string_view stage;  // "vert", "frag" ...
  std::string_view kind;   // "original", "linear", "pn-tagged" ...
  unsigned object = 0;     // number of the shader object in its stage
  std::string_view source;
};
using ShaderSink = void (*)(const ShownShader& shader);
void set_shader_sink(ShaderSink sink);
bool wants_shaders();
void show_shader(const ShownShader& shader);

}  // namespace glark::core
