// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the hooks share.
#pragma once

#include "glark/core/capture/draw_call.h"
#include "glark/core/context.h"
#include "glark/core/stages.h"
#include "glark/gl/hooks.h"
#include "include/GL/glark.h"

namespace glark::core::track {

// A draw of the application: goes into the display list being cut, or to the stages.
void draw(Context& context, const DrawCall& call);
// A draw that goes to the stages, and one that stays as it is: either may give the application's transform feedback
// back to GL.
void refine(Context& context, const DrawCall& call);
void pass(Context& context, Cause cause);
void hand_back_feedback(Context& context);

// False while a display list is compiled and not executed: the call then changes no state. To be asked by hooks of
// calls that change state that refined draws depend on.
inline bool executes(Context& context) {
  ListCompilation& lists = context.state().lists();
  lists.note_state_change();
  return !lists.compiling() || lists.executes_too();
}

// GL_CURRENT_DEPTH_TAG_ARK.
GLuint current_tag(const Context& context);
// Between glBegin and glEnd; GL_INVALID_OPERATION is then raised.
bool inside_begin(Context& context);

}  // namespace glark::core::track
