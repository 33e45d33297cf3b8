// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The extension's state: names all of it, sets all of it, reads all of it.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "conformance/suite/test.h"

namespace glark::conformance {

enum class StateKind { integer, number, boolean };

// A state that GetIntegerv and its relatives return.
struct StateName {
  const char* leaf;
  GLenum name;
  StateKind kind;
  const char* clause;
  const char* token_clause;
};
const std::vector<StateName>& extension_state();

GLint integer_of(GLenum name);
GLfloat number_of(GLenum name);
const void* pointer_of(GLenum name);

// The current value of a generic attribute.
std::vector<float> current_value(GLuint attribute);
GLint array_state(GLuint attribute, GLenum name);

// Gives every state of the extension a value other than its initial one. Binds a vertex array object and a buffer.
struct EverythingSet {
  GLuint array = 0;
  GLuint buffer = 0;
};
EverythingSet set_everything(Test& t);

// The extension's state, all generic attributes and their arrays, and bindings; also the refinement shader of
// `program`.
using Snapshot = std::map<std::string, std::string>;
Snapshot take_snapshot(Test& t, GLuint program = 0);
// The message says which values differ.
bool expect_unchanged(Test& t, const Snapshot& after, const Snapshot& before, const std::string& what);

// Expects call() to generate exactly this error and to change no state.
void expect_refused(Test& t, GLenum error, const std::string& what, const std::function<void()>& call,
                    GLuint program = 0);

}  // namespace glark::conformance
