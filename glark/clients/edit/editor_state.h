// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What an Editor holds.
#pragma once

#include "glark/clients/edit/history/change.h"
#include "glark/clients/edit/history/history.h"

namespace glark::edit {

struct Editor::State {
  EditorOptions options;
  common::Workers workers;
  Shape shape;
  Symmetric symmetric;
  History history;

  State(Sampling sampling, EditorOptions wanted)
      : options(std::move(wanted)),
        workers(options.threads),
        shape(make_shape(std::move(sampling), workers)),
        history(options.temporary) {}

  // Does the operation and adds it to the history.
  void apply(const Operation& operation);

 private:
  // The changes of the operations, which hold the new values.
  Change change_of(const Paint& paint) const;
  Change change_of(const Project& project) const;
  Change change_of(const Refine& refine) const;
  template <class Kind>
  Change change_of(const Kind& operation) const;

  // Undo, Redo and Symmetric are no changes of the shape.
  template <class Kind>
  void do_it(const Kind& operation);
  void do_it(const Undo& undo);
  void do_it(const Redo& redo);
  void do_it(const Symmetric& wanted) { symmetric = wanted; }

  void move_in_history(std::vector<char> bytes, void (History::*move)(std::span<const char>));
  void turn_normals(Change& done);
};

}  // namespace glark::edit
