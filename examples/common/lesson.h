// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
//
// The set-up that all examples and lessons share: a window with keys, or a picture without a display.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace lesson {

enum class Api { compatibility, core, gles };

struct Key {
  char key;
  const char* help;  // what the key does, in a few words
  std::function<void()> press;
};

struct Lesson {
  const char* title;                         // of the window
  std::vector<Key> keys;                     // {'d', "one level deeper", [] { ++level; }}: shown by --help and on h
  std::function<void()> begin;               // once, with a current context
  std::function<void(double seconds)> draw;  // each frame; the buffer is cleared, the viewport is set
  Api api = Api::compatibility;
  int width = 640, height = 480;  // unless --size says otherwise
};

// The whole of main(). Without arguments, it opens a window. With --png FILE, or FILE alone, it writes a picture and
// needs no display.
//   --size 640x480     of the window or the picture
//   --press KEYS       presses these keys first
//   --seconds T        the time that draw() gets for the picture; 0 if not given
//   --frames N         draws N frames; the picture shows the last one
// Returns the exit status. begin() and draw() may throw a std::exception: its text is printed, the status is 1.
int run(int argc, char** argv, const Lesson& lesson);

// Shows one line of text: in the title of the window, or on standard output with --png.
void say(const std::string& line);
// As printf does.
[[gnu::format(printf, 1, 2)]] void say(const char* format, ...);

// Runs `draw` without drawing, and returns how many triangles it would draw. Refined triangles count, coarse ones do
// not.
unsigned count_triangles(const std::function<void()>& draw);

// The same as text: "1 triangle", "64 triangles".
std::string triangles_as_text(const std::function<void()>& draw);

}  // namespace lesson
