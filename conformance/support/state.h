// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The extension's state: its names, all of it set, all of it read.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "conformance/suite/test.h"

namespace glark::conformance {

enum class StateKind { integer, number, boolean };

// What GetIntegerv and its kin answer.
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

// Every state of the extension gets a value that is not its initial one; a vertex array object and a buffer are bound.
struct EverythingSet {
  GLuint array = 0;
  GLuint buffer = 0;
};
EverythingSet set_everything(Test& t);

// The extension's state, all of the generic attributes and their arrays, and what is bound. `program`: its refinement shader, too.
using Snapshot = std::map<std::string, std::string>;
Snapshot take_snapshot(Test& t, GLuint program = 0);
// Says which differ.
bool expect_unchanged(Test& t, const Snapshot& after, const Snapshot& before, const std::string& what);

// call() generates this one error and changes no state.
void expect_refused(Test& t, GLenum error, const std::string& what, const std::function<void()>& call,
                    GLuint program = 0);

}  // namespace glark::conformance
