// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Functions that the hooks share.
#pragma once

#include <vector>

#include "glark/core/capture/draw_call.h"
#include "glark/core/context.h"
#include "glark/core/stages.h"
#include "glark/gl/hooks.h"
#include "include/GL/glark.h"

namespace glark::core::track {

// Returns whether GL may restart a primitive within a draw without indices of vertices below `end`. OpenGL 4.6, 10.3.6,
// forbids it, but NVIDIA (580) does so at the vertex with the number of the restart index.
bool restarts_at_vertex(Context& context, std::uint64_t end);

inline bool is_index_type(GLenum type) {
  return type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT;
}

// Records the application's draw in the display list that is being cut, or gives it to the stages.
void draw(Context& context, const DrawCall& call);
// refine() gives a draw to the stages; leave() issues it unrefined. Either may give the application's transform feedback
// back to GL.
void refine(Context& context, const DrawCall& call);
void leave(Context& context, const DrawCall& call, Cause cause);
// Issues a draw that GL will refuse.
void refused(Context& context, const Issue& issue);
void hand_back_feedback(Context& context);

// A call that GL refuses while transform feedback is active and not paused. Returns whether it is one now, and raises
// GL_INVALID_OPERATION if so. GL does not: our feedback is paused between our draws.
bool refused_while_capturing(Context& context);

// GL has executed a glEnd.
void primitive_ended(Context& context);
// glMaterial, perhaps between glBegin and glEnd.
void change_material(Context& context, const MaterialChange& change);
// The vertices that follow carry these parameters of the material in attributes, until the capture ends.
void begin_materials(Context& context, MaterialSet parameters);
void end_materials(Context& context);
// While a display list is compiled: glMaterial, and glEnd.
void record_material(Context& context, const MaterialChange& change);
void record_materials_end(Context& context);
// The values of the attributes that carry materials in the segment, except for those that it sets itself.
std::vector<CurrentValue> values_under_materials(Context& context, const SegmentEffects& effects);
// Sets the attributes of these parameters as the change sets the parameters.
void carry_change(Context& context, const MaterialChange& change, MaterialSet parameters);
// Refined draws replace the fixed-function vertex stage, not a program.
bool replaces_fixed_function(Context& context);

// Returns false if the call changes no state: while a display list is compiled and not executed, and between glBegin and
// glEnd, where GL refuses it. Hooks of calls that change the state of refined draws must ask this.
inline bool executes(Context& context) {
  ListCompilation& lists = context.state().lists();
  lists.effects().touches_state = true;
  return (!lists.compiling() || lists.executes_too()) && !context.state().immediate().open();
}

// GL_CURRENT_DEPTH_TAG_ARK.
GLuint current_tag(const Context& context);
// Returns whether the call of `function` lies between glBegin and glEnd, and raises GL_INVALID_OPERATION if so.
bool inside_begin(Context& context, const char* function);

}  // namespace glark::core::track
