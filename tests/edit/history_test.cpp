// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// Undo and redo.
#include <random>

#include "tests/edit/samplings.h"

namespace glark::edit {
namespace {

const char* const steps[] = {"paint 0 0 1 0.5 255 0 0",
                             "inflate 0 0 1 0.5 0.1",
                             "symmetric on y 0.1",
                             "smooth 0 0 1 0.8 0.5",
                             "move 1 0 0 0.5 0.2 0 0.1",
                             "bend -1 0 0 1 0 0 0 0 1 30",
                             "twist 0 0 -1 0 0 1 50",
                             "symmetric off",
                             "deform 0 0 1 0.4 0 0 1 0.9 0 0 0.3",
                             "paint 1 0 0 0.7 0 90 0 0.3"};

TEST(History, UndoAndRedoRestoreTheBytes) {
  Editor editor(sphere(400));
  std::vector<std::string> states{bytes_of(editor)};
  for (const char* line : steps) {
    apply(editor, line);
    if (editor.undo_count() == states.size()) states.push_back(bytes_of(editor));
  }
  ASSERT_EQ(states.size(), 9U);  // symmetric is no step
  for (std::size_t k = states.size() - 1; k-- > 0;) {
    apply(editor, "undo");
    EXPECT_TRUE(bytes_of(editor) == states[k]) << k;
  }
  EXPECT_EQ(editor.undo_count(), 0U);
  for (std::size_t k = 1; k < states.size(); ++k) {
    apply(editor, "redo");
    EXPECT_TRUE(bytes_of(editor) == states[k]) << k;
  }
  EXPECT_EQ(editor.redo_count(), 0U);
}

TEST(History, AnyWayThroughItIsThatOfAStack) {
  Editor editor(sphere(100));
  std::vector<std::string> states{bytes_of(editor)};
  std::size_t now = 0;
  std::mt19937 random(5);
  for (int step = 0; step < 300; ++step) {
    const std::size_t choice = random() % 5;
    if (choice < 2 && now > 0) {
      apply(editor, "undo");
      --now;
    } else if (choice == 2 && now + 1 < states.size()) {
      apply(editor, "redo");
      ++now;
    } else {
      editor.apply(
          Inflate{{{0, 0, random() % 2 == 0 ? 1.0 : -1.0}, 0.5 + 0.01 * static_cast<double>(random() % 9)}, 0.01});
      states.resize(++now);
      states.push_back(bytes_of(editor));
    }
    ASSERT_TRUE(bytes_of(editor) == states[now]) << step;
    ASSERT_EQ(editor.undo_count(), now);
    ASSERT_EQ(editor.redo_count(), states.size() - 1 - now);
  }
}

TEST(History, ItsEndsAreExplained) {
  Editor editor(plane(5));
  EXPECT_EQ(problem_of([&] { apply(editor, "undo"); }), "undo: there is no operation before");
  EXPECT_EQ(problem_of([&] { apply(editor, "redo"); }), "redo: no operation is undone");
}

// For each sample in the ball, two new ones between it and its neighbours.
Refined more_samples(const Refine& refine, const Editor& editor) {
  Refined refined;
  for (std::size_t i = 0; i < editor.size(); ++i) {
    if (distance(position(editor.positions(), i), common::to_vector(refine.ball.centre)) > refine.ball.radius) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      refined.before.positions.push_back(editor.positions_before()[3 * i + k] + (k == 0 ? 0.01 : 0));
      refined.before.normals.push_back(editor.normals_before()[3 * i + k]);
      refined.after.positions.push_back(editor.positions()[3 * i + k] + (k == 0 ? 0.01 : 0));
    }
  }
  return refined;
}

TEST(History, RefinementsAreUndone) {
  Editor* address = nullptr;
  EditorOptions options;
  options.refine = [&](std::span<const Refine> balls) { return more_samples(balls.front(), *address); };
  Editor editor(plane(21), options);
  address = &editor;
  std::vector<std::string> states{bytes_of(editor)};
  for (const char* line :
       {"inflate 0 0 0 0.5 0.2", "refine 0 0 0 0.4", "paint 0 0 0 0.4 9 9 9", "move 0 0 0 0.4 0 0 1"}) {
    apply(editor, line);
    states.push_back(bytes_of(editor));
  }
  EXPECT_GT(editor.size(), 441U);
  for (int round = 0; round < 2; ++round) {
    for (std::size_t k = 4; k-- > 0;) {
      apply(editor, "undo");
      EXPECT_TRUE(bytes_of(editor) == states[k]) << k;
    }
    EXPECT_EQ(editor.size(), 441U);
    for (std::size_t k = 1; k < 5; ++k) {
      apply(editor, "redo");
      EXPECT_TRUE(bytes_of(editor) == states[k]) << k;
    }
  }
}

}  // namespace
}  // namespace glark::edit
