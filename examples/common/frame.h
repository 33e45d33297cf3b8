// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// What the window and the picture have in common.
#pragma once

#include "examples/common/lesson.h"

namespace lesson {

struct Arguments {
  std::string picture;  // empty: a window
  int width, height;
  std::string keys;
  double seconds = 0;
  int frames = 1;
};

struct View {
  float turn = 0, tilt = 0;  // degrees, from dragging the mouse
  int width = 640, height = 480;
  float aspect = 4.0F / 3;  // of the part that is drawn: width by height
};
View& view();

// While it is true, say() says nothing.
bool& silent();

// Clears the buffer, sets the viewport and draws.
void draw_frame(const Lesson& lesson, int width, int height, double seconds);

// Returns false if the lesson has no such key.
bool press(const Lesson& lesson, char key);
// Presses the keys of --press, one after the other; a key that the lesson does not have is a std::runtime_error.
void press_all(const Lesson& lesson, const std::string& keys);

// Both return the exit status.
int show_window(const Lesson& lesson, const Arguments& arguments);
int write_picture(const Lesson& lesson, const Arguments& arguments);

}  // namespace lesson
