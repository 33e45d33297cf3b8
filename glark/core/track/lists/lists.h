// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Functions that the hooks of display lists share with each other and with the hooks of draws.
#pragma once

#include <functional>
#include <memory>

#include "glark/core/capture/draw_call.h"
#include "glark/core/context.h"
#include "glark/core/state/lists/display_list.h"

namespace glark::core::track {

inline constexpr int deepest_nesting = 64;  // OpenGL's own minimum of GL_MAX_LIST_NESTING

// Null: the list does not exist, or it was compiled before glark knew the context.
std::shared_ptr<DisplayList> find_list(const Context& context, GLuint name);
// GL_LIST_BASE.
GLuint list_base(Context& context);
// Repeats the changes that an executed list made on GL's attribute stack on our stack.
void follow_stack(Context& context, GLuint list);

// While a list is compiled (cut_list.cpp). list_begin and list_end return false if the list is not cut here.
void record_draw(Context& context, const DrawCall& call);
bool list_begin(Context& context, GLenum mode);
bool list_end(Context& context);
void record_call(Context& context, GLuint name);
void record_calls(Context& context, GLsizei n, GLenum type, const void* lists);
void delete_segments(Context& context, const DisplayList& list);
// Makes a call that is not compiled, although a list may be.
void outside_list(Context& context, const std::function<void()>& call);

// While a list is called (call_list.cpp).
// `base` is the list base of a call by glCallLists, as it was when that began: a called list may change GL_LIST_BASE.
void call_segment(Context& context, const ListSegment& segment, GLuint base, int depth);
void follow_stacks(Context& context, GLuint base, GLsizei n, GLenum type, const void* lists);
// A list may have changed state unseen. Null: an unknown list, or one that calls others.
void forget_state(Context& context, const DisplayList* list);

// One segment (run_segment.cpp).
void run_state(Context& context, const ListSegment& segment);
void run_draw(Context& context, const ListSegment& segment, std::uint64_t triangles);
// Applies the effects of a segment's calls to the current values.
void apply_effects(Context& context, const SegmentEffects& effects);

}  // namespace glark::core::track
