// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the hooks share.
#pragma once

#include <memory>

#include "glark/core/capture/draw_call.h"
#include "glark/core/context.h"
#include "glark/core/stages.h"
#include "glark/gl/hooks.h"
#include "include/GL/glark.h"

namespace glark::core::track {

// A draw of the application: goes into the display list being cut, or to the stages.
void draw(Context& context, const DrawCall& call);
// A draw that goes to the stages, and one that stays as it is: either may give the application's transform feedback back to GL.
void refine(Context& context, const DrawCall& call);
void pass(Context& context, Cause cause);
void hand_back_feedback(Context& context);

// While a display list is compiled (and not executed) state does not change.
inline bool executes(Context& context) {
  context.state().lists().segment.touches_state = true;  // the segment that is being compiled, if any
  return !context.state().lists().compiling || context.state().lists().mode == GL_COMPILE_AND_EXECUTE;
}

// Display lists.
constexpr int deepest_nesting = 64;  // OpenGL's own minimum of GL_MAX_LIST_NESTING
std::shared_ptr<DisplayList> find_list(Context& context, GLuint name);
GLuint list_base(Context& context);
void follow_stack(Context& context, GLuint list);  // which has been executed: what it did to the attribute stack
void record_draw(Context& context, const DrawCall& call);
bool list_begin(Context& context, GLenum mode);
bool list_end(Context& context);
void apply_effects(Context& context, const SegmentEffects& effects);
void forget_uniforms(Context& context);  // a list has set some of the current program
void run_state(Context& context, const ListSegment& segment);
void run_draw(Context& context, const ListSegment& segment, std::uint64_t triangles);

// Errors of ours.
GLuint current_tag(const Context& context);  // GL_CURRENT_DEPTH_TAG_ARK
bool inside_begin(Context& context);         // raises GL_INVALID_OPERATION between glBegin and glEnd

}  // namespace glark::core::track
