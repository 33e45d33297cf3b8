// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// One change between two draws, in many circumstances (combinations.h). An implementation may keep what a draw has
// computed (11.R.13), but the next draw has to see every change. Linear refinement is invisible, and so is a curved one
// of flat triangles, so the expected picture is that of the same draw without refinement.
#pragma once

#include <vector>

#include "conformance/changes/scene.h"

namespace glark::conformance {

// What a change concerns, and so which draws show it. `instances`: which vertices an instance reads. `integers`: what only
// a scene that reads all its inputs has.
enum class Concern { arrays, instances, indices, commands, state, integers };

// A row of a table of changes.
struct Change {
  const char* leaf;  // of the case's name: the command, or what is special
  // The commands of GL that make the change, by their names in gl.xml without "gl". tests/conformance/check_commands.py
  // reads them.
  std::vector<const char*> commands;
  Concern concern;
  void (*make)(Test& t, Scene& scene);
  Apis apis = every_api;
  int version = 0;               // the version of desktop GL that has the commands, if it is more than 4.3
  bool changes_program = false;  // its uniforms, or the program itself
};

// One table of several.
std::vector<Change> joined(std::vector<std::vector<Change>> tables);

// The rows of all tables that have become cases.
const std::vector<const Change*>& all_changes();

// Makes a case "ark.change.AREA.LEAF" of each change, and "ark.change.AREA.LEAF.compiled" of those of state. `first`: the number of the first change, for combinations_of().
std::vector<Case> change_cases(const char* area, const std::vector<Change>& changes, std::size_t first);

}  // namespace glark::conformance
