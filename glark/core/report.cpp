// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/report.h"

namespace glark::core {
namespace {

std::atomic<LogSink> sink{nullptr};

constexpr std::array<CauseText, cause_count> cause_texts{{
    {"not_triangles", "the draw has no triangles (points, lines, patches or adjacency)", "nothing to do"},
    {"level_zero",
     "every edge has depth 0 and the refinement is a built-in one: the coarse triangle is the refined one",
     "raise the level"},
    {"no_program", "no program is in use whose sources glark has seen",
     "link programs from GLSL source while glark is loaded"},
    {"program_not_derived", "no refinement program could be derived from the application's",
     "see the log line of the program"},
    {"program_pipeline", "the program pipeline has no vertex stage whose source glark has seen",
     "give it a vertex program linked from GLSL source while glark is loaded"},
    {"program_gone", "the program in use was deleted, or its last link failed: OpenGL cannot return to it",
     "delete programs after their last draw"},
    {"program_binary", "the program was loaded from a binary, or from SPIR-V",
     "make the application compile its shaders from GLSL, for instance by clearing its cache"},
    {"assembly_program", "an ARB assembly vertex program is enabled", "use GLSL"},
    {"tessellation", "the application tessellates by itself", "nothing to do"},
    {"too_many_attributes", "the vertex attributes of three corners do not fit into the attributes of one instance",
     "use fewer or smaller attributes"},
    {"side_effects", "the vertex stage writes to buffers, images or counters, once per vertex of the application",
     "move the writes to another draw"},
    {"transform_feedback", "the application captures transform feedback", "nothing to do"},
    {"primitive_query", "the application counts primitives or pipeline statistics", "nothing to do"},
    {"polygon_mode", "the application draws polygons as lines or points",
     "nothing to do; --wireframe shows refined triangles"},
    {"render_mode", "selection or feedback is on", "nothing to do"},
    {"rasterizer_discard", "nothing is rasterised", "nothing to do"},
    {"indirect_unbounded", "the number of vertices is known to the GPU only, and has no bound",
     "use an indirect draw with a known count"},
    {"invalid_draw", "OpenGL refuses the call", "see the application's glGetError"},
    {"out_of_memory", "no memory for the coarse triangles of the draw", "draw fewer triangles a call"},
}};

}  // namespace

void set_log_sink(LogSink wanted) { sink.store(wanted, std::memory_order_relaxed); }

void log(LogLevel level, std::string_view message) {
  if (const LogSink current = sink.load(std::memory_order_relaxed); current != nullptr) {
    current(level, message);
  }
}

const CauseText& text_of(Cause cause) { return cause_texts.at(static_cast<std::size_t>(cause)); }

Statistics& statistics() {
  static Statistics* const instance = new Statistics;  // never destroyed: drivers may draw from their own exit handlers
  return *instance;
}

}  // namespace glark::core
