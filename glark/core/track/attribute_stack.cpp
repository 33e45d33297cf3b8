// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Hooks of the attribute stack, which saves GL_ARK with the group of GL_ENABLE_BIT. GL_ARK itself is never compiled
// into a list, but glPushAttrib and glPopAttrib are. After a list was executed, our stack repeats the list's changes of
// GL's stack.
#include "glark/core/track/lists/lists.h"
#include "glark/core/track/track.h"

namespace glark::core {
namespace {

void push(Context& c, GLbitfield mask) {
  c.attribute_stack().push(mask, c.ark().enabled, c.capabilities().attribute_stack);
}

void pop(Context& c) {
  if (c.attribute_stack().restores_textures()) {
    c.textures().to_any();
  }
  if (const std::optional<bool> enabled = c.attribute_stack().pop()) {
    c.ark().enabled = *enabled;
    c.update_refining();
  }
}

void follow(Context& c, GLuint name, int depth) {
  const std::shared_ptr<DisplayList> list = depth < track::deepest_nesting ? track::find_list(c, name) : nullptr;
  if (list == nullptr) {
    return;
  }
  for (const StackStep& step : list->stack_steps) {
    switch (step.kind) {
      case StackStep::Kind::push: push(c, step.value); break;
      case StackStep::Kind::pop: pop(c); break;
      case StackStep::Kind::call: follow(c, step.value, depth + 1); break;
      case StackStep::Kind::call_offset: follow(c, track::list_base(c) + step.value, depth + 1); break;
    }
  }
}

void record(Context& c, StackStep step) {
  if (c.state().lists().add_stack_step(step)) {
    c.share().lists_push = true;
  }
}

}  // namespace

void track::follow_stack(Context& c, GLuint list) {
  if (c.share().lists_push && !c.state().immediate().open()) {
    follow(c, list, 0);
  }
}

namespace hook {

void PushAttrib(Context& c, GLbitfield mask) {
  c.gl().PushAttrib(mask);
  record(c, {StackStep::Kind::push, mask});
  if (track::executes(c)) {
    push(c, mask);
  }
}

void PopAttrib(Context& c) {
  c.gl().PopAttrib();
  c.changes().forget_in_list();
  record(c, {StackStep::Kind::pop});
  if (!track::executes(c)) {
    return;
  }
  c.state().forget_bindings();
  c.state().fixed_function().touch();
  c.state().arrays().forget_current_values();  // GL_CURRENT_BIT
  pop(c);
}

}  // namespace hook
}  // namespace glark::core
